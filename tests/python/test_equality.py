# SPDX-License-Identifier: MIT
"""Python gives what the program gives, to the last bit."""
import json

import numpy
from support import SOURCE, FolderCase, frostfill, run_program, unittest

METHODS = [("fast", "fall"), ("fast", "skip"), ("fast", "descend"), ("paper", "fall")]


def meshes():
    """Built-in ones, one with narrow parts, and files, where they are."""
    shared = SOURCE.parent / "shared" / "meshes"
    files = [shared / "spot.obj", shared / "stanford-bunny.obj"]
    return ["torus", "human", str(SOURCE / "meshes" / "cube.obj")] + [
        str(file) for file in files if file.exists()]


class Equality(FolderCase):
    def program_summary(self, mesh, *options):
        out = self.folder / "program"
        return json.loads(
            run_program("fill", mesh, *options, "--frames", "none", "--json", "--overwrite",
                        "--out", out))

    def test_state_hashes_are_those_of_the_program(self):
        for mesh in meshes():
            for preset, motion in METHODS:
                with self.subTest(mesh=mesh, preset=preset, motion=motion):
                    expected = self.program_summary(
                        mesh, "--preset", preset, "--motion", motion, "--count", "60", "--seed", "3")
                    run = frostfill.fill(mesh, preset=preset, motion=motion, count=60, seed=3)
                    self.assertEqual(run.state_hash, expected["state_hash"])
                    simulation = frostfill.Simulation(
                        mesh, preset=preset, motion=motion, count=60, seed=3)
                    simulation.advance()
                    self.assertEqual(simulation.state_hash(), expected["state_hash"])

    def test_states_are_those_of_the_table_of_spheres(self):
        run = frostfill.fill("torus", count=60, out=self.folder / "run")
        table = numpy.genfromtxt(self.folder / "run" / "spheres.csv", delimiter=",", names=True,
                                 dtype=None, encoding="ascii")
        for axis, name in enumerate("xyz"):
            self.assertTrue(numpy.array_equal(run.centres[:, axis], table[name]))
        self.assertTrue(numpy.array_equal(run.radii, table["radius"]))
        self.assertTrue(numpy.array_equal(run.groups, table["group"]))
        names = [frostfill.SphereState(state).name.lower() for state in run.states]
        self.assertEqual(names, table["state"].tolist())
        self.assertEqual(set(names), {"frozen", "discarded"})

    def test_a_mesh_in_arrays_is_the_mesh_of_its_file(self):
        read = frostfill.Simulation("cube", count=50)
        given = frostfill.Simulation(vertices=read.vertices, triangles=read.triangles, count=50,
                                     name="cube")
        for simulation in (read, given):
            simulation.advance()
        self.assertEqual(read.state_hash(), given.state_hash())

    def test_a_picture_is_the_one_of_the_program(self):
        run = frostfill.fill("torus", count=40, duration=2, frames_fps=10, out=self.folder / "run")
        run_program("render", self.folder / "run", "--out", self.folder / "drawn", "--frames", "12",
                    "--size", "200x150", "--color-by", "height", "--quiet")
        frame = run.render(frame=12, size=(200, 150), color_by="height")
        file = self.folder / "frame.png"
        frame.save(file)
        difference = pixels(file).astype(int) - pixels(self.folder / "drawn/frames/frame_00012.png")
        self.assertEqual(numpy.abs(difference).max(), 0)


def pixels(file):
    """Of a PNG with 8 bits a channel and no interlacing, read by hand."""
    import struct
    import zlib

    data = file.read_bytes()
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    channels = {2: 3, 6: 4}[colour]
    rows = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, -1)
    result = numpy.zeros((height, width * channels), numpy.uint8)
    before = numpy.zeros(width * channels, numpy.uint8)
    for y, row in enumerate(rows):
        before = result[y] = unfiltered(int(row[0]), row[1:], before, channels)
    return result.reshape(height, width, channels)


def unfiltered(kind, row, above, channels):
    """A row of a PNG without its filter: section 9.2 of its specification."""
    if kind == 0:
        return row
    if kind == 2:
        return row + above
    out = numpy.zeros_like(row)
    for i, value in enumerate(row.tolist()):
        left = int(out[i - channels]) if i >= channels else 0
        up = int(above[i])
        corner = int(above[i - channels]) if i >= channels else 0
        guess = left + up - corner
        nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up),
                      (abs(guess - corner), 2, corner))[2]
        out[i] = (value + {1: left, 3: (left + up) // 2, 4: nearest}[kind]) % 256
    return out


if __name__ == "__main__":
    unittest.main()
