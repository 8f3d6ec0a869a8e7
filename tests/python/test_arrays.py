# SPDX-License-Identifier: MIT
"""Arrays: shapes, types, views that nobody pulls the memory from under."""
import gc
import pathlib
import tempfile

import numpy
from support import frostfill, unittest


class Arrays(unittest.TestCase):
    def test_have_the_shapes_and_types_that_their_help_says(self):
        simulation = frostfill.Simulation("torus", count=30)
        simulation.advance(50)
        snapshot = simulation.snapshot()
        n = len(snapshot)
        self.assertGreater(n, 0)
        for name, kind, shape in [
            ("centres", "f8", (n, 3)), ("radii", "f8", (n,)), ("states", "u1", (n,)),
            ("groups", "u4", (n,)), ("speeds", "f4", (n,)), ("origin", "f8", (3,)),
            ("rotation", "f8", (3, 3)), ("offset", "f8", (3,)), ("changed", "u4", None),
            ("triangle_states", "u1", (len(simulation.triangles),)),
        ]:
            array = getattr(snapshot, name)
            self.assertEqual(array.dtype, kind, name)
            self.assertFalse(array.flags.writeable, name)
            self.assertFalse(array.flags.owndata, name)
            if shape is not None:
                self.assertEqual(array.shape, shape, name)
        self.assertEqual(simulation.vertices.dtype, "f8")
        self.assertEqual(simulation.triangles.dtype, "u4")
        self.assertLess(simulation.triangles.max(), len(simulation.vertices))

    def test_tell_how_spheres_have_turned_when_asked(self):
        simulation = frostfill.Simulation("torus", count=30, rest="joint", friction=0.3,
                                          rest_orientation=True)
        while simulation.step():
            pass
        snapshot = simulation.snapshot()
        turned = numpy.stack([snapshot.qx, snapshot.qy, snapshot.qz, snapshot.qw], axis=1)
        self.assertEqual(turned.shape, (30, 4))
        self.assertTrue(numpy.allclose(numpy.linalg.norm(turned, axis=1), 1, atol=1e-4))
        self.assertTrue((numpy.abs(turned[:, :3]) > 0.01).any())
        plain = frostfill.Simulation("torus", count=30).snapshot()
        with self.assertRaises(frostfill.Error):
            plain.qx

    def test_of_every_step_are_those_of_a_fresh_snapshot(self):
        """Only what has changed is renewed; in a twin, each snapshot is made from nothing."""
        stepped = frostfill.Simulation("torus", count=60, spheres_groups_per_set=1)
        twin = frostfill.Simulation("torus", count=60, spheres_groups_per_set=1)
        kept = []
        for snapshot in stepped:
            twin.step()
            fresh = twin.snapshot()
            kept.append(fresh)  # so that the twin takes new memory each time
            for name in ("centres", "radii", "states", "groups", "speeds", "triangle_states"):
                self.assertTrue(
                    numpy.array_equal(getattr(snapshot, name), getattr(fresh, name)), name)
        self.assertEqual(stepped.state_hash(), twin.state_hash())

    def test_stay_as_they_are_while_the_simulation_goes_on_and_when_it_is_gone(self):
        simulation = frostfill.Simulation("torus", count=60)
        kept = []
        for snapshot in simulation:
            kept.append((snapshot.centres, snapshot.centres.copy(), snapshot.time))
        del simulation, snapshot
        gc.collect()
        self.assertGreater(len(kept), 100)
        for array, copy, _ in kept:
            self.assertTrue(numpy.array_equal(array, copy))
        times = [time for *_, time in kept]
        self.assertEqual(times, sorted(times))

    def test_of_a_run_outlive_it(self):
        run = frostfill.fill("torus", count=30)
        centres, copy, folder = run.centres, run.centres.copy(), run.directory
        del run
        gc.collect()
        self.assertFalse(folder.exists())
        self.assertTrue(numpy.array_equal(centres, copy))

    def test_of_any_layout_are_taken(self):
        cube = frostfill.Simulation("cube", count=20)
        vertices, triangles = cube.vertices, cube.triangles
        cube.advance()
        wide = numpy.zeros((len(vertices), 6))
        wide[:, ::2] = vertices
        read_only = vertices.copy()
        read_only.flags.writeable = False
        for v in (wide[:, ::2], numpy.asfortranarray(vertices), vertices[::-1][::-1], read_only,
                  vertices.tolist(), vertices.astype(">f8"), vertices.astype(numpy.longdouble)):
            for t in (triangles.astype("i4"), triangles.astype(">u8"), triangles.tolist()):
                same = frostfill.Simulation(vertices=v, triangles=t, count=20, name="cube")
                same.advance()
                self.assertEqual(same.state_hash(), cube.state_hash())

    def test_counts_are_those_of_the_states(self):
        simulation = frostfill.Simulation("torus", count=60)
        seen = set()
        for snapshot in simulation:
            counts = numpy.bincount(snapshot.states, minlength=3).tolist()
            self.assertEqual([snapshot.running, snapshot.frozen, snapshot.discarded], counts)
            self.assertEqual(snapshot.discarded_triangles, int(snapshot.triangle_states.sum()))
            seen.add((counts[2], snapshot.discarded_triangles))
        self.assertTrue(any(spheres != triangles for spheres, triangles in seen))

    def test_of_a_moved_object_bring_its_points_to_where_an_export_has_them(self):
        run = frostfill.fill("torus", count=20, move_tilt=30, move_turn=40, duration=1, frames_fps=10)
        with tempfile.TemporaryDirectory() as folder:
            (file,) = run.export(pathlib.Path(folder) / "world.xyz", frames="last")
            rows = file.read_text().splitlines()[2:]
        world = numpy.array([[float(word) for word in row.split()[1:4]] for row in rows])
        last = run.last
        self.assertFalse(numpy.allclose(last.rotation, last.rotation.T))
        moved = last.origin + last.offset + (last.centres - last.origin) @ last.rotation.T
        self.assertLess(numpy.abs(moved - world).max(), 1e-12)

    def test_pictures_show_themselves(self):
        picture = frostfill.Simulation("cube", count=5).render(size=(40, 30), legend=False)
        self.assertEqual((picture.shape, picture.dtype), ((30, 40, 3), "u1"))
        self.assertGreater(picture.std(), 1)
        self.assertEqual(picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertIsNone(picture[0]._repr_png_())
        clear = frostfill.Simulation("cube", count=5).render(size=(40, 30), background="none")
        self.assertEqual(clear.shape, (30, 40, 4))


if __name__ == "__main__":
    unittest.main()
