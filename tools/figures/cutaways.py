# SPDX-License-Identifier: MIT
"""The four objects, filled by the preset fast and cut open: above by state, below by set."""

from . import style, tables

SIDE, STRIP, BELOW, LEFT = 210, 24, 36, 24
AZIMUTH = 30  # [degree] of the camera; the quarter nearest to it is taken away


def measure(folder, quick):
    from . import runs
    rows, by_state, by_set = [], [], []
    for column, mesh in enumerate(runs.OBJECTS):
        run = runs.finished(mesh, count=60 if quick else 1500, azimuth=AZIMUTH,
                            cutaway=f"wedge:{AZIMUTH - 45},{AZIMUTH + 45}", **runs.panel(SIDE))
        state = run.snapshot()
        rows.append((mesh, column, len(state), state.frozen, state.discarded, state.discarded_triangles))
        by_state.append(run.render())
        by_set.append(run.render(color_by="set"))
    tables.write(folder / "cutaways.csv",
                 ("object", "column", "spheres", "frozen", "discarded", "polygons_discarded"), rows)
    style.save_picture(runs.joined(by_state + by_set, len(rows), STRIP), folder / "cutaways-panels.png")


def draw(folder):
    table = tables.read(folder / "cutaways.csv")
    panels = style.read_picture(folder / "cutaways-panels.png")
    height, width = panels.shape[0] + BELOW, panels.shape[1] + LEFT
    figure = style.canvas(width, height)
    figure.figimage(panels, LEFT, BELOW, origin="upper")
    for row, label in enumerate(("by state", "by set, first (dark) to last (bright)")):
        top = height - row * (SIDE + STRIP)
        figure.text(LEFT / 2 / width, (top - SIDE / 2) / height, label, rotation="vertical", ha="center",
                    va="center")
        for column, spheres in zip(table["column"], table["spheres"]):
            figure.text((LEFT + (column + 0.5) * SIDE) / width, (top - SIDE - STRIP / 2) / height,
                        f"{spheres:.0f} spheres", ha="center", va="center")
    figure.legend(handles=[style.swatch("frozen", style.STATES["frozen"]),
                           style.swatch("discarded", style.STATES["discarded"]),
                           style.swatch("discarded polygons", style.DISCARDED_POLYGON, "s")],
                  loc="lower center", ncols=3)
    return figure
