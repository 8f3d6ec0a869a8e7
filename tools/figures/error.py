# SPDX-License-Identifier: MIT
"""Run time against error, a point a run: steps, discards, volume, layers, rendering and rest.

Rings: no rival is both faster and better. Squares: the defaults. Errors below 1e-9 are equal, and so are
times within 5 %."""

import numpy

from . import error_runs, style, tables

LAB = ("rest",)
measure = error_runs.measure
NO_ERROR, SAME_TIME = 1e-9, 0.05
MARKS = ((style.BLUE, "s"), (style.SKY, "^"), (style.VERMILLION, "o"), (style.ORANGE, "v"),
         (style.GREEN, "D"))


def _points(ax, x, y, label, colour, mark, **more):
    ax.plot(x, y, color=colour, marker=mark, linestyle="none", label=label, **more)


def _rings(ax, table, y, front="Pareto front", default="our defaults"):
    """Around points of the front, and of the defaults."""
    on_front = tables.pareto_front(table["seconds"], table["error"], table.words("rivals"), NO_ERROR,
                                   SAME_TIME)
    _points(ax, table["seconds"][on_front], y[on_front], front, style.BLACK, "o", markerfacecolor="none",
            markersize=9)
    usual = table["default"] == 1
    _points(ax, table["seconds"][usual], y[usual], default, style.PURPLE, "s", markerfacecolor="none",
            markersize=12)


def _steps(ax, table):
    for curve, (colour, mark) in zip(("fast", "fast skip", "paper", "paper semi-implicit"), MARKS):
        rows = table.where(curve=curve)
        _points(ax, rows["seconds"], rows["error"], curve, colour, mark)
    _rings(ax, table, table["error"], "front, fall or skip")
    ax.set(xscale="log", yscale="log", ylim=(1e-4, 100), xlabel="processor time [s]",
           title="Steps and sweeps: overlap in motion + unsupported",
           ylabel="mean largest overlap [r] + unsupported share")


def _discards(ax, table):
    for curve, label, colour, mark in (("paper", "the paper's rules", style.VERMILLION, "o"),
                                       ("exact", "the exact rule: no deviation", style.BLUE, "s")):
        rows = table.where(curve=curve)
        _points(ax, 100 * rows["spheres_dropped"], numpy.maximum(rows["error"], NO_ERROR), label, colour, mark)
    ax.set(yscale="log", title="Discards: deviation from the run without",
           xlabel="share of spheres dropped [%]", ylabel="farthest deviation [r]")


def _volume_by_radius(ax, table):
    for name, (colour, mark) in style.OBJECTS.items():
        rows = table.where(curve="wall-corrected", rivals=name)
        ax.plot(rows["rS_over_V"], 100 * rows["signed_error"], color=colour, marker=mark,
                label=f"{name}, wall-corrected")
        rows = table.where(curve="two radii", rivals=name)
        _points(ax, rows["rS_over_V"], 100 * rows["signed_error"], f"{name}, two radii", colour, mark,
                markerfacecolor="white")
    for bound in (1, -1):
        ax.axhline(bound, color=style.BLACK, linestyle="--", linewidth=1)
    ax.set(xscale="log", ylim=(-6, 8), title="Volume: radius against error (dashed: 1 %)", xlabel="r S / V",
           ylabel="error of the volume [%]")


def _volume_by_time(ax, table):
    for curve, (colour, mark) in zip(("raw", "wall-corrected", "two radii"), MARKS):
        rows = table.where(curve=curve)
        _points(ax, rows["seconds"], 100 * rows["error"], curve, colour, mark)
    _rings(ax, table, 100 * table["error"], "front, of one object", "--estimate-volume")
    ax.set(xscale="log", yscale="log", xlim=(5e-4, 100), title="Volume: time against error",
           xlabel="processor time [s]", ylabel="error of the volume [%]")


def _layers(ax, table):
    for curve, label, colour, mark in (("by set", "sets freeze whole", style.BLUE, "s"),
                                       ("one by one", "each sphere by itself", style.SKY, "o")):
        rows = table.where(curve=curve)
        ax.plot(rows["layers"], rows["fraction"], color=colour, marker=mark, label=label)
    for fraction, label, dashes in ((0.64, "random close packing, 0.64", "--"),
                                    (0.58, "drop and roll, 0.58", ":")):
        ax.axhline(fraction, color=style.BLACK, linestyle=dashes, linewidth=1, label=label)
    ax.set(xscale="log", ylim=(0.57, 0.68), title="Layers in a set: packing far from walls",
           xlabel="layers in a set", ylabel="packing fraction")


def _rendering(ax, table):
    for curve, label, colour, mark in (
            ("exact spheres", "spheres: 1, 2, 4 samples; 2×2, 3×3, 4×4", style.BLUE, "s"),
            ("shell", "shell of 1,152 to 294,912 triangles, 1 and 4 samples", style.SKY, "^")):
        rows = table.where(curve=curve)
        _points(ax, rows["seconds"], rows["error"], label, colour, mark)
    _rings(ax, table, table["error"])
    ax.set(xscale="log", yscale="log", ylim=(0.3, 100), title="Rendering: frame time against pixel error",
           xlabel="processor time of a picture [s]", ylabel="difference from the reference [of 255]")


def _rest(ax, table, column, floor, scale):
    """A row of `floor` or less lies there: the axis is logarithmic."""
    engines = dict.fromkeys(table.words("curve"))
    looks = {"each": ("each by itself", style.BLUE, "s"), "joint": ("--rest joint", style.GREEN, "^")}
    for friction in (0, 0.3):
        for engine in engines:
            label, colour, mark = looks.get(engine, (engine, style.VERMILLION, "o"))
            rows = table.where(curve=engine, friction=friction)
            _points(ax, rows["seconds"], scale * numpy.maximum(rows[column], floor),
                    f"{label}, friction {friction:g}", colour, mark,
                    **({"markerfacecolor": "white"} if friction else {}))
    ax.set(xscale="log", yscale="log", xlabel="processor time [s]")


def draw(folder):
    table = {name: tables.read(folder / f"error-{name}.csv")
             for name in ("steps", "discards", "volume", "layers", "rendering", "rest")}
    figure, axes = style.panels(1000, 1480, 4, 2)
    _steps(axes[0][0], table["steps"])
    _discards(axes[0][1], table["discards"])
    _volume_by_radius(axes[1][0], table["volume"])
    _volume_by_time(axes[1][1], table["volume"])
    _layers(axes[2][0], table["layers"])
    _rendering(axes[2][1], table["rendering"])
    _rest(axes[3][0], table["rest"], "error", 1e-4, 100)
    _rings(axes[3][0], table["rest"], 100 * numpy.maximum(table["rest"]["error"], 1e-4),
           "front, of one friction")
    axes[3][0].set(title="Rest: what nothing holds when all are let go", ylim=(0.006, 2e3),
                   ylabel="share of spheres [%]; none is at 0.01")
    _rest(axes[3][1], table["rest"], "max_overlap", 1e-14, 1)
    axes[3][1].set(title="Rest: overlap that is left", ylim=(3e-15, 1e4),
                   ylabel="largest overlap [r]; none is at 10⁻¹⁴")
    for ax in axes.flat:
        ax.legend(loc="upper right" if ax in (axes[0][0], axes[3][0], axes[3][1]) else "best", fontsize=8,
                  ncols=2 if ax in (axes[1][0], axes[3][1]) else 1)
    return figure
