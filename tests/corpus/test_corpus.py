#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the corpus and its checker. Exits 77 when all that was asked for had to be skipped."""

import json
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import make_corpus  # noqa: E402
import shapes  # noqa: E402

try:
    import check_packing
except (ImportError, SystemExit):
    check_packing = None


class Corpus(unittest.TestCase):
    def make(self, seed):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            # A large mesh takes as long as all others, and shows nothing that they do not.
            kinds = [k for k in make_corpus.KINDS if k not in ("many-triangles", "high-genus")]
            records = make_corpus.make_corpus(path, seed, kinds, each=1)
            return make_corpus.digest(path, records), records

    def test_the_same_seed_gives_the_same_bytes(self):
        first, records = self.make(1)
        self.assertEqual(first, self.make(1)[0])
        self.assertNotEqual(first, self.make(2)[0])
        self.assertGreaterEqual(len(records), 28)

    def test_every_kind_says_what_is_wrong(self):
        for name, function in make_corpus.KINDS.items():
            self.assertTrue(function.__doc__, name)


class Solids(unittest.TestCase):
    """Every solid is closed and wound outward, or the truth of the corpus is none."""

    def test_are_closed_and_wound_outward(self):
        import random
        rng = random.Random(1)
        solids = [shapes.box(1, 2, 3, 3), shapes.sphere(2), shapes.torus(), shapes.cylinder(),
                  shapes.cone(), shapes.capsule(), shapes.pipe(), shapes.gear(),
                  shapes.blob(rng, 2), shapes.cells_mesh([(0, 0, 0), (1, 0, 0)]),
                  shapes.implicit(lambda x, y, z: x * x + y * y + z * z - 0.5, 8),
                  shapes.tube_along(lambda t: (math.cos(6.2831853 * t), 0,
                                               math.sin(6.2831853 * t)), 0.2, 40, 8),
                  shapes.tube_along(lambda t: (t, 0, 0), 0.2, 4, 8, closed=False)]
        for k, mesh in enumerate(solids):
            edges = {(f[i], f[(i + 1) % 3]) for f in mesh.faces for i in range(3)}
            self.assertEqual(len(edges), 3 * len(mesh.faces), k)
            self.assertTrue(all((b, a) in edges for a, b in edges), k)
            self.assertGreater(shapes.volume(mesh), 0, k)

    def test_lids_close_what_is_open(self):
        half = shapes.sphere(2)
        half = half.without(k for k in range(len(half.faces)) if half.centre(k)[1] > 0)
        closed = half + shapes.lids_of(half)
        self.assertGreater(shapes.volume(closed), 0.4 * shapes.volume(shapes.sphere(2)))


@unittest.skipUnless(check_packing, "numpy is missing")
class Checker(unittest.TestCase):
    """Spheres placed by hand in a box of side 2 about the origin."""

    def check(self, *spheres, state="frozen", mesh=None):
        with tempfile.TemporaryDirectory() as folder:
            run = pathlib.Path(folder)
            rows = [f"{k},0,{x!r},{y!r},{z!r},{r!r},{state}"
                    for k, (x, y, z, r) in enumerate(spheres)]
            (run / "spheres.csv").write_text("\n".join(["id,group,x,y,z,radius,state", *rows]))
            scene = {"object": {"up": "y", "units_per_metre": 1}}
            (run / "summary.json").write_text(json.dumps({"scene": scene}))
            (run / "walls").write_bytes((mesh or shapes.box(2, 2, 2, 2)).bytes())
            return check_packing.check(run, run / "walls")

    def test_a_sphere_on_the_floor_is_right(self):
        result = self.check((0.0, -0.9, 0.0, 0.1))
        self.assertEqual(result["faults"], [])
        self.assertEqual(result["unsupported"], 0)

    def test_a_sphere_in_the_air_hangs(self):
        self.assertEqual(self.check((0.0, 0.3, 0.0, 0.1))["unsupported"], 1)
        self.assertEqual(self.check((0.0, 0.3, 0.0, 0.1), state="running")["unsupported"], 0)

    def test_a_gap_of_a_hundredth_carries_and_a_larger_one_does_not(self):
        self.assertEqual(self.check((0.0, -0.9 + 0.0009, 0.0, 0.1))["unsupported"], 0)
        self.assertEqual(self.check((0.0, -0.9 + 0.0011, 0.0, 0.1))["unsupported"], 1)

    def test_walls_count_from_both_sides(self):
        inside = self.check((0.0, -0.95, 0.0, 0.1))["wall_overlap"]
        outside = self.check((0.0, -1.05, 0.0, 0.1))
        self.assertAlmostEqual(inside, 0.5)
        self.assertAlmostEqual(outside["wall_overlap"], 0.5)
        self.assertEqual(outside["centres_outside"], 1)

    def test_overlaps_are_in_the_smaller_radius(self):
        result = self.check((0.0, 0.0, 0.0, 0.2), (0.29, 0.0, 0.0, 0.1))
        self.assertAlmostEqual(result["overlap"], 0.1)
        self.assertTrue(result["faults"])

    def test_far_pairs_of_cells_do_not_meet(self):
        self.assertEqual(self.check((-0.5, -0.9, 0.0, 0.1), (0.5, -0.9, 0.0, 0.1))["overlap"], 0)

    def test_two_spheres_carry_a_third_only_between_them(self):
        floor = [(-0.1, -0.9, 0.0, 0.1), (0.1, -0.9, 0.0, 0.1)]
        up = 0.1 * math.sqrt(3)
        self.assertEqual(self.check(*floor, (0.0, -0.9 + up, 0.0, 0.1))["unsupported"], 0)
        beside = (0.2, -0.9 + up, 0.0, 0.1)
        self.assertEqual(self.check(*floor, beside)["unsupported"], 1)

    def test_a_winding_number_of_two_is_inside_and_of_a_flipped_box_is_not(self):
        box = shapes.box(2, 2, 2)
        self.assertEqual(self.check((0.1, 0.2, 0.3, 0.1), mesh=box + box)["centres_outside"], 0)
        self.assertEqual(self.check((0.1, 0.2, 0.3, 0.1), mesh=box.flipped())["centres_outside"],
                         1)

    def test_positions_that_are_not_numbers_are_a_fault(self):
        self.assertEqual(self.check((math.nan, 0.0, 0.0, 0.1))["not_finite"], 1)


if __name__ == "__main__":
    unittest.main()
