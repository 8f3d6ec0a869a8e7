# SPDX-License-Identifier: MIT
"""Fills a closed mesh with falling spheres and draws every frame without a screen.

Lengths are in the unit of the mesh file and times in seconds, unless a name says otherwise. Arrays
are NumPy's. What is refused is an exception with one sentence: a subclass of frostfill.Error.

>>> import frostfill
>>> run = frostfill.fill("torus", count=40, seed=7)
>>> run.centres.shape, run.radii.shape, run.states.dtype
((40, 3), (40,), dtype('uint8'))
>>> bool((run.states == frostfill.SphereState.RUNNING).any())
False
>>> run.render(size=(160, 120)).shape
(120, 160, 3)
"""

from ._frostfill import (
    BadData,
    CannotCreate,
    EquilibriumReport,
    Error,
    InputMissing,
    MeshReport,
    OutOfMemory,
    PackingAnalysis,
    Postcondition,
    QualityReport,
    Snapshot,
    StoppedEarly,
    ThresholdFailed,
    Unavailable,
    Usage,
    VolumeEstimate,
    WriteFailed,
)
from ._frostfill import version as __version__
from ._instruments import Inspection, Packing, analyse, check, inspect, read_packing, volume
from ._pictures import Picture
from ._progress import Progress
from ._runs import Run, fill, load
from ._simulation import Simulation, SphereState

__all__ = [
    "fill",
    "load",
    "Run",
    "Simulation",
    "Snapshot",
    "SphereState",
    "Picture",
    "Progress",
    "read_packing",
    "Packing",
    "check",
    "QualityReport",
    "EquilibriumReport",
    "analyse",
    "PackingAnalysis",
    "inspect",
    "Inspection",
    "MeshReport",
    "volume",
    "VolumeEstimate",
    "Error",
    "Usage",
    "BadData",
    "InputMissing",
    "Unavailable",
    "Postcondition",
    "OutOfMemory",
    "CannotCreate",
    "WriteFailed",
    "StoppedEarly",
    "ThresholdFailed",
    "__version__",
]
