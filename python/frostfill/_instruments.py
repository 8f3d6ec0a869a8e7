# SPDX-License-Identifier: MIT
"""The judge of packings, their analyses, the inspection of meshes, and volumes from fillings."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import NamedTuple

from numpy.typing import ArrayLike

from . import _frostfill
from ._frostfill import MeshReport, PackingAnalysis, QualityReport, VolumeEstimate
from ._keywords import takes_options


@takes_options("judging")
def check(
    centres: ArrayLike,
    radii: ArrayLike,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    *,
    mesh: str | PathLike[str] | None = None,
    at_rest: ArrayLike | None = None,
    **options,
) -> QualityReport:
    """Judges spheres in a mesh, from any source.

    centres: numbers [n, 3]; radii: [n], or one number. The mesh: vertices [v, 3] and triangles
    [t, 3], or `mesh`, a name or a file. at_rest: bool [n], whose weight has to be carried; all by
    default.

    >>> report = check([[0, 0, 0], [0.5, 0, 0]], 0.3, mesh="cube")
    >>> round(report.max_overlap, 6), report.centres_outside
    (0.333333, 0)
    """
    return _frostfill.check(centres, radii, mesh, vertices, triangles, at_rest, **options)


@takes_options("loading")
def analyse(
    centres: ArrayLike,
    radii: ArrayLike,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    *,
    mesh: str | PathLike[str] | None = None,
    up: str = "y",
    centre: ArrayLike | None = None,
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

    Spheres and mesh as for frostfill.check. The keywords are the options of `frostfill analyse`;
    only: names, of porosity, pairs, contacts, cells, order and sizes.

    >>> found = analyse([[0, 0, 0], [0.5, 0, 0]], 0.25, mesh="cube", samples=1000)
    >>> found.sphere_contacts, found.summary["contacts"]["pairs"]
    (array([1, 1], dtype=uint32), 1)
    """
    given = {
        "up": up,
        "centre": centre,
        "bins": bins,
        "range": range,
        "gap": gap,
        "bond": bond,
        "rattlers_below": rattlers_below,
        "samples": samples,
        "only": [only] if isinstance(only, str) else list(only),
        "threads": threads,
    }
    return _frostfill.analyse(centres, radii, mesh, vertices, triangles, given, **options)


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
