# SPDX-License-Identifier: MIT
"""Errors against closed forms over the time step. What is exact lies on the floor."""

import numpy

from . import style, tables

LAB = ("closed-forms",)
FLOOR = 1e-16
EXPLICIT, SEMI = (style.VERMILLION, "o", "-"), (style.ORANGE, "s", "--")
LEFT = ((("free fall", "explicit Euler"), "free fall, explicit Euler: +gT Δt/2", EXPLICIT),
        (("free fall", "semi-implicit Euler"), "free fall, semi-implicit Euler: −gT Δt/2", SEMI),
        (("free fall", "exact step"), "free fall, our step", (style.BLUE, "D", "-")),
        (("throw", "exact step"), "throw, our step", (style.GREEN, "^", ":")))
RIGHT = ((("bounce", "explicit Euler"), "bounce, explicit Euler", EXPLICIT),
         (("bounce", "semi-implicit Euler"), "bounce, semi-implicit Euler", SEMI),
         (("bounce", "exact step"), "bounce, our step", (style.BLUE, "D", "-")),
         (("head-on pair", "exact step"), "head-on pair, our step", (style.PURPLE, "v", ":")))


def draw(folder):
    table = tables.read(folder / "closed-forms.csv")
    figure, axes = style.panels(900, 500, 1, 2)
    for ax, series, title, label in ((axes[0], LEFT, "Free fall and throw", "error [r]"),
                                     (axes[1], RIGHT, "Bounce (apex e²h) and head-on pair",
                                      "relative error")):
        for (problem, method), words, (colour, mark, dashes) in series:
            rows = table.where(problem=problem, method=method)
            ax.plot(rows["value"], numpy.maximum(rows["magnitude"], FLOOR), color=colour, marker=mark,
                    linestyle=dashes, markerfacecolor="white" if mark == "s" else colour, label=words)
        ax.set(xscale="log", yscale="log", title=title, ylabel=label, xlabel="time step [√(r/g)]",
               xlim=(7e-4, 0.14), ylim=(3e-17, 3))
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14))
    return figure
