# SPDX-License-Identifier: MIT
"""Runs step by step."""

from __future__ import annotations

import enum
from os import PathLike

from numpy.typing import ArrayLike

from . import _frostfill
from ._keywords import takes_options
from ._pictures import Picture


class SphereState(enum.IntEnum):
    """The numbers in the arrays of states."""

    RUNNING = 0
    FROZEN = 1
    DISCARDED = 2


class Simulation(_frostfill.Simulation):
    """A run, step by step. Nothing is written.

    Iterating takes a step and gives the state after it, a Snapshot, until the run is over:

    >>> for snapshot in Simulation("torus", count=20):
    ...     highest = snapshot.centres[:, 1].max()
    >>> snapshot
    <frostfill.Snapshot of ... spheres at ... s: 0 running, ...>

    Arrays of a snapshot are views of the simulation's memory. They keep their values for as long as
    you keep them: the next snapshots then lie elsewhere. Keeping none, or only the newest, is
    quickest: it takes only what has changed.
    """

    @takes_options("filling")
    def __init__(
        self,
        mesh: str | PathLike[str] | None = None,
        *,
        vertices: ArrayLike | None = None,
        triangles: ArrayLike | None = None,
        **options,
    ):
        """Loads and repairs the mesh, as frostfill.fill does. Raises Error."""
        super().__init__(mesh, vertices=vertices, triangles=triangles, **options)

    @takes_options("pictures")
    def render(self, **options) -> Picture:
        """Draws the state as it is now.

        >>> Simulation("cube", count=10).render(size=(64, 48)).shape
        (48, 64, 3)
        """
        return super().render(**options).view(Picture)
