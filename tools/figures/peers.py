# SPDX-License-Identifier: MIT
"""Other engines on the same cube: time against overlap, a point a run."""

import numpy

from . import style, tables

LAB = ("peers",)
FLOOR = 1e-16
KNOWN = {"Frostfill": (style.BLUE, "s"), "Bullet": (style.ORANGE, "^"), "ODE": (style.GREEN, "D"),
         "LIGGGHTS": (style.VERMILLION, "o")}
OTHERS = ((style.PURPLE, "v"), (style.SKY, "P"), (style.BLACK, "*"))


def draw(folder):
    table = tables.read(folder / "peers.csv")
    figure, ax = style.panels(900, 500)
    seconds, worst = table["seconds"], numpy.maximum(table["worst"], FLOOR)
    names = list(dict.fromkeys(table.words("engine")))
    marks = dict(zip((name for name in names if name not in KNOWN), OTHERS))
    for name in names:
        rows = table.where(engine=name)
        colour, mark = {**KNOWN, **marks}[name]
        ax.plot(rows["seconds"], numpy.maximum(rows["worst"], FLOOR), color=colour, marker=mark,
                linestyle="none", markersize=7, label=name)
    restless = table["at_rest"] == 0
    ax.plot(seconds[restless], worst[restless], color=style.BLACK, marker="x", linestyle="none",
            markersize=11, label="not at rest at the end")
    front = tables.pareto_front(seconds, worst)
    ax.plot(seconds[front], worst[front], color=style.BLACK, marker="o", markerfacecolor="none",
            linestyle="none", markersize=13, label="Pareto front")
    for x, y, engine, setting in zip(seconds, worst, table.words("engine"), table.words("setting")):
        left = engine == "LIGGGHTS"  # where ODE lies at its right
        ax.annotate(setting, (x, y), xytext=(-10 if left else 10, 0), textcoords="offset points",
                    ha="right" if left else "left", va="center", fontsize=8.5)
    ax.set(xscale="log", yscale="log", xlim=(0.06, 300), ylim=(1e-10, 10), xlabel="processor time [s], one thread",
           ylabel="largest overlap, of spheres or with the walls [r]")
    style.legend_right(figure, ax, 180)
    return figure
