# SPDX-License-Identifier: MIT
"""What triangles cost: processor time to start a run, and then for each sphere and each picture."""

from . import style, tables

LAB = ("triangles",)


def draw(folder):
    table = tables.read(folder / "triangles.csv")
    triangles = table["triangles"]
    figure, (start, then) = style.panels(900, 400, 1, 2)
    start.plot(triangles, table["load"], color=style.BLUE, marker="o", label="load and repair")
    start.plot(triangles, table["prepare"], color=style.VERMILLION, marker="s",
               label="prepare the simulation")
    start.plot(triangles, 2e-6 * triangles, color=style.BLACK, linestyle=":", label="proportional")
    start.set(title="Before the first step", ylabel="processor time [s]")
    then.plot(triangles, 1000 * table["sphere"], color=style.GREEN, marker="^", label="a sphere")
    then.plot(triangles, 1000 * table["picture"], color=style.PURPLE, marker="D", label="a picture")
    then.set(title="For each one then", ylabel="processor time [ms]")
    for ax in (start, then):
        ax.set(xscale="log", yscale="log", xlabel="triangles")
        ax.legend(loc="upper left")
    return figure
