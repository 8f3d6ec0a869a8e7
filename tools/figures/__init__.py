# SPDX-License-Identifier: MIT
"""The figures of the documentation, a module each.

A module has `draw(folder)`, which gives the figure of the tables in a folder, or None where the
measurement makes the picture; and either `LAB`, the measurements of frostfill-lab that it shows, or
`measure(folder, quick)`, which makes the tables with the module frostfill, or both. Its own words say
what the figure shows.
"""

import importlib

NAMES = ("torus", "studio", "volume", "interaction", "times", "claim", "operations", "discarded",
         "closeness", "density", "filling", "cutaways", "closed_forms", "error", "peers", "triangles",
         "sizes", "friction")


def figure(name):
    """The module of a figure, by its name with - or _."""
    return importlib.import_module("." + name.replace("-", "_"), __name__)
