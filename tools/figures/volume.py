# SPDX-License-Identifier: MIT
"""PAPER, Figure 1: a filled volume, which pairs of groups are tested, and the same with discards."""

import matplotlib.colors
import numpy

from . import style, tables

SIDE, HEAD, BELOW, MIDDLE = 340, 36, 40, 330
KINDS = {"running": style.STATES["running"], "frozen": style.STATES["frozen"],
         "none": style.NOT_TESTED, "discarded": style.STATES["discarded"]}


def measure(folder, quick):
    from . import runs
    options = dict(preset="paper", search_polygons="grid", search_spheres="all-pairs", freezing_every_sets=1,
                   **runs.panel(SIDE), **({"count": 60} if quick else {}))
    count = runs.frostfill.Simulation("torus", **options).expected_spheres * 3 // 4
    rows, pictures = [], []
    for name, rule in (("frozen", {"discard_rule": "none"}), ("discarded", {})):
        (moment,) = runs.moments("torus", [count], **options, **rule)
        state = moment.snapshot()
        pairs = runs.pairs_of_groups(state)
        rows.append((name, len(state), state.running, state.frozen, state.discarded,
                     sum(tests for *_, tests in pairs)))
        pictures.append(moment.render())
    tables.write(folder / "volume-pairs.csv", ("i", "j", "kind", "tests"), pairs)
    tables.write(folder / "volume.csv",
                 ("panel", "spheres", "running", "frozen", "discarded", "tests_a_step"), rows)
    style.save_picture(runs.joined(pictures, 2), folder / "volume-panels.png")


def draw_pairs(ax, table):
    """The pairs of groups as cells, a colour for each kind."""
    groups = int(table["j"].max())
    codes = numpy.full((groups, groups), numpy.nan)
    kinds = list(KINDS)
    for i, j, kind in zip(table["i"], table["j"], table.words("kind")):
        codes[int(i) - 1, int(j) - 1] = kinds.index(kind)
    edges = numpy.arange(groups + 1) + 0.5
    ax.pcolormesh(edges, edges, codes, cmap=matplotlib.colors.ListedColormap(list(KINDS.values())), vmin=-0.5,
                  vmax=len(kinds) - 0.5, edgecolors="white", linewidth=0.8 if groups < 40 else 0.3)
    ax.invert_yaxis()
    ax.grid(False)
    ax.set(xlabel="group", ylabel="group", aspect="equal")


def draw(folder):
    panels = style.read_picture(folder / "volume-panels.png")
    width, height = 2 * SIDE + MIDDLE, SIDE + HEAD + BELOW
    figure = style.canvas(width, height)
    figure.figimage(panels[:, :SIDE], 0, BELOW, origin="upper")
    figure.figimage(panels[:, SIDE:], SIDE + MIDDLE, BELOW, origin="upper")
    for x, title in ((SIDE / 2, "(A) running and frozen"), (SIDE + MIDDLE / 2, "(B) pairs of groups"),
                     (1.5 * SIDE + MIDDLE, "(C) with discards")):
        figure.text(x / width, 1 - HEAD / 2 / height, title, ha="center", va="center", fontsize=11)
    ax = figure.add_axes(((SIDE + 55) / width, (BELOW + 50) / height, (MIDDLE - 70) / width,
                          (MIDDLE - 70) / height))
    draw_pairs(ax, tables.read(folder / "volume-pairs.csv"))
    figure.legend(handles=[style.swatch(name, colour) for name, colour in style.STATES.items()]
                  + [style.swatch("not tested", style.NOT_TESTED, "s")], loc="lower center", ncols=4)
    return figure
