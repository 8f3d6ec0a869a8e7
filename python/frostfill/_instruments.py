# SPDX-License-Identifier: MIT
"""The judge of packings, their analyses, the inspection of meshes, and volumes from fillings."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from os import PathLike
from typing import NamedTuple

import numpy
from numpy.typing import ArrayLike

from . import _frostfill
from ._frostfill import MeshReport, PackingAnalysis, QualityReport, VolumeEstimate
from ._keywords import takes_options


class Packing(NamedTuple):
    """A packing from a file: spheres in the coordinates of their mesh."""

    centres: numpy.ndarray  # float64 [n, 3]
    radii: numpy.ndarray  # float64 [n]
    at_rest: numpy.ndarray  # bool [n]; where the file does not say, all
    format: str  # what the file is, in a few words


def read_packing(
    path: str | PathLike[str],
    *,
    radius: float | None = None,
    columns: Mapping[str, str | int] | None = None,
) -> Packing:
    """Reads spheres from a file of any program, for frostfill.check and frostfill.analyse.

    path: a run, a table (CSV), XYZ, a dump or data file of LAMMPS or LIGGGHTS, or the text
    of YADE; of several moments the last. radius: of all spheres of a file that has none. columns: which columns of a table are x, y, z and radius or
    diameter, by name or by number from 1, where they have other names.

    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp(), "beads.csv")
    >>> _ = file.write_text("px,py,pz,size\\n0,0,0,0.5\\n")
    >>> found = read_packing(file, columns={"x": "px", "y": "py", "z": "pz", "diameter": "size"})
    >>> found.radii, found.format
    (array([0.25]), 'a table')
    """
    if radius is not None and (isinstance(radius, (bool, str)) or not math.isfinite(radius) or radius <= 0):
        raise _frostfill.Usage(f"radius must be a number above 0, not {radius!r}")
    text = ""
    if columns is not None:
        if not isinstance(columns, Mapping) or not columns:
            raise _frostfill.Usage('columns must be a dictionary such as {"x": "px", "radius": 4}')
        text = ",".join(f"{quantity}={column}" for quantity, column in columns.items())
    return Packing(*_frostfill.read_packing(path, 0.0 if radius is None else radius, text))


@takes_options("judging")
def check(
    centres: ArrayLike,
    radii: ArrayLike,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    *,
    mesh: str | PathLike[str] | None = None,
    box: ArrayLike | None = None,
    periodic: bool = False,
    at_rest: ArrayLike | None = None,
    **options,
) -> QualityReport:
    """Judges spheres in a mesh or in a box, from any source.

    centres: numbers [n, 3]; radii: [n], or one number. The mesh: vertices [v, 3] and triangles
    [t, 3], or `mesh`, a name or a file. In its place a box: its size [3], from 0 on, or its lowest
    corner and its highest one [2, 3]. A periodic box repeats in all directions and has no walls:
    only overlaps of spheres are judged then. at_rest: bool [n], whose weight has to be carried; all
    by default.

    >>> report = check([[0, 0, 0], [0.5, 0, 0]], 0.3, mesh="cube")
    >>> round(report.max_overlap, 6), report.centres_outside
    (0.333333, 0)
    >>> check([[0.1, 1, 1], [1.9, 1, 1]], 0.2, box=(2, 2, 2), periodic=True).max_overlap > 0.9
    True
    """
    return _frostfill.check(
        centres, radii, mesh, vertices, triangles, _numbers(box), bool(periodic), at_rest, **options
    )


def _numbers(box):
    """A box in a row."""
    try:
        return box if box is None else numpy.ravel(box)
    except ValueError:
        raise _frostfill.Usage(f"box is {box!r}, but it must be an array of 3 or 6 numbers") from None


@takes_options("loading")
def analyse(
    centres: ArrayLike,
    radii: ArrayLike,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    *,
    mesh: str | PathLike[str] | None = None,
    box: ArrayLike | None = None,
    periodic: bool = False,
    up: str = "y",
    centre: ArrayLike | None = None,
    below: float | None = None,
    forces: float | None = None,
    bins: int = 50,
    range: float = 5,
    gap: float = 0.01,
    bond: float = 1.3,
    rattlers_below: int = 3,
    samples: int = 1 << 20,
    only: str | Sequence[str] = (),
    threads: int = 0,
    **options,
) -> PackingAnalysis:
    """Analyses spheres in a mesh: porosity, neighbours, contacts, Voronoi cells, order and sizes.

    Spheres, mesh and box as for frostfill.check; a periodic box has no cells and no porosity by the
    distance from a wall. The keywords are the options of `frostfill analyse`;
    only: names, of porosity, pairs, contacts, cells, order and sizes.

    >>> found = analyse([[0, 0, 0], [0.5, 0, 0]], 0.25, mesh="cube", samples=1000)
    >>> found.sphere_contacts, found.summary["contacts"]["pairs"]
    (array([1, 1], dtype=uint32), 1)
    """
    given = {
        "up": up,
        "centre": centre,
        "below": below,
        "forces": forces,
        "bins": bins,
        "range": range,
        "gap": gap,
        "bond": bond,
        "rattlers_below": rattlers_below,
        "samples": samples,
        "only": [only] if isinstance(only, str) else list(only),
        "threads": threads,
    }
    return _frostfill.analyse(
        centres, radii, mesh, vertices, triangles, _numbers(box), bool(periodic), given, **options
    )


class Inspection(NamedTuple):
    """What frostfill.inspect found."""

    as_read: MeshReport
    """before any repair"""
    filled: MeshReport | None
    """as it is filled, after repair; None for a mesh that cannot be filled"""
    repairs: list[str]
    """a sentence each"""
    refusal: str | None
    """why it cannot be filled, and which options would help"""


@takes_options("loading")
def inspect(
    mesh: str | PathLike[str] | None = None,
    *,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    **options,
) -> Inspection:
    """Inspects a mesh: its defects, its repairs, and whether it can be filled.

    >>> report = inspect("cube")
    >>> report.as_read.closed, report.filled.volume, report.repairs
    (True, 8.0, [])
    """
    return Inspection(*_frostfill.inspect(mesh, vertices, triangles, **options))


@takes_options("filling")
def volume(
    mesh: str | PathLike[str] | None = None,
    *,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    **options,
) -> VolumeEstimate:
    """Estimates the volume of a mesh by filling it with spheres, and with spheres half as large.

    >>> estimate = volume("cube")
    >>> abs(estimate.volume - estimate.mesh_volume) < 3 * estimate.error
    True
    """
    return _frostfill.volume(mesh, vertices, triangles, **options)
