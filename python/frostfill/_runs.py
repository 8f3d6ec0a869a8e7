# SPDX-License-Identifier: MIT
"""Runs that are kept: made by fill, or read from a folder."""

from __future__ import annotations

import json
import os
import shutil
import stat
import tempfile
import uuid
import weakref
from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _frostfill
from ._keywords import takes_options
from ._pictures import Picture
from ._progress import Progress, watching


class Run(_frostfill.KeptRun):
    """A run that was kept: its states, its mesh, and pictures of it.

    It is what frostfill.fill and frostfill.load give. Its arrays are those of the last state, and
    they are read-only views without a copy. len(run) is the number of frames, and iterating over a
    run gives the state of each.

    >>> run = fill("torus", count=30, duration=1, frames_fps=10)
    >>> [len(snapshot) for snapshot in run] == sorted(len(snapshot) for snapshot in run)
    True
    """

    @property
    def centres(self) -> NDArray[numpy.float64]:
        """float64 [n, 3]: centres of the spheres, in the unit and frame of the mesh."""
        return self.last.centres

    @property
    def radii(self) -> NDArray[numpy.float64]:
        """float64 [n]: radii, in the unit of the mesh."""
        return self.last.radii

    @property
    def states(self) -> NDArray[numpy.uint8]:
        """uint8 [n]: 0 running, 1 frozen, 2 discarded; see frostfill.SphereState."""
        return self.last.states

    @property
    def groups(self) -> NDArray[numpy.uint32]:
        """uint32 [n]: the group with which a sphere appeared, from 0."""
        return self.last.groups

    @property
    def contacts(self) -> NDArray[numpy.uint32]:
        """uint32 [n]: the number of contacts of each sphere at rest; see Snapshot.contacts."""
        return self.last.contacts

    @property
    def table(self) -> NDArray:
        """The spheres with named columns: x, y, z, radius, state, ...; see Snapshot.table.

        >>> run = fill("torus", count=30, duration=1, frames_fps=10)
        >>> run.table.dtype.names[:5], len(run.table["x"])
        (('x', 'y', 'z', 'radius', 'state'), 30)
        """
        return self.last.table

    @property
    def directory(self) -> Path:
        """The folder of the run's files. Without `out`, one that goes when the run does."""
        return self.file.parent

    @property
    def summary(self) -> dict:
        """What summary.json holds: scene, counts, errors, times. Empty for a run that did not end."""
        return json.loads(self.summary_text or "{}")

    @property
    def state_hash(self) -> str:
        """Hash of the bits of the last state: 16 hex digits, the same on every machine."""
        return self.summary.get("state_hash", "")

    @takes_options("pictures")
    def render(self, frame: int | None = None, **options) -> Picture:
        """Draws the state of a frame, the last one by default. What is not given is as in the run.

        >>> run = fill("torus", count=30, duration=1, frames_fps=10)
        >>> run.render(frame=0, size=(64, 48), style="studio").shape
        (48, 64, 3)
        """
        return self.draw_frame(frame, **options).view(Picture)

    @takes_options("pictures")
    def draw(
        self,
        directory: str | PathLike[str],
        *,
        video: str | PathLike[str] | None = None,
        overwrite: bool = False,
        progress: Callable[[Progress], object] | bool | None = None,
        **options,
    ) -> int:
        """Draws frames into a folder, as `frostfill render` does, and returns their number.

        video: a file .mp4, .webm or .gif, made with ffmpeg. progress: True shows a bar; see fill.
        """
        with watching(progress) as call:
            return self.draw_into(directory, video, overwrite, call, **options)

    def save(self, directory: str | PathLike[str], *, overwrite: bool = False) -> Path:
        """Keeps the run's files in a folder, for frostfill.load and for the program.

        Raises CannotCreate if the folder holds a run already, unless that may be overwritten, and
        if it holds anything else.
        """
        target = Path(os.fsdecode(directory))
        holds_run = (target / "summary.json").exists() or (target / self.file.name).exists()
        if target.exists() and target.resolve() == self.directory.resolve():
            return target
        if target.exists() and not (target.is_dir() and (holds_run or not any(target.iterdir()))):
            raise _frostfill.CannotCreate(f"'{target}' is there and holds no run: give another folder")
        if holds_run and not overwrite:
            raise _frostfill.CannotCreate(
                f"'{target}' holds a run already: give overwrite=True, or another folder"
            )
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
            fresh = target.with_name(f".{target.name}-{uuid.uuid4().hex}")
            fresh.mkdir()
            mode = stat.S_IMODE(fresh.stat().st_mode)  # copytree takes that of the other folder
            try:
                shutil.copytree(self.directory, fresh, dirs_exist_ok=True)
                os.chmod(fresh, mode)
                shutil.rmtree(target, ignore_errors=True)
                os.rename(fresh, target)
            finally:
                shutil.rmtree(fresh, ignore_errors=True)
        except (OSError, ValueError) as error:
            raise _frostfill.CannotCreate(f"'{target}' cannot be written: {error}") from error
        return target

    def export(
        self,
        path: str | PathLike[str],
        format: str | None = None,
        *,
        frames: str | None = None,
        overwrite: bool = False,
        measure: str | Sequence[str] = (),
        full_mesh: bool = False,
        no_shell: bool = False,
        lids: bool = False,
        contacts: str | None = None,
        resolution: int | None = None,
        ascii: bool = False,
        cell: float | None = None,
        voxels: int | None = None,
        threads: int | None = None,
    ) -> list[Path]:
        """Writes the run for other programs, and returns the files, the one to open first.

        Without a format, `path` is a file and its ending says what it is: .vtp, .xyz, .glb, .ply,
        .csv, .vti, .dump or .data (LAMMPS). With one, such as "vtp", "openfoam", "npy" or
        "liggghts", it is a folder. frames: "last", "all" or numbers and ranges such as
        "0..100:10". The other keywords are the options of `frostfill export`; a format refuses
        those that it does not take.
        """
        values = {
            "frames": frames,
            "measure": ([measure] if isinstance(measure, str) else list(measure)) or None,
            "contacts": contacts,
            "resolution": resolution,
            "cell": cell,
            "voxels": voxels,
            "threads": threads,
        }
        flags = {"overwrite": overwrite, "full_mesh": full_mesh, "no_shell": no_shell,
                 "lids": lids, "ascii": ascii}
        given = {name: value for name, value in values.items() if value is not None}
        given.update((name, True) for name, value in flags.items() if value)
        if format is not None:
            return self.export_into(_text(format, "format"), path, given)
        target = Path(os.fsdecode(path))
        ending = target.suffix[1:].lower()
        if ending not in _ENDINGS:
            raise _frostfill.Usage(
                f"'{target}' does not say its format: end it in .{', .'.join(_ENDINGS)}, or give a "
                "folder and a format"
            )
        if target.exists() and not overwrite:
            raise _frostfill.CannotCreate(f"'{target}' is there already: give overwrite=True")
        if ending == "vtp":
            given.setdefault("frames", "last")
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".frostfill-", dir=target.parent) as folder:
            files = self.export_into(_ENDINGS[ending], folder, given)
            return _move_to(target, [file for file in files if file.suffix == f".{ending}"])

    def __repr__(self) -> str:
        return f"<frostfill.Run of {len(self.radii)} spheres, {len(self)} frames, in {self.directory}>"

    def _repr_png_(self) -> bytes:
        """The last state, as a notebook shows it."""
        return self.render(size=(640, 360))._repr_png_()


# Formats that are one file of spheres, by its ending.
_ENDINGS = {"vtp": "vtp", "xyz": "xyz", "glb": "glb", "csv": "csv",
            "vti": "vti", "dump": "lammps-dump"}


def _text(value, name):
    if not isinstance(value, str):
        raise _frostfill.Usage(f"{name} is {value!r}, but it must be a str")
    return value


def _move_to(target, files):
    """The spheres to the target, and a mesh that belongs to them beside it."""
    meshes = [file for file in files if file.name.startswith("mesh")]
    spheres = [file for file in files if file not in meshes]
    if len(spheres) != 1 or len(meshes) > 1:
        raise _frostfill.Usage(
            f"these frames make {len(spheres)} files: give one frame, or a folder and a format"
        )
    moved = [target]
    os.replace(spheres[0], target)
    for mesh in meshes:
        moved.append(target.with_name(f"{target.stem}_mesh{target.suffix}"))
        os.replace(mesh, moved[-1])
    return moved


@takes_options("filling")
def fill(
    mesh: str | PathLike[str] | Sequence[str | PathLike[str]] | None = None,
    *,
    vertices: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    scene: str | PathLike[str] | None = None,
    out: str | PathLike[str] | None = None,
    overwrite: bool = False,
    resume: bool = False,
    progress: Callable[[Progress], object] | bool | None = None,
    **options,
) -> Run:
    """Fills a mesh with spheres, to the end of the run.

    mesh: "torus", "sphere", "cube", "human", a container such as "cylinder:1,4", or a mesh file; a
    list of files, or a folder, whose files are the patches of one mesh. Or give arrays: vertices, numbers
    [v, 3], and triangles, indices [t, 3]. Or a scene: a scene file, or the summary.json of a run.
    The mesh is repaired where that can be done; see frostfill.inspect.

    out: a folder for the files of the run, as `frostfill fill` writes them. Without it they are kept
    only for as long as the run; Run.save keeps them. No pictures are drawn unless `frames` is given.
    resume: continue the run in `out`.
    progress: True shows a bar: of tqdm where it is installed, otherwise a line of text. A function
    is called with a frostfill.Progress ten times a second; an exception in it stops the run.

    Ctrl-C stops after the step. Raises Error; Postcondition has the attribute `run`.

    >>> fill("torus", cuont=20)
    Traceback (most recent call last):
    TypeError: fill() has no keyword 'cuont'; did you mean 'count'?
    >>> fill("torus", count=-1)
    Traceback (most recent call last):
    frostfill.Usage: count is '-1', but it must be a whole number from 1 to 9007199254740992 or none
    >>> import numpy
    >>> corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> faces = numpy.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    >>> len(fill(vertices=corners, triangles=faces, count=12).centres)
    12
    """
    if out is None:
        if overwrite or resume:
            raise _frostfill.Usage("overwrite and resume need out, the folder of a run")
        # A folder of its own, as a run is never written into one that somebody made.
        folder = tempfile.mkdtemp(prefix="frostfill-")
        directory = os.path.join(folder, "run")
    else:
        folder = None
        directory = os.fsdecode(out)
    try:
        with watching(progress) as call:
            failures = _frostfill.fill_into(
                directory, mesh, vertices, triangles, scene, overwrite, resume, call, **options
            )
        run = Run(directory)
    except BaseException:
        if folder:
            shutil.rmtree(folder, ignore_errors=True)
        raise
    if folder:
        weakref.finalize(run, shutil.rmtree, folder, ignore_errors=True)
    for failure in filter(None, failures):
        error = _frostfill.Postcondition(failure)
        error.run = run
        raise error
    return run


def load(path: str | PathLike[str]) -> Run:
    """Reads a run that was kept: its folder, or its run.frost. Raises InputMissing or BadData.

    >>> load("nowhere")
    Traceback (most recent call last):
    frostfill.InputMissing: 'nowhere' is not there: give the directory of a run that was kept, or its run.frost
    """
    return Run(path)
