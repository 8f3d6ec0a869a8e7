# SPDX-License-Identifier: MIT
"""The worked example runs, and what it measures is what is known of packings."""
import runpy
import shutil
import sys

import numpy
from support import SOURCE, FolderCase, require, unittest

require("matplotlib")


class LiggghtsAtRest(FolderCase):
    def test_stays_where_it_was_put(self):
        if not shutil.which("liggghts"):
            self.skipTest("apt-get install liggghts")
        before = sys.argv
        sys.argv = ["liggghts_at_rest.py", str(self.folder)]
        self.addCleanup(setattr, sys, "argv", before)
        found = runpy.run_path(str(SOURCE / "examples" / "liggghts_at_rest.py"))
        self.assertGreaterEqual(found["near"], 0.99)
        self.assertTrue(0 < found["moved"].max() < 0.5)
        self.assertLess(found["quality"].max_overlap, 1e-3)


class Example(FolderCase):
    def test_of_a_packing_runs_and_measures_what_is_known_of_random_packings(self):
        before = sys.argv
        sys.argv = ["packing.py", str(self.folder)]
        self.addCleanup(setattr, sys, "argv", before)
        found = runpy.run_path(str(SOURCE / "examples" / "packing.py"))

        # Loose random packings of equal spheres are between 0.55 and 0.60 dense.
        self.assertTrue(0.55 < found["inside"] < 0.60, found["inside"])
        # At the wall there are only points of contact, and the first layer ends a diameter away.
        self.assertLess(found["fraction"][0], 0.01)
        apart = found["distances"] / found["radius"]
        near = (apart > 1) & (apart < 3)
        self.assertAlmostEqual(apart[near][found["fraction"][near].argmin()], 2, delta=0.1)
        # No two centres are closer than a diameter, most neighbours touch, and far away g is 1.
        g, diameters = found["correlation"], found["middles"] / found["radius"] / 2
        self.assertEqual(g[diameters < 0.99].max(), 0)
        self.assertGreater(g[(diameters > 0.99) & (diameters < 1.05)].max(), 5)
        self.assertAlmostEqual(g[diameters > 3].mean(), 1, delta=0.05)
        # Smaller spheres take longer and say so.
        self.assertGreater(found["seconds"][-1], found["seconds"][0])
        self.assertLess(found["expected"][-1], found["expected"][0])
        self.assertTrue(numpy.all(numpy.array(found["errors"]) < 4 * numpy.array(found["expected"])))

        self.assertEqual(found["drawn"], 48)
        for name in ("packing", "walls", "pairs", "error"):
            self.assertTrue((self.folder / f"python-{name}.png").stat().st_size > 5000)
        if shutil.which("ffmpeg"):
            self.assertTrue((self.folder / "turntable.mp4").stat().st_size > 5000)


if __name__ == "__main__":
    unittest.main()
