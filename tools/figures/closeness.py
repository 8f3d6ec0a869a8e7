# SPDX-License-Identifier: MIT
"""PAPER, 51 %: what covers a polygon against what is discarded and what escapes."""

from . import style, tables

CLOSENESSES = (0.3, 0.6, 1, 1.5, 2, 3)  # [r]; the first is the default
PAPER = {"torus": 51, "sphere": 0.4, "cube": 0.8, "human": 0.6}


def measure(folder, quick):
    from . import runs
    rows = []
    for mesh in runs.OBJECTS:
        for closeness in CLOSENESSES:
            options = {"count": 60} if quick else {}
            run = runs.finished(mesh, preset="paper", discard_closeness=closeness, **runs.GRIDS, **options)
            quality = run.quality()
            share = 100 * run.snapshot().discarded_triangles / len(run.triangles)
            rows.append((mesh, f"{closeness:g}", run.sphere_count, f"{share:.1f}", f"{PAPER[mesh]:g}",
                         quality.centres_outside, f"{quality.max_overlap:.2f}",
                         f"{quality.max_wall_overlap:.2f}", quality.unsupported))
    tables.write(folder / "closeness.csv",
                 ("object", "closeness", "spheres", "polygons_percent", "paper_percent", "outside",
                  "max_overlap", "max_in_wall", "unsupported"), rows)


def draw(folder):
    table = tables.read(folder / "closeness.csv")
    figure, axes = style.panels(1000, 380, 1, 3)
    for ax, column, title in zip(axes, ("polygons_percent", "outside", "max_overlap"),
                                 ("Polygons discarded [%]", "Centres outside",
                                  "Largest overlap of two spheres [r]")):
        for name, (colour, mark) in style.OBJECTS.items():
            rows = table.where(object=name)
            ax.plot(rows["closeness"], rows[column], color=colour, marker=mark, label=name)
            if column == "polygons_percent":
                ax.plot(rows["closeness"], rows["paper_percent"], color=colour, linestyle="--", linewidth=1)
        ax.set(title=title, xlim=(0, 3.1), xlabel="largest distance of a covering sphere [r]")
        ax.set_ylim(bottom=0)
    axes[0].text(0.9, 5, "dashed: the paper's,\n51 % and three below 1 %", fontsize=8.5)
    style.legend_below(figure, axes[1].get_legend_handles_labels(), 4)
    return figure
