# SPDX-License-Identifier: MIT
"""PAPER, Figure 3: sphere–polygon work in milliseconds a frame, the paper's and ours.

A mark is the mean; a bar goes from the first set after a freezing to the last one before the next."""

from . import style, tables

LAB = ("times",)
SERIES = {"paper loop": ("paper, loop", style.BLACK, "o", "black"),
          "paper tree": ("paper, tree", style.BLACK, "o", "white"),
          "loop": ("loop", style.VERMILLION, "s", None), "list": ("linked list", style.PURPLE, "^", None),
          "tree": ("tree", style.ORANGE, "D", None), "grid": ("grid", style.BLUE, "v", None)}


def draw(folder):
    table = tables.read(folder / "times.csv")
    figure, ax = style.panels(820, 420)
    for k, (name, (label, colour, mark, face)) in enumerate(SERIES.items()):
        rows = table.where(series=name)
        ax.errorbar(rows["number"] + 0.12 * (k - 2.5), rows["ms"],
                    (rows["ms"] - rows["low"], rows["high"] - rows["ms"]), color=colour, marker=mark,
                    markerfacecolor=face or colour, linestyle="none", capsize=3, label=label)
    objects = {number: name.capitalize() for number, name in zip(table["number"], table.words("object"))}
    ax.set(yscale="log", ylabel="sphere–polygon work [ms a frame]", xlim=(-0.5, len(objects) - 0.5),
           xticks=list(objects), xticklabels=objects.values())
    style.legend_right(figure, ax, 130)
    return figure
