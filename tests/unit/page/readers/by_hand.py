"""Reads a page with Python's standard library and compares every number of every frame with oracle.json.

The script `facts` of a page is JSON: scene, summary, colours, strokes. The script `sections` is base64 of a zlib stream of the
sections that facts.sections names, each with its length. Counts, differences and ids are written as docs/run-file.md says.

    points, normals, creases: corners of the shell in unit space, as floats; 16-bit normals; distances from creases
    triangles: differences of three numbers of corners each
    edges, edgeKinds: the triangles beside each edge, in which corner it is not, how strongly it is drawn
    frames, times, poses, changes, state, x, y, z, radius, group, speed, contacts:uint32: the frames, in the streams of the run file, without exact

Places are in units of film.step from origin, radii in units of film.radius_step; a speed of 255 is film.fastest, or more.
film.columns says of radius, group and speed when they change; film.carried names the streams of the other columns.
"""
import base64
import collections
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
        self.data, self.at = sections.get(name, b""), 0

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


readers = collections.defaultdict(lambda: Reader("nothing"), {name: Reader(name) for name in sections})
axes = [readers[axis] for axis in "xyz"]
film = facts["film"]
frames = len(film["frames"])
times, poses = (list(struct.unpack(f"<{len(data) // 8}d", data))
                for data in (sections["times"], sections.get("poses", b"")))
time, pose, counts = 0, None, [0] * 6
spheres, polygons, renewed = {}, [0] * facts["triangles"], [0, 0, 0, 0, 0]
assert film["carried"] == {"contacts": {"stream": "contacts:uint32", "whole": True}}
contacts = {}


def next_frame():
    global time, pose, counts
    flags = readers["frames"].count()
    if flags == 2:
        return
    time, pose = times.pop(0), [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]
    counts = [count + readers["frames"].difference() for count in counts]
    if flags == 1:
        pose, poses[:12] = poses[:12], []
    changes = readers["changes"]
    n = changes.count()
    for gone in [each for each in spheres if each >= n]:
        del spheres[gone]
    ran = {i for i, sphere in spheres.items() if sphere["state"] == 0}
    new = changes.ids()
    for i in new:
        for k, name in enumerate(["x", "y", "z", "radius", "group"]):
            renewed[k] += readers[name].difference()
        spheres[i] = {"place": renewed[:3], "gone": [0, 0, 0], "radius": renewed[3], "group": renewed[4],
                      "speed": 0, "state": readers["state"].count()}
    for i in changes.ids():
        spheres[i]["state"] = readers["state"].count()
    new = set(new)
    for i in range(n):
        sphere = spheres[i]
        runs = sphere["state"] == 0
        if i not in new and (runs or i in ran):
            sphere["gone"] = [g + axis.difference() for g, axis in zip(sphere["gone"], axes)]
            sphere["place"] = [p + g for p, g in zip(sphere["place"], sphere["gone"])]
            if not runs:
                sphere["gone"] = [0, 0, 0]
        sphere["speed"] = (sphere["speed"] if i in ran else 0) + readers["speed"].difference() if runs else 0
    for i in changes.ids():
        polygons[i] ^= 1
    for i in [each for each in contacts if each >= n]:
        del contacts[i]
    for i in readers["contacts:uint32"].ids():
        contacts[i] = contacts.get(i, 0) + readers["contacts:uint32"].difference()


def in_world(place, pose):
    fromOrigin = [film["step"] * p for p in place]
    turned = [sum(pose[3 * row + k] * fromOrigin[k] for k in range(3)) for row in range(3)]
    return [facts["origin"][k] + pose[9 + k] + turned[k] for k in range(3)]


smallest = min(oracle["frames"][-1]["radii"])
assert film["step"] / 2 <= 0.001 * smallest and film["error_over_radius"] <= 0.001
assert abs(film["error_over_radius"] * smallest - film["step"] / 2) < 1e-12
assert film["frames"] == [frame["number"] for frame in oracle["frames"]]
worst = 0
for frame in oracle["frames"]:
    next_frame()
    assert time == frame["time"]
    centres = frame.get("centres") or []
    assert len(spheres) == len(centres)
    waiting = frame.get("waiting") or []
    states = [3 if waits else state for waits, state in zip(waiting, frame.get("states") or [])]
    assert counts[2:] == [states.count(0), states.count(1), states.count(2), sum(frame["polygons"])]
    assert polygons == frame["polygons"]
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
assert not times and not poses
for name in ["frames", "changes", "state", "x", "y", "z", "radius", "group", "speed",
             "contacts:uint32"]:
    assert readers[name].at == len(sections[name]), name
assert not sections["exact"]

points = struct.unpack(f"<{len(sections['points']) // 4}f", sections["points"])
corner = 0
for triangle in oracle["triangles"]:
    for vertex in triangle:
        corner += readers["triangles"].difference()
        for k in range(3):
            there = points[3 * corner + k] / facts["scale_of_unit"] + facts["centre"][k]
            assert abs(there - oracle["vertices"][vertex][k]) < 1e-6 / facts["scale_of_unit"]
assert readers["triangles"].at == len(sections["triangles"])


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def unit(a):
    length = sum(p * p for p in a) ** 0.5
    return [p / length for p in a]


def normal_of(triangle):
    a, b, c = (oracle["vertices"][k] for k in triangle)
    u, v = minus(b, a), minus(c, a)
    return unit([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]])


def cosine(a, b):
    return sum(p * q for p, q in zip(a, b))


# The torus is smooth: each normal is the one of the ring's tube at its vertex, to the sharpness of the mesh.
normals = struct.unpack(f"<{len(sections['normals']) // 2}h", sections["normals"])
assert len(normals) == len(points)
readers["triangles"].at, corner = 0, 0
for triangle in oracle["triangles"]:
    for vertex in triangle:
        corner += readers["triangles"].difference()
        normal = [part / 32767 for part in normals[3 * corner:3 * corner + 3]]
        assert abs(cosine(normal, normal) - 1) < 2e-4, normal
        assert cosine(normal, normal_of(triangle)) > 0.9, (normal, triangle)
# It has no crease, so that all of it is as far from one as can be said.
assert set(sections["creases"]) == {255} and 3 * len(sections["creases"]) == len(points)

# Each edge is there once, beside its two triangles, opposite the corners that it names.
wanted = {tuple(sorted(triangle[k] for k in range(3) if k != c))
          for triangle in oracle["triangles"] for c in range(3)}
found, first = set(), 0
kinds = sections["edgeKinds"]
for edge in range(len(kinds) // 2):
    first += readers["edges"].difference()
    second = first + readers["edges"].difference()
    ends = []
    for t, opposite in ((first, kinds[2 * edge] % 4), (second, kinds[2 * edge] // 4)):
        ends.append(tuple(sorted(v for k, v in enumerate(oracle["triangles"][t]) if k != opposite)))
    assert first != second and ends[0] == ends[1], (edge, ends)
    assert kinds[2 * edge + 1] == 60, "an edge of a smooth surface is drawn plainly"
    found.add(ends[0])
assert found == wanted and len(kinds) == 2 * len(wanted)
assert readers["edges"].at == len(sections["edges"])
print(f"{frames} frames: places are within {worst / smallest:.2g} r; "
      f"the page states {film['error_over_radius']:.2g} r")
