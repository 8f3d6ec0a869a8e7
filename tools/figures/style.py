# SPDX-License-Identifier: MIT
"""What all figures share: colours, marks, and how a file is written.

Colours are from the palette of Okabe and Ito, and every series has a mark or dashes of its own besides.
"""

import io

import matplotlib

matplotlib.use("Agg")

import matplotlib.figure
import matplotlib.image
import matplotlib.lines
import numpy
import PIL.Image

BLUE, ORANGE, GREEN, VERMILLION = "#0072b2", "#e69f00", "#009e73", "#d55e00"
PURPLE, SKY, BLACK = "#cc79a7", "#56b4e9", "#202020"

# The states of spheres, as the style `paper` draws them.
STATES = {"running": "#e69f00", "frozen": "#408cc4", "discarded": "#dddddd"}
NOT_TESTED = "#fbe8bf"
DISCARDED_POLYGON = PURPLE

OBJECTS = {"torus": (VERMILLION, "o"), "sphere": (BLUE, "s"), "cube": (GREEN, "^"), "human": (PURPLE, "D")}

DPI = 100
matplotlib.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 10, "figure.dpi": DPI, "savefig.dpi": DPI,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#606060",
    "axes.grid": True, "axes.grid.axis": "y", "grid.color": "#d8d8d8", "grid.linewidth": 0.6,
    "axes.axisbelow": True, "axes.titlesize": 11, "axes.labelcolor": BLACK, "text.color": BLACK,
    "xtick.color": BLACK, "ytick.color": BLACK, "lines.linewidth": 1.6, "lines.markersize": 5,
    "legend.frameon": False, "legend.fontsize": 9, "figure.constrained_layout.use": True,
})


def canvas(width, height):
    """An empty figure of so many pixels, in which places are given in pixels: no layout moves them."""
    return matplotlib.figure.Figure(figsize=(width / DPI, height / DPI), layout="none")


def panels(width, height, rows=1, columns=1):
    """A figure of so many pixels and its axes."""
    figure = matplotlib.figure.Figure(figsize=(width / DPI, height / DPI))
    return figure, figure.subplots(rows, columns)


def legend_below(figure, entries, columns, pixels=34):
    """One legend for all axes, in so many pixels below them. `entries`: handles, or handles and labels."""
    share = pixels / (figure.get_size_inches()[1] * DPI)
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    handles, labels = entries if isinstance(entries, tuple) else (entries, [each.get_label() for each in entries])
    figure.legend(handles, labels, loc="lower center", ncols=columns)


def legend_right(figure, ax, pixels):
    """A legend in so many pixels at the right."""
    share = pixels / (figure.get_size_inches()[0] * DPI)
    figure.get_layout_engine().set(rect=(0, 0, 1 - share, 1))
    figure.legend(*ax.get_legend_handles_labels(), loc="upper right")


def swatch(label, colour, marker="o"):
    """An entry of a legend that stands for an area or a sphere."""
    return matplotlib.lines.Line2D([], [], color=colour, marker=marker, linestyle="none", markersize=8,
                                   label=label)


def read_picture(path):
    """A PNG as bytes [height, width, 3]."""
    return numpy.asarray(PIL.Image.open(path).convert("RGB"))


def save_picture(pixels, path, colours=256):
    """Writes a small PNG: pictures of a documentation need no more colours."""
    image = PIL.Image.fromarray(numpy.asarray(pixels)[:, :, :3])
    image.quantize(colours, kmeans=1, dither=PIL.Image.Dither.NONE).save(path, optimize=True)


def save(figure, path):
    """Writes a figure, the same bytes each time."""
    memory = io.BytesIO()
    figure.savefig(memory, format="rgba", dpi=DPI * (1 if figure.images else 1.5))
    width, height = (round(side) for side in figure.get_size_inches() * DPI * (1 if figure.images else 1.5))
    pixels = numpy.frombuffer(memory.getvalue(), numpy.uint8).reshape(height, width, 4)
    save_picture(pixels, path, 256 if figure.images else 128)
