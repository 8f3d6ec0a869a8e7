# SPDX-License-Identifier: MIT
"""How loosely and how densely grains rest together, and on how many contacts, against friction.

About 2,200 spheres in the cube, one pile each. Published values: compressed without friction and with
0.3, by Agnolin and Roux (2007); the loosest packing of rough spheres by Onoda and Liniger (1990)."""

import numpy

from . import style, tables

FRICTIONS = (0.1, 0.2, 0.3, 0.6, 1)
COMPRESSED = {"friction": (0, 0.3), "fraction": (0.639, 0.593), "contacts": (6, 4.5)}
LOOSEST = 0.555


def contacts_in_bulk(run):
    """Mean number of contacts of a sphere in the bulk that is no rattler."""
    from . import runs
    state = run.snapshot()
    found = runs.frostfill.analyse(state.centres, state.radii, run.vertices, run.triangles,
                                   gap=1e-4, only=["contacts"])
    held = runs.in_bulk(found) & (found.rattlers == 0)
    return numpy.mean(found.sphere_contacts[held])


def measure(folder, quick):
    from . import runs
    rows = []
    for preparation in ("loosest", "densest"):
        for friction in FRICTIONS[:1] if quick else FRICTIONS:
            run = runs.finished("cube", count=700 if quick else 2200, motion="granular", rest="joint",
                                friction=friction, fraction=preparation)
            settling = run.quality().settling
            rows.append((preparation, f"{friction:g}", f"{settling.fraction:.4f}",
                         f"{contacts_in_bulk(run):.2f}", run.sphere_count, int(settling.settled)))
    tables.write(folder / "friction.csv",
                 ("preparation", "friction", "fraction", "contacts", "spheres", "settled"), rows)


def draw(folder):
    table = tables.read(folder / "friction.csv")
    figure, axes = style.panels(900, 400, 1, 2)
    for ax, column, label in zip(axes, ("fraction", "contacts"),
                                 ("packing fraction of the bulk", "contacts of a sphere in the bulk")):
        for name, colour, mark, dashes in (("densest", style.BLUE, "s", "-"),
                                           ("loosest", style.VERMILLION, "o", "--")):
            rows = table.where(preparation=name)
            ax.plot(rows["friction"], rows[column], color=colour, marker=mark, linestyle=dashes, label=name)
        ax.plot(COMPRESSED["friction"], COMPRESSED[column], color=style.BLACK, marker="^", linestyle="none",
                markerfacecolor="white", markersize=7, label="published, compressed")
        ax.set(xlim=(-0.05, 1.1), xlabel="friction", ylabel=label)
    axes[0].axhline(LOOSEST, color=style.BLACK, linestyle=":", linewidth=1.3, label="published, loosest")
    axes[0].set_ylim(0.54, 0.66)
    axes[0].legend(loc="lower left", ncols=2, bbox_to_anchor=(0, 0.16))
    axes[1].set_ylim(4, 6.2)
    axes[1].legend(loc="upper right")
    return figure
