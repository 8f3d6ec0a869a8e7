# SPDX-License-Identifier: MIT
"""Shares of discarded spheres and polygons while 2,000 spheres fill each object, by both rules."""

from . import style, tables

RULES = {"exact": "exact: by reachability", "paper": "paper: by height and covered vertices"}


def measure(folder, quick):
    from . import runs
    rows = []
    for mesh in runs.OBJECTS:
        for rule, options in {"paper": {"preset": "paper", **runs.GRIDS}, "exact": {}}.items():
            try:
                run = runs.frostfill.fill(mesh, count=60 if quick else 2000, spheres_group_size=10,
                                          spheres_groups_per_set=2, **options)
            except runs.frostfill.Postcondition as outside:  # the paper's method loses some
                run = outside.run
            sets = tables.read(run.directory / "sets.csv")
            present = 0
            for row in sets.rows:
                present += int(row["spheres"])
                rows.append((mesh, rule, f"{100 * present / len(run.centres):.3f}", present,
                             f"{100 * int(row['discarded']) / present:.3f}",
                             f"{100 * int(row['discarded_polygons']) / len(run.triangles):.3f}"))
    tables.write(folder / "discarded.csv",
                 ("object", "rule", "present_percent", "spheres", "discarded_spheres_percent",
                  "discarded_polygons_percent"), rows)


def draw(folder):
    table = tables.read(folder / "discarded.csv")
    figure, axes = style.panels(860, 660, 2, 2)
    for row, (column, label) in enumerate((
            ("discarded_spheres_percent", "spheres discarded [% of those present]"),
            ("discarded_polygons_percent", "polygons discarded [% of the mesh]"))):
        for ax, (rule, title) in zip(axes[row], RULES.items()):
            for name, (colour, mark) in style.OBJECTS.items():
                rows = table.where(object=name, rule=rule)
                ax.plot(rows["present_percent"], rows[column], color=colour, marker=mark,
                        markevery=14, label=name)
            ax.set(xlim=(0, 100), ylim=(0, 100))
            if row == 0:
                ax.set_title(title)
            else:
                ax.set_xlabel("spheres present [% of all]")
        axes[row][0].set_ylabel(label)
    style.legend_below(figure, axes[0][0].get_legend_handles_labels(), 4)
    return figure
