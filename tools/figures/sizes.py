# SPDX-License-Identifier: MIT
"""Size curves by mass of the cube, diameters 1:10, as asked and as achieved."""

from . import style, tables

RUNS = {"count": ("a count", style.BLUE, "s"),
        "full_within": ("until full, within 0.5 %", style.GREEN, "o"),
        "full": ("until no sphere fits", style.VERMILLION, "^")}


def measure(folder, quick):
    from . import runs
    largest = 0.5 if quick else 0.15
    curve = folder / "sizes-asked.csv"  # shares of the mass, evenly over the radii
    tables.write(curve, ("radius", "cumulative mass"), ((f"{largest / 10:g}", 0), (f"{largest:g}", 1)))
    rows = []
    for name, options in {"count": {"count": 100 if quick else 15000}, "full_within": {"count": None},
                          "full": {"count": None, "spheres_curve_within": None}}.items():
        run = runs.finished("cube", motion="descend", sizes=str(curve), **options)
        for point in run.sizes.points:
            rows.append((name, f"{point.radius:.6g}", f"{100 * point.asked:.5f}",
                         f"{100 * point.achieved:.5f}", run.sphere_count))
    tables.write(folder / "sizes.csv",
                 ("run", "radius", "asked_percent", "achieved_percent", "spheres"), rows)


def draw(folder):
    table = tables.read(folder / "sizes.csv")
    figure, (above, below) = style.panels(760, 560, 2, 1)
    asked = table.where(run="count")
    above.plot(asked["radius"], asked["asked_percent"], color=style.BLACK, label="asked")
    for name, (label, colour, mark) in RUNS.items():
        rows = table.where(run=name)
        above.plot(rows["radius"], rows["achieved_percent"], color=colour, marker=mark, linestyle="none",
                   label=label)
        below.plot(rows["radius"], rows["achieved_percent"] - rows["asked_percent"], color=colour,
                   marker=mark)
    above.set_ylabel("passing [% of the mass]")
    above.legend(loc="upper left")
    below.set(xlabel="radius [mesh unit]", ylabel="achieved less asked [%]")
    return figure
