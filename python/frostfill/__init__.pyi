# SPDX-License-Identifier: MIT
# Printed by python/make_stub.py from the module; a test compares. Do not edit.
import enum
from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal, NamedTuple, TypedDict, Unpack

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

class LoadOptions(TypedDict, total=False):
    lid: bool
    cavity: bool
    wrap: float | Literal['auto', 'none'] | None
    object_unite: bool

class JudgeOptions(LoadOptions, total=False):
    up: Literal['x', 'y', 'z']
    judge_friction: float | Literal['none'] | None
    judge_rolling_friction: float | Literal['auto'] | None
    judge_unbalance: float

class PictureOptions(TypedDict, total=False):
    frames: str | int | Sequence[float] | Sequence[str]
    frames_fps: float
    frames_limit: int
    frames_hold: float
    frames_passes: str | int | Sequence[float] | Sequence[str]
    size: str | int | Sequence[float] | Sequence[str]
    picture_samples: int
    picture_supersample: int
    style: Literal['clean', 'paper', 'dark', 'studio']
    color_by: Literal['auto', 'radius', 'state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6']
    colour_map: Literal['viridis', 'cividis', 'plasma', 'inferno', 'magma']
    colour: str | int | Sequence[float] | Sequence[str]
    cutaway: str | int | Sequence[float] | Sequence[str]
    picture_ambient_occlusion: bool
    legend: bool
    shell: bool
    picture_full_mesh: bool
    picture_edges: Literal['auto', 'on', 'off'] | bool
    picture_shell_opacity: float | Literal['auto'] | None
    picture_ground: bool
    picture_static_layer: bool
    background: str | int | Sequence[float] | Sequence[str]
    picture_backend: Literal['auto', 'osmesa', 'egl', 'builtin']
    azimuth: float | Literal['auto'] | None
    elevation: float
    camera_field_of_view: float
    zoom: float
    camera_orthographic: bool
    camera_target: Sequence[float] | Literal['auto'] | None
    camera_distance: float | Literal['auto'] | None
    turntable: float | Literal['none'] | None
    camera_path: str | int | Sequence[float] | Sequence[str] | None

class FillOptions(JudgeOptions, PictureOptions, total=False):
    name: str | int | Sequence[float] | Sequence[str]
    units: float | Literal['m', 'cm', 'mm', 'in', 'ft']
    radius: float | tuple[float, float] | str | PathLike[str] | None
    count: int | Literal['none'] | None
    sizes: str | int | Sequence[float] | Sequence[str] | None
    by: Literal['number', 'mass', 'volume'] | None
    spheres_curve_within: float | Literal['none'] | None
    spheres_fill_gaps: bool
    inlet: str | int | Sequence[float] | Sequence[str]
    seed: int
    spheres_until_full: bool
    spheres_group_size: int
    spheres_groups_per_set: int
    preset: Literal['fast', 'paper']
    motion: Literal['fall', 'skip', 'descend', 'granular']
    motion_gravity: float
    motion_integrator: Literal['explicit', 'semi-implicit']
    motion_dt: float | Literal['auto'] | None
    motion_restitution: float
    motion_sweeps: int
    threads: int
    move_tilt: float
    move_turn: float
    move_shake: float
    move_frequency: float | Literal['auto'] | None
    move_duration: float | Literal['auto'] | None
    freezing_rule: Literal['one-by-one', 'by-set']
    freezing_every_sets: int
    freezing_rest_speed: float
    freezing_rest_window: float
    freezing_set_time_limit: float
    rest: Literal['each', 'joint']
    friction: float
    fraction: float | Literal['loosest', 'densest', 'none'] | None
    rest_wall_friction: float | Literal['auto'] | None
    rest_rolling_friction: float
    rest_orientation: bool
    discard_rule: Literal['none', 'paper', 'exact']
    discard_epsilon: float
    discard_closeness: float
    search_spheres: Literal['all-pairs', 'grid']
    search_polygons: Literal['loop', 'list', 'quadtree', 'grid']
    search_neighbour_lists: bool
    frames_slow_motion: float | Literal['auto'] | None
    duration: float | Literal['auto'] | None
    frames_keep_run: bool | Literal['auto'] | None
    colour_running: str | int | Sequence[float] | Sequence[str]
    colour_frozen: str | int | Sequence[float] | Sequence[str]
    colour_discarded: str | int | Sequence[float] | Sequence[str]
    colour_active_polygon: str | int | Sequence[float] | Sequence[str]
    colour_discarded_polygon: str | int | Sequence[float] | Sequence[str]
    colour_text: str | int | Sequence[float] | Sequence[str]

def fill(
        mesh: str | PathLike[str] | Sequence[str | PathLike[str]] | None = ...,
        *,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        scene: str | PathLike[str] | None = ...,
        out: str | PathLike[str] | None = ...,
        overwrite: bool = ...,
        resume: bool = ...,
        progress: Callable[[Progress], Any] | bool | None = ...,
        **options: Unpack[FillOptions],
    ) -> Run: ...

def load(path: str | PathLike[str]) -> Run: ...

class Run:
    @property
    def last(self) -> Snapshot: ...
    def frame(self, number: Any) -> Snapshot: ...
    def __getitem__(self, index: int) -> Snapshot: ...
    def __len__(self) -> int: ...
    @property
    def frames(self) -> NDArray[numpy.uint64]: ...
    @property
    def vertices(self) -> NDArray[numpy.float64]: ...
    @property
    def triangles(self) -> NDArray[numpy.uint32]: ...
    @property
    def file(self) -> Path: ...
    @property
    def options(self) -> dict: ...
    @property
    def centres(self) -> NDArray[numpy.float64]: ...
    @property
    def radii(self) -> NDArray[numpy.float64]: ...
    @property
    def states(self) -> NDArray[numpy.uint8]: ...
    @property
    def groups(self) -> NDArray[numpy.uint32]: ...
    @property
    def contacts(self) -> NDArray[numpy.uint32]: ...
    @property
    def table(self) -> NDArray: ...
    @property
    def directory(self) -> Path: ...
    @property
    def summary(self) -> dict: ...
    @property
    def state_hash(self) -> str: ...
    def render(self, frame: int | None = ..., **options: Unpack[PictureOptions]) -> Picture: ...
    def draw(
        self,
        directory: str | PathLike[str],
        *,
        video: str | PathLike[str] | None = ...,
        overwrite: bool = ...,
        progress: Callable[[Progress], Any] | bool | None = ...,
        **options: Unpack[PictureOptions],
    ) -> int: ...
    def save(self, directory: str | PathLike[str], *, overwrite: bool = ...) -> Path: ...
    def export(
        self,
        path: str | PathLike[str],
        format: str | None = ...,
        *,
        frames: str | None = ...,
        overwrite: bool = ...,
        measure: str | Sequence[str] = ...,
        full_mesh: bool = ...,
        no_shell: bool = ...,
        lids: bool = ...,
        contacts: str | None = ...,
        resolution: int | None = ...,
        ascii: bool = ...,
        cell: float | None = ...,
        voxels: int | None = ...,
        threads: int | None = ...,
    ) -> list[Path]: ...

class Simulation:
    def __init__(self, mesh: str | PathLike[str] | None = ..., *, vertices: ArrayLike | None = ..., triangles: ArrayLike | None = ..., **options: Unpack[FillOptions]) -> None: ...
    def step(self) -> bool: ...
    def advance(self, steps: Any = None) -> int: ...
    def snapshot(self) -> Snapshot: ...
    def __iter__(self) -> Iterator[Snapshot]: ...
    def __next__(self) -> Snapshot: ...
    def render(self, **options: Unpack[PictureOptions]) -> Picture: ...
    def state_hash(self) -> str: ...
    def quality(self) -> QualityReport: ...
    @property
    def finished(self) -> bool: ...
    @property
    def full(self) -> bool: ...
    @property
    def inlets_reached(self) -> bool: ...
    @property
    def time(self) -> float: ...
    @property
    def time_step(self) -> float: ...
    @property
    def steps(self) -> int: ...
    @property
    def radius(self) -> float: ...
    @property
    def smallest_radius(self) -> float: ...
    @property
    def sizes(self) -> SizeReport | None: ...
    @property
    def sphere_count(self) -> int: ...
    @property
    def resting_count(self) -> int: ...
    @property
    def expected_spheres(self) -> int: ...
    @property
    def stray(self) -> int | None: ...
    @property
    def vertices(self) -> NDArray[numpy.float64]: ...
    @property
    def triangles(self) -> NDArray[numpy.uint32]: ...
    @property
    def options(self) -> dict: ...

class Snapshot:
    @property
    def table(self) -> NDArray[numpy.void]: ...
    @property
    def centres(self) -> NDArray[numpy.float64]: ...
    @property
    def radii(self) -> NDArray[numpy.float64]: ...
    @property
    def states(self) -> NDArray[numpy.uint8]: ...
    @property
    def groups(self) -> NDArray[numpy.uint32]: ...
    @property
    def speeds(self) -> NDArray[numpy.float32]: ...
    @property
    def contacts(self) -> NDArray[numpy.uint32]: ...
    @property
    def qx(self) -> NDArray[numpy.float32]: ...
    @property
    def qy(self) -> NDArray[numpy.float32]: ...
    @property
    def qz(self) -> NDArray[numpy.float32]: ...
    @property
    def qw(self) -> NDArray[numpy.float32]: ...
    @property
    def triangle_states(self) -> NDArray[numpy.uint8]: ...
    @property
    def changed(self) -> NDArray[numpy.uint32]: ...
    @property
    def rotation(self) -> NDArray[numpy.float64]: ...
    @property
    def offset(self) -> NDArray[numpy.float64]: ...
    @property
    def origin(self) -> NDArray[numpy.float64]: ...
    @property
    def time(self) -> float: ...
    @property
    def step(self) -> int: ...
    @property
    def frame(self) -> int: ...
    @property
    def set(self) -> int: ...
    @property
    def running(self) -> int: ...
    @property
    def frozen(self) -> int: ...
    @property
    def discarded(self) -> int: ...
    @property
    def discarded_triangles(self) -> int: ...
    def __len__(self) -> int: ...

class SphereState(enum.IntEnum):
    RUNNING = 0
    FROZEN = 1
    DISCARDED = 2

class Picture(NDArray[numpy.uint8]):
    def save(self, file: str | PathLike[str]) -> None: ...

class Progress(NamedTuple):
    fraction: float
    seconds_left: float | None
    spheres: int
    time: float
    stage: str

def read_packing(path: str | PathLike[str], *, radius: float | None = ..., columns: Mapping[str, str | int] | None = ...) -> Packing: ...

class Packing(NamedTuple):
    centres: NDArray[Any]
    radii: NDArray[Any]
    at_rest: NDArray[Any]
    format: str

def check(
        centres: ArrayLike,
        radii: ArrayLike,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        *,
        mesh: str | PathLike[str] | None = ...,
        box: ArrayLike | None = ...,
        periodic: bool = ...,
        at_rest: ArrayLike | None = ...,
        **options: Unpack[JudgeOptions],
    ) -> QualityReport: ...

class QualityReport:
    @property
    def max_overlap(self) -> float: ...
    @property
    def mean_overlap(self) -> float: ...
    @property
    def max_wall_overlap(self) -> float: ...
    @property
    def centres_outside(self) -> int: ...
    @property
    def not_finite(self) -> int: ...
    @property
    def unsupported(self) -> int: ...
    @property
    def energy_gain(self) -> float: ...
    @property
    def energy_excess(self) -> float: ...
    @property
    def mesh_volume(self) -> float: ...
    @property
    def sphere_volume(self) -> float: ...
    @property
    def volume_estimate(self) -> float: ...
    @property
    def volume_estimate_error(self) -> float: ...
    @property
    def equilibrium(self) -> EquilibriumReport | None: ...
    @property
    def heaps(self) -> List[HeapReport]: ...
    @property
    def settling(self) -> SettlingReport | None: ...

class EquilibriumReport:
    @property
    def friction(self) -> float: ...
    @property
    def spheres(self) -> int: ...
    @property
    def unbalanced(self) -> int: ...
    @property
    def largest(self) -> float: ...
    @property
    def settled(self) -> bool: ...
    @property
    def least_friction(self) -> float: ...

def analyse(
        centres: ArrayLike,
        radii: ArrayLike,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        *,
        mesh: str | PathLike[str] | None = ...,
        box: ArrayLike | None = ...,
        periodic: bool = ...,
        up: str = ...,
        centre: ArrayLike | None = ...,
        below: float | None = ...,
        forces: float | None = ...,
        bins: int = ...,
        range: float = ...,
        gap: float = ...,
        bond: float = ...,
        rattlers_below: int = ...,
        samples: int = ...,
        only: str | Sequence[str] = ...,
        threads: int = ...,
        **options: Unpack[LoadOptions],
    ) -> PackingAnalysis: ...

class PackingAnalysis:
    @property
    def ids(self) -> NDArray[numpy.uint32]: ...
    @property
    def centres(self) -> NDArray[numpy.float64]: ...
    @property
    def radii(self) -> NDArray[numpy.float64]: ...
    @property
    def wall_distances(self) -> NDArray[numpy.float64]: ...
    @property
    def depths(self) -> NDArray[numpy.float64]: ...
    @property
    def sphere_contacts(self) -> NDArray[numpy.uint32]: ...
    @property
    def wall_contacts(self) -> NDArray[numpy.uint32]: ...
    @property
    def rattlers(self) -> NDArray[numpy.uint8]: ...
    @property
    def cells(self) -> NDArray[numpy.uint8]: ...
    @property
    def cell_volumes(self) -> NDArray[numpy.float64]: ...
    @property
    def local_fractions(self) -> NDArray[numpy.float64]: ...
    @property
    def bonds(self) -> NDArray[numpy.uint32]: ...
    @property
    def q6(self) -> NDArray[numpy.float64]: ...
    @property
    def table(self) -> NDArray[numpy.void]: ...
    @property
    def porosity_height(self) -> NDArray[numpy.void]: ...
    @property
    def porosity_radial(self) -> NDArray[numpy.void]: ...
    @property
    def porosity_wall(self) -> NDArray[numpy.void]: ...
    @property
    def sizes_height(self) -> NDArray[numpy.void]: ...
    @property
    def sizes_radial(self) -> NDArray[numpy.void]: ...
    @property
    def pairs(self) -> NDArray[numpy.void]: ...
    @property
    def network(self) -> NDArray[numpy.void]: ...
    @property
    def forces(self) -> NDArray[numpy.float64]: ...
    @property
    def summary(self) -> dict: ...
    def save(self, folder: Any, overwrite: bool = False) -> List[str]: ...

def inspect(mesh: str | PathLike[str] | None = ..., *, vertices: ArrayLike | None = ..., triangles: ArrayLike | None = ..., **options: Unpack[LoadOptions]) -> Inspection: ...

class Inspection(NamedTuple):
    as_read: MeshReport
    filled: MeshReport | None
    repairs: list[str]
    refusal: str | None

class MeshReport:
    @property
    def vertices(self) -> int: ...
    @property
    def triangles(self) -> int: ...
    @property
    def components(self) -> int: ...
    @property
    def boundary_edges(self) -> int: ...
    @property
    def non_manifold_edges(self) -> int: ...
    @property
    def unbalanced_edges(self) -> int: ...
    @property
    def inconsistent_edges(self) -> int: ...
    @property
    def degenerate_triangles(self) -> int: ...
    @property
    def duplicate_triangles(self) -> int: ...
    @property
    def unused_vertices(self) -> int: ...
    @property
    def genus(self) -> int: ...
    @property
    def volume(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def crossed_triangles(self) -> int: ...
    @property
    def box(self) -> tuple: ...
    @property
    def closed(self) -> bool: ...

def volume(mesh: str | PathLike[str] | None = ..., *, vertices: ArrayLike | None = ..., triangles: ArrayLike | None = ..., **options: Unpack[FillOptions]) -> VolumeEstimate: ...

class VolumeEstimate:
    @property
    def volume(self) -> float: ...
    @property
    def error(self) -> float: ...
    @property
    def mesh_volume(self) -> float: ...
    @property
    def radius(self) -> float: ...
    @property
    def coarse(self) -> int: ...
    @property
    def fine(self) -> int: ...

class Error(Exception):
    ...
class Usage(Error, ValueError):
    code: int

class BadData(Error, ValueError):
    code: int

class InputMissing(Error, OSError):
    code: int

class Unavailable(Error):
    code: int

class Postcondition(Error):
    code: int

class OutOfMemory(Error, MemoryError):
    code: int

class CannotCreate(Error, OSError):
    code: int

class WriteFailed(Error, OSError):
    code: int

class StoppedEarly(Error):
    code: int

class ThresholdFailed(Error):
    code: int

