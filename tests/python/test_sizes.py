# SPDX-License-Identifier: MIT
"""Size curves from Python: the spheres themselves are the oracle, and wrong calls are sentences."""
import subprocess

import numpy
from support import FolderCase, PROGRAM, frostfill, unittest

# Text of a file, and what the sentence says of it. Each of the program and of Python.
WRONG_FILES = {
    "": "is empty",
    "1,20\n2,80\n": "line 1",
    "diameter [mm],mass share\n1,1\n": "line 1",
    "radius,weight\n1,1\n": "line 1",
    "radius,share\n0.1,1\n": "line 1",
    "radius,mass share\n": "line 1",
    "radius,mass share\n0.1\n": "line 2",
    "radius,mass share\n0.1,0.2,0.3\n": "line 2",
    "radius,mass share\nsmall,1\n": "line 2",
    "radius,mass share\n0,1\n": "line 2",
    "radius,mass share\n-1,1\n": "line 2",
    "radius,mass share\nnan,1\n": "line 2",
    "radius,mass share\n0.1,inf\n": "line 2",
    "radius,mass share\n0.1,0.5\n0.2,0.4\n": "line 3",
    "radius,mass share\n0.1,0.5\n0.1,0.5\n": "line 3",
    "radius,cumulative mass\n0.1,0\n0.2,0.6\n0.3,0.5\n0.4,1\n": "line 4",
    "radius,cumulative mass\n0.1,0.2\n0.2,1\n": "line 2",
    "radius,cumulative mass\n0.1,0\n0.2,0.9\n": "line 3",
    "radius,mass share\n0.001,0.5\n0.2,0.5\n": "line 3",
    "\xff\xfe\x00": "line 1",
}
WRONG_KEYWORDS = [
    {"sizes": v, "by": "mass"} for v in (
        5, "", True, "gauss:1,2", "lognormal:", "lognormal:0.1", "lognormal:0.1,0", "normal:0.1,0.2",
        "weibull:0.1,2,0.3..0.2", "lognormal:0.1,0.01,nan..1", "nowhere.csv", b"x")
] + [
    {"sizes": "lognormal:0.1,0.02", "by": v} for v in ("weight", 3, "", ["mass"], None)
] + [
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "curve_within": v} for v in (-0.1, 2, "much", numpy.nan, [1])
] + [
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "fill_gaps": v} for v in ("yes", 1, None)
] + [
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "radius": 0.1}, {"by": "mass"}, {"fill_gaps": True},
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "fill_gaps": True, "tilt": 5},
    {"sizes": "lognormal:3,0.1", "by": "mass"},  # larger than the object
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "preset": "paper"},
]


class Sizes(FolderCase):
    def test_are_those_of_the_spheres(self):
        file = self.folder / "sieve.csv"
        file.write_text("diameter;passing by mass\n0.1;0\n0.2;50\n0.4;100\n")
        simulation = frostfill.Simulation("cube", sizes=file, count=600, motion="descend")
        for state in simulation:
            pass
        sizes = simulation.sizes
        mass = numpy.array(state.radii, float) ** 3
        for point in sizes.points:
            self.assertAlmostEqual(point.achieved, mass[state.radii <= point.radius * (1 + 1e-6)].sum() / mass.sum(), 5)
        asked = {round(point.radius, 9): point.asked for point in sizes.points}
        self.assertAlmostEqual(asked[0.1], 0.5)
        self.assertAlmostEqual(sizes.deviation, max(abs(p.asked - p.achieved) for p in sizes.points))
        self.assertLess(sizes.deviation, 0.02)
        self.assertIsNone(frostfill.Simulation("cube", count=3).sizes)

    def test_that_are_wrong_are_refused_in_a_sentence(self):
        for keywords in WRONG_KEYWORDS:
            with self.subTest(keywords), self.assertRaises((frostfill.Error, TypeError)) as caught:
                frostfill.Simulation("cube", **keywords)
            self.assertNotIn("\n", str(caught.exception))

    def test_files_that_are_wrong_are_refused_by_their_line(self):
        file = self.folder / "sieve.csv"
        for text, what in WRONG_FILES.items():
            file.write_bytes(text.encode("latin-1"))
            with self.subTest(text), self.assertRaises(frostfill.BadData) as caught:
                frostfill.Simulation("cube", sizes=str(file))
            self.assertIn(str(file), str(caught.exception))
            self.assertIn(what, str(caught.exception))
            done = subprocess.run([PROGRAM, "fill", "cube", "--sizes", file, "--out", self.folder / "run"],
                                  capture_output=True, text=True, errors="replace", check=False)
            self.assertEqual(done.returncode, 65, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(what, done.stderr)
            self.assertFalse((self.folder / "run").exists())


if __name__ == "__main__":
    unittest.main()
