# SPDX-License-Identifier: MIT
"""Draws the tables of an analysis beside this file: python3 figures.py [TABLE.csv ...]"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

BLUE, ORANGE, VERMILLION, SKY = "#0072b2", "#e69f00", "#d55e00", "#56b4e9"  # of Okabe and Ito
FOLDER = pathlib.Path(__file__).resolve().parent
NAMES = sys.argv[1:] or [file.name for file in FOLDER.glob("*.csv")]
plt.rcParams.update({"axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.grid.axis": "y",
                     "axes.axisbelow": True, "grid.color": "#d8d8d8", "legend.frameon": False, "savefig.dpi": 150})


def table(name):
    """Columns by their names, and the middles and widths of bins."""
    with (FOLDER / f"{name}.csv").open() as file:
        rows = list(csv.DictReader(file))
    columns = {key: [float(row[key]) for row in rows] for key in (rows[0] if rows else ())}
    bins = list(zip(columns.get("from", ()), columns.get("to", ())))
    return columns, [(a + b) / 2 for a, b in bins], [b - a for a, b in bins]


def figure(name, tables, *labels):
    """The figure of the first table, if that is asked for, with a plot for each that is there."""
    there = [(table(one), one) for one in tables if f"{one}.csv" in NAMES]
    if not there or f"{tables[0]}.csv" not in NAMES:
        return
    drawn, plots = plt.subplots(1, len(there), figsize=(4.5 * len(there) + 1.5, 4), squeeze=False)
    for plot, ((columns, middles, widths), one) in zip(plots[0], there):
        if columns:
            DRAW[name](plot, columns, middles, widths)
        plot.set(xlabel=labels[tables.index(one)])
    drawn.tight_layout()
    for ending in ("svg", "png"):
        drawn.savefig(FOLDER / f"{name}.{ending}")


def porosity(plot, columns, middles, _):
    low, high = ([p + k * e for p, e in zip(columns["porosity"], columns["error"])] for k in (-2, 2))
    plot.fill_between(middles, low, high, color=SKY, alpha=0.5, linewidth=0)  # twice the error
    plot.plot(middles, columns["porosity"], color=BLUE)
    plot.set(ylim=(0, 1), ylabel="porosity")


def pairs(plot, columns, middles, _):
    plot.plot(middles, columns["g"], color=BLUE, label="g(r)")
    other = plot.twinx()
    other.plot(columns["to"], columns["neighbours"], "--", color=VERMILLION, label="neighbours up to the distance")
    other.set(ylabel="neighbours")
    other.grid(False)
    plot.set(ylabel="g(r)")
    plot.figure.legend(loc="upper left", bbox_to_anchor=(0.02, 0.98), bbox_transform=plot.transAxes)


def contacts(plot, columns, *_):
    plot.bar(columns["contacts"], columns["spheres"], color=BLUE, alpha=0.6, label="all")
    plot.bar(columns["contacts"], columns["rattlers"], color=ORANGE, alpha=0.8, label="rattlers")
    plot.set(ylabel="spheres")
    plot.legend()


def histogram(counted):
    def draw(plot, columns, middles, widths):
        plot.bar(middles, columns[counted], widths, color=BLUE, alpha=0.6)
        plot.set(ylabel=counted)
    return draw


def sizes(plot, columns, middles, _):
    plot.errorbar(middles, columns["mean_radius"], columns["deviation"], fmt="o", color=BLUE)
    plot.set(ylim=(0, None), ylabel="mean radius [mesh unit]")


DRAW = {"porosity": porosity, "pairs": pairs, "contacts": contacts, "cells": histogram("cells"),
        "order": histogram("spheres"), "sizes": sizes}
PLACES = ("height [mesh unit]", "distance from the axis [mesh unit]", "distance from the wall [mesh unit]")
figure("porosity", ["porosity_height", "porosity_radial", "porosity_wall"], *PLACES)
figure("pairs", ["pairs"], "distance [mesh unit]")
figure("contacts", ["contacts"], "contacts with spheres")
figure("cells", ["cells"], "sphere's share of its Voronoi cell")
figure("order", ["order"], "Q6")
figure("sizes", ["sizes_height", "sizes_radial"], *PLACES)
