# SPDX-License-Identifier: MIT
"""Share of the cube that is filled, against the number of spheres that appear together.

About 1,000 spheres, until no sphere fits; five seeds; bars are 95 % confidence intervals of the mean."""

import numpy

from . import style, tables

METHODS = {"paper": ("paper", style.VERMILLION, "o", "-"),
           "fast": ("fast, every moment of the fall", style.BLUE, "s", "--"),
           "skip": ("fast, from the first contact on", style.GREEN, "D", ":")}
SET_SIZES = (1, 2, 5, 10, 20, 50, 100)
STUDENT = {2: 12.706, 5: 2.7764}  # quantile of 97.5 % for so many runs


def measure(folder, quick):
    from . import runs
    seeds = 2 if quick else 5
    rows = []
    for method, options in {"paper": {"preset": "paper", "discard_rule": "none", "freezing_every_sets": 1,
                                      **runs.GRIDS},
                            "fast": {"motion": "fall"}, "skip": {"motion": "skip"}}.items():
        radius = runs.frostfill.Simulation("cube", count=30 if quick else 1000, **options).radius
        for size in SET_SIZES:
            shares = []
            for seed in range(1, seeds + 1):
                quality = runs.finished("cube", radius=radius, count=None, spheres_group_size=size,
                                        spheres_groups_per_set=1, seed=seed, **options).quality()
                shares.append(100 * quality.sphere_volume / quality.mesh_volume)
            half = STUDENT[seeds] * numpy.std(shares, ddof=1) / numpy.sqrt(seeds)
            rows.append((method, size, f"{numpy.mean(shares):.4f}", f"{half:.4f}", seeds))
    tables.write(folder / "density.csv",
                 ("method", "set_size", "packing_percent", "half_width_95", "runs"), rows)


def draw(folder):
    table = tables.read(folder / "density.csv")
    figure, ax = style.panels(760, 420)
    for shift, (name, (label, colour, mark, dashes)) in zip((-1, 0, 1), METHODS.items()):
        rows = table.where(method=name)
        ax.errorbar(rows["set_size"] * 1.025 ** shift, rows["packing_percent"], rows["half_width_95"],
                    color=colour, marker=mark, linestyle=dashes, capsize=3, label=label)
    ax.set(xscale="log", xlabel="spheres in a set", ylabel="volume filled [%]", xlim=(0.8, 125),
           xticks=SET_SIZES, xticklabels=[str(size) for size in SET_SIZES])
    ax.minorticks_off()
    ax.legend(loc="upper left")
    return figure
