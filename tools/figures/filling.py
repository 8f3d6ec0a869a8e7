# SPDX-License-Identifier: MIT
"""The four objects while they fill, with the paper's method."""

from . import style, tables

COLUMNS, SIDE, STRIP, BELOW = 5, 190, 24, 36


def measure(folder, quick):
    from . import runs
    rows, pictures = [], []
    for row, mesh in enumerate(runs.OBJECTS):
        options = dict(preset="paper", **runs.GRIDS, **runs.panel(SIDE), **({"count": 40} if quick else {}))
        count = runs.frostfill.Simulation(mesh, **options).expected_spheres
        spheres = [count * column // COLUMNS for column in range(1, COLUMNS)] + [float("inf")]
        for column, moment in enumerate(runs.moments(mesh, spheres, **options)):
            state = moment.snapshot()
            rows.append((mesh, column, row, len(state), state.running, state.frozen, state.discarded,
                         state.discarded_triangles))
            pictures.append(moment.render())
    tables.write(folder / "filling.csv",
                 ("object", "column", "row", "spheres", "running", "frozen", "discarded",
                  "polygons_discarded"), rows)
    style.save_picture(runs.joined(pictures, COLUMNS, STRIP), folder / "filling-panels.png")


def draw(folder):
    table = tables.read(folder / "filling.csv")
    panels = style.read_picture(folder / "filling-panels.png")
    height, width = panels.shape[:2]
    figure = style.canvas(width, height + BELOW)
    figure.figimage(panels, 0, BELOW, origin="upper")
    for column, row, spheres in zip(table["column"], table["row"], table["spheres"]):
        y = height + BELOW - (row + 1) * (SIDE + STRIP) + STRIP / 2
        figure.text((column + 0.5) * SIDE / width, y / (height + BELOW), f"{spheres:.0f} spheres",
                    ha="center", va="center")
    figure.legend(handles=[style.swatch(name, colour) for name, colour in style.STATES.items()],
                  loc="lower center", ncols=3)
    return figure
