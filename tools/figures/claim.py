# SPDX-License-Identifier: MIT
"""The paper's claim: the number of spheres grows, the number of operations holds.

10,000 spheres fill the torus in sets of a hundred. The percentages say how much more a frame, and a
sphere, costs in the last tenth of the sets than in the first."""

from . import style, tables

LAB = ("claim",)
METHODS = {"all running": ("nothing frozen", style.BLACK, "+"),
           "freezing": ("freezing each set", style.VERMILLION, "o"),
           "discards": ("and both discards", style.ORANGE, "s"),
           "grid": ("our grids", style.SKY, "^"), "fast": ("our engine (fast)", style.BLUE, "D")}
PANELS = (("ms", "Time of a frame", "milliseconds"), ("tests", "Tests of a frame", "pairs tested"),
          ("sphere_ms", "Time of a sphere, until it rests", "milliseconds"),
          ("sphere_tests", "Tests of a sphere, until it rests", "pairs tested"))


def growth(costs):
    """By how much the last tenth of the points costs more than the first. [%]"""
    tenth = max(len(costs) // 10, 1)
    return 100 * (costs[-tenth:].mean() / costs[:tenth].mean() - 1)


def draw(folder):
    points = tables.read(folder / "claim.csv")
    figure, axes = style.panels(900, 760, 2, 2)
    for ax, (column, title, label) in zip(axes.flat, PANELS):
        for name, (words, colour, mark) in METHODS.items():
            rows = points.where(method=name)
            if column.startswith("sphere") and name == "all running":
                continue  # only single steps are timed, so what a sphere costs is not known
            ax.plot(rows["spheres"], rows[column], color=colour, marker=mark, linestyle="none",
                    markersize=4, label=words)
            up = {("ms", "grid"): -7, ("ms", "fast"): 7}.get((column, name), 0)
            ax.annotate(f"{growth(rows[column]):+.0f} %", (rows["spheres"][-1], rows[column][-1]),
                        xytext=(6, up),
                        textcoords="offset points", color=colour, va="center", fontsize=9)
        ax.set(yscale="log", title=title, ylabel=label, xlim=(0, 12800), xticks=range(0, 10001, 2500))
        if column.startswith("sphere"):
            ax.set_xlabel("spheres present")
    style.legend_below(figure, axes[0][0].get_legend_handles_labels(), 5)
    return figure
