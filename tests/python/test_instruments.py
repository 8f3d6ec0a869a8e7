# SPDX-License-Identifier: MIT
"""The judge, the inspection and the volumes, against closed forms and the program."""
import json

import numpy
from support import FolderCase, frostfill, run_program, unittest

CUBE = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = numpy.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                     [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])


class ReadPacking(FolderCase):
    def test_takes_what_the_program_takes_and_what_it_gives_is_judged(self):
        file = self.folder / "beads.csv"
        file.write_text("px,size,py,pz\n0.3,0.2,0.1,0.5\n0.48,0.2,0.1,0.5\n")
        found = frostfill.read_packing(file, columns={"x": "px", "y": "py", "z": 4, "diameter": "size"})
        numpy.testing.assert_array_equal(found.centres, [[0.3, 0.1, 0.5], [0.48, 0.1, 0.5]])
        numpy.testing.assert_array_equal(found.radii, [0.1, 0.1])
        self.assertEqual((found.at_rest.dtype, found.at_rest.tolist(), found.format), (bool, [True, True], "a table"))
        self.assertAlmostEqual(frostfill.check(found.centres, found.radii, CUBE, FACES).max_overlap, 0.2)
        file.write_text("#format x_y_z\n0.3 0.1 0.5\n")
        self.assertEqual(frostfill.read_packing(file, radius=0.25).radii.tolist(), [0.25])

    def test_reads_what_was_exported_to_the_same_numbers(self):
        run = frostfill.fill("cube", count=20, duration=0.5)
        for format, name in {"yade": "yade.txt", "lethe": "particles.input"}.items():
            run.export(self.folder, format)
            found = frostfill.read_packing(self.folder / name)
            numpy.testing.assert_array_equal(found.centres, run.centres)
            numpy.testing.assert_array_equal(found.radii, run.radii)
        found = frostfill.read_packing(run.directory)
        numpy.testing.assert_array_equal(found.centres, run.centres)


class Check(FolderCase):
    def test_finds_what_is_laid_out_by_hand(self):
        # Two overlap by a fifth, one lies on the ground, one floats, one is outside.
        centres = [[0.3, 0.1, 0.5], [0.48, 0.1, 0.5], [0.8, 0.1, 0.2], [0.5, 0.5, 0.5], [0.5, 0.5, 3]]
        report = frostfill.check(centres, 0.1, CUBE, FACES)
        self.assertAlmostEqual(report.max_overlap, 0.2)
        two = frostfill.check([[0.1, 0.1, 0.1], [0.28, 0.1, 0.1], [0.47, 0.1, 0.1]], 0.1, CUBE, FACES)
        self.assertAlmostEqual(two.max_overlap, 0.2)
        self.assertAlmostEqual(two.mean_overlap, 0.15)  # of 0.2 and 0.1
        self.assertEqual(report.centres_outside, 1)
        self.assertGreaterEqual(report.unsupported, 1)
        self.assertAlmostEqual(report.mesh_volume, 1)
        self.assertAlmostEqual(report.sphere_volume, 5 * 4 / 3 * numpy.pi * 0.001)
        calm = frostfill.check(centres[2:4], [0.1, 0.1], CUBE, FACES, at_rest=[True, False])
        self.assertEqual((calm.unsupported, calm.centres_outside), (0, 0))

    def test_says_of_a_run_what_the_program_says(self):
        run = frostfill.fill("torus", count=80, out=self.folder / "run")
        said = json.loads(run_program("check", self.folder / "run", "--json"))
        report = frostfill.check(run.centres, run.radii, run.vertices, run.triangles,
                                 at_rest=run.states > 0)
        for ours, theirs in [
            (report.max_overlap, "max_overlap_over_radius"),
            (report.mean_overlap, "mean_overlap_over_radius"),
            (report.max_wall_overlap, "max_wall_overlap_over_radius"),
            (report.centres_outside, "centres_outside"),
            (report.unsupported, "unsupported_frozen"),
        ]:
            self.assertIn(theirs, said)
            self.assertAlmostEqual(ours, said[theirs], 12, theirs)

    def test_says_from_which_friction_a_pile_stands(self):
        # Two on the floor and one between them: 30 degrees.
        pile = [[0.3, 0.1, 0.5], [0.5, 0.1, 0.5], [0.4, 0.1 + 0.1 * 3 ** 0.5, 0.5]]
        self.assertIsNone(frostfill.check(pile, 0.1, CUBE, FACES).equilibrium)
        for friction, falls in [(0.25, True), (0.28, False)]:
            report = frostfill.check(pile, 0.1, CUBE, FACES, judge_friction=friction,
                                     judge_unbalance=0.001)
            joint = report.equilibrium
            self.assertEqual((joint.friction, joint.spheres, joint.settled), (friction, 3, True))
            self.assertEqual((joint.unbalanced > 0, joint.largest > 0.001), (falls, falls))
            self.assertAlmostEqual(joint.least_friction / (2 - 3 ** 0.5), 1, 2)
        air = frostfill.check([[0.5, 0.5, 0.5]], 0.1, CUBE, FACES, judge_friction=1).equilibrium
        self.assertEqual((air.unbalanced, air.largest, air.least_friction), (1, 1, numpy.inf))
        self.assertIn("least_friction=inf", repr(air))

    def test_judges_a_run_together_when_told_to(self):
        run = frostfill.fill("torus", count=60, judge_friction=0.5, out=self.folder / "stands")
        summary = json.loads((self.folder / "stands" / "summary.json").read_text())
        report = frostfill.check(run.centres, run.radii, run.vertices, run.triangles,
                                 judge_friction=0.5)
        self.assertEqual(summary["error"]["equilibrium"]["at_rest"], report.equilibrium.spheres)
        self.assertAlmostEqual(summary["error"]["equilibrium"]["least_friction"],
                               report.equilibrium.least_friction, 2)

    def test_says_how_all_have_settled_together(self):
        simulation = frostfill.Simulation("cube", radius=0.2, count=30, rest="joint", friction=0.4)
        while simulation.step():
            pass
        settling = simulation.quality().settling
        self.assertEqual((settling.rounds, settling.settled), (1, True))
        self.assertLess(settling.missing, 0.1)
        self.assertLessEqual(settling.overlap, 1e-8)
        with self.assertRaisesRegex(Exception, "--rest"):
            frostfill.Simulation("cube", radius=0.2, friction=0.4)

    def test_counts_places_that_are_no_numbers(self):
        report = frostfill.check([[numpy.nan, 0, 0], [0.5, 0.5, 0.5]], 0.1, CUBE, FACES)
        self.assertEqual(report.not_finite, 1)


class Inspect(unittest.TestCase):
    def test_knows_the_cube(self):
        report = frostfill.inspect(vertices=CUBE, triangles=FACES)
        self.assertTrue(report.as_read.closed)
        self.assertAlmostEqual(report.filled.volume, 1)
        self.assertAlmostEqual(report.filled.area, 6)
        self.assertEqual(report.repairs, [])
        low, high = report.filled.box
        self.assertTrue(numpy.array_equal(low, [0, 0, 0]) and numpy.array_equal(high, [1, 1, 1]))

    def test_says_what_is_repaired(self):
        inside_out = FACES.copy()
        inside_out[:4] = inside_out[:4, ::-1]
        report = frostfill.inspect(vertices=CUBE, triangles=inside_out)
        self.assertFalse(report.as_read.closed)
        self.assertAlmostEqual(report.filled.volume, 1)
        self.assertEqual(len(report.repairs), 1)

    def test_says_why_a_mesh_cannot_be_filled_and_what_would_help(self):
        report = frostfill.inspect(vertices=CUBE, triangles=FACES[:10])
        self.assertEqual(report.as_read.boundary_edges, 4)
        self.assertIsNone(report.filled)
        self.assertIn("lid", report.refusal)
        closed = frostfill.inspect(vertices=CUBE, triangles=FACES[:10], lid=True)
        self.assertAlmostEqual(closed.filled.volume, 1)


class Volume(unittest.TestCase):
    def test_of_a_cube_is_known_within_its_uncertainty(self):
        estimate = frostfill.volume(vertices=CUBE, triangles=FACES, radius=0.06)
        self.assertAlmostEqual(estimate.mesh_volume, 1)
        self.assertLess(abs(estimate.volume - 1), 3 * estimate.error)
        self.assertLess(estimate.error, 0.1)
        self.assertGreater(estimate.fine, 6 * estimate.coarse)


if __name__ == "__main__":
    unittest.main()
