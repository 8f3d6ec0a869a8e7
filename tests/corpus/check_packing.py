#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges a packing by means that share nothing with the program that made it.

    tests/corpus/check_packing.py RUN_DIR [--walls FILE] [--inside FILE] [--slack LENGTH]

RUN_DIR is the folder of a run, with spheres.csv and summary.json. WALLS holds triangles as nine
little-endian doubles each, in the unit of the mesh file, INSIDE a closed surface; without them the
run's own mesh.ply is taken. Needs numpy; exits 77 without it, 1 if something is wrong.

- A centre is outside where the winding number [van Oosterom and Strackee 1983] is at most 1/2.
- A wall overlap is how far a triangle, from either side, lies within a sphere.
- A sphere at rest is unsupported when the best push of at most three contacts leaves more than a
  tenth of its weight; a gap of up to a hundredth of its radius is a contact.
"""

import argparse
import csv
import itertools
import json
import math
import pathlib
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: the checker needs numpy (python3-numpy)")
    sys.exit(77)

GAP = 0.01  # [r] below which a gap counts as a contact
UNSUPPORTED = 0.1  # [1] of the weight that may remain
OVERLAP = 1e-7  # [r] that rounding may leave
AT_ONCE = 2_000_000  # pairs of sphere and triangle held in memory at a time
IN_CACHE = 8192  # triangles at a time


def read_triangles(path):
    """n x 3 x 3 coordinates of a plain list or of a run's mesh.ply."""
    data = pathlib.Path(path).read_bytes()
    if not data.startswith(b"ply"):
        return np.frombuffer(data, "<f8").reshape(-1, 3, 3)
    head, _, body = data.partition(b"end_header\n")
    counts = [int(line.split()[2]) for line in head.split(b"\n") if line.startswith(b"element")]
    if b"property double x" not in head or b"list uchar uint" not in head or len(counts) != 2:
        raise ValueError(f"{path} is not a mesh.ply of a run")
    vertices = np.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    faces = np.frombuffer(body, np.dtype([("n", "u1"), ("v", "<u4", 3)]), counts[1],
                          24 * counts[0])
    return vertices[faces["v"]]


def winding_numbers(points, triangles):
    """Sums the solid angles of all triangles; one coordinate at a time, which is several times
    faster than arrays of vectors."""
    result = np.zeros(len(points))
    corners = [[np.ascontiguousarray(triangles[:, k, axis]) for axis in range(3)] for k in range(3)]
    for begin in range(0, len(triangles), IN_CACHE):
        part = [[axis[begin:begin + IN_CACHE] for axis in corner] for corner in corners]
        for i, p in enumerate(points):
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
                [axis - coordinate for axis, coordinate in zip(corner, p)] for corner in part)
            a = np.sqrt(ax * ax + ay * ay + az * az)
            b = np.sqrt(bx * bx + by * by + bz * bz)
            c = np.sqrt(cx * cx + cy * cy + cz * cz)
            over = (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx))
            under = (a * b * c + (ax * bx + ay * by + az * bz) * c
                     + (bx * cx + by * cy + bz * cz) * a + (cx * ax + cy * ay + cz * az) * b)
            result[i] += np.arctan2(over, under).sum()
    return result / (2 * math.pi)


def dot(a, b):
    return np.einsum("ij,ij->i", a, b)


def closest_on_segment(p, a, b):
    d = b - a
    length = dot(d, d)
    t = np.clip(dot(p - a, d) / np.where(length > 0, length, 1), 0, 1)
    return a + t[:, None] * d


def closest_points(p, t):
    """The point of each triangle of t that is closest to the point of p in the same row."""
    a, b, c = t[:, 0], t[:, 1], t[:, 2]
    best = closest_on_segment(p, a, b)
    for q in (closest_on_segment(p, b, c), closest_on_segment(p, c, a)):
        nearer = dot(p - q, p - q) < dot(p - best, p - best)
        best = np.where(nearer[:, None], q, best)
    normal = np.cross(b - a, c - a)
    area = dot(normal, normal)
    normal = normal / np.sqrt(np.where(area > 0, area, 1))[:, None]
    q = p - dot(p - a, normal)[:, None] * normal
    above = (area > 0)
    for s, e in ((a, b), (b, c), (c, a)):
        above &= dot(np.cross(e - s, q - s), normal) >= 0
    return np.where(above[:, None], q, best)


def near_triangles(centres, reach, triangles):
    """Pairs (sphere, triangle) that may be closer than `reach` of the sphere."""
    middle = triangles.mean(axis=1)
    around = np.sqrt(((triangles - middle[:, None]) ** 2).sum(axis=2).max(axis=1))
    spheres, those = [], []
    step = max(1, AT_ONCE // max(len(triangles), 1))
    for begin in range(0, len(centres), step):
        p = centres[begin:begin + step]
        squared = sum((p[:, None, k] - middle[None, :, k]) ** 2 for k in range(3))
        limit = (reach[begin:begin + step, None] + around[None]) * (1 + 1e-9)
        i, j = np.nonzero(squared <= limit * limit)
        spheres.append(i + begin)
        those.append(j)
    return np.concatenate(spheres), np.concatenate(those)


def near_pairs(centres, radii):
    """Pairs of spheres whose gap is at most a hundredth of the larger radius, by a list of cells."""
    cell = 2 * radii.max() * (1 + GAP)
    keys = np.floor((centres - centres.min(axis=0)) / cell).astype(np.int64)
    cells = {}
    for i, key in enumerate(map(tuple, keys)):
        cells.setdefault(key, []).append(i)
    first, second = [], []
    for key, members in cells.items():
        for step in itertools.product((-1, 0, 1), repeat=3):
            for j in cells.get(tuple(k + s for k, s in zip(key, step)), ()):
                for i in members:
                    if i < j:
                        first.append(i)
                        second.append(j)
    i, j = np.array(first, int), np.array(second, int)
    distance = np.sqrt(((centres[i] - centres[j]) ** 2).sum(axis=1))
    keep = distance < radii[i] + radii[j] + GAP * np.maximum(radii[i], radii[j])
    return i[keep], j[keep], distance[keep]


def inner(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def left_by_two(m, n, down):
    """What of the weight is left when two normals carry it, or 1 if one of them would have to pull."""
    mn = inner(m, n)
    area = 1 - mn * mn
    if area <= 1e-14:
        return 1.0
    md, nd = inner(m, down), inner(n, down)
    a, b = (mn * nd - md) / area, (mn * md - nd) / area
    if a < 0 or b < 0:
        return 1.0
    rest = [down[k] + a * m[k] + b * n[k] for k in range(3)]
    return math.sqrt(inner(rest, rest))


def three_carry(l, m, n, down):
    """Whether three independent normals carry the weight without pulling."""
    lm, mn, nl = cross(l, m), cross(m, n), cross(n, l)
    volume = inner(lm, n)
    if volume * volume <= 1e-14:
        return False
    return all(-inner(c, down) * volume >= 0 for c in (mn, nl, lm))


def rest_of_weight(normals, down):
    """The least |down + sum of lambda n|, lambda >= 0, over subsets of at most three normals; or the
    first that is small enough. In plain numbers: contacts are few, and arrays of them are slow."""
    if len(normals) > 60:  # those of fine meshes: nearly equal ones do as one
        normals = normals[np.unique(np.round(normals, 2), axis=0, return_index=True)[1]]
    normals, down = [tuple(map(float, n)) for n in normals], tuple(map(float, down))
    best = 1.0
    for n in normals:
        push = -inner(n, down)
        if push > 0:
            best = min(best, math.sqrt(max(0.0, 1 - push * push)))
    for m, n in itertools.combinations(normals, 2):
        if best <= UNSUPPORTED:
            return best
        best = min(best, left_by_two(m, n, down))
    if best > UNSUPPORTED and any(three_carry(*three, down)
                                  for three in itertools.combinations(normals, 3)):
        return 0.0
    return best


def distinct(normals):
    kept = []
    for n in normals:
        if all(float(n @ m) < 1 - 1e-10 for m in kept):
            kept.append(n)
    return np.array(kept).reshape(-1, 3)


def read_spheres(run):
    with open(run / "spheres.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    numbers = np.array([[float(r[k]) for k in ("x", "y", "z", "radius")] for r in rows])
    numbers = numbers.reshape(-1, 4)
    return numbers[:, :3], numbers[:, 3], np.array([r["state"] != "running" for r in rows], bool)


def check(run, walls=None, inside=None, slack=0.0):
    """What is wrong with a run, as a dictionary; `faults` names it in words. `inside` may be "run":
    the run's own mesh tells what is inside, whatever the walls are."""
    run = pathlib.Path(run)
    summary = json.loads((run / "summary.json").read_text())
    unit = summary["scene"]["object"]["units_per_metre"]
    centres, radii, resting = read_spheres(run)
    finite = np.isfinite(centres).all(axis=1)
    result = {"spheres": len(centres), "not_finite": int((~finite).sum())}
    centres, radii, resting = centres[finite], radii[finite], resting[finite]
    mesh = read_triangles(walls) / unit if walls else read_triangles(run / "mesh.ply")
    solid = read_triangles(run / "mesh.ply") if inside == "run" else mesh
    if inside and inside != "run":
        solid = read_triangles(inside) / unit
    # What is far from the origin is moved there, so that differences lose nothing.
    origin = mesh.reshape(-1, 3).mean(axis=0)
    centres, mesh, solid = centres - origin, mesh - origin, solid - origin
    slack /= unit

    winding = winding_numbers(centres, solid)
    result["centres_outside"] = int((winding <= 0.5).sum())
    result["least_winding"] = float(winding.min(initial=1))

    contacts = [[] for _ in centres]
    deepest = 0.0
    if len(centres):
        s, t = near_triangles(centres, radii * (1 + GAP) + slack, mesh)
        step = AT_ONCE // 4
        for begin in range(0, len(s), step):
            i, j = s[begin:begin + step], t[begin:begin + step]
            p = centres[i]
            q = closest_points(p, mesh[j])
            away = p - q
            distance = np.sqrt(dot(away, away))
            deepest = max(deepest, float(((radii[i] - slack - distance) / radii[i]).max(initial=0)))
            for k in np.nonzero((distance <= radii[i] * (1 + GAP) + slack) & (distance > 0))[0]:
                contacts[i[k]].append(away[k] / distance[k])
    result["wall_overlap"] = deepest

    overlap = 0.0
    if len(centres):
        i, j, distance = near_pairs(centres, radii)
        smaller = np.minimum(radii[i], radii[j])
        overlap = float(((radii[i] + radii[j] - distance) / smaller).max(initial=0))
        for a, b, d in zip(i, j, distance):
            if d > 0 and resting[a] and resting[b]:
                n = (centres[a] - centres[b]) / d
                gap = d - radii[a] - radii[b]
                if gap < GAP * radii[a]:
                    contacts[a].append(n)
                if gap < GAP * radii[b]:
                    contacts[b].append(-n)
    result["overlap"] = overlap

    down = np.zeros(3)
    down["xyz".index(summary["scene"]["object"]["up"])] = -1
    hanging = [k for k in np.nonzero(resting)[0]
               if rest_of_weight(distinct(contacts[k]), down) > UNSUPPORTED]
    result["unsupported"] = len(hanging)
    result["at_rest"] = int(resting.sum())
    result["faults"] = faults_of(result)
    return result


def faults_of(result):
    faults = []
    if result["not_finite"]:
        faults.append(f"{result['not_finite']} positions are not numbers")
    if result["centres_outside"]:
        faults.append(f"{result['centres_outside']} centres outside")
    if result["wall_overlap"] > OVERLAP:
        faults.append(f"wall overlap {result['wall_overlap']:.1e} r")
    if result["overlap"] > OVERLAP:
        faults.append(f"overlap {result['overlap']:.1e} r")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=pathlib.Path, metavar="RUN_DIR")
    parser.add_argument("--walls", type=pathlib.Path)
    parser.add_argument("--inside", type=pathlib.Path)
    parser.add_argument("--slack", type=float, default=0.0)
    options = parser.parse_args()
    result = check(options.run, options.walls, options.inside, options.slack)
    print(json.dumps(result, indent=1))
    return 1 if result["faults"] else 0


if __name__ == "__main__":
    sys.exit(main())
