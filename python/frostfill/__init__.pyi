# SPDX-License-Identifier: MIT
# Printed by python/make_stub.py from the module; a test compares. Do not edit.
import enum
from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

def fill(
        mesh: str | PathLike[str] | None = ...,
        *,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        scene: str | PathLike[str] | None = ...,
        out: str | PathLike[str] | None = ...,
        overwrite: bool = ...,
        resume: bool = ...,
        name: str | int | Sequence[float] | Sequence[str] = ...,
        preset: Literal['fast', 'paper'] = ...,
        up: Literal['x', 'y', 'z'] = ...,
        units: float | Literal['m', 'cm', 'mm', 'in', 'ft'] = ...,
        lid: bool = ...,
        cavity: bool = ...,
        wrap: float | Literal['auto', 'none'] | None = ...,
        unite: bool = ...,
        radius: float | tuple[float, float] | str | PathLike[str] | None = ...,
        sizes: str | int | Sequence[float] | Sequence[str] | None = ...,
        by: Literal['number', 'mass', 'volume'] | None = ...,
        curve_within: float | Literal['none'] | None = ...,
        fill_gaps: bool = ...,
        count: int | Literal['none'] | None = ...,
        until_full: bool = ...,
        group_size: int = ...,
        groups_per_set: int = ...,
        spheres_release: Literal['ceilings'] = ...,
        inlet: str | int | Sequence[float] | Sequence[str] = ...,
        seed: int = ...,
        gravity: float = ...,
        motion: Literal['fall', 'skip', 'descend', 'granular'] = ...,
        integrator: Literal['explicit', 'semi-implicit'] = ...,
        dt: float | Literal['auto'] | None = ...,
        restitution: float = ...,
        sweeps: int = ...,
        tilt: float = ...,
        turn: float = ...,
        shake: float = ...,
        shake_frequency: float | Literal['auto'] | None = ...,
        move_for: float | Literal['auto'] | None = ...,
        freeze_every: int = ...,
        freeze_by_set: bool = ...,
        freezing_rule: Literal['one-by-one', 'by-set'] | None = ...,
        rest_speed: float = ...,
        rest_window: float = ...,
        set_time_limit: float = ...,
        rest: Literal['each', 'joint'] = ...,
        friction: float = ...,
        wall_friction: float | Literal['auto'] | None = ...,
        fraction: float | Literal['loosest', 'densest', 'none'] | None = ...,
        orientation: bool = ...,
        rolling_friction: float = ...,
        judge_friction: float | Literal['none'] | None = ...,
        judge_rolling_friction: float | Literal['auto'] | None = ...,
        judge_unbalance: float = ...,
        threads: int = ...,
        discard: Literal['none', 'paper', 'exact'] = ...,
        discard_epsilon: float = ...,
        discard_closeness: float = ...,
        sphere_search: Literal['all-pairs', 'grid'] = ...,
        polygon_search: Literal['loop', 'list', 'quadtree', 'grid'] = ...,
        neighbour_lists: bool = ...,
        frames: str | int | Sequence[float] | Sequence[str] = ...,
        fps: float = ...,
        slow_motion: float | Literal['auto'] | None = ...,
        duration: float | Literal['auto'] | None = ...,
        max_frames: int = ...,
        hold: float = ...,
        passes: str | int | Sequence[float] | Sequence[str] = ...,
        keep_run: Literal['auto', 'on', 'off'] | bool = ...,
        size: str | int | Sequence[float] | Sequence[str] = ...,
        samples: int = ...,
        supersample: int = ...,
        style: Literal['clean', 'paper', 'dark', 'studio'] = ...,
        color_by: Literal['state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6'] = ...,
        cutaway: str | int | Sequence[float] | Sequence[str] = ...,
        ambient_occlusion: bool = ...,
        legend: bool = ...,
        shell: bool = ...,
        edges: Literal['auto', 'on', 'off'] | bool = ...,
        shell_opacity: float | Literal['auto'] | None = ...,
        ground: bool = ...,
        static_layer: Literal['on', 'off'] | bool = ...,
        background: str | int | Sequence[float] | Sequence[str] = ...,
        backend: Literal['auto', 'osmesa', 'egl', 'egl-hardware', 'egl-software', 'egl-surfaceless', 'builtin'] = ...,
        azimuth: float | Literal['auto'] | None = ...,
        elevation: float = ...,
        field_of_view: float = ...,
        zoom: float = ...,
        orthographic: bool = ...,
        target: Sequence[float] | Literal['auto'] | None = ...,
        distance: float | Literal['auto'] | None = ...,
        turntable: float | Literal['none'] | None = ...,
        colour_running: str | int | Sequence[float] | Sequence[str] = ...,
        colour_frozen: str | int | Sequence[float] | Sequence[str] = ...,
        colour_discarded: str | int | Sequence[float] | Sequence[str] = ...,
        colour_active_polygon: str | int | Sequence[float] | Sequence[str] = ...,
        colour_discarded_polygon: str | int | Sequence[float] | Sequence[str] = ...,
        colour_text: str | int | Sequence[float] | Sequence[str] = ...,
    ) -> Run:
    """Fills a mesh with spheres, to the end of the run.

    mesh: "torus", "sphere", "cube", "human", or a mesh file. Or give arrays: vertices, numbers
    [v, 3], and triangles, indices [t, 3]. Or a scene: a scene file, or the summary.json of a run.
    The mesh is repaired where that can be done; see frostfill.inspect.

    out: a folder for the files of the run, as `frostfill fill` writes them. Without it they are kept
    only for as long as the run; Run.save keeps them. No pictures are drawn unless `frames` is given.
    resume: continue the run in `out`.

    Ctrl-C stops after the step. Raises Error; Postcondition has the attribute `run`."""

def load(path: str | PathLike[str]) -> Run:
    """Reads a run that was kept: its folder, or its run.frost. Raises InputMissing or BadData."""

class Run:
    """A run that was kept: its states, its mesh, and pictures of it.

    It is what frostfill.fill and frostfill.load give. Its arrays are those of the last state, and
    they are read-only views without a copy. len(run) is the number of frames, and iterating over a
    run gives the state of each."""
    @property
    def last(self) -> Snapshot:
        """The last state: a Snapshot."""
    def frame(self, number: Any) -> Snapshot:
        """The state of a frame, by its number; -1 is the last. A Snapshot. Frames are read in order, so the next one is quick; for an earlier one reading starts again at the first."""
    def __getitem__(self, index: int) -> Snapshot:
        ...
    def __len__(self) -> int:
        ...
    @property
    def frames(self) -> NDArray[numpy.uint64]:
        """uint64 [f]: numbers of the frames that are kept, ascending."""
    @property
    def vertices(self) -> NDArray[numpy.float64]:
        """float64 [v, 3]: of the mesh as simulated, after repair."""
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """uint32 [t, 3]: indices into vertices, counter-clockwise seen from outside."""
    @property
    def file(self) -> Path:
        """pathlib.Path of the run file."""
    @property
    def options(self) -> dict:
        """All settings of the run, by keyword."""
    @property
    def centres(self) -> NDArray[numpy.float64]:
        """float64 [n, 3]: centres of the spheres, in the unit and frame of the mesh."""
    @property
    def radii(self) -> NDArray[numpy.float64]:
        """float64 [n]: radii, in the unit of the mesh."""
    @property
    def states(self) -> NDArray[numpy.uint8]:
        """uint8 [n]: 0 running, 1 frozen, 2 discarded; see frostfill.SphereState."""
    @property
    def groups(self) -> NDArray[numpy.uint32]:
        """uint32 [n]: the group with which a sphere appeared, from 0."""
    @property
    def contacts(self) -> NDArray[numpy.uint32]:
        """uint32 [n]: the number of contacts of each sphere at rest; see Snapshot.contacts."""
    @property
    def directory(self) -> Path:
        """The folder of the run's files. Without `out`, one that goes when the run does."""
    @property
    def summary(self) -> dict:
        """What summary.json holds: scene, counts, errors, times. Empty for a run that did not end."""
    @property
    def state_hash(self) -> str:
        """Hash of the bits of the last state: 16 hex digits, the same on every machine."""
    def render(
        self,
        frame: int | None = ...,
        *,
        frames: str | int | Sequence[float] | Sequence[str] = ...,
        fps: float = ...,
        max_frames: int = ...,
        hold: float = ...,
        passes: str | int | Sequence[float] | Sequence[str] = ...,
        size: str | int | Sequence[float] | Sequence[str] = ...,
        samples: int = ...,
        supersample: int = ...,
        style: Literal['clean', 'paper', 'dark', 'studio'] = ...,
        color_by: Literal['state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6'] = ...,
        cutaway: str | int | Sequence[float] | Sequence[str] = ...,
        ambient_occlusion: bool = ...,
        legend: bool = ...,
        shell: bool = ...,
        edges: Literal['auto', 'on', 'off'] | bool = ...,
        shell_opacity: float | Literal['auto'] | None = ...,
        ground: bool = ...,
        static_layer: Literal['on', 'off'] | bool = ...,
        background: str | int | Sequence[float] | Sequence[str] = ...,
        backend: Literal['auto', 'osmesa', 'egl', 'egl-hardware', 'egl-software', 'egl-surfaceless', 'builtin'] = ...,
        azimuth: float | Literal['auto'] | None = ...,
        elevation: float = ...,
        field_of_view: float = ...,
        zoom: float = ...,
        orthographic: bool = ...,
        target: Sequence[float] | Literal['auto'] | None = ...,
        distance: float | Literal['auto'] | None = ...,
        turntable: float | Literal['none'] | None = ...,
    ) -> Picture:
        """Draws the state of a frame, the last one by default. What is not given is as in the run."""
    def draw(
        self,
        directory: str | PathLike[str],
        *,
        video: str | PathLike[str] | None = ...,
        contact_sheet: bool = ...,
        camera_path: str = ...,
        overwrite: bool = ...,
        frames: str | int | Sequence[float] | Sequence[str] = ...,
        fps: float = ...,
        max_frames: int = ...,
        hold: float = ...,
        passes: str | int | Sequence[float] | Sequence[str] = ...,
        size: str | int | Sequence[float] | Sequence[str] = ...,
        samples: int = ...,
        supersample: int = ...,
        style: Literal['clean', 'paper', 'dark', 'studio'] = ...,
        color_by: Literal['state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6'] = ...,
        cutaway: str | int | Sequence[float] | Sequence[str] = ...,
        ambient_occlusion: bool = ...,
        legend: bool = ...,
        shell: bool = ...,
        edges: Literal['auto', 'on', 'off'] | bool = ...,
        shell_opacity: float | Literal['auto'] | None = ...,
        ground: bool = ...,
        static_layer: Literal['on', 'off'] | bool = ...,
        background: str | int | Sequence[float] | Sequence[str] = ...,
        backend: Literal['auto', 'osmesa', 'egl', 'egl-hardware', 'egl-software', 'egl-surfaceless', 'builtin'] = ...,
        azimuth: float | Literal['auto'] | None = ...,
        elevation: float = ...,
        field_of_view: float = ...,
        zoom: float = ...,
        orthographic: bool = ...,
        target: Sequence[float] | Literal['auto'] | None = ...,
        distance: float | Literal['auto'] | None = ...,
        turntable: float | Literal['none'] | None = ...,
    ) -> int:
        """Draws frames into a folder, as `frostfill render` does, and returns their number.

        video: a file .mp4, .webm or .gif, made with ffmpeg. camera_path: "0:30,20 8:120,45", or a
        file of such lines."""
    def save(self, directory: str | PathLike[str], *, overwrite: bool = ...) -> Path:
        """Keeps the run's files in a folder, for frostfill.load and for the program.

        Raises CannotCreate if the folder holds a run already, unless that may be overwritten, and
        if it holds anything else."""
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
    ) -> list[Path]:
        """Writes the run for other programs, and returns the files, the one to open first.

        Without a format, `path` is a file and its ending says what it is: .vtp, .xyz, .glb, .ply,
        .csv, .npz, .vti, .dump or .data (LAMMPS). With one, such as "vtp", "openfoam", "npy" or
        "liggghts", it is a folder. frames: "last", "all" or numbers and ranges such as
        "0..100:10". The other keywords are the options of `frostfill export`; a format refuses
        those that it does not take."""

class Simulation:
    """A run, step by step. Nothing is written.

    Iterating takes a step and gives the state after it, a Snapshot, until the run is over:"""
    def __init__(
        self,
        mesh: str | PathLike[str] | None = ...,
        *,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        name: str | int | Sequence[float] | Sequence[str] = ...,
        preset: Literal['fast', 'paper'] = ...,
        up: Literal['x', 'y', 'z'] = ...,
        units: float | Literal['m', 'cm', 'mm', 'in', 'ft'] = ...,
        lid: bool = ...,
        cavity: bool = ...,
        wrap: float | Literal['auto', 'none'] | None = ...,
        unite: bool = ...,
        radius: float | tuple[float, float] | str | PathLike[str] | None = ...,
        sizes: str | int | Sequence[float] | Sequence[str] | None = ...,
        by: Literal['number', 'mass', 'volume'] | None = ...,
        curve_within: float | Literal['none'] | None = ...,
        fill_gaps: bool = ...,
        count: int | Literal['none'] | None = ...,
        until_full: bool = ...,
        group_size: int = ...,
        groups_per_set: int = ...,
        spheres_release: Literal['ceilings'] = ...,
        inlet: str | int | Sequence[float] | Sequence[str] = ...,
        seed: int = ...,
        gravity: float = ...,
        motion: Literal['fall', 'skip', 'descend', 'granular'] = ...,
        integrator: Literal['explicit', 'semi-implicit'] = ...,
        dt: float | Literal['auto'] | None = ...,
        restitution: float = ...,
        sweeps: int = ...,
        tilt: float = ...,
        turn: float = ...,
        shake: float = ...,
        shake_frequency: float | Literal['auto'] | None = ...,
        move_for: float | Literal['auto'] | None = ...,
        freeze_every: int = ...,
        freeze_by_set: bool = ...,
        freezing_rule: Literal['one-by-one', 'by-set'] | None = ...,
        rest_speed: float = ...,
        rest_window: float = ...,
        set_time_limit: float = ...,
        rest: Literal['each', 'joint'] = ...,
        friction: float = ...,
        wall_friction: float | Literal['auto'] | None = ...,
        fraction: float | Literal['loosest', 'densest', 'none'] | None = ...,
        orientation: bool = ...,
        rolling_friction: float = ...,
        judge_friction: float | Literal['none'] | None = ...,
        judge_rolling_friction: float | Literal['auto'] | None = ...,
        judge_unbalance: float = ...,
        threads: int = ...,
        discard: Literal['none', 'paper', 'exact'] = ...,
        discard_epsilon: float = ...,
        discard_closeness: float = ...,
        sphere_search: Literal['all-pairs', 'grid'] = ...,
        polygon_search: Literal['loop', 'list', 'quadtree', 'grid'] = ...,
        neighbour_lists: bool = ...,
        frames: str | int | Sequence[float] | Sequence[str] = ...,
        fps: float = ...,
        slow_motion: float | Literal['auto'] | None = ...,
        duration: float | Literal['auto'] | None = ...,
        max_frames: int = ...,
        hold: float = ...,
        passes: str | int | Sequence[float] | Sequence[str] = ...,
        keep_run: Literal['auto', 'on', 'off'] | bool = ...,
        size: str | int | Sequence[float] | Sequence[str] = ...,
        samples: int = ...,
        supersample: int = ...,
        style: Literal['clean', 'paper', 'dark', 'studio'] = ...,
        color_by: Literal['state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6'] = ...,
        cutaway: str | int | Sequence[float] | Sequence[str] = ...,
        ambient_occlusion: bool = ...,
        legend: bool = ...,
        shell: bool = ...,
        edges: Literal['auto', 'on', 'off'] | bool = ...,
        shell_opacity: float | Literal['auto'] | None = ...,
        ground: bool = ...,
        static_layer: Literal['on', 'off'] | bool = ...,
        background: str | int | Sequence[float] | Sequence[str] = ...,
        backend: Literal['auto', 'osmesa', 'egl', 'egl-hardware', 'egl-software', 'egl-surfaceless', 'builtin'] = ...,
        azimuth: float | Literal['auto'] | None = ...,
        elevation: float = ...,
        field_of_view: float = ...,
        zoom: float = ...,
        orthographic: bool = ...,
        target: Sequence[float] | Literal['auto'] | None = ...,
        distance: float | Literal['auto'] | None = ...,
        turntable: float | Literal['none'] | None = ...,
        colour_running: str | int | Sequence[float] | Sequence[str] = ...,
        colour_frozen: str | int | Sequence[float] | Sequence[str] = ...,
        colour_discarded: str | int | Sequence[float] | Sequence[str] = ...,
        colour_active_polygon: str | int | Sequence[float] | Sequence[str] = ...,
        colour_discarded_polygon: str | int | Sequence[float] | Sequence[str] = ...,
        colour_text: str | int | Sequence[float] | Sequence[str] = ...,
    ) -> None:
        """Loads and repairs the mesh, as frostfill.fill does. Raises Error."""
    def step(self) -> bool:
        """Advances by one time step. Returns False when the run is over."""
    def advance(self, steps: Any = None) -> int:
        """Takes this many steps, or all to the end, without returning to Python in between. Returns how many were taken. Ctrl-C stops it after a step."""
    def snapshot(self) -> Snapshot:
        """The state as it is now: a Snapshot."""
    def __iter__(self) -> Iterator[Snapshot]:
        ...
    def __next__(self) -> Snapshot:
        ...
    def render(
        self,
        *,
        frames: str | int | Sequence[float] | Sequence[str] = ...,
        fps: float = ...,
        max_frames: int = ...,
        hold: float = ...,
        passes: str | int | Sequence[float] | Sequence[str] = ...,
        size: str | int | Sequence[float] | Sequence[str] = ...,
        samples: int = ...,
        supersample: int = ...,
        style: Literal['clean', 'paper', 'dark', 'studio'] = ...,
        color_by: Literal['state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6'] = ...,
        cutaway: str | int | Sequence[float] | Sequence[str] = ...,
        ambient_occlusion: bool = ...,
        legend: bool = ...,
        shell: bool = ...,
        edges: Literal['auto', 'on', 'off'] | bool = ...,
        shell_opacity: float | Literal['auto'] | None = ...,
        ground: bool = ...,
        static_layer: Literal['on', 'off'] | bool = ...,
        background: str | int | Sequence[float] | Sequence[str] = ...,
        backend: Literal['auto', 'osmesa', 'egl', 'egl-hardware', 'egl-software', 'egl-surfaceless', 'builtin'] = ...,
        azimuth: float | Literal['auto'] | None = ...,
        elevation: float = ...,
        field_of_view: float = ...,
        zoom: float = ...,
        orthographic: bool = ...,
        target: Sequence[float] | Literal['auto'] | None = ...,
        distance: float | Literal['auto'] | None = ...,
        turntable: float | Literal['none'] | None = ...,
    ) -> Picture:
        """Draws the state as it is now."""
    def state_hash(self) -> str:
        """Hash of the bits of all positions, and of which spheres are at rest: 16 hex digits."""
    def quality(self) -> QualityReport:
        """Judges the state as it is now: a QualityReport."""
    @property
    def finished(self) -> bool:
        """The run is over."""
    @property
    def full(self) -> bool:
        """The run is over because no sphere fits any more."""
    @property
    def inlets_reached(self) -> bool:
        """The run is over because no sphere comes through the inlets any more."""
    @property
    def time(self) -> float:
        """Simulated time, in seconds."""
    @property
    def time_step(self) -> float:
        """In seconds."""
    @property
    def steps(self) -> int:
        """Number of steps so far."""
    @property
    def radius(self) -> float:
        """The largest radius of the run, in the unit of the mesh."""
    @property
    def smallest_radius(self) -> float:
        """The smallest radius of the run, in the unit of the mesh."""
    @property
    def sizes(self) -> SizeReport | None:
        """The size curve so far beside the one of the keyword sizes; None without that."""
    @property
    def sphere_count(self) -> int:
        """Spheres that have appeared."""
    @property
    def resting_count(self) -> int:
        """Spheres at rest: frozen and discarded."""
    @property
    def expected_spheres(self) -> int:
        """The target of the run: the count, or an estimate if it fills until full."""
    @property
    def stray(self) -> int | None:
        """The sphere that stopped the run, because no sphere can be where it is; None if there is none."""
    @property
    def vertices(self) -> NDArray[numpy.float64]:
        """float64 [v, 3]: of the mesh as simulated, after repair."""
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """uint32 [t, 3]: indices into vertices, counter-clockwise seen from outside."""
    @property
    def options(self) -> dict:
        """All settings of the run, by keyword."""

class Snapshot:
    """A state of a run: arrays and counts.

    Arrays are read-only views of the library's own memory, made without a copy. They stay as they are
    for as long as you keep them; a simulation then takes other memory for its next states."""
    @property
    def centres(self) -> NDArray[numpy.float64]:
        """float64 [n, 3]: centres of the spheres, in the unit and frame of the mesh. Sphere k is row k, in order of appearance."""
    @property
    def radii(self) -> NDArray[numpy.float64]:
        """float64 [n]: radii, in the unit of the mesh."""
    @property
    def states(self) -> NDArray[numpy.uint8]:
        """uint8 [n]: 0 running, 1 frozen, 2 discarded; see frostfill.SphereState."""
    @property
    def groups(self) -> NDArray[numpy.uint32]:
        """uint32 [n]: the group with which a sphere appeared, from 0."""
    @property
    def speeds(self) -> NDArray[numpy.float32]:
        """float32 [n]: mesh units a second; 0 at rest."""
    @property
    def contacts(self) -> NDArray[numpy.uint32]:
        """uint32 [n]: of a sphere at rest: other spheres at rest, and pieces of wall, whose gap to it is below 0.01 of its radius; 0 while it runs."""
    @property
    def qx(self) -> NDArray[numpy.float32]:
        """float32 [n]: component of the unit quaternion that turns a sphere from how it appeared."""
    @property
    def qy(self) -> NDArray[numpy.float32]:
        """float32 [n]: component of the unit quaternion that turns a sphere from how it appeared."""
    @property
    def qz(self) -> NDArray[numpy.float32]:
        """float32 [n]: component of the unit quaternion that turns a sphere from how it appeared."""
    @property
    def qw(self) -> NDArray[numpy.float32]:
        """float32 [n]: component of the unit quaternion that turns a sphere from how it appeared."""
    @property
    def triangle_states(self) -> NDArray[numpy.uint8]:
        """uint8 [t]: 0 active, 1 discarded, of the triangles of the simulated mesh."""
    @property
    def changed(self) -> NDArray[numpy.uint32]:
        """uint32 [c]: ascending ids of the spheres that appeared, moved or changed their state since these arrays were last brought up to date. All of them, for the first."""
    @property
    def rotation(self) -> NDArray[numpy.float64]:
        """float64 [3, 3]: of a moved object. A point p of the mesh is at origin + offset + rotation @ (p - origin)."""
    @property
    def offset(self) -> NDArray[numpy.float64]:
        """float64 [3]: of a moved object, in the unit of the mesh."""
    @property
    def origin(self) -> NDArray[numpy.float64]:
        """float64 [3]: the middle of the mesh's box, in the frame of the mesh."""
    @property
    def time(self) -> float:
        """Simulated time, in seconds."""
    @property
    def step(self) -> int:
        """Number of time steps since the start."""
    @property
    def frame(self) -> int:
        """Number of the frame in a run that was kept; 0 in a simulation."""
    @property
    def set(self) -> int:
        """Index of the newest set."""
    @property
    def running(self) -> int:
        """Number of running spheres."""
    @property
    def frozen(self) -> int:
        """Number of frozen spheres."""
    @property
    def discarded(self) -> int:
        """Number of discarded spheres."""
    @property
    def discarded_triangles(self) -> int:
        """Number of discarded triangles."""
    def __len__(self) -> int:
        ...

class SphereState(enum.IntEnum):
    """The numbers in the arrays of states."""
    RUNNING = 0
    FROZEN = 1
    DISCARDED = 2

class Picture(NDArray[numpy.uint8]):
    """A picture: uint8 [height, width, 3 or 4], sRGB, rows from the top; the fourth is alpha.

    A NumPy array that shows itself in a notebook."""
    def save(self, file: str | PathLike[str]) -> None:
        """Writes a PNG file; an incomplete one never appears."""

def read_packing(path: str | PathLike[str], *, radius: float | None = ..., columns: Mapping[str, str | int] | None = ...) -> Packing:
    """Reads spheres from a file of any program, for frostfill.check and frostfill.analyse.

    path: a run, a table (CSV), XYZ, a dump or data file of LAMMPS or LIGGGHTS, the text of YADE,
    a data file of MercuryDPM, particle_input.dat of MFiX, or the binary of packing-generation; of several
    moments the last. radius: of all
    spheres of a file that has none. columns: which columns of a table are x, y, z and radius or
    diameter, by name or by number from 1, where they have other names."""

class Packing(NamedTuple):
    """A packing from a file: spheres in the coordinates of their mesh."""
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
        at_rest: ArrayLike | None = ...,
        up: Literal['x', 'y', 'z'] = ...,
        lid: bool = ...,
        cavity: bool = ...,
        wrap: float | Literal['auto', 'none'] | None = ...,
        unite: bool = ...,
        judge_friction: float | Literal['none'] | None = ...,
        judge_rolling_friction: float | Literal['auto'] | None = ...,
        judge_unbalance: float = ...,
    ) -> QualityReport:
    """Judges spheres in a mesh, from any source.

    centres: numbers [n, 3]; radii: [n], or one number. The mesh: vertices [v, 3] and triangles
    [t, 3], or `mesh`, a name or a file. at_rest: bool [n], whose weight has to be carried; all by
    default."""

class QualityReport:
    """The quality of a packing. Overlaps are depths over the radius, the smaller of two."""
    @property
    def max_overlap(self) -> float:
        """[r] the largest overlap of two spheres"""
    @property
    def mean_overlap(self) -> float:
        """[r] over all pairs that touch or overlap"""
    @property
    def max_wall_overlap(self) -> float:
        """[r] the largest overlap of sphere and mesh"""
    @property
    def centres_outside(self) -> int:
        """by winding number"""
    @property
    def not_finite(self) -> int:
        """spheres whose position is not a number"""
    @property
    def unsupported(self) -> int:
        """spheres at rest whose contacts cannot carry their weight"""
    @property
    def energy_gain(self) -> float:
        """largest growth of the total energy in a step, over that of a fall; 0 without a run"""
    @property
    def energy_excess(self) -> float:
        """largest excess of the energy over its start plus the work done, over that of a fall; 0 without a run"""
    @property
    def restored_discards(self) -> int:
        """times that all discards were taken back; 0 without a run"""
    @property
    def mesh_volume(self) -> float:
        """[unit^3]"""
    @property
    def sphere_volume(self) -> float:
        """[unit^3] of all spheres"""
    @property
    def volume_estimate(self) -> float:
        """[unit^3] of the mesh, estimated from the number of spheres; NaN unless full of equal ones"""
    @property
    def volume_estimate_error(self) -> float:
        """[unit^3] its uncertainty"""
    @property
    def equilibrium(self) -> EquilibriumReport | None:
        """whether all that is at rest stays so together; None unless judge_friction is given"""
    @property
    def heaps(self) -> List[HeapReport]:
        """the heap below each inlet"""
    @property
    def settling(self) -> SettlingReport | None:
        """how all settled together; None unless rest is joint"""

class EquilibriumReport:
    """Whether forces in all contacts at once balance all spheres at rest, under a friction."""
    @property
    def friction(self) -> float:
        """under which it was judged"""
    @property
    def spheres(self) -> int:
        """at rest"""
    @property
    def unbalanced(self) -> int:
        """spheres that miss more than judge_unbalance of their weight"""
    @property
    def largest(self) -> float:
        """[own weight] what is missing on a sphere at most"""
    @property
    def settled(self) -> bool:
        """False: forces were still changing when they were taken"""
    @property
    def least_friction(self) -> float:
        """with which all but one in a hundred are balanced; inf: none up to 8"""

def analyse(
        centres: ArrayLike,
        radii: ArrayLike,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        *,
        mesh: str | PathLike[str] | None = ...,
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
        lid: bool = ...,
        cavity: bool = ...,
        wrap: float | Literal['auto', 'none'] | None = ...,
        unite: bool = ...,
    ) -> PackingAnalysis:
    """Analyses spheres in a mesh: porosity, neighbours, contacts, Voronoi cells, order and sizes.

    Spheres and mesh as for frostfill.check. The keywords are the options of `frostfill analyse`;
    only: names, of porosity, pairs, contacts, cells, order and sizes."""

class PackingAnalysis:
    """What frostfill.analyse found."""
    @property
    def ids(self) -> NDArray[numpy.uint32]:
        """uint32 [n] place in `centres` of each sphere that counts: not outside, and a number"""
    @property
    def centres(self) -> NDArray[numpy.float64]:
        """float64 [n, 3]"""
    @property
    def radii(self) -> NDArray[numpy.float64]:
        """float64 [n]"""
    @property
    def wall_distances(self) -> NDArray[numpy.float64]:
        """float64 [n] from the centre to the wall"""
    @property
    def sphere_contacts(self) -> NDArray[numpy.uint32]:
        """uint32 [n] other spheres that each touches"""
    @property
    def wall_contacts(self) -> NDArray[numpy.uint32]:
        """uint32 [n] pieces of wall that each touches"""
    @property
    def rattlers(self) -> NDArray[numpy.uint8]:
        """uint8 [n] 1 for each that its contacts do not hold"""
    @property
    def cells(self) -> NDArray[numpy.uint8]:
        """uint8 [n] Voronoi cells: 0 whole, 1 cut by a wall, 2 open, 3 none"""
    @property
    def cell_volumes(self) -> NDArray[numpy.float64]:
        """float64 [n] [unit^3] NaN unless whole"""
    @property
    def local_fractions(self) -> NDArray[numpy.float64]:
        """float64 [n] share of the cell that the sphere fills; NaN unless whole"""
    @property
    def bonds(self) -> NDArray[numpy.uint32]:
        """uint32 [n] spheres near enough for Q6"""
    @property
    def q6(self) -> NDArray[numpy.float64]:
        """float64 [n]"""
    @property
    def porosity_height(self) -> NDArray[numpy.float64]:
        """float64 [rows, 5] from, to, porosity, its standard error, volume of the object there"""
    @property
    def porosity_radial(self) -> NDArray[numpy.float64]:
        """float64 [rows, 5] from, to, porosity, its standard error, volume of the object there"""
    @property
    def porosity_wall(self) -> NDArray[numpy.float64]:
        """float64 [rows, 5] from, to, porosity, its standard error, volume of the object there"""
    @property
    def sizes_height(self) -> NDArray[numpy.float64]:
        """float64 [rows, 5] from, to, spheres, mean radius, standard deviation of the radii"""
    @property
    def sizes_radial(self) -> NDArray[numpy.float64]:
        """float64 [rows, 5] from, to, spheres, mean radius, standard deviation of the radii"""
    @property
    def pairs(self) -> NDArray[numpy.float64]:
        """float64 [rows, 4] from, to, g(r), neighbours up to `to`"""
    @property
    def network(self) -> NDArray[numpy.float64]:
        """float64 [contacts, 3] rows of the two spheres in the lists, and the gap between them"""
    @property
    def forces(self) -> NDArray[numpy.float64]:
        """float64 [contacts, 3] [weight of a mean sphere] on the first sphere of each row of network, if forces were asked for; what they leave is summary's largest_unbalance"""
    @property
    def summary(self) -> dict:
        """what summary.json holds: means, counts and settings"""
    def save(self, folder: Any, overwrite: bool = False) -> List[str]:
        """Writes the tables, the files for ParaView and summary.json into a folder, as the command does, and returns their names."""

def inspect(
        mesh: str | PathLike[str] | None = ...,
        *,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        lid: bool = ...,
        cavity: bool = ...,
        wrap: float | Literal['auto', 'none'] | None = ...,
        unite: bool = ...,
    ) -> Inspection:
    """Inspects a mesh: its defects, its repairs, and whether it can be filled."""

class Inspection(NamedTuple):
    """What frostfill.inspect found."""
    as_read: MeshReport
    filled: MeshReport | None
    repairs: list[str]
    refusal: str | None

class MeshReport:
    """Facts about a mesh. Counts are exact."""
    @property
    def vertices(self) -> int:
        """number of vertices"""
    @property
    def triangles(self) -> int:
        """number of triangles"""
    @property
    def components(self) -> int:
        """pieces connected through shared edges"""
    @property
    def boundary_edges(self) -> int:
        """edges with one triangle: the rim of a hole"""
    @property
    def non_manifold_edges(self) -> int:
        """edges with three triangles or more"""
    @property
    def unbalanced_edges(self) -> int:
        """those of them whose windings do not cancel"""
    @property
    def inconsistent_edges(self) -> int:
        """edges whose two triangles have opposite windings"""
    @property
    def degenerate_triangles(self) -> int:
        """triangles without area"""
    @property
    def duplicate_triangles(self) -> int:
        """triangles that are there twice"""
    @property
    def unused_vertices(self) -> int:
        """vertices without a triangle"""
    @property
    def genus(self) -> int:
        """handles over all components; of a closed mesh"""
    @property
    def volume(self) -> float:
        """[unit^3] of the interior; of an open mesh a signed sum"""
    @property
    def area(self) -> float:
        """[unit^2]"""
    @property
    def crossed_triangles(self) -> int:
        """triangles that meet others away from their edges"""
    @property
    def box(self) -> tuple:
        """the lowest and the highest corner of the mesh's box, each float64 [3]"""
    @property
    def closed(self) -> bool:
        """whether the windings at every edge cancel"""

def volume(
        mesh: str | PathLike[str] | None = ...,
        *,
        vertices: ArrayLike | None = ...,
        triangles: ArrayLike | None = ...,
        name: str | int | Sequence[float] | Sequence[str] = ...,
        preset: Literal['fast', 'paper'] = ...,
        up: Literal['x', 'y', 'z'] = ...,
        units: float | Literal['m', 'cm', 'mm', 'in', 'ft'] = ...,
        lid: bool = ...,
        cavity: bool = ...,
        wrap: float | Literal['auto', 'none'] | None = ...,
        unite: bool = ...,
        radius: float | tuple[float, float] | str | PathLike[str] | None = ...,
        sizes: str | int | Sequence[float] | Sequence[str] | None = ...,
        by: Literal['number', 'mass', 'volume'] | None = ...,
        curve_within: float | Literal['none'] | None = ...,
        fill_gaps: bool = ...,
        count: int | Literal['none'] | None = ...,
        until_full: bool = ...,
        group_size: int = ...,
        groups_per_set: int = ...,
        spheres_release: Literal['ceilings'] = ...,
        inlet: str | int | Sequence[float] | Sequence[str] = ...,
        seed: int = ...,
        gravity: float = ...,
        motion: Literal['fall', 'skip', 'descend', 'granular'] = ...,
        integrator: Literal['explicit', 'semi-implicit'] = ...,
        dt: float | Literal['auto'] | None = ...,
        restitution: float = ...,
        sweeps: int = ...,
        tilt: float = ...,
        turn: float = ...,
        shake: float = ...,
        shake_frequency: float | Literal['auto'] | None = ...,
        move_for: float | Literal['auto'] | None = ...,
        freeze_every: int = ...,
        freeze_by_set: bool = ...,
        freezing_rule: Literal['one-by-one', 'by-set'] | None = ...,
        rest_speed: float = ...,
        rest_window: float = ...,
        set_time_limit: float = ...,
        rest: Literal['each', 'joint'] = ...,
        friction: float = ...,
        wall_friction: float | Literal['auto'] | None = ...,
        fraction: float | Literal['loosest', 'densest', 'none'] | None = ...,
        orientation: bool = ...,
        rolling_friction: float = ...,
        judge_friction: float | Literal['none'] | None = ...,
        judge_rolling_friction: float | Literal['auto'] | None = ...,
        judge_unbalance: float = ...,
        threads: int = ...,
        discard: Literal['none', 'paper', 'exact'] = ...,
        discard_epsilon: float = ...,
        discard_closeness: float = ...,
        sphere_search: Literal['all-pairs', 'grid'] = ...,
        polygon_search: Literal['loop', 'list', 'quadtree', 'grid'] = ...,
        neighbour_lists: bool = ...,
        frames: str | int | Sequence[float] | Sequence[str] = ...,
        fps: float = ...,
        slow_motion: float | Literal['auto'] | None = ...,
        duration: float | Literal['auto'] | None = ...,
        max_frames: int = ...,
        hold: float = ...,
        passes: str | int | Sequence[float] | Sequence[str] = ...,
        keep_run: Literal['auto', 'on', 'off'] | bool = ...,
        size: str | int | Sequence[float] | Sequence[str] = ...,
        samples: int = ...,
        supersample: int = ...,
        style: Literal['clean', 'paper', 'dark', 'studio'] = ...,
        color_by: Literal['state', 'group', 'set', 'speed', 'height', 'contacts', 'unbalance', 'wall_distance', 'sphere_contacts', 'wall_contacts', 'rattler', 'cell', 'local_fraction', 'bonds', 'q6'] = ...,
        cutaway: str | int | Sequence[float] | Sequence[str] = ...,
        ambient_occlusion: bool = ...,
        legend: bool = ...,
        shell: bool = ...,
        edges: Literal['auto', 'on', 'off'] | bool = ...,
        shell_opacity: float | Literal['auto'] | None = ...,
        ground: bool = ...,
        static_layer: Literal['on', 'off'] | bool = ...,
        background: str | int | Sequence[float] | Sequence[str] = ...,
        backend: Literal['auto', 'osmesa', 'egl', 'egl-hardware', 'egl-software', 'egl-surfaceless', 'builtin'] = ...,
        azimuth: float | Literal['auto'] | None = ...,
        elevation: float = ...,
        field_of_view: float = ...,
        zoom: float = ...,
        orthographic: bool = ...,
        target: Sequence[float] | Literal['auto'] | None = ...,
        distance: float | Literal['auto'] | None = ...,
        turntable: float | Literal['none'] | None = ...,
        colour_running: str | int | Sequence[float] | Sequence[str] = ...,
        colour_frozen: str | int | Sequence[float] | Sequence[str] = ...,
        colour_discarded: str | int | Sequence[float] | Sequence[str] = ...,
        colour_active_polygon: str | int | Sequence[float] | Sequence[str] = ...,
        colour_discarded_polygon: str | int | Sequence[float] | Sequence[str] = ...,
        colour_text: str | int | Sequence[float] | Sequence[str] = ...,
    ) -> VolumeEstimate:
    """Estimates the volume of a mesh by filling it with spheres, and with spheres half as large."""

class VolumeEstimate:
    """An object's volume, estimated from fillings with spheres."""
    @property
    def volume(self) -> float:
        """[unit^3] the estimate"""
    @property
    def error(self) -> float:
        """[unit^3] its uncertainty"""
    @property
    def mesh_volume(self) -> float:
        """[unit^3] of the mesh itself, to compare with"""
    @property
    def radius(self) -> float:
        """[unit] of the coarse spheres; the fine ones have half of it"""
    @property
    def coarse(self) -> int:
        """spheres of the radius that fit, a mean over seeds"""
    @property
    def fine(self) -> int:
        """spheres of half the radius that fit"""

class Error(Exception):
    """An error of the library: one sentence says what is wrong, where, and what to do."""

class Usage(Error, ValueError):
    """A call or a value that makes no sense."""
    code: int

class BadData(Error, ValueError):
    """A mesh, packing or scene that cannot be used."""
    code: int

class InputMissing(Error, OSError):
    """An input file does not exist or cannot be read."""
    code: int

class Unavailable(Error):
    """OpenGL or a program that is needed is missing."""
    code: int

class Postcondition(Error):
    """The result is wrong: a sphere outside the mesh, an overlap, a blank picture."""
    code: int

class OutOfMemory(Error, MemoryError):
    """There is too little memory."""
    code: int

class CannotCreate(Error, OSError):
    """A file or directory cannot be created."""
    code: int

class WriteFailed(Error, OSError):
    """Writing failed, for instance on a full disk."""
    code: int

class StoppedEarly(Error):
    """Stopped before the end."""
    code: int

class ThresholdFailed(Error):
    """A comparison failed."""
    code: int

