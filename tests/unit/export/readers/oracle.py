# SPDX-License-Identifier: MIT
"""What the frames of a run hold, and how what a reader found is compared with it."""
import itertools
import json
import math
import pathlib
import struct

# The oracle's names of columns, and how many bytes of which kind a number takes: d, f, I, B, q as in struct.
COLUMNS = {"radius": "radii", "state": "states", "group": "groups", "set": "sets", "speed": "speeds",
           "id": "ids", "contacts": "contacts"}
KINDS = {"x": "d", "y": "d", "z": "d", "radius": "d", "id": "I", "state": "B", "group": "I", "set": "I",
         "speed": "f", "contacts": "I"}


class Oracle:
    """Frames as the run file has them: lists, in the order of the ids."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        data = json.loads((self.folder / "oracle.json").read_text())
        self.frames, self.vertices, self.triangles = data["frames"], data["vertices"], data["triangles"]
        low, high = (tuple(f(v[i] for v in self.vertices) for i in range(3)) for f in (min, max))
        self.origin = [(a + b) / 2 for a, b in zip(low, high)]
        for frame in self.frames:
            for name in ("centres", "radii", "states", "groups", "speeds", "contacts"):
                frame.setdefault(name, [])  # of a frame without spheres
            frame["sets"] = [group // data["groups_per_set"] for group in frame["groups"]]
            frame["ids"] = list(range(len(frame["radii"])))
            frame["vertices"] = [self.in_world(frame, v) for v in self.vertices]
            corners = [self.in_world(frame, v) for v in itertools.product(*zip(low, high))]
            frame["box"] = [[f(v[i] for v in corners) for i in range(3)] for f in (min, max)]
        self.faults = []
        self.compared = 0

    def in_world(self, frame, point):
        """Where a point of the mesh is in a frame."""
        from_origin = [a - b for a, b in zip(point, self.origin)]
        return [o + t + sum(r * p for r, p in zip(row, from_origin))
                for o, t, row in zip(self.origin, frame["offset"], frame["rotation"])]

    def file(self, name):
        return self.folder / "export" / name

    def files(self, ending, names):
        """No file with this ending is there but these."""
        self.equal("files", sorted(path.name for path in self.file("").glob(f"*.{ending}")), sorted(names))

    def equal(self, what, found, wanted):
        """Compares what is no number: a word, a line, a shape."""
        self.compared += 1
        if found != wanted:
            self.faults.append(f"{what}: {found!r}, and not {wanted!r}")

    def same(self, what, found, wanted, tolerance=0.0):
        """Compares numbers, or lists of them. A tolerance is relative to the unit of the mesh."""
        found, wanted = flat(found), flat(wanted)
        if len(found) != len(wanted):
            self.faults.append(f"{what}: {len(found)} numbers, and not {len(wanted)}")
            return
        self.compared += len(wanted)
        for i, (a, b) in enumerate(zip(found, wanted)):
            if not abs(a - b) <= tolerance and not (math.isnan(a) and math.isnan(b)):
                self.faults.append(f"{what}: number {i} is {a!r}, and not {b!r}")
                return

    def frame(self, what, index, found, tolerance=0.0):
        """Compares the columns of `found`, a dictionary, with frame `index`. Of a column that the oracle
        does not know it only asks for a finite number for each sphere."""
        for name, values in found.items():
            if name == "speeds":  # single precision, written with the digits that it needs
                values = [struct.unpack("f", struct.pack("f", value))[0] for value in values]
            if name in self.frames[index]:
                self.same(f"{what}, frame {index}, {name}", values, self.frames[index][name], tolerance)
            else:
                self.equal(f"{what}, frame {index}, {name}", [len(values), all(map(math.isfinite, values))],
                           [len(self.frames[index]["ids"]), True])

    def finish(self):
        for fault in self.faults[:10]:
            print(fault)
        if not self.compared:
            print("nothing was compared")
        raise SystemExit(0 if self.compared and not self.faults else 1)


def flat(values):
    if not hasattr(values, "__len__"):
        return [float(values)]
    return [x for value in values for x in flat(value)]
