# SPDX-License-Identifier: MIT
"""The torus while it fills, as a run draws it."""

from . import style


def measure(folder, quick):
    from . import runs
    (moment,) = runs.moments("torus", [40 if quick else 200])
    style.save_picture(moment.render(), folder / "torus.png")


def draw(folder):
    return None
