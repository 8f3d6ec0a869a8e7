# SPDX-License-Identifier: MIT
"""Wrong calls: each is an exception with a sentence, and the interpreter lives on."""
import itertools
import pathlib
import threading

import numpy
from support import FolderCase, frostfill, unittest

CUBE = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = numpy.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                     [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])


class Hostile:
    """Raises whatever is asked of it."""

    def __array__(self, *_):
        raise RuntimeError("no array")

    def __fspath__(self):
        raise RuntimeError("this is no path")

    def __str__(self):
        raise RuntimeError("no text")

    __float__ = __index__ = __len__ = __str__


def changed(array, place, value):
    copy = array.astype(float)
    copy[place] = value
    return copy


def ragged():
    rows = numpy.empty(2, object)
    rows[:] = [[1, 2, 3], [1, 2]]
    return rows


# What is no array of numbers [n, 3], whatever it is for.
NO_POINTS = {
    "text": "abc", "number": 3.5, "set": {1, 2}, "dictionary": {"x": 1}, "hostile": Hostile(),
    "bytes": b"abc", "function": len, "none in it": [[1, 2, None]], "texts": [["a", "b", "c"]],
    "complex": CUBE * 1j, "booleans": CUBE > 0.5, "objects": CUBE.astype(object), "ragged": ragged(),
    "dates": numpy.zeros((4, 3), "M8[s]"), "structured": numpy.zeros(4, "f8,f8,f8"),
    "flat": CUBE.ravel(), "two columns": CUBE[:, :2], "four columns": numpy.zeros((4, 4)),
    "three dimensions": CUBE[None], "a number's array": numpy.array(1.0), "turned": CUBE.T,
    "huge": numpy.broadcast_to(0.0, (10**12, 3)), "huge whole": numpy.broadcast_to(0, (10**12, 3)),
    "empty list": [], "no columns": numpy.zeros((5, 0)),
}
# What is, but is no cube's corners.
NO_VERTICES = {
    **NO_POINTS, "none": None, "no rows": numpy.zeros((0, 3)), "too few": CUBE[:4],
    "nan": changed(CUBE, (0, 0), numpy.nan), "infinite": changed(CUBE, (3, 1), numpy.inf),
    "all alike": CUBE * 0, "flat cube": CUBE * [1, 1, 0], "overflow": CUBE * 1e300,
    "largest": CUBE * numpy.finfo(float).max, "smallest": CUBE * 5e-324,
}
NO_TRIANGLES = {
    **NO_POINTS, "none": None, "no rows": numpy.zeros((0, 3), int), "fractions": FACES + 0.5,
    "whole as float": FACES.astype(float), "negative": FACES - 1, "beyond": FACES + 1,
    "far beyond": FACES + 2**40, "wraps": FACES.astype("u8") + (2**64 - 5), "one": FACES[:1],
    "collapsed": FACES * 0, "half open": FACES[:6],
}
NO_RADII = {
    "none": None, "text": "abc", "hostile": Hostile(), "too few": [0.1], "too many": [0.1] * 9,
    "negative": [-0.1] * 8, "zero": 0, "one zero": [0.1] * 7 + [0], "nan": numpy.nan,
    "one nan": [0.1] * 7 + [numpy.nan], "infinite": numpy.inf, "two dimensions": [[0.1]] * 8,
    "complex": 1j, "booleans": [True] * 8, "texts": ["a"] * 8, "huge": numpy.broadcast_to(0.1, 10**12),
}
# Keywords of analyse.
NO_ANALYSIS = {
    "up": ("w", "", 1, None, Hostile()), "centre": ((1, 2), "abc", 5, (1, 2, numpy.nan), Hostile()),
    "bins": (0, -1, 1.5, 10**6, 2**80, "many", None), "range": (0, -1, 51, numpy.nan, "far", None, Hostile()),
    "gap": (-0.1, 2, "wide", None), "bond": (0.5, 4, numpy.inf, "long"), "rattlers_below": (-1, 0.5, 2**40, "all"),
    "samples": (0, -5, 1.5, 15, "all"), "threads": (-1, 0.5, "all"),
    "only": ("everything", ["pairs", "poros"], [5], [None]),
}
# A value of no option, and values out of the range of each kind of option.
NO_VALUES = [
    {"count": v} for v in (0, -1, 1.5, "many", "1.5", True, 2**53 + 2, 2**70, [1], numpy.nan, Hostile(),
                           numpy.float64(3), b"3", ())
] + [
    {"radius": v} for v in (0, -1, numpy.nan, numpy.inf, "", "x..y", (1,), (1, 2, 3), (1, "b"), "nowhere.txt",
                            True, {}, Hostile(), (0.2, 0.1), 1e300, [numpy.nan, 1], (-1, 1))
] + [
    {"seed": v} for v in (None, -1, 0.5, "x", 2**64, numpy.array([1, 2]))
] + [
    {"preset": v} for v in (None, "", "fats", 1, True, ["fast"], "paper\0")
] + [
    {"camera_target": v} for v in (1, (1, 2), (1, 2, 3, 4), ("a", 0, 0), (numpy.nan, 0, 0), "1,2", [None] * 3)
] + [
    {"size": v} for v in (0, (0, 0), (800,), (800, 600, 3), "800", (-1, 5), (10**9, 10**9), (1.5, 2), None,
                          [[1], [2]])
] + [
    {"spheres_until_full": v} for v in (None, "yes", 1, 0.0, [True])
] + [
    {"motion_restitution": v} for v in (None, -0.1, 1.1, "bouncy", numpy.nan, True, 1j)
] + [
    {"frames": v} for v in ("x", (1.5,), "5..x", [[1]], -1)
] + [
    {"background": v} for v in ("blue-ish", "#12", None, ("#ffffff", "#000000"))
] + [
    {"up": "w"}, {"units": "parsec"}, {"units": 0}, {"wrap": -1}, {"threads": -1}, {"frames_fps": 0}, {"motion_dt": 0},
    {"frames_keep_run": "maybe"}, {"cutaway": "slice"}, {"frames_passes": "colour"}, {"style": "baroque"},
    {"duration": -1}, {"motion_gravity": 0}, {"spheres_group_size": -1}, {"lid": "yes"}, {"search_polygons": "oracle"},
]


class WrongCalls(FolderCase):
    calls = 0

    def refuse(self, function, *arguments, kinds=frostfill.Error, **keywords):
        """The call is refused by an exception of ours, in one sentence."""
        WrongCalls.calls += 1
        try:
            function(*arguments, **keywords)
        except kinds as error:
            sentence = str(error)
            self.assertGreaterEqual(len(sentence.split()), 3, sentence)
            self.assertNotIn("\n", sentence)
            self.assertLess(len(sentence), 500)
            return sentence
        self.fail("was not refused")

    def test_of_vertices(self):
        for (name, wrong), call in itertools.product(
                NO_VERTICES.items(), (frostfill.fill, frostfill.Simulation, frostfill.volume)):
            with self.subTest(vertices=name, call=call.__name__):
                self.refuse(call, vertices=wrong, triangles=FACES)

    def test_of_triangles(self):
        for (name, wrong), call in itertools.product(
                NO_TRIANGLES.items(), (frostfill.Simulation, frostfill.volume)):
            with self.subTest(triangles=name, call=call.__name__):
                self.refuse(call, vertices=CUBE, triangles=wrong)

    def test_of_what_is_inspected(self):
        for name, wrong in NO_POINTS.items():
            with self.subTest(points=name):
                self.refuse(frostfill.inspect, vertices=wrong, triangles=FACES)
                self.refuse(frostfill.inspect, vertices=CUBE, triangles=wrong)

    def test_of_centres_and_radii(self):
        for name, wrong in {**NO_POINTS, "none": None}.items():
            with self.subTest(centres=name):
                self.refuse(frostfill.check, wrong, 0.1, CUBE, FACES)
        for name, wrong in NO_RADII.items():
            with self.subTest(radii=name):
                self.refuse(frostfill.check, CUBE, wrong, CUBE, FACES)
        for wrong in ([True], "no", numpy.ones((8, 1), bool), [True] * 9, Hostile()):
            self.refuse(frostfill.check, CUBE, 0.1, CUBE, FACES, at_rest=wrong)

    def test_of_analyses(self):
        for name, wrong in {**NO_POINTS, "none": None}.items():
            with self.subTest(centres=name):
                self.refuse(frostfill.analyse, wrong, 0.1, CUBE, FACES)
        for name, wrong in NO_RADII.items():
            with self.subTest(radii=name):
                self.refuse(frostfill.analyse, CUBE / 2 + 0.25, wrong, CUBE, FACES)
        for keyword, wrongs in NO_ANALYSIS.items():
            for wrong in wrongs:
                with self.subTest(keyword, wrong=repr(type(wrong))):
                    self.refuse(frostfill.analyse, CUBE / 2 + 0.25, 0.1, CUBE, FACES, **{keyword: wrong})
        self.refuse(frostfill.analyse, CUBE + 5, 0.1, CUBE, FACES)
        self.refuse(frostfill.analyse, CUBE, 0.1)
        self.refuse(frostfill.analyse, CUBE, 0.1, CUBE, FACES, kinds=TypeError, judge_friction=1)
        found = frostfill.analyse(CUBE / 2 + 0.25, 0.1, CUBE, FACES, only="order")
        for part in ("network", "rattlers", "cells", "pairs", "porosity_wall", "sizes_radial"):
            self.refuse(getattr, found, part)
        for wrong in (None, 5, "", "\0"):
            self.refuse(found.save, wrong)
        self.refuse(frostfill.PackingAnalysis, kinds=TypeError)

    def test_of_values(self):
        for wrong in NO_VALUES:
            with self.subTest(**{name: repr(type(value)) for name, value in wrong.items()}):
                sentence = self.refuse(frostfill.Simulation, "cube", **wrong)
                if not sentence.startswith("cannot read"):
                    self.assertIn(next(iter(wrong)), sentence)

    def test_of_meshes(self):
        empty = self.folder / "empty.obj"
        empty.write_text("")
        noise = self.folder / "noise.stl"
        noise.write_bytes(bytes(range(256)) * 20)
        for wrong in (None, "", 5, b"", "no such file.obj", "\0", self.folder, empty, noise, Hostile(), [],
                      pathlib.Path("/nowhere/x.ply"), "x" * 100_000, CUBE, True):
            for call in (frostfill.fill, frostfill.Simulation, frostfill.inspect):
                self.refuse(call, wrong)
        self.refuse(frostfill.fill, "cube", vertices=CUBE, triangles=FACES)
        self.refuse(frostfill.fill, vertices=CUBE)
        self.refuse(frostfill.fill, triangles=FACES)

    def test_of_keywords_name_the_nearest(self):
        for name, nearest in {"cuont": "count", "color": "color_by", "spheres_untilfull": "spheres_until_full",
                              "raduis": "radius", "seeds": "seed", "colour_by": "color_by",
                              "Preset": "preset", "until_full": "spheres_until_full", "sphere_search": "search_spheres"}.items():
            sentence = self.refuse(frostfill.Simulation, "cube", kinds=TypeError, **{name: 1})
            self.assertIn(f"has no keyword '{name}'", sentence)
            if name != "color":
                self.assertIn(f"did you mean '{nearest}'?", sentence)
        sentence = self.refuse(frostfill.Simulation, "cube", kinds=TypeError, zzzzzzzzzzzz=1)
        self.assertIn("help(", sentence)
        # What only a run takes is no keyword of its pictures, nor of instruments.
        simulation = frostfill.Simulation("cube", count=3)
        for name in ("count", "seed", "duration", "mesh", "up"):
            self.refuse(simulation.render, kinds=TypeError, **{name: 1})
        self.refuse(frostfill.check, CUBE, 0.1, CUBE, FACES, kinds=TypeError, count=3)
        self.refuse(frostfill.inspect, "cube", kinds=TypeError, up="z")

    def test_of_files_of_packings(self):
        file = self.folder / "beads.csv"
        file.write_text("a,b,c,r\n1,2,3,4\n")
        read = frostfill.read_packing
        for wrong in (None, 5, "", "\0", Hostile(), "no/such/file", self.folder):
            self.refuse(read, wrong)
        self.refuse(read, file)
        for wrong in (0, -1, numpy.nan, numpy.inf, "1", True):
            self.refuse(read, file, radius=wrong)
        for wrong in ("x=a", {}, 5, {"x": ""}, {"mass": "a"}, {"x": "q"}, {"x": 9}, {"radius": "r", "diameter": "r"}):
            self.refuse(read, file, columns=wrong)
        whole = {"x": "a", "y": "b", "z": "c", "radius": "r"}
        for text, said in {"a,b,c,r\n1,2,3,nan\n": "line 2", "a,b,c,r\n1,2,3,-4\n": "line 2", "a,b,c,r\n1,2\n": "line 2",
                           "a,b,c\n1,2,3\n": "line 1", "": "heading"}.items():
            file.write_text(text)
            self.assertIn(said, self.refuse(read, file, columns=whole))
        file.write_bytes(bytes(40))
        self.assertIn("is not a text", self.refuse(read, file))

    def test_of_runs(self):
        run = frostfill.fill("cube", count=5, duration=0.5, frames_fps=10)
        both = (frostfill.Error, TypeError)
        for wrong in ("x", 1.5, 10**6, -10**6, 2**80, [1], numpy.nan):
            self.refuse(run.frame, wrong)
            self.refuse(run.render, wrong)
        for wrong in (None, 5, "", "\0", Hostile(), "no/such/folder\0x"):
            self.refuse(frostfill.load, wrong)
            self.refuse(run.draw, wrong)
            self.refuse(run.export, wrong, "csv")
            self.refuse(run.save, wrong, kinds=(*both, RuntimeError))
        self.refuse(frostfill.load, "nowhere")
        self.refuse(frostfill.load, self.folder)
        damaged = self.folder / "run.frost"
        damaged.write_bytes(b"FROST" + bytes(1000))
        self.refuse(frostfill.load, damaged)
        whole = run.file.read_bytes()
        damaged.write_bytes(whole[:len(whole) // 3])
        self.refuse(frostfill.load, damaged)
        self.refuse(run.render, zoom=-1)
        self.refuse(run.render, size=(10, 10), picture_backend="crayons")
        self.refuse(run.draw, self.folder / "p", frames="none")
        self.refuse(run.draw, self.folder / "p", turntable=4, camera_path="0:30,20 1:90,20")
        self.refuse(run.export, self.folder / "x", 5)
        self.refuse(run.export, self.folder / "x", "doc")
        self.refuse(run.export, self.folder / "x", "liggths")
        self.refuse(run.export, self.folder / "x.gmsh")
        self.refuse(run.export, self.folder / "x.vtp", frames="seven")
        self.refuse(run.save, damaged)
        self.refuse(run.save, "/proc/nothing/here")
        self.refuse(frostfill.fill, "cube", overwrite=True)
        self.refuse(frostfill.fill, scene=damaged)
        self.refuse(frostfill.fill, scene="nowhere.toml")
        self.refuse(frostfill.fill, "cube", count=3, out="/proc/nothing/here")
        self.assertEqual(len(run.radii), 5)

    def test_of_pictures(self):
        from frostfill import _frostfill
        good = numpy.zeros((4, 5, 3), numpy.uint8)
        self.assertEqual(_frostfill.encode_png(good)[:4], b"\x89PNG")
        for wrong in (None, "x", good[0], good.astype(float), good[:, :, :2], good[:0], good[:, :0],
                      numpy.broadcast_to(numpy.uint8(0), (10**6, 10**6, 3)), good.astype("i1"), Hostile()):
            self.refuse(_frostfill.encode_png, wrong)
        for wrong in (None, "", 5, "/nowhere/x.png", self.folder):
            self.refuse(good.view(frostfill.Picture).save, wrong)

    def test_of_states_that_are_over(self):
        simulation = frostfill.Simulation("cube", count=3)
        simulation.advance()
        self.assertFalse(simulation.step())
        self.assertEqual(simulation.advance(10), 0)
        self.assertEqual(list(simulation), [])
        self.refuse(simulation.advance, -1)
        self.refuse(simulation.advance, "all")
        for made in (frostfill.Snapshot, frostfill.QualityReport, frostfill.MeshReport):
            self.refuse(made, kinds=TypeError)

    def test_leave_errors_that_are_caught_as_ours_and_as_pythons(self):
        with self.assertRaises(ValueError):
            frostfill.Simulation("cube", count=-1)
        with self.assertRaises(OSError) as caught:
            frostfill.load("nowhere")
        self.assertEqual((caught.exception.code, type(caught.exception)), (66, frostfill.InputMissing))
        with self.assertRaises(frostfill.BadData):
            frostfill.Simulation(vertices=CUBE * 0, triangles=FACES)

    @classmethod
    def tearDownClass(cls):
        print(f"{cls.calls} wrong calls were refused")
        assert cls.calls >= 200, cls.calls
        assert threading.active_count() == 1


if __name__ == "__main__":
    unittest.main()
