# SPDX-License-Identifier: MIT
"""Runs that are kept: saved, loaded, exported, drawn."""
import json
import os
import stat
import unittest.mock

import numpy
from support import FolderCase, frostfill, run_program, unittest


class Runs(FolderCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = frostfill.fill("torus", count=60, duration=2.05, frames_fps=10, seed=7)

    def test_have_a_frame_for_each_of_the_animation(self):
        run = self.run_
        self.assertEqual(len(run), len(run.frames))
        self.assertAlmostEqual(len(run), 20, delta=2)
        counts = [len(snapshot) for snapshot in run]
        self.assertEqual(counts, sorted(counts))
        self.assertEqual(counts[-1], 60)
        self.assertEqual(len(run.frame(7)), counts[7])
        self.assertEqual(run.frame(7).frame, 7)
        self.assertTrue(numpy.array_equal(run.frame(-1).centres, run.centres))
        with self.assertRaisesRegex(frostfill.Usage, "the run has no frame 999: it has .* 0 to"):
            run.frame(999)

    def test_are_the_same_after_saving_and_loading(self):
        saved = self.run_.save(self.folder / "deep" / "torus")
        loaded = frostfill.load(saved)
        made = self.folder / "made"
        made.mkdir()
        self.assertEqual(saved.stat().st_mode, made.stat().st_mode)
        saved.chmod(0o700)  # a copy is as open to others as any folder that is made
        self.assertEqual(loaded.save(self.folder / "copy").stat().st_mode, made.stat().st_mode)
        for name in ("centres", "radii", "states", "groups"):
            self.assertTrue(numpy.array_equal(getattr(loaded, name), getattr(self.run_, name)))
        self.assertEqual(loaded.options, self.run_.options)
        self.assertEqual(loaded.state_hash, self.run_.state_hash)
        self.assertEqual(json.loads((saved / "summary.json").read_text()), loaded.summary)
        self.assertEqual(frostfill.load(saved / "run.frost").state_hash, loaded.state_hash)
        run_program("check", saved)  # the program takes it for a run of its own

    def test_are_saved_without_touching_the_umask(self):
        def refuse(mask):
            raise AssertionError("another thread may make a file meanwhile")

        before = os.umask(0o027)
        try:
            with unittest.mock.patch("os.umask", refuse):
                saved = self.run_.save(self.folder / "run")
        finally:
            os.umask(before)
        self.assertEqual(stat.S_IMODE(saved.stat().st_mode), 0o750)

    def test_are_drawn_while_they_are_filled_if_frames_are_asked_for(self):
        out = self.folder / "out"
        frostfill.fill("cube", count=5, duration=0.3, size=(64, 48), frames="all", out=out)
        self.assertEqual(len(list((out / "frames").glob("*.png"))),
                         len(frostfill.load(out).frames))

    def test_have_a_table_of_their_spheres(self):
        table = self.run_.table
        self.assertEqual(table.dtype.names[:7], ("x", "y", "z", "radius", "state", "group", "speed"))
        numpy.testing.assert_array_equal(table["z"], self.run_.centres[:, 2])
        numpy.testing.assert_array_equal(table["contacts"], self.run_.contacts)
        self.assertEqual(len(self.run_.frame(0).table), len(self.run_.frame(0)))

    def test_are_filled_into_several_files_of_one_mesh(self):
        corners = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v 0 0 1"]
        files = [self.folder / "base.obj", self.folder / "rest.obj"]
        files[0].write_text("\n".join([*corners, "f 1 3 2", "f 1 2 4"]))
        files[1].write_text("\n".join([*corners, "f 1 4 3", "f 2 3 4"]))
        run = frostfill.fill(files, count=3)
        self.assertEqual(len(run.triangles), 4)
        self.assertEqual(frostfill.fill(scene=run.directory / "summary.json").state_hash, run.state_hash)
        with self.assertRaisesRegex(frostfill.Usage, "mesh is"):
            frostfill.fill([files[0], 5])

    def test_show_their_last_picture_in_a_notebook(self):
        shown = self.run_._repr_png_()
        self.assertEqual(shown, self.run_.render(-1, size=(640, 360))._repr_png_())
        self.assertNotEqual(shown, self.run_.render(0, size=(640, 360))._repr_png_())

    def test_and_pictures_are_told_in_a_line(self):
        picture = self.run_.render(size=(64, 48))
        self.assertEqual(repr(picture), "<frostfill.Picture of 64 x 48 pixels>")
        self.assertEqual(repr(picture[0, 0, :1]), f"Picture([{picture[0, 0, 0]}], dtype=uint8)")
        self.assertRegex(repr(self.run_), "^<frostfill.Run of 60 spheres, .* frames, in /.*>$")

    def test_are_not_saved_over_anything_without_being_told_to(self):
        target = self.folder / "run"
        self.run_.save(target)
        with self.assertRaisesRegex(frostfill.CannotCreate, "holds a run already"):
            self.run_.save(target)
        self.run_.save(target, overwrite=True)
        self.assertEqual(frostfill.load(target).state_hash, self.run_.state_hash)
        letters = self.folder / "letters"
        letters.mkdir()
        (letters / "to_mother.txt").write_text("Dear mother")
        with self.assertRaisesRegex(frostfill.CannotCreate, "holds no run"):
            self.run_.save(letters, overwrite=True)
        self.assertEqual([f.name for f in letters.iterdir()], ["to_mother.txt"])
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()), ["letters", "run"])

    def test_are_repeated_from_their_summary(self):
        saved = self.run_.save(self.folder / "run")
        again = frostfill.fill(scene=saved / "summary.json")
        self.assertEqual(again.state_hash, self.run_.state_hash)

    def test_are_filled_into_a_folder_like_those_of_the_program(self):
        out = self.folder / "out"
        frostfill.fill("cube", count=20, out=out)
        self.assertEqual({f.name for f in out.iterdir()},
                         {"mesh.ply", "polygons.csv", "run.frost", "sets.csv", "spheres.csv",
                          "summary.json"})
        with self.assertRaises(frostfill.CannotCreate):
            frostfill.fill("cube", count=20, out=out)
        frostfill.fill("cube", count=10, out=out, overwrite=True)
        self.assertEqual(len(frostfill.load(out).radii), 10)

    def test_are_exported_to_a_file_by_its_ending_or_to_a_folder_by_a_format(self):
        run = self.run_
        files = run.export(self.folder / "torus.vtp")
        self.assertEqual([f.name for f in files], ["torus.vtp", "torus_mesh.vtp"])
        self.assertIn(b"<VTKFile", files[0].read_bytes()[:100])
        for ending in ("xyz", "glb", "csv", "dump"):
            (file,) = run.export(self.folder / f"torus.{ending}")
            self.assertGreater(file.stat().st_size, 100)
        self.assertEqual(run.export(self.folder / "all", "vtp", frames="0,1")[0].name, "run.pvd")
        with self.assertRaisesRegex(frostfill.CannotCreate, "is there already"):
            run.export(self.folder / "torus.csv")
        run.export(self.folder / "torus.csv", overwrite=True)
        with self.assertRaisesRegex(frostfill.Usage, "does not say its format"):
            run.export(self.folder / "torus.docx")
        with self.assertRaisesRegex(frostfill.Usage, "make 2 files"):
            run.export(self.folder / "two.vtp", frames="0,1")
        with self.assertRaisesRegex(frostfill.Usage, "did you mean csv"):
            run.export(self.folder / "folder", "csw")

    def test_are_exported_with_the_options_of_the_command(self):
        run = self.run_
        folder = self.folder / "geometry"
        (distance, label, _) = run.export(folder, "npy", voxels=24, contacts="shrink:0.9", threads=1)
        self.assertEqual(max(numpy.load(distance).shape), 24)
        self.assertEqual(numpy.load(label).max(), len(run.radii))
        bed = json.loads(run.export(folder, "openfoam", cell=0.5, resolution=2)[-1].read_text())
        self.assertGreater(bed["estimated_cells"], 0)
        stl = run.export(folder, "stl-bed", ascii=True, contacts="caps:0.05")[0]
        self.assertTrue(stl.read_text().startswith("solid "))
        csv = run.export(self.folder / "measured.csv", measure=["q6", "rattler"])[0]
        self.assertTrue({"q6", "rattler"} <= set(csv.read_text().splitlines()[0].split(",")))
        self.assertNotIn(b'"shell"', run.export(self.folder / "bare.glb", no_shell=True)[0].read_bytes())
        for format, option in (("csv", {"voxels": 8}), ("vtp", {"contacts": "none"}), ("xyz", {"cell": 1}),
                               ("gmsh", {"measure": "q6"}), ("stl-bed", {"no_shell": True})):
            with self.assertRaisesRegex(frostfill.Usage, f"{format} takes no "):
                run.export(self.folder / "none", format, **option)
        with self.assertRaisesRegex(frostfill.Usage, "does not say its format"):
            run.export(self.folder / "x.npy")
        self.assertFalse((self.folder / "none").exists())
        for wrong in ({"voxels": "8"}, {"voxels": -1}, {"contacts": 5}, {"threads": 1.5}):
            with self.assertRaises(frostfill.Usage):
                run.export(self.folder / "none", "npy", **wrong)

    def test_are_drawn_into_a_folder(self):
        drawn = self.run_.draw(self.folder / "pictures", frames="0..9", size=(80, 60))
        self.assertEqual(drawn, 10)
        self.assertEqual(len(list((self.folder / "pictures/frames").glob("*.png"))), 10)

    def test_keep_the_options_that_were_given(self):
        options = self.run_.options
        self.assertEqual((options["mesh"], options["count"], options["seed"]), ("torus", 60, 7))
        self.assertEqual((options["frames_fps"], options["duration"]), (10.0, 2.05))
        self.assertIsNone(options["radius"])

    def test_take_options_in_the_forms_that_python_has(self):
        options = frostfill.Simulation(
            "cube", count=numpy.int32(20), radius=(0.05, numpy.float32(0.0625)), size=(64, 48),
            camera_target=numpy.array([0.0, 0.1, 0.2]), picture_static_layer=False,
            frames_passes=["depth", "normal"],
            units="mm", up="z", wrap=None, frames=range(3), colour_frozen="#ff0000").options
        self.assertEqual(options["radius"], "0.05..0.0625")
        self.assertEqual((options["size"], options["picture_static_layer"]), ("64x48", False))
        self.assertEqual((options["camera_target"], options["units"]), ((0.0, 0.1, 0.2), 1000.0))
        self.assertEqual((options["frames_passes"], options["frames"]), ("depth,normal", "0,1,2"))
        self.assertEqual((options["up"], options["wrap"]), ("z", None))
        self.assertEqual(options["colour_frozen"], "#ff0000")


if __name__ == "__main__":
    unittest.main()
