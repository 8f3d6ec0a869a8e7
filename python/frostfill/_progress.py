# SPDX-License-Identifier: MIT
"""How far work is: for a function of the caller, or as a bar."""

from __future__ import annotations

import contextlib
import sys
import time
import warnings
from collections.abc import Callable
from typing import NamedTuple

from . import _frostfill


class Progress(NamedTuple):
    """How far a run is. A function that is given as `progress` gets one, ten times a second."""

    fraction: float  # done, from 0 to 1; pictures of a run that was filled begin at 0 again
    seconds_left: float | None  # estimated; None where nothing is known
    spheres: int  # that have appeared
    time: float  # [s] simulated
    stage: str  # "spheres" or "pictures"


@contextlib.contextmanager
def watching(progress: Callable[[Progress], object] | bool | None):
    """What the library calls while it works; None for no progress. Ends with the fraction 1."""
    if progress is None or progress is False:
        yield None
        return
    if progress is not True and not callable(progress):
        raise _frostfill.Usage(f"progress is {progress!r}, but it must be True or a function")
    with (_bar() if progress is True else contextlib.nullcontext(progress)) as show:
        began, stage, last = time.monotonic(), None, (0, 0.0)

        def call(fraction, draws, settles, spheres, simulated):
            nonlocal began, stage, last
            if draws and fraction == 0:
                return  # nothing is drawn yet, or nothing at all
            now = "pictures" if draws else "spheres"
            if now != stage:
                began, stage = time.monotonic(), now
            taken, last = time.monotonic() - began, (spheres, simulated)
            known = fraction > 0 and taken > 0 and not settles
            show(Progress(fraction, taken * (1 - fraction) / fraction if known else None, *last, now))

        yield call
        show(Progress(1.0, 0.0, *last, stage or "spheres"))


@contextlib.contextmanager
def _bar():
    """A bar of tqdm, in a notebook one of its own; without tqdm, a line of text."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a notebook without ipywidgets has a bar of text
            from tqdm.auto import tqdm

            bar = tqdm(total=1.0, bar_format="{percentage:3.0f} % |{bar}| {elapsed}, {remaining} left")
    except ImportError:
        try:
            yield _show_line
        finally:
            print(file=sys.stderr)
        return

    def show(progress):
        bar.n = progress.fraction
        bar.refresh()

    with bar:
        yield show


def _show_line(progress):
    left = "" if progress.seconds_left is None else f", {progress.seconds_left:.0f} s left"
    text = f"{100 * progress.fraction:3.0f} % of the {progress.stage}{left}"
    print(f"\r{text:40}", end="", file=sys.stderr, flush=True)
