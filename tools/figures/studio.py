# SPDX-License-Identifier: MIT
"""The torus while it fills, with smaller spheres, in the style for covers."""

from . import style


def measure(folder, quick):
    from . import runs
    count = 60 if quick else 1500
    (moment,) = runs.moments("torus", [count * 5 // 8], count=count, spheres_group_size=40, style="studio")
    style.save_picture(moment.render(), folder / "studio.png")


def draw(folder):
    return None
