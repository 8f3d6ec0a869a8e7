"""Reads a page with Python's standard library and compares every number of every frame with oracle.json."""
import base64
import json
import re
import struct
import sys
import zlib

folder = sys.argv[1]
page = open(f"{folder}/view.html", encoding="utf-8").read()
oracle = json.load(open(f"{folder}/oracle.json"))


def script(name):
    return re.search(rf'<script id="{name}"[^>]*>(.*?)</script>', page, re.S).group(1)


facts = json.loads(script("facts"))
packed = zlib.decompress(base64.b64decode(script("sections"), validate=True))
sections, at = {}, 0
for name, size in facts["sections"]:
    sections[name], at = packed[at:at + size], at + size
assert at == len(packed)


class Reader:
    def __init__(self, name):
        self.data, self.at = sections[name], 0

    def count(self):
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def difference(self):
        folded = self.count()
        return folded // 2 if folded % 2 == 0 else -(folded + 1) // 2

    def ids(self):
        ids, before = [], 0
        for _ in range(self.count()):
            before += self.count()
            ids.append(before)
        return ids


readers = {name: Reader(name) for name, _ in facts["sections"]}
axes = [readers[axis] for axis in "xyz"]
film = facts["film"]
frames = len(film["frames"])
times = struct.unpack(f"<{frames}d", sections["times"])
poses = struct.unpack(f"<{12 * frames}d", sections["poses"])
spheres, polygons, renewed = {}, [0] * facts["triangles"], [0, 0, 0, 0, 0]
contacts = {}
assert film["columns"] == [{"name": "contacts", "whole": True}]


def next_frame():
    changes = readers["changes"]
    if changes.count() == 0:
        return
    n = changes.count()
    for gone in [each for each in spheres if each >= n]:
        del spheres[gone]
    ran = {i for i, sphere in spheres.items() if sphere["state"] == 0}
    new = changes.ids()
    for i in new:
        for k, name in enumerate(["x", "y", "z", "radii", "groups"]):
            renewed[k] += readers[name].difference()
        spheres[i] = {"place": renewed[:3], "gone": [0, 0, 0], "radius": renewed[3], "group": renewed[4],
                      "speed": 0, "state": readers["states"].count()}
    for i in changes.ids():
        spheres[i]["state"] = readers["states"].count()
    new = set(new)
    for i in range(n):
        sphere = spheres[i]
        runs = sphere["state"] == 0
        if i not in new and (runs or i in ran):
            sphere["gone"] = [g + axis.difference() for g, axis in zip(sphere["gone"], axes)]
            sphere["place"] = [p + g for p, g in zip(sphere["place"], sphere["gone"])]
            if not runs:
                sphere["gone"] = [0, 0, 0]
        sphere["speed"] = sphere["speed"] + readers["speeds"].difference() if runs else 0
    for i in changes.ids():
        polygons[i] ^= 1
    for i in [i for i in contacts if i >= n]:
        del contacts[i]
    for i in readers["columns"].ids():
        contacts[i] = contacts.get(i, 0) + readers["columns"].difference()


def in_world(place, pose):
    fromOrigin = [film["step"] * p for p in place]
    turned = [sum(pose[3 * row + k] * fromOrigin[k] for k in range(3)) for row in range(3)]
    return [facts["origin"][k] + pose[9 + k] + turned[k] for k in range(3)]


smallest = min(oracle["frames"][-1]["radii"])
assert film["step"] / 2 <= 0.001 * smallest and film["error_over_radius"] <= 0.001
assert abs(film["error_over_radius"] * smallest - film["step"] / 2) < 1e-12
assert film["frames"] == [frame["number"] for frame in oracle["frames"]]
worst = 0
for index, frame in enumerate(oracle["frames"]):
    next_frame()
    assert times[index] == frame["time"]
    centres = frame.get("centres") or []
    assert len(spheres) == len(centres)
    waiting = frame.get("waiting") or []
    states = [3 if waits else state for waits, state in zip(waiting, frame.get("states") or [])]
    counts = [readers["counts"].count() for _ in range(4)]
    assert counts == [states.count(0), states.count(1), states.count(2), sum(frame["polygons"])]
    assert polygons == frame["polygons"]
    pose = poses[12 * index:12 * index + 12]
    for i, centre in enumerate(centres):
        sphere = spheres[i]
        assert contacts.get(i, 0) == frame["contacts"][i]
        assert sphere["state"] == states[i] and sphere["group"] == frame["groups"][i]
        assert abs(sphere["radius"] * film["radius_step"] - frame["radii"][i]) <= film["radius_step"] / 2
        # Each coordinate of the mesh's frame is within half a step, whichever way the object is turned.
        apart = [a - b for a, b in zip(in_world(sphere["place"], pose), centre)]
        turned_back = [sum(pose[3 * row + k] * apart[row] for row in range(3)) for k in range(3)]
        worst = max(worst, *map(abs, turned_back))
        speed = 0 if waiting[i] else min(frame["speeds"][i], film["fastest"])
        shown = sphere["speed"] / 255 * film["fastest"]
        assert abs(shown - speed) <= film["fastest"] / 509, (i, shown, speed)
assert worst <= film["step"] / 2 * (1 + 1e-6), (worst, film["step"])
assert worst > film["step"] / 8, "places are finer than they need be"
for name in ["changes", "x", "y", "z", "radii", "groups", "states", "speeds", "counts", "columns"]:
    assert readers[name].at == len(sections[name]), name

points = struct.unpack(f"<{len(sections['points']) // 4}f", sections["points"])
corner = 0
for triangle in oracle["triangles"]:
    for vertex in triangle:
        corner += readers["triangles"].difference()
        for k in range(3):
            there = points[3 * corner + k] / facts["scale_of_unit"] + facts["centre"][k]
            assert abs(there - oracle["vertices"][vertex][k]) < 1e-6 / facts["scale_of_unit"]
print(f"{frames} frames: places are within {worst / smallest:.2g} r; "
      f"the page states {film['error_over_radius']:.2g} r")
