# SPDX-License-Identifier: MIT
"""Shares of discarded spheres and polygons while 2,000 spheres fill each object, by both rules."""

from . import style, tables

RULES = {"exact": "exact: by reachability", "paper": "paper: by height and covered vertices"}


def measure(folder, quick):
    from . import runs
    rows = []
    for mesh in runs.OBJECTS:
        for rule, options in {"paper": {"preset": "paper", **runs.GRIDS}, "exact": {}}.items():
            run = runs.frostfill.Simulation(mesh, count=60 if quick else 2000, spheres_group_size=10,
                                            spheres_groups_per_set=2, **options)
            ends = []
            while run.step():
                state = run.snapshot()
                if state.set == len(ends):  # a set has ended
                    ends.append(state)
                ends[-1] = state
            ends[-1] = run.snapshot()
            rows += [(mesh, rule, f"{100 * len(state) / len(ends[-1]):.3f}", len(state),
                      f"{100 * state.discarded / len(state):.3f}",
                      f"{100 * state.discarded_triangles / len(run.triangles):.3f}") for state in ends]
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
