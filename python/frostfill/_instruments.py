# SPDX-License-Identifier: MIT
"""The judge of packings, the inspection of meshes, and volumes from fillings."""

from __future__ import annotations

from os import PathLike
from typing import NamedTuple

from numpy.typing import ArrayLike

from . import _frostfill
from ._frostfill import MeshReport, QualityReport, VolumeEstimate
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
