# SPDX-License-Identifier: MIT
"""Runs the inputs of other programs as they are: with_inputs.py FOLDER liggghts|lammps|yade|gmsh. What the
program has read is compared with the run; a run of its own has to go to its end with every sphere."""
import pathlib
import re
import subprocess
import sys

from oracle import Oracle

run = Oracle(sys.argv[1])
last = run.frames[-1]
EXPORT = run.file("")


def call(*words):
    done = subprocess.run(words, cwd=EXPORT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout[-3000:], done.stderr[-1000:])
        raise SystemExit(1)
    return done.stdout


def inside(centres):
    """Nothing has left the box by more than a radius."""
    low, high = last["box"]
    out = [c for c in centres if any(not a - r < x < b + r for x, a, b, r in
                                     zip(c, low, high, 3 * [max(last["radii"])]))]
    run.equal("spheres out of the box in the end", out, [])


def dumped(name):
    """The first and the last state of a dump: id, type, x, y, z, radius."""
    blocks = pathlib.Path(EXPORT, name).read_text().split("ITEM: ATOMS")[1:]
    first, end = ([[float(word) for word in line.split()] for line in block.split("ITEM:")[0].splitlines()[1:]]
                  for block in (blocks[0], blocks[-1]))
    run.equal("states", len(blocks), 2)
    run.same("ids", [row[0] - 1 for row in first], last["ids"])
    run.same("centres", [row[2:5] for row in first], last["centres"], 1e-12)
    run.same("radii", [row[5] for row in first], last["radii"], 1e-14)
    run.same("ids in the end", [row[0] - 1 for row in end], last["ids"])
    inside([row[2:5] for row in end])


def liggghts():
    said = call("liggghts", "-in", "liggghts.in", "-log", "none")
    dumped("liggghts.dump")
    run.equal("triangles of the walls", f"imported {len(run.triangles)}" in said.lower()
              or str(len(run.triangles)) in said, True)


def lammps():
    call("lmp", "-in", "lammps.in", "-log", "none")
    dumped("lammps.dump")


def yade():
    """What is read is written by YADE before the first step. Its steps are slow: only a hundred are taken."""
    script = pathlib.Path(EXPORT, "yade.py")
    text = script.read_text()
    text, count = re.subn(r"^O\.run\(ceil\(.*\), True\)$", """
with open("read.txt", "w") as file:
    for body in O.bodies:
        shape = body.shape
        file.write(repr((shape.radius, *body.state.pos) if isinstance(shape, Sphere)
                        else [list(body.state.pos + corner) for corner in shape.vertices]) + "\\\\n")
O.run(100, True)""", text, flags=re.MULTILINE)
    run.equal("runs in the script", count, 1)
    script.write_text(text)
    call("yade", "-n", "-x", "yade.py")
    read = [eval(line) for line in pathlib.Path(EXPORT, "read.txt").read_text().splitlines()]  # noqa: S307
    balls = [row for row in read if isinstance(row, tuple)]
    run.same("radii", [row[0] for row in balls], last["radii"], 1e-15)
    run.same("centres", [row[1:] for row in balls], last["centres"], 1e-15)
    run.equal("walls", len(read) - len(balls), len(run.triangles))
    run.same("corners of the walls", read[len(balls):],
             [[last["vertices"][corner] for corner in triangle] for triangle in run.triangles], 1e-14)
    end = [[float(word) for word in line.split()]
           for line in pathlib.Path(EXPORT, "yade_end.txt").read_text().splitlines()[1:]]
    run.same("radii in the end", [row[3] for row in end], last["radii"], 1e-15)
    inside([row[:3] for row in end])


globals()[sys.argv[2]]()
run.finish()
