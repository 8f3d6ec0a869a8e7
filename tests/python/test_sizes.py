# SPDX-License-Identifier: MIT
"""Size curves from Python: the spheres themselves are the oracle, and wrong calls are sentences."""
import numpy
from support import FolderCase, frostfill, unittest

# Types that a command line does not have; values that are wrong are in the table of wrong calls.
WRONG_KEYWORDS = [
    {"sizes": v, "by": "mass"} for v in (5, "", True, b"x")
] + [
    {"sizes": "lognormal:0.1,0.02", "by": v} for v in (3, "", ["mass"], None)
] + [
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "curve_within": v} for v in (-0.1, numpy.nan, [1])
] + [
    {"sizes": "lognormal:0.1,0.02", "by": "mass", "fill_gaps": v} for v in ("yes", 1, None)
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


if __name__ == "__main__":
    unittest.main()
