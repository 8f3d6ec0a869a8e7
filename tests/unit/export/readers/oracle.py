# SPDX-License-Identifier: MIT
"""What the frames of a run hold, and how what a reader found is compared with it."""
import json
import math
import pathlib
import struct


class Oracle:
    """Frames as the run file has them: lists, in the order of the ids."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        data = json.loads((self.folder / "oracle.json").read_text())
        self.frames, self.vertices, self.triangles = data["frames"], data["vertices"], data["triangles"]
        for frame in self.frames:
            for name in ("centres", "radii", "states", "groups", "speeds"):
                frame.setdefault(name, [])  # of a frame without spheres
            frame["sets"] = [group // data["groups_per_set"] for group in frame["groups"]]
            frame["ids"] = list(range(len(frame["radii"])))
        self.faults = []
        self.compared = 0

    def file(self, name):
        return self.folder / "export" / name

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
        """Compares the columns of `found`, a dictionary, with frame `index`."""
        for name, values in found.items():
            if name == "speeds":  # single precision, written with the digits that it needs
                values = [struct.unpack("f", struct.pack("f", value))[0] for value in values]
            self.same(f"{what}, frame {index}, {name}", values, self.frames[index][name], tolerance)

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
