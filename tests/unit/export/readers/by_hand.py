# SPDX-License-Identifier: MIT
"""Reads what was exported with nothing but Python's standard library: by_hand.py FOLDER FORMAT

The readers follow the definitions of the formats, and ask for all that these ask for: counts, versions,
types, lengths. Columns are read by the names that the file gives them."""
import csv
import re
import struct
import sys

from by_hand_gltf import read_glb, read_instanced
from by_hand_vtp import read_vtp
from oracle import COLUMNS, KINDS, Oracle

PLACE = ["x", "y", "z"]


def named(rows, names, first_id=0):
    """Columns of a table by the oracle's names."""
    assert all(len(row) == len(names) for row in rows), f"a row has not {len(names)} values"
    assert len(set(names)) == len(names), names
    columns = {COLUMNS.get(name, name): [float(row[i]) for row in rows]
               for i, name in enumerate(names) if name not in PLACE}
    x = names.index("x")
    assert names[x:x + 3] == PLACE, names
    columns["centres"] = [[float(value) for value in row[x:x + 3]] for row in rows]
    columns["ids"] = [i - first_id for i in columns["ids"]]
    return columns


def required(oracle, names, wanted):
    oracle.equal("columns that are missing", [name for name in wanted if name not in names], [])


def whole(oracle, names, rows):
    """Numbers that count are written without a fraction."""
    for i, name in enumerate(names):
        if KINDS.get(name) in ("I", "B"):
            oracle.equal(name, [row[i] for row in rows if not row[i].isdigit()], [])


def read_csv(oracle):
    oracle.files("csv", [f"spheres_{frame['number']:05}.csv" for frame in oracle.frames])
    for k, frame in enumerate(oracle.frames):
        rows = list(csv.reader(oracle.file(f"spheres_{frame['number']:05}.csv").open()))
        oracle.equal("first column", rows[0][0], "id")
        required(oracle, rows[0], KINDS)
        whole(oracle, rows[0], rows[1:])
        oracle.frame("csv", k, named(rows[1:], rows[0]))


def read_xyz(oracle):
    lines = oracle.file("spheres.xyz").read_text().splitlines()
    at = 0
    for k, frame in enumerate(oracle.frames):
        count = int(lines[at])
        facts = {key: quoted or word for key, quoted, word in
                 re.findall(r'(\w+)=(?:"([^"]*)"|(\S+))', lines[at + 1])}
        oracle.same("time", float(facts["Time"]), frame["time"])
        oracle.same("number", int(facts["frame"]), frame["number"])
        oracle.same("step", int(facts["step"]), frame["step"])
        low, high = frame["box"]
        x, y, z = (b - a for a, b in zip(low, high))
        lattice = [float(word) for word in facts["Lattice"].split()]
        oracle.same("lattice", lattice, [x, 0, 0, 0, y, 0, 0, 0, z], 1e-12)
        oracle.same("origin", [float(word) for word in facts["Origin"].split()], low, 1e-12)
        oracle.equal("periodic", facts["pbc"], "F F F")
        fields = facts["Properties"].split(":")
        names, letters, widths = fields[::3], fields[1::3], list(map(int, fields[2::3]))
        oracle.equal("first fields", (names[:2], letters[:2], widths), (["species", "pos"], ["S", "R"],
                     [1, 3] + [1] * (len(names) - 2)))
        required(oracle, names, ("radius", "id", "state", "group", "set", "speed"))
        for name, letter in zip(names, letters):
            if name in KINDS:
                oracle.equal(f"type of {name}", letter, "R" if KINDS[name] in "df" else "I")
        rows = [line.split(" ") for line in lines[at + 2:at + 2 + count]]
        oracle.equal("species", [row[0] for row in rows if row[0] != "X"], [])
        columns = PLACE + names[2:]
        whole(oracle, columns, [row[1:] for row in rows])
        oracle.frame("xyz", k, named([row[1:] for row in rows], columns))
        at += 2 + count
    oracle.same("lines", at, len(lines))


def bounds(lines):
    """Lower and upper corner from a line an axis."""
    return [list(column) for column in zip(*(map(float, line.split()[:2]) for line in lines))]


def read_dump(oracle):
    lines = oracle.file("spheres.dump").read_text().splitlines()
    at = 0
    for k, frame in enumerate(oracle.frames):
        oracle.equal("items", lines[at:at + 6:2] + lines[at + 6:at + 7],
                     ["ITEM: TIME", "ITEM: TIMESTEP", "ITEM: NUMBER OF ATOMS", "ITEM: BOX BOUNDS ff ff ff"])
        oracle.same("time", float(lines[at + 1]), frame["time"])
        oracle.same("number", int(lines[at + 3]), frame["number"])
        count = int(lines[at + 5])
        oracle.same("box", bounds(lines[at + 7:at + 10]), frame["box"], 1e-12)
        names = lines[at + 10].split()
        oracle.equal("columns", names[:4], ["ITEM:", "ATOMS", "id", "type"])
        names = names[2:]
        required(oracle, names, KINDS)
        rows = [line.split(" ") for line in lines[at + 11:at + 11 + count]]
        whole(oracle, names, rows)
        columns = named(rows, names, first_id=1)
        oracle.same("types", [i - 1 for i in columns.pop("type")], columns["states"])
        oracle.frame("dump", k, columns)
        at += 11 + count
    oracle.same("lines", at, len(lines))


READERS = {"csv": read_csv, "xyz": read_xyz, "lammps-dump": read_dump,
           "vtp": read_vtp, "glb": read_glb,
           "glb-instanced": read_instanced}

if __name__ == "__main__":
    run = Oracle(sys.argv[1])
    READERS[sys.argv[2]](run)
    run.finish()
