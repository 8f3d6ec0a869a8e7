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
        self.assertEqual(found.network.shape, (3 * 6 * 6 * 5, 3))
        first, second = found.network[:, :2].astype(int).T
        apart = numpy.linalg.norm(found.centres[first] - found.centres[second], axis=1)
        numpy.testing.assert_allclose(apart - 1, found.network[:, 2], atol=1e-12)
        numpy.testing.assert_allclose(found.radii, 0.5)
        filled = (1 - found.porosity_height[:, 2]) @ found.porosity_height[:, 4]
        self.assertAlmostEqual(filled, 216 * numpy.pi / 6)
        self.assertEqual(found.sizes_height[:, 2].sum(), 216)
        contact = found.pairs[(found.pairs[:, 0] < 1) & (found.pairs[:, 1] > 1)]
        self.assertEqual(contact[0, 3], 6)

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
        self.assertEqual(found.porosity_height.shape, (6, 5))
        self.assertAlmostEqual(found.porosity_radial[-1, 1], 72**0.5)
        self.assertEqual(found.summary["settings"]["up"], "z")
        with self.assertRaisesRegex(frostfill.Usage, "has no contacts"):
            found.network

    def test_ends_the_bed_at_its_surface_or_at_a_height(self):
        high = BOX * (1, 2, 1)
        bed = frostfill.analyse(LATTICE, 0.5, high, FACES, samples=1 << 16, only="porosity")
        self.assertAlmostEqual(bed.summary["porosity"]["sampled"], 1 - numpy.pi / 6, delta=0.01)
        numpy.testing.assert_allclose(bed.porosity_height[:, 1].max(), 6)
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
