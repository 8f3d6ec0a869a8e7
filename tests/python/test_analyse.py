# SPDX-License-Identifier: MIT
"""Analyses in Python give what the program gives, and what is known of a lattice."""
import json
import subprocess

import numpy
from support import PROGRAM, FolderCase, frostfill, unittest

BOX = numpy.array([[x, y, z] for x in (0, 6) for y in (0, 6) for z in (0, 6)], float)
FACES = numpy.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                     [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
LATTICE = numpy.array([[x, y, z] for x in range(6) for y in range(6) for z in range(6)]) + 0.5


def analyse(**keywords):
    return frostfill.analyse(LATTICE, 0.5, BOX, FACES, **{"samples": 4096, **keywords})


class Analyse(FolderCase):
    def test_knows_a_simple_cubic_lattice(self):
        found = analyse()
        inner = found.wall_distances > 1
        self.assertEqual(inner.sum(), 64)
        numpy.testing.assert_allclose(found.depths, 6 - found.centres[:, 1])
        self.assertTrue((found.sphere_contacts[inner] == 6).all())
        self.assertEqual(found.wall_contacts.sum(), 6 * 36)
        self.assertEqual(found.rattlers.sum(), 0)
        numpy.testing.assert_allclose(found.q6[inner], 8**-0.5, rtol=1e-12)
        self.assertTrue((found.bonds[inner] == 6).all())
        self.assertEqual(found.network.shape, (3 * 6 * 6 * 5,))
        first, second = found.network["first"], found.network["second"]
        apart = numpy.linalg.norm(found.centres[first] - found.centres[second], axis=1)
        numpy.testing.assert_allclose(apart - 1, found.network["gap"], atol=1e-12)
        numpy.testing.assert_allclose(found.radii, 0.5)
        slabs = found.porosity_height
        filled = (1 - slabs["porosity"]) @ slabs["object_volume"]
        self.assertAlmostEqual(filled, 216 * numpy.pi / 6)
        self.assertEqual(found.sizes_height["spheres"].sum(), 216)
        contact = found.pairs[(found.pairs["from"] < 1) & (found.pairs["to"] > 1)]
        self.assertEqual(contact["neighbours"][0], 6)

    def test_has_tables_with_the_columns_of_the_files(self):
        found = analyse()
        names = found.save(self.folder / "found")
        for name in ("porosity_height", "porosity_radial", "porosity_wall", "sizes_height", "sizes_radial",
                     "pairs", "network"):
            self.assertIn(f"{name}.csv", names)
            read = numpy.genfromtxt(self.folder / "found" / f"{name}.csv", delimiter=",", names=True)
            table = getattr(found, name)
            self.assertEqual(table.dtype.names, read.dtype.names, name)
            for column in table.dtype.names:
                numpy.testing.assert_allclose(table[column], read[column], rtol=1e-5, atol=1e-12)
        self.assertEqual(found.table.dtype.names[:7],
                         ("id", "x", "y", "z", "radius", "wall_distance", "depth"))
        for axis, name in enumerate("xyz"):
            numpy.testing.assert_array_equal(found.table[name], found.centres[:, axis])
        numpy.testing.assert_array_equal(found.table["q6"], found.q6)
        self.assertNotIn("q6", analyse(only="contacts").table.dtype.names)

    def test_tables_become_data_frames(self):
        try:
            import pandas
        except ImportError as missing:
            self.skipTest(f"{missing}; apt-get install python3-pandas")
        found = analyse(only="contacts")
        self.assertEqual(list(pandas.DataFrame(found.network).columns), ["first", "second", "gap"])
        self.assertEqual(pandas.DataFrame(found.table)["sphere_contacts"].max(), 6)

    def test_takes_a_box_in_place_of_a_mesh(self):
        boxed = frostfill.analyse(LATTICE, 0.5, box=(6, 6, 6), samples=4096)
        self.assertEqual(boxed.summary, analyse().summary)
        moved = frostfill.analyse(LATTICE - 3, 0.5, box=[[-3, -3, -3], [3, 3, 3]], only="contacts")
        self.assertEqual(moved.wall_contacts.sum(), 6 * 36)
        periodic = frostfill.analyse(LATTICE, 0.5, box=(6, 6, 6), periodic=True, range=2)
        self.assertTrue((periodic.sphere_contacts == 6).all())
        self.assertEqual(periodic.summary["settings"]["bounds"], "periodic")
        with self.assertRaisesRegex(frostfill.Usage, "has no porosity"):
            periodic.porosity_height
        apart = [[0.2, 3, 3], [5.8, 3, 3]]
        self.assertEqual(frostfill.check(apart, 0.3, box=(6, 6, 6)).max_overlap, 0)
        overlap = frostfill.check(apart, 0.3, box=(6, 6, 6), periodic=True).max_overlap
        self.assertAlmostEqual(overlap, 0.2 / 0.3)
        for wrong, said in ({"box": (1, 2)}, "three lengths"), ({"box": (1, 1, -1)}, "three lengths"), \
                ({"box": "abc"}, "array of numbers"), ({"box": [[1], [1, 2]]}, "3 or 6 numbers"), \
                ({"periodic": True}, "needs a box"), ({"box": (6, 6, 6), "mesh": "cube"}, "not both"):
            for call in (frostfill.analyse, frostfill.check):
                with self.assertRaisesRegex(frostfill.Usage, said):
                    call(LATTICE, 0.5, **wrong)
        with self.assertRaisesRegex(frostfill.Usage, "only overlaps"):
            frostfill.check(apart, 0.3, box=(6, 6, 6), periodic=True, judge_friction=0.3)

    def test_finds_the_forces_in_contacts(self):
        found = analyse(only="contacts", forces=0.5)
        self.assertEqual(found.forces.shape, (len(found.network), 3))
        self.assertGreater(abs(found.forces).max(), 0.5)
        self.assertIn("largest_unbalance", found.summary["contacts"])
        self.assertEqual(abs(analyse(only="contacts").forces).max(), 0)
        with self.assertRaisesRegex(frostfill.Usage, "friction of forces"):
            analyse(forces=-1)

    def test_has_cells_of_one_size(self):
        try:
            found = analyse(only="cells")
        except frostfill.Unavailable as missing:
            self.skipTest(str(missing))
        whole = found.cells == 0
        self.assertEqual(whole.sum(), 64)
        numpy.testing.assert_allclose(found.cell_volumes[whole], 1, rtol=1e-12)
        self.assertTrue(numpy.isnan(found.local_fractions[~whole]).all())

    def test_takes_an_axis_and_names(self):
        found = analyse(only=["porosity", "sizes"], up="z", centre=(0, 0, 0), bins=6)
        self.assertEqual(found.porosity_height.shape, (6,))
        self.assertAlmostEqual(found.porosity_radial["to"][-1], 72**0.5)
        self.assertEqual(found.summary["settings"]["up"], "z")
        with self.assertRaisesRegex(frostfill.Usage, "has no contacts"):
            found.network

    def test_ends_the_bed_at_its_surface_or_at_a_height(self):
        high = BOX * (1, 2, 1)
        bed = frostfill.analyse(LATTICE, 0.5, high, FACES, samples=1 << 16, only="porosity")
        self.assertAlmostEqual(bed.summary["porosity"]["sampled"], 1 - numpy.pi / 6, delta=0.01)
        numpy.testing.assert_allclose(bed.porosity_height["to"].max(), 6)
        whole = frostfill.analyse(LATTICE, 0.5, high, FACES, samples=1 << 16, only="porosity", below=12)
        self.assertAlmostEqual(whole.summary["porosity"]["sampled"], 1 - numpy.pi / 12, delta=0.01)
        with self.assertRaisesRegex(frostfill.Usage, "above 0"):
            analyse(below=-1)

    def test_leaves_out_what_is_outside(self):
        found = frostfill.analyse([[0, 0, 0], [9, 0, 0], [0.5, 0, 0]], 0.25, mesh="cube", only="order")
        self.assertEqual(list(found.ids), [0, 2])
        self.assertEqual(found.summary["left_out"]["outside"], 1)

    def test_writes_what_the_program_writes(self):
        run = frostfill.fill("cube", count=60, seed=3, out=self.folder / "run")
        found = frostfill.analyse(run.centres, run.radii, run.vertices, run.triangles, samples=2000)
        names = found.save(self.folder / "here")
        subprocess.run([PROGRAM, "analyse", str(self.folder / "run"), "--samples", "2000", "--quiet"],
                       check=True)
        for name in names:
            there = self.folder / "run" / "analysis" / name
            self.assertEqual((self.folder / "here" / name).read_bytes(), there.read_bytes(), name)
        self.assertEqual(json.loads((self.folder / "here" / "summary.json").read_text()), found.summary)
        self.assertEqual(json.loads(str(found)), found.summary)
        with self.assertRaisesRegex(frostfill.CannotCreate, "overwrite=True"):
            found.save(self.folder / "here")
        found.save(self.folder / "here", overwrite=True)


if __name__ == "__main__":
    unittest.main()
