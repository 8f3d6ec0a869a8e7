# SPDX-License-Identifier: MIT
"""Operations a time step while groups of ten freeze one after another in the torus.

Lines are the paper's lemmas, marks what was counted, at every eighth group."""

from . import style, tables

LAB = ("operations",)


def draw(folder):
    table = tables.read(folder / "operations.csv").where(k=1)
    figure, (left, right) = style.panels(900, 520, 1, 2)
    kept, dropped = table.where(discards=0), table.where(discards=1)
    left.plot(kept["spheres"], kept["tests_without_freezing"], color=style.BLACK, linestyle=":",
              label="tests with nothing frozen, n(n−1)/2")
    for rows, colour, mark, dashes, words in ((kept, style.VERMILLION, "o", "-", "with freezing"),
                                              (dropped, style.BLUE, "s", "--", "with discards")):
        left.plot(rows["spheres"], rows["sphere_tests_lemma"], color=colour, linestyle=dashes,
                  label=f"tests {words}, Lemma 1")
        left.plot(rows["spheres"], rows["sphere_tests"], color=colour, marker=mark, markevery=(7, 8),
                  linestyle="none", label="counted")
        right.plot(rows["spheres"], rows["polygon_tests_so_far_lemma"] / 1e6, color=colour,
                   linestyle=dashes, label=f"{'no' if rows is kept else 'with'} discards, Lemma 3")
        right.plot(rows["spheres"], rows["polygon_tests_so_far"] / 1e6, color=colour, marker=mark,
                   markevery=(7, 8), linestyle="none", label="counted")
    left.plot(dropped["spheres"], dropped["sphere_responses_greatest"], color=style.GREEN, marker="^",
              markevery=(7, 8), linestyle="none", label="most responses in a step")
    left.set(title="Sphere–sphere", yscale="log", xlabel="spheres present", ylabel="operations a step")
    right.set(title="Sphere–polygon", xlabel="spheres present",
              ylabel="tests so far, one step a set [million]")
    for ax in (left, right):
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14))
    return figure
