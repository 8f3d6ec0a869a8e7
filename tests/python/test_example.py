# SPDX-License-Identifier: MIT
"""The worked example runs, and what it measures is what is known of packings."""
import importlib.util
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


class ExampleOf(FolderCase):
    """Runs an example by its name in a folder of its own."""

    def run_example(self, name):
        before = sys.argv
        sys.argv = [f"{name}.py", str(self.folder)]
        self.addCleanup(setattr, sys, "argv", before)
        return runpy.run_path(str(SOURCE / "examples" / f"{name}.py"))


class LiggghtsHeap(ExampleOf):
    def test_lies_as_steep_as_ours_by_the_rule_of_the_summary(self):
        if not shutil.which("liggghts"):
            self.skipTest("apt-get install liggghts")
        found = self.run_example("liggghts_heap")
        self.assertAlmostEqual(found["ours"][0], found["known"][0], delta=1e-3)
        # Three heaps of one cell differ by up to 3 degrees.
        self.assertAlmostEqual(found["theirs"][0], found["ours"][0], delta=4)
        self.assertGreater(found["theirs"][0], 25)


class FixedBed(ExampleOf):
    def test_is_meshed_and_flows_in_openfoam(self):
        if not shutil.which("snappyHexMesh"):
            self.skipTest("apt-get install openfoam")
        found = self.run_example("openfoam_bed")
        self.assertIn("Mesh OK", found["checked"])
        self.assertGreater(found["cells"], 5000)
        # Flat facets lack 3 % of each sphere, and a hundredth of its radius another 3 %.
        self.assertTrue(0 < found["porosity"] - found["exact"] < 0.07 * (1 - found["exact"]))
        self.assertEqual(len(found["residuals"]), 5)
        self.assertLess(found["residuals"][-1], 0.2)


class PowderLayer(ExampleOf):
    def test_has_the_masses_of_its_sieves(self):
        found = self.run_example("powder_layer")
        self.assertLess(found["deviation"], 0.6)  # of 100
        self.assertGreater(len(found["run"].radii), 2000)
        self.assertTrue(0.52 < found["middle"] < 0.64, found["middle"])


class TubePorosity(ExampleOf):
    def test_swings_at_the_wall_as_the_correlations_do(self):
        found = self.run_example("tube_porosity")
        z, porosity = found["z"], found["found"]
        # As a closed form: at the wall it is 1, and half a diameter away the first layer is densest.
        self.assertGreater(porosity[z < 0.05].min(), 0.9)
        self.assertAlmostEqual(found["first"], 0.55, delta=0.1)
        second = z[(z > 0.7) & (z < 1.3)][porosity[(z > 0.7) & (z < 1.3)].argmax()]
        self.assertAlmostEqual(second, 1, delta=0.1)
        self.assertLess(found["apart"](found["de_klerk"]), 0.045)
        self.assertLess(found["apart"](found["mueller"]), 0.06)
        # The correlation's own mean error is 1.5 %.
        self.assertAlmostEqual(found["middle"] / found["benyahia"], 1, delta=0.03)
        if importlib.util.find_spec("fluids"):  # apt-get install python3-fluids
            from fluids.packed_bed import voidage_Benyahia_Oneil_spherical

            self.assertAlmostEqual(found["benyahia"], voidage_Benyahia_Oneil_spherical(2 * found["radius"], 2), places=12)
        self.assertTrue((self.folder / "tube.txt").exists())
        if importlib.util.find_spec("matplotlib"):
            self.assertGreater((self.folder / "tube.png").stat().st_size, 5000)


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
        # There are more of smaller spheres, and they say that they tell the volume better.
        self.assertGreater(found["numbers"][-1], 10 * found["numbers"][0])
        self.assertLess(found["expected"][-1], found["expected"][0])
        self.assertTrue(numpy.all(numpy.array(found["errors"]) < 4 * numpy.array(found["expected"])))

        self.assertEqual(found["drawn"], 48)
        for name in ("packing", "walls", "pairs", "error"):
            self.assertTrue((self.folder / f"python-{name}.png").stat().st_size > 5000)
        if shutil.which("ffmpeg"):
            self.assertTrue((self.folder / "turntable.mp4").stat().st_size > 5000)


if __name__ == "__main__":
    unittest.main()
