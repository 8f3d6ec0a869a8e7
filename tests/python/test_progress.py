# SPDX-License-Identifier: MIT
"""How far work is, for a function of the caller and as a bar."""
import contextlib
import io
import sys
import unittest.mock

from support import FolderCase, frostfill, unittest

LONG = {"mesh": "torus", "count": 4000}  # some seconds


class Progress(FolderCase):
    def test_of_a_run_rises_to_one(self):
        seen = []
        run = frostfill.fill(**LONG, progress=seen.append)
        self.assertGreater(len(seen), 2)
        fractions = [each.fraction for each in seen]
        self.assertEqual(fractions[-1], 1)
        self.assertLess(fractions[0], 0.5)
        self.assertEqual(seen[-1].seconds_left, 0)
        self.assertTrue(all(each.stage == "spheres" for each in seen))
        self.assertTrue(all(a.spheres <= b.spheres and a.time <= b.time for a, b in zip(seen, seen[1:])))
        self.assertTrue(any(each.seconds_left for each in seen[:-1]))
        quiet = frostfill.fill(**LONG)
        self.assertEqual(quiet.state_hash, run.state_hash)

    def test_of_pictures_rises_to_one(self):
        run = frostfill.fill("torus", count=30, duration=1, frames_fps=20)
        seen = []
        run.draw(self.folder / "out", size=(320, 240), progress=seen.append)
        self.assertEqual((seen[-1].fraction, seen[-1].seconds_left), (1, 0))

    def test_stops_a_run_by_an_exception(self):
        calls = []

        def fail(progress):
            calls.append(progress)
            raise KeyError("enough")

        with self.assertRaisesRegex(KeyError, "enough"):
            frostfill.fill(**LONG, progress=fail)
        self.assertEqual(len(calls), 1)

    def test_is_a_line_of_text_without_tqdm(self):
        with unittest.mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}):
            said = io.StringIO()
            with contextlib.redirect_stderr(said):
                frostfill.fill("torus", count=30, progress=True)
        self.assertRegex(said.getvalue(), "\r100 % of the spheres, 0 s left +\n$")

    def test_is_a_bar_with_tqdm(self):
        try:
            import tqdm.auto  # noqa: F401
        except ImportError as missing:
            self.skipTest(f"{missing}; apt-get install python3-tqdm")
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            frostfill.fill("torus", count=30, progress=True)
        self.assertIn("100 % |", said.getvalue())

    def test_is_true_or_a_function(self):
        run = frostfill.fill("torus", count=3)
        for wrong in (5, "yes", []):
            with self.assertRaisesRegex(frostfill.Usage, "True or a function"):
                frostfill.fill("torus", count=3, progress=wrong)
            with self.assertRaisesRegex(frostfill.Usage, "True or a function"):
                run.draw(self.folder / "out", progress=wrong)
        frostfill.fill("torus", count=3, progress=False)


if __name__ == "__main__":
    unittest.main()
