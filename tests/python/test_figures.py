# SPDX-License-Identifier: MIT
"""The figures of the documentation: each is drawn from the tables beside it, and shows their numbers."""
import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import matplotlib
    import numpy
except ImportError:
    print("skipped: matplotlib is missing (apt-get install python3-matplotlib)")
    sys.exit(77)

ROOT = pathlib.Path(os.environ["FROSTFILL_SOURCE_DIR"])
RECORDED = ROOT / "docs" / "figures"
sys.path.insert(0, str(ROOT / "tools"))
import figures  # noqa: E402
from figures import style, tables  # noqa: E402

# What must be drawn, by figure: a table, the cells of its rows, columns along and up, and a factor up.
SERIES = {
    "closeness": [("closeness", {"object": name}, "closeness", column, 1)
                  for name in ("torus", "sphere", "cube", "human")
                  for column in ("polygons_percent", "outside", "max_overlap")],
    "density": [("density", {"method": "fast"}, "set_size", "packing_percent", 1)],
    "discarded": [("discarded", {"object": name, "rule": rule}, "present_percent", column, 1)
                  for name in ("torus", "human") for rule in ("paper", "exact")
                  for column in ("discarded_spheres_percent", "discarded_polygons_percent")],
    "friction": [("friction", {"preparation": name}, "friction", column, 1)
                 for name in ("loosest", "densest") for column in ("fraction", "contacts")],
    "sizes": [("sizes", {"run": name}, "radius", "achieved_percent", 1)
              for name in ("count", "full_within", "full")]
             + [("sizes", {"run": "count"}, "radius", "asked_percent", 1)],
    "claim": [("claim", {"method": name}, "spheres", column, 1)
              for name in ("freezing", "discards", "grid", "fast")
              for column in ("ms", "tests", "sphere_ms", "sphere_tests")]
             + [("claim", {"method": "all running"}, "spheres", "ms", 1)],
    "operations": [("operations", {"k": "1", "discards": discards}, "spheres", column, factor)
                   for discards in ("0", "1")
                   for column, factor in (("sphere_tests", 1), ("sphere_tests_lemma", 1),
                                          ("polygon_tests_so_far", 1e-6),
                                          ("polygon_tests_so_far_lemma", 1e-6))],
    "triangles": [("triangles", {}, "triangles", column, factor)
                  for column, factor in (("load", 1), ("prepare", 1), ("sphere", 1000), ("picture", 1000))],
    "closed_forms": [("closed-forms", {"problem": "bounce", "method": "explicit Euler"}, "value",
                      "magnitude", 1),
                     ("closed-forms", {"problem": "free fall", "method": "semi-implicit Euler"}, "value",
                      "magnitude", 1)],
    "peers": [("peers", {"engine": name}, "seconds", "worst", 1) for name in ("Frostfill", "ODE")],
    "error": [("error-steps", {"curve": "paper"}, "seconds", "error", 1),
              ("error-layers", {"curve": "by set"}, "layers", "fraction", 1),
              ("error-volume", {"curve": "raw"}, "seconds", "error", 100),
              ("error-volume", {"curve": "two radii", "rivals": "cube"}, "rS_over_V", "signed_error", 100),
              ("error-rendering", {"curve": "shell"}, "seconds", "error", 1),
              ("error-rest", {"curve": "LIGGGHTS", "friction": "0.3"}, "seconds", "max_overlap", 1)],
}


def column(name, cells, heading, factor=1):
    """Of a recorded table, by other means than the figures read it."""
    with open(RECORDED / f"{name}.csv", newline="", encoding="utf-8") as file:
        return [factor * float(row[heading]) for row in csv.DictReader(file)
                if all(row[key] == cell for key, cell in cells.items())]


def lines_of(figure):
    return [[list(map(float, values)) for values in line.get_data()]
            for axes in figure.axes for line in axes.get_lines()]


def close(one, other):
    return len(one) == len(other) and all(math.isclose(a, b, rel_tol=1e-9) for a, b in zip(one, other))


class Figures(unittest.TestCase):
    def test_every_table_that_is_recorded_is_drawn(self):
        drawn = set(SERIES) | {"times", "volume", "interaction", "filling", "cutaways", "torus", "studio"}
        self.assertEqual(drawn, set(figures.NAMES))

    def test_series_are_the_columns_of_the_tables(self):
        for name, series in SERIES.items():
            lines = lines_of(figures.figure(name).draw(RECORDED))
            for table, cells, along, up, factor in series:
                with self.subTest(figure=name, table=table, cells=cells, column=up):
                    x, y = column(table, cells, along), column(table, cells, up, factor)
                    self.assertGreater(len(x), 1)
                    near = [line for line in lines if close(line[1], y)]
                    # Three series of a figure lie beside each other, so that their bars can be seen.
                    self.assertTrue(any(close(line[0], x) or name == "density" for line in near))

    def test_growth_is_of_the_last_tenth_over_the_first(self):
        growth = figures.figure("claim").growth
        costs = numpy.array([100.0] * 2 + [7.0] * 16 + [110.0] * 2)
        self.assertAlmostEqual(growth(costs), 10)
        self.assertAlmostEqual(growth(costs[::-1]), 100 * (100 / 110 - 1))

    def test_figure_3_has_a_mark_for_each_time(self):
        lines = lines_of(figures.figure("times").draw(RECORDED))
        for series in ("paper loop", "paper tree", "loop", "list", "tree", "grid"):
            times = column("times", {"series": series}, "ms")
            self.assertEqual(len(times), 4)
            self.assertTrue(any(close(line[1], times) for line in lines), series)

    def test_figure_1_and_2_have_a_cell_for_each_pair_of_groups(self):
        kinds = ("running", "frozen", "none", "discarded")
        for name in ("volume", "interaction"):
            figure = figures.figure(name).draw(RECORDED)
            (mesh,) = [mesh for axes in figure.axes for mesh in axes.collections
                       if isinstance(mesh, matplotlib.collections.QuadMesh)]
            pairs = tables.read(RECORDED / f"{name}-pairs.csv")
            shown = mesh.get_array().reshape(int(pairs["j"].max()), -1)
            for i, j, kind in zip(pairs["i"], pairs["j"], pairs.words("kind")):
                self.assertEqual(shown[int(i) - 1, int(j) - 1], kinds.index(kind))

    def test_figure_2_has_the_circles_of_its_section(self):
        section = figures.figure("interaction").draw(RECORDED).axes[0]
        circles = [[*circle.center, circle.radius] for circle in section.patches]
        recorded = list(zip(*(column("interaction-spheres", {}, name) for name in ("x", "y", "radius"))))
        self.assertTrue(all(close(one, other) for one, other in zip(circles, recorded)))
        self.assertEqual(len(circles), len(recorded))

    def test_panels_are_shown_pixel_by_pixel(self):
        for name in ("filling", "cutaways"):
            (image,) = figures.figure(name).draw(RECORDED).images
            panels = style.read_picture(RECORDED / f"{name}-panels.png")
            self.assertTrue((image.get_array()[:, :, :3] == panels).all())

    def test_states_have_the_colours_of_the_style_paper(self):
        import frostfill
        options = frostfill.Simulation("cube", count=1, style="paper").options
        self.assertEqual(style.STATES, {state: options["colour_" + state] for state in style.STATES})
        self.assertTrue(options["colour_discarded_polygon"].startswith(style.DISCARDED_POLYGON))

    def test_pairs_of_groups_and_sections_are_measured_as_geometry_says(self):
        from types import SimpleNamespace

        from figures import interaction, runs
        # Two groups of three: the first frozen, the second running.
        state = SimpleNamespace(groups=[0, 0, 0, 1, 1, 1], states=numpy.array([1, 1, 1, 0, 0, 0]))
        self.assertEqual(runs.pairs_of_groups(state),
                         [(1, 1, "none", 0), (1, 2, "frozen", 9), (2, 2, "running", 3)])
        # A plane 0.6 from the centre of a unit sphere cuts it in a circle of 0.8.
        plane = interaction.Plane((9, 0, 0), (1, 0, 0), (0, 1, 0), 2)
        spheres = SimpleNamespace(centres=numpy.array([[10, 0, 0.6], [10, 3, 5]]),
                                  radii=numpy.ones(2), states=[1, 0])
        self.assertEqual(interaction.circles(spheres, plane), [("frozen", "0.50000", "0.00000", "0.40000")])
        cube = runs.frostfill.Simulation("cube", count=1)
        plane = interaction.Plane((0, 0, 0.1), (1, 0, 0), (0, 1, 0), 1)
        rows = interaction.traces(cube.vertices, cube.triangles, numpy.zeros(len(cube.triangles)), plane)
        self.assertAlmostEqual(sum(math.hypot(float(dx), float(dy)) for *_, dx, dy in rows), 8, places=3)

    def test_measuring_gives_what_is_recorded(self):
        with tempfile.TemporaryDirectory() as folder:
            figures.figure("closeness").measure(pathlib.Path(folder), False)
            measured = pathlib.Path(folder, "closeness.csv").read_text()
        self.assertEqual(measured, (RECORDED / "closeness.csv").read_text())

    def test_the_front_is_what_no_rival_beats_in_both_ways(self):
        front = tables.pareto_front([1, 2, 2, 3], [5, 3, 4, math.inf])
        self.assertEqual(list(front), [True, True, False, False])
        # Rivals alone compete; rounding and times that scatter are nothing.
        front = tables.pareto_front([1, 2, 2, 1.01], [1e-15, 0, 5, 1e-16], ["a", "a", "b", "a"], 1e-9, 0.05)
        self.assertEqual(list(front), [True, False, True, True])

    def test_the_script_draws_the_same_bytes_again(self):
        with tempfile.TemporaryDirectory() as folder:
            for out in ("a", "b"):
                subprocess.run([ROOT / "scripts" / "figures", "times", "volume", "--out", f"{folder}/{out}"],
                               check=True, capture_output=True)
            for name in ("times.png", "volume.png"):
                first, second = (pathlib.Path(folder, out, name).read_bytes() for out in ("a", "b"))
                self.assertEqual(first, second)
            refused = subprocess.run([ROOT / "scripts" / "figures", "nothing"], capture_output=True, text=True)
            self.assertEqual(refused.returncode, 1)
            self.assertIn("there is no figure 'nothing'", refused.stderr)


if __name__ == "__main__":
    unittest.main()
