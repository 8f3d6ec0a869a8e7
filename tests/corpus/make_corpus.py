#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a corpus of meshes as people have them: whole, broken in every way that we know, and no
meshes at all.

    tests/corpus/make_corpus.py OUTPUT_DIR [--seed N] [--kind K ...] [--each N]

The same seed gives the same bytes. corpus.json has a record for each file:

    file, kind   the mesh, and the function of this script that made it
    expected     fill: has an interior and must fill at defaults;
                 open: has one once it is lidded or wrapped;
                 refuse: has none, or is no mesh;
                 any: to fill and to refuse are both right
    note         what is wrong with it
    walls        triangles that no sphere may cut, as nine doubles each, little-endian
    inside       a closed surface whose winding number tells what is inside; by default the walls;
                 `run`: only the program can say, because the surface has no side that is out
    slack        [mesh unit] by how much the file may lie beside the walls, for instance for a crack
"""

import argparse
import hashlib
import json
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import formats  # noqa: E402
import shapes  # noqa: E402
from shapes import Mesh  # noqa: E402

KINDS = {}


def kind(function):
    KINDS[function.__name__.replace("_", "-")] = function
    return function


class Maker:
    """Writes the meshes of one kind and keeps their records."""

    def __init__(self, folder, name, seed, each):
        self.folder, self.kind, self.each = folder, name, each
        self.rng = random.Random(f"{seed}/{name}")
        self.records = []

    def numbers(self, count):
        return range(min(count, self.each) if self.each else count)

    def write(self, extension, data, expected, note, walls=None, inside=None, slack=0.0):
        name = f"{self.kind}-{len(self.records):02}"
        record = {"file": f"{name}.{extension}", "kind": self.kind, "expected": expected,
                  "note": note}
        (self.folder / record["file"]).write_bytes(data)
        for what, mesh in (("walls", walls), ("inside", inside)):
            if mesh == "run":
                record[what] = mesh
            elif mesh is not None:
                record[what] = f"truth/{name}.{what}"
                (self.folder / record[what]).write_bytes(mesh.bytes())
        if slack:
            record["slack"] = slack
        self.records.append(record)

    def add(self, mesh, note, expected="fill", walls=None, inside=None, slack=0.0, double=False,
            form=None):
        """Writes a mesh in a format that changes with the number. All coordinates are those of
        single precision unless `double`, so that no reader has an excuse."""
        if not double:
            mesh = mesh.single()
            walls = walls.single() if walls else None
            inside = inside.single() if isinstance(inside, Mesh) else inside
        elif form is None:
            form = ("obj", "off", "ply64")[len(self.records) % 3]
        form = form or ("obj", "stl", "ply", "off", "ply-ascii")[len(self.records) % 5]
        data = {"obj": lambda: formats.obj(mesh), "stl": lambda: formats.stl_binary(mesh),
                "ply": lambda: formats.ply(mesh, "binary_little_endian"),
                "ply64": lambda: formats.ply(mesh, "binary_little_endian", "double"),
                "ply-ascii": lambda: formats.ply(mesh), "off": lambda: formats.off(mesh)}[form]()
        walls = (walls or mesh) if expected != "refuse" else None
        self.write(form.partition("-")[0].removesuffix("64"), data, expected, note, walls, inside,
                   slack)


def solid(rng, size=None):
    """A clean solid of some kind, turned at random."""
    makers = (lambda: shapes.sphere(3), lambda: shapes.torus(), lambda: shapes.box(1.2, 0.8, 1, 6),
              lambda: shapes.cylinder(0.6, 1.4, 40), lambda: shapes.cone(),
              lambda: shapes.capsule(), lambda: shapes.gear(), lambda: shapes.blob(rng, 3),
              lambda: shapes.sphere(3).scaled(1.3, 0.7, 1),
              lambda: shapes.lathe([(0.3, -1), (0.8, -0.4), (0.5, 0.2), (0.9, 0.8), (0.4, 1)], 28))
    mesh = rng.choice(makers)().turned(rng)
    return mesh.scaled(size / mesh.size()) if size else mesh


def some_of(rng, items, share):
    items = list(items)
    return sorted(rng.sample(items, max(1, round(len(items) * share))))


def patch(rng, mesh, share):
    """Triangles around one of them."""
    middle = mesh.centre(rng.randrange(len(mesh.faces)))
    order = sorted(range(len(mesh.faces)), key=lambda i: math.dist(mesh.centre(i), middle))
    return order[:max(1, round(len(order) * share))]


@kind
def clean_solids(make):
    """Nothing is wrong."""
    rng = make.rng
    all_of = [shapes.sphere(3), shapes.torus(), shapes.box(1, 2, 0.7), shapes.cylinder(),
              shapes.cone(), shapes.capsule(), shapes.gear(), shapes.blob(rng),
              shapes.lathe([(0, -1), (0.8, -0.4), (0.3, 0.2), (0.9, 0.8), (0, 1)]),
              shapes.sphere(0), shapes.sphere(3).scaled(2, 0.4, 1),
              shapes.cells_mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1), (2, 1, 1)])]
    for i in make.numbers(12):
        make.add(all_of[i] if i % 2 else all_of[i].turned(rng), "clean")


@kind
def folds(make):
    """Vertices pushed past their neighbours, so that the surface crosses itself in small folds."""
    rng = make.rng
    for i in make.numbers(12):
        mesh = [shapes.sphere(3), shapes.torus(), shapes.blob(rng, 3)][i % 3]
        near = {}
        for f in mesh.faces:
            for k in range(3):
                near.setdefault(f[k], []).append(f[(k + 1) % 3])
        vertices = list(mesh.vertices)
        moved = some_of(rng, range(len(vertices)), [0.005, 0.02, 0.08, 0.2][i % 4])
        for k in moved:
            to = mesh.vertices[rng.choice(near[k])]
            far = rng.uniform(1.3, 3)
            vertices[k] = tuple(a + far * (b - a) for a, b in zip(vertices[k], to))
        make.add(Mesh(vertices, mesh.faces).turned(rng), f"{len(moved)} vertices folded over")


@kind
def crossing_tubes(make):
    """A closed tube along a curve that meets itself: its walls pass through each other."""
    rng = make.rng
    for i in make.numbers(10):
        p, q = [(1, 2), (2, 3), (3, 2), (2, 5), (3, 4)][i % 5]

        def curve(t, p=p, q=q, i=i):
            s = 2 * math.pi * t
            if i < 5:  # a Lissajous curve, nearly flat
                return (math.sin(p * s), 0.15 * math.sin(3 * s), math.sin(q * s + 0.4))
            d = 1 + 0.4 * math.cos(q * s)
            return (d * math.cos(p * s), 0.4 * math.sin(q * s), d * math.sin(p * s))

        tube = shapes.tube_along(curve, rng.uniform(0.16, 0.3), 160, 16)
        make.add(tube.turned(rng), f"knot {p}/{q} with a fat tube")


@kind
def overlapping_boxes(make):
    """2 to 20 closed boxes, turned at random, that pass through each other."""
    rng = make.rng
    for i in make.numbers(10):
        count = [2, 2, 3, 4, 5, 7, 9, 12, 16, 20][i]
        spread = 0.35 * count ** (1 / 3)
        make.add(shapes.joined(
            shapes.box(*(rng.uniform(0.5, 1.3) for _ in range(3)), cells=rng.choice((1, 1, 3)))
            .turned(rng).moved(*(rng.uniform(-spread, spread) for _ in range(3)))
            for _ in range(count)), f"{count} boxes")


@kind
def overlapping_solids(make):
    """Closed pieces of other shapes that pass through each other."""
    rng = make.rng
    for i in make.numbers(10):
        count = [2, 2, 3, 3, 4, 5, 6, 8, 12, 20][i]
        spread = 0.45 * count ** (1 / 3)
        make.add(shapes.joined(
            solid(rng, rng.uniform(0.7, 1.6)).moved(*(rng.uniform(-spread, spread)
                                                      for _ in range(3)))
            for _ in range(count)), f"{count} solids")


@kind
def nested_outward(make):
    """Shells inside each other, all wound outward: the inner ones bound nothing."""
    rng = make.rng
    for i in make.numbers(10):
        outer = solid(rng, 2) if i % 2 else shapes.sphere(3)
        inner = shapes.joined(
            solid(rng, 0.3).moved(*(0.25 * (k - i % 3 / 2), 0.05 * k, 0)) for k in range(i % 3 + 1))
        if i % 2:
            outer = shapes.sphere(3, 1.2).scaled(1, 0.9, 1.1)
        make.add(outer + inner, f"{i % 3 + 1} outward shells inside")


@kind
def cavities(make):
    """Cavities that are wound inward, as they ought to be."""
    rng = make.rng
    for i in make.numbers(10):
        count = i % 4 + 1
        outer = [shapes.box(2, 2, 2, 5), shapes.sphere(4, 1.1)][i % 2]
        holes = [solid(rng, rng.uniform(0.3, 0.55)).moved(0.3 * math.cos(6.3 * k / count),
                                                          0.25 * (k - 1.5), 0.3 * math.sin(
                                                              6.3 * k / count)) for k in range(1)]
        holes += [shapes.sphere(2, 0.14).moved(0.62 * math.cos(2.1 * k), 0.0,
                                               0.62 * math.sin(2.1 * k)) for k in range(count - 1)]
        make.add(outer + shapes.joined(holes).flipped(), f"{count} cavities")


@kind
def nested_three_deep(make):
    """A solid in a cavity in a solid, and deeper."""
    rng = make.rng
    for i in make.numbers(10):
        base = [shapes.sphere(3), shapes.box(2, 2, 2, 4), shapes.torus(1, 0.45),
                shapes.cylinder(1, 2)][i % 4]
        depth = 3 + i % 3
        parts = []
        for k in range(depth):
            part = base.scaled(1 - 0.25 * k) if i % 4 != 2 else shapes.torus(1, 0.45 - 0.12 * k)
            parts.append(part.flipped() if k % 2 else part)
        make.add(shapes.joined(parts).turned(rng), f"{depth} deep")


def opened_along(rng, mesh, share, width):
    """Gives triangles of a patch vertices of their own, moved by up to `width`."""
    vertices, faces = list(mesh.vertices), list(mesh.faces)
    own = {}
    for i in patch(rng, mesh, share):
        corners = []
        for v in faces[i]:
            if v not in own:
                own[v] = len(vertices)
                vertices.append(tuple(c + rng.uniform(-width, width) for c in mesh.vertices[v]))
            corners.append(own[v])
        faces[i] = tuple(corners)
    return Mesh(vertices, faces)


@kind
def slits(make):
    """Cuts of no width: vertices are there twice, with the same coordinates."""
    rng = make.rng
    for i in make.numbers(10):
        mesh = solid(rng)
        cut = mesh
        for _ in range(i % 3 + 1):
            cut = opened_along(rng, cut, rng.uniform(0.05, 0.4), 0)
        make.add(cut, f"{i % 3 + 1} cuts", walls=mesh, form=("obj", "off", "ply")[i % 3])


@kind
def cracks(make):
    """Cuts whose sides are apart by 1e-7 to 1e-3 of the size."""
    rng = make.rng
    for i in make.numbers(10):
        mesh = solid(rng)
        width = mesh.size() * 10 ** -(7 - i // 2)
        make.add(opened_along(rng, mesh, rng.uniform(0.1, 0.4), width),
                 f"cracks of {width:.0e}", inside=mesh, slack=2 * width,
                 form=("obj", "off", "ply")[i % 3])


@kind
def t_junctions(make):
    """Vertices on the edges of neighbours that do not know them."""
    rng = make.rng
    for i in make.numbers(10):
        mesh = solid(rng) if i % 2 else shapes.box(1, 1, 1, 3)
        vertices, faces = list(mesh.vertices), []
        chosen = set(some_of(rng, range(len(mesh.faces)), [0.02, 0.1, 0.3, 0.6][i % 4]))
        for k, f in enumerate(mesh.faces):
            if k not in chosen:
                faces.append(f)
                continue
            t = rng.choice((0.5, rng.uniform(0.1, 0.9)))
            a, b, c = f
            vertices.append(tuple(p + t * (q - p) for p, q in zip(vertices[a], vertices[b])))
            faces += [(a, len(vertices) - 1, c), (len(vertices) - 1, b, c)]
        make.add(Mesh(vertices, faces), f"{len(chosen)} vertices on edges", walls=mesh,
                 slack=1e-7 * mesh.size())


@kind
def needles(make):
    """Triangles that are thousands of times longer than wide, or have no area."""
    rng = make.rng
    for i in make.numbers(10):
        if i < 3:
            make.add(shapes.cylinder(0.5, 2, [720, 2000, 5000][i]).turned(rng), "long thin sectors")
            continue
        mesh = solid(rng)
        if i < 6:  # three triangles in place of one, meeting near a corner
            vertices, faces = list(mesh.vertices), []
            for f in mesh.faces:
                if rng.random() < 0.3:
                    p, q, r = (mesh.vertices[k] for k in f)
                    near = 10.0 ** -rng.uniform(2, 5)
                    vertices.append(tuple((1 - 2 * near) * a + near * b + near * c
                                          for a, b, c in zip(p, q, r)))
                    k = len(vertices) - 1
                    faces += [(f[0], f[1], k), (f[1], f[2], k), (f[2], f[0], k)]
                else:
                    faces.append(f)
            make.add(Mesh(vertices, faces), "slivers", walls=mesh, slack=1e-6 * mesh.size())
        elif i < 8:  # of no area
            extra = [(f[0], f[1], f[1]) for f in mesh.faces[::7]]
            extra += [(f[0], f[0], f[0]) for f in mesh.faces[::11]]
            make.add(Mesh(mesh.vertices, mesh.faces + extra), "triangles of no area", walls=mesh)
        else:  # an edge between two triangles is halved in both: flat triangles between
            vertices, faces = list(mesh.vertices), list(mesh.faces)
            for f in mesh.faces[::9]:
                vertices.append(tuple((a + b) / 2 for a, b in zip(vertices[f[0]],
                                                                  vertices[f[1]])))
                faces.append((f[0], f[1], len(vertices) - 1))
            make.add(Mesh(vertices, faces), "flat triangles on edges", walls=mesh,
                     slack=1e-6 * mesh.size())


@kind
def flipped_patches(make):
    """Patches and single triangles wound the wrong way."""
    rng = make.rng
    for i in make.numbers(12):
        mesh = solid(rng)
        if i % 3 == 2:
            mesh = mesh + solid(rng).moved(4, 0, 0)
        share = [0.02, 0.15, 0.5, 0.7][i % 4]
        turned = set(patch(rng, mesh, share) if i % 2 else some_of(rng, range(len(mesh.faces)),
                                                                   share))
        faces = [(f[0], f[2], f[1]) if k in turned else f for k, f in enumerate(mesh.faces)]
        make.add(Mesh(mesh.vertices, faces), f"{len(turned)} triangles flipped", walls=mesh)


@kind
def inward(make):
    """Everything wound inward, cavities included."""
    rng = make.rng
    for i in make.numbers(10):
        mesh = solid(rng)
        if i % 3 == 1:
            mesh = shapes.sphere(3) + shapes.box(0.5, 0.5, 0.5).flipped()
        elif i % 3 == 2:
            mesh = mesh + solid(rng).moved(3, 1, 0)
        make.add(mesh.flipped(), "inside out", walls=mesh)


@kind
def inward_parts(make):
    """Pieces beside or across each other, some of them inside out."""
    rng = make.rng
    for i in make.numbers(10):
        step = 3 if i % 2 else 0.7
        parts = [solid(rng, 1.5).moved(step * k, 0, 0) for k in range(2 + i % 3)]
        wrong = [p.flipped() if k % 2 == i // 5 else p for k, p in enumerate(parts)]
        make.add(shapes.joined(wrong), "apart" if i % 2 else "crossing",
                 walls=shapes.joined(parts))


@kind
def doubled(make):
    """Every triangle is there from both sides, in whole or in part."""
    rng = make.rng
    for i in make.numbers(10):
        mesh = solid(rng)
        again = mesh.flipped()
        if i >= 5:
            keep = set(patch(rng, mesh, [0.1, 0.3, 0.5, 0.8, 0.95][i - 5]))
            again = again.without(k for k in range(len(mesh.faces)) if k not in keep)
        whole = mesh + again if i % 2 else Mesh(mesh.vertices, mesh.faces + again.faces)
        make.add(whole, f"{len(again.faces)} of {len(mesh.faces)} triangles from both sides",
                 walls=mesh)


@kind
def duplicated(make):
    """Triangles that are there two to four times, wound alike or not."""
    rng = make.rng
    for i in make.numbers(10):
        mesh = solid(rng)
        extra = []
        for k in some_of(rng, range(len(mesh.faces)), [0.05, 0.3, 1][i % 3]):
            for _ in range(rng.randint(1, 3)):
                f = mesh.faces[k]
                shift = rng.randrange(3)
                f = f[shift:] + f[:shift]
                extra.append(f if i % 2 or rng.random() < 0.5 else (f[0], f[2], f[1]))
        rng.shuffle(extra)
        make.add(Mesh(mesh.vertices, mesh.faces + extra), f"{len(extra)} copies", walls=mesh)


@kind
def edges_of_four(make):
    """Solids that touch along edges: four triangles an edge."""
    rng = make.rng
    for i in make.numbers(10):
        if i < 2:
            cells = [[(0, 0, 0), (1, 1, 0)], [(0, 0, 0), (1, 1, 0), (2, 2, 0), (3, 1, 0)]][i]
        elif i == 2:
            cells = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)
                     if (x + y + z) % 2 == 0]
        else:
            n = 3 + i // 3
            cells = [(x, y, z) for x in range(n) for y in range(n) for z in range(n)
                     if rng.random() < 0.5] or [(0, 0, 0)]
        mesh = shapes.cells_mesh(cells)
        make.add(mesh.turned(rng) if i % 2 else mesh, f"{len(cells)} cells")


@kind
def touching_vertices(make):
    """Pieces that share a vertex or touch in a point."""
    rng = make.rng
    for i in make.numbers(10):
        if i % 2:
            count = 2 + i // 2
            mesh = shapes.cells_mesh([(k, k, k) for k in range(count)])
        else:
            one = shapes.cone(0.6, 1.2, 12 + i)
            mesh = one.moved(0, -1.2, 0) + one.scaled(1, -1, 1).flipped().moved(0, 1.2, 0)
            top = [k for k, v in enumerate(mesh.vertices) if abs(v[1]) < 1e-12 and v[0] == 0]
            if i % 4 == 0 and len(top) == 2:  # one vertex for both
                mesh = Mesh(mesh.vertices,
                            [tuple(top[0] if v == top[1] else v for v in f) for f in mesh.faces])
        make.add(mesh.turned(rng) if i % 3 else mesh, "pieces touch in a point")


@kind
def shared_faces(make):
    """Closed boxes side by side: each has the wall between them."""
    rng = make.rng
    for i in make.numbers(10):
        cells = {(0, 0, 0)}
        while len(cells) < 2 + i:
            x, y, z = rng.choice(sorted(cells))
            cells.add(rng.choice(((x + 1, y, z), (x, y + 1, z), (x, y, z + 1))))
        make.add(shapes.cells_mesh(cells, apart=True), f"{len(cells)} boxes side by side",
                 walls=shapes.cells_mesh(cells))


@kind
def coplanar_overlaps(make):
    """Boxes that overlap and have sides in the same plane."""
    rng = make.rng
    for i in make.numbers(10):
        cells, parts = set(), []
        start = (0, 0, 0)
        for _ in range(2 + i // 2):
            size = [rng.randint(2, 4) for _ in range(3)]
            inside = [(start[0] + x, start[1] + y, start[2] + z) for x in range(size[0])
                      for y in range(size[1]) for z in range(size[2])]
            cells.update(inside)
            parts.append(shapes.box(*size).moved(*(s + d / 2 for s, d in zip(start, size))))
            axis = rng.randrange(3)
            start = tuple(s + (size[k] - rng.randint(1, 2) if k == axis else 0)
                          for k, s in enumerate(start))
        make.add(shapes.joined(parts), f"{len(parts)} boxes", walls=shapes.cells_mesh(cells))


@kind
def thin_walls(make):
    """Vessels and pipes whose wall is 1 to 6 hundredths of their size: the wall is what fills."""
    rng = make.rng
    for i in make.numbers(12):
        t = [0.06, 0.04, 0.02, 0.01][i % 4]
        if i % 3 == 0:
            mesh = shapes.pipe(0.5, 0.5 - t, 1.5)
        elif i % 3 == 1:  # a cup
            mesh = shapes.lathe([(0, 0), (0.5, 0), (0.5, 1), (0.5 - t, 1), (0.5 - t, t), (0, t)],
                                40)
        else:
            mesh = shapes.sphere(4) + shapes.sphere(4, 1 - t).flipped()
        make.add(mesh.turned(rng) if i % 2 else mesh, f"walls of {t:g}")


@kind
def far_apart(make):
    """Parts that lie up to thousands of their sizes apart."""
    rng = make.rng
    for i in make.numbers(10):
        step = [10, 30, 100, 300, 1000, 3000, 3000, 5000, 10000, 100][i]
        count = [2, 3, 2, 2, 2, 2, 4, 2, 2, 20][i]
        make.add(shapes.joined(
            solid(rng, 1).moved(*((step * k if axis == i % 3 else rng.uniform(0, step / 3))
                                  for axis in range(3))) for k in range(count)).single(),
                 f"{count} parts, {step} sizes apart")


@kind
def mixed_sizes(make):
    """Parts of which one is up to a thousand times larger than another."""
    rng = make.rng
    for i in make.numbers(10):
        ratio = [10, 30, 100, 300, 1000][i % 5]
        large = solid(rng, 1)
        small = shapes.joined(solid(rng, 1 / ratio).moved(1.2 + 0.1 * k, 0.3, 0.1 * k)
                              for k in range(i // 5 * 7 + 1))
        make.add(large + small, f"sizes 1 : {ratio}")


@kind
def tiny_scales(make):
    """Sizes of 1e-9 to 1e-3."""
    for i in make.numbers(10):
        scale = 10.0 ** -[3, 4, 5, 6, 6, 6, 7, 7, 8, 9][i]
        make.add(solid(make.rng, scale), f"size {scale:g}", double=i % 2 == 1)


@kind
def huge_scales(make):
    """Sizes of 1e3 to 1e12."""
    for i in make.numbers(10):
        scale = 10.0 ** [3, 4, 5, 6, 6, 6, 7, 8, 9, 12][i]
        make.add(solid(make.rng, scale), f"size {scale:g}", double=i % 2 == 1)


@kind
def far_offsets(make):
    """Far from the origin: what is lost in single precision may be all of it."""
    rng = make.rng
    for i in make.numbers(12):
        size, offset = [(1, 1e3), (1, 1e4), (100, 1e6), (10, 1e5), (1, 1e5), (1, 1e6), (10, 1e6),
                        (0.1, 1e4), (1, 1e6), (0.01, 1e3), (1, 4e6), (0.1, 1e6)][i]
        mesh = solid(rng, size).moved(offset, offset / 3 if i % 2 else 0, -offset / 7)
        make.add(mesh, f"size {size:g} at {offset:g}", double=i not in (0, 2))


@kind
def small_holes(make):
    """A few triangles are missing."""
    rng = make.rng
    for i in make.numbers(12):
        mesh = solid(rng)
        if len(mesh.faces) < 200:
            mesh = shapes.blob(rng, 3)
        gone = some_of(rng, range(len(mesh.faces)), [0.002, 0.01, 0.03][i % 3])
        if i % 4 == 3:
            gone = patch(rng, mesh, 0.015)
        make.add(mesh.without(gone), f"{len(gone)} triangles missing", inside=mesh)


@kind
def large_openings(make):
    """Busts, half shells, open boxes, pipes, vases: nothing but a surface, with a large opening."""
    rng = make.rng
    half = shapes.sphere(4)
    for i in make.numbers(12):
        about = 32
        if i % 6 == 0:
            mesh = half.without(k for k in range(len(half.faces)) if half.centre(k)[1] > 0.0)
            mesh = shapes.without_loose_vertices(mesh)
        elif i % 6 == 1:
            mesh = shapes.box(1, 1, 1, 4)
            mesh = mesh.without(k for k in range(len(mesh.faces)) if mesh.centre(k)[1] > 0.499)
        elif i % 6 == 2:
            mesh = shapes.lathe([(0.5, -1), (0.5, 1)], about, closed=False)
        elif i % 6 == 3:
            mesh = shapes.lathe([(0, 0), (0.4, 0.05), (0.7, 0.6), (0.3, 1.2), (0.5, 1.6)], about,
                                closed=False)
        elif i % 6 == 4:  # a bust: open below
            mesh = shapes.lathe([(0.8, 0), (0.7, 0.4), (0.25, 0.6), (0.5, 1), (0.4, 1.4),
                                 (0, 1.5)], about, closed=False)
        else:
            mesh = shapes.box(1, 1, 1, 4)
            mesh = mesh.without(k for k in range(len(mesh.faces)) if abs(mesh.centre(k)[0]) > 0.499)
        mesh = shapes.without_loose_vertices(mesh)
        if i >= 6:
            mesh = mesh.scaled(1, 1.5, 0.7).turned(rng)
        mesh = mesh.single()
        make.add(mesh, "a large opening", expected="open", inside=mesh + shapes.lids_of(mesh))


@kind
def flat_sheets(make):
    """Sheets without an inside."""
    rng = make.rng
    for i in make.numbers(12):
        n = 12
        grid = [(x / n, 0.0 if i < 4 else [0.02, 0.1, 0.2][i % 3] * math.sin(x * 0.7)
                 * math.cos(z * 0.9), z / n) for x in range(n) for z in range(n)]
        sheet = Mesh(grid, shapes.grid_faces(n, n, False, False))
        if i == 0:
            sheet = Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        elif i == 1:
            sheet = sheet + sheet.flipped()
        elif i in (2, 3):
            square = Mesh([(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)], [(0, 2, 1), (0, 3, 2)])
            sheet = shapes.joined(square.moved(1.3 * (k % 4), 0 if i == 2 else 0.5 * k,
                                               1.3 * (k // 4)) for k in range(12))
        elif i == 4:
            sheet = sheet + sheet.moved(0, 0.8, 0)
        make.add(sheet.turned(rng) if i % 2 else sheet, "a sheet", expected="refuse")


def band(turns, width=0.35, about=64, across=6):
    """A band with half turns; odd numbers of them have one side."""
    vertices = []
    for i in range(about):
        s = 2 * math.pi * i / about
        for j in range(across):
            w = width * (2 * j / (across - 1) - 1)
            d = 1 + w * math.cos(turns * s / 2)
            vertices.append((d * math.cos(s), w * math.sin(turns * s / 2), d * math.sin(s)))
    faces = []
    for i in range(about):
        for j in range(across - 1):
            a, b = i * across + j, i * across + j + 1
            c, d = (i + 1) % about * across + j, (i + 1) % about * across + j + 1
            if i == about - 1 and turns % 2:
                c, d = across - 1 - j, across - 2 - j
            faces += [(a, b, d), (a, d, c)]
    return Mesh(vertices, faces)


def klein(about=48, across=24, bottle=True):
    vertices = []
    for i in range(about):
        u = 2 * math.pi * i / about
        for j in range(across):
            v = 2 * math.pi * j / across
            if bottle:  # the bottle whose neck goes through its side
                r = 4 * (1 - math.cos(u) / 2)
                if u < math.pi:
                    x = 6 * math.cos(u) * (1 + math.sin(u)) + r * math.cos(u) * math.cos(v)
                    y = 16 * math.sin(u) + r * math.sin(u) * math.cos(v)
                else:
                    x = 6 * math.cos(u) * (1 + math.sin(u)) + r * math.cos(v + math.pi)
                    y = 16 * math.sin(u)
                vertices.append((x / 10, y / 10, r * math.sin(v) / 10))
            else:  # the figure of eight
                d = 2 + math.cos(u / 2) * math.sin(v) - math.sin(u / 2) * math.sin(2 * v)
                vertices.append((d * math.cos(u), math.sin(u / 2) * math.sin(v)
                                 + math.cos(u / 2) * math.sin(2 * v), d * math.sin(u)))
    faces = []
    for i in range(about):
        for j in range(across):
            k = (j + 1) % across

            def at(i, j):
                if i < about:
                    return i * across + j
                return (across // 2 - j) % across if bottle else (-j) % across

            faces += [(at(i, j), at(i, k), at(i + 1, k)), (at(i, j), at(i + 1, k), at(i + 1, j))]
    return Mesh(vertices, faces)


@kind
def one_sided(make):
    """Moebius strips are sheets; a Klein bottle has room inside, but no side that is out."""
    rng = make.rng
    for i in make.numbers(10):
        if i < 6:
            make.add(band([1, 3, 1, 2, 5, 1][i]).turned(rng), "a band with half turns",
                     expected="refuse")
        else:
            make.add(klein(bottle=i % 2 == 0).turned(rng), "a Klein bottle", expected="open",
                     inside="run")


@kind
def unwelded(make):
    """Soups of triangles: each has vertices of its own, some a rounding apart."""
    rng = make.rng
    for i in make.numbers(14):
        mesh = solid(rng)
        if i % 7 == 5:
            mesh = solid(rng, 1.2) + solid(rng, 1.2).moved(0.4, 0.2, 0)
        mesh = mesh.single()
        soup = mesh.soup()
        if i % 7 == 0:
            data, name = formats.stl_binary(mesh, b"solid of a program that lies"), "stl"
        elif i % 7 == 1:
            data, name = formats.stl_ascii(mesh), "stl"
        elif i % 7 == 2:
            data, name = formats.stl_ascii(mesh, "two parts", "\r\n", 2), "stl"
        elif i % 7 == 3:
            data, name = formats.stl_ascii(mesh, upper=True), "stl"
        elif i % 7 == 4:
            data, name = formats.obj(soup), "obj"
        elif i % 7 == 5:
            data, name = formats.off(soup), "off"
        else:
            eps = 1e-7 * mesh.size()
            soup = soup.mapped(lambda v, e=eps: tuple(c + rng.uniform(-e, e) for c in v)).single()
            make.write("stl", formats.stl_binary(soup), "fill", "vertices a rounding apart", mesh,
                       slack=5e-7 * mesh.size())
            continue
        make.write(name, data, "fill", "a soup", mesh)


def quads_of_box(cells=3):
    """A box of quadrilaterals, and the same of triangles."""
    mesh = shapes.box(1, 1.4, 0.8, cells).single()
    quads = [(a[0], a[1], a[2], b[2]) for a, b in zip(mesh.faces[::2], mesh.faces[1::2])]
    return mesh, quads


@kind
def obj_variants(make):
    """The freedoms of OBJ files."""
    rng = make.rng
    box, quads = quads_of_box()
    ball = solid(rng).single()
    arrow = Mesh([(x, y, z) for y in (0.0, 1.0) for x, z in
                  ((0, 0), (2, 0), (2, 2), (1, 2), (1, 1), (0, 1))])
    sides = [tuple(reversed(range(6)))[::-1], tuple(range(11, 5, -1))]
    sides += [(6 + k, 6 + (k + 1) % 6, (k + 1) % 6, k) for k in range(6)]
    triangles = []
    for low in (0, 6):
        for a, b, c in ((0, 1, 4), (1, 2, 3), (1, 3, 4), (0, 4, 5)):
            triangles.append((a, b, c) if low == 0 else (6 + a, 6 + c, 6 + b))
    for k in range(6):
        triangles += [(6 + k, 6 + (k + 1) % 6, (k + 1) % 6), (6 + k, (k + 1) % 6, k)]
    concave = Mesh(arrow.vertices, triangles)
    if shapes.volume(concave) < 0:
        concave, sides = concave.flipped(), [tuple(reversed(s)) for s in sides]
    variants = [
        ("negative indices", ball, formats.obj(ball, relative=True)),
        ("quadrilaterals", box, formats.obj(box, faces=quads)),
        ("v/vt/vn", ball, formats.obj(ball, style="{0}/1/1")),
        ("v//vn", ball, formats.obj(ball, style="{0}//1")),
        ("UTF-8 with a byte order mark", ball, b"\xef\xbb\xbf" + formats.obj(ball)),
        ("UTF-16, little-endian", ball, b"\xff\xfe" + formats.obj(ball, encoding="utf-16-le")),
        ("UTF-16, big-endian", ball, b"\xfe\xff" + formats.obj(ball, encoding="utf-16-be")),
        ("CRLF", ball, formats.obj(ball, "\r\n")),
        ("comments, groups, a missing material", ball,
         formats.obj(ball, before="# a comment\nmtllib absent.mtl\no thing\n", groups=50)),
        ("concave polygons", concave, formats.obj(arrow, faces=sides)),
        ("points and lines beside", ball, formats.obj(ball, after="p 1 2 3\nl 1 2 3\nl 4 5")),
        ("tabs and spaces", ball, formats.obj(ball).replace(b" ", b"  \t ")),
        ("lines continued", ball, formats.obj(ball).replace(b"f ", b"f \\\n ")),
        ("vertices with weights and colours", ball,
         b"\n".join(line + b" 1 0.5 0.5" if line.startswith(b"v ") else line
                    for line in formats.obj(ball).split(b"\n"))),
        ("old ends of lines: CR alone", ball, formats.obj(ball, "\r")),
        ("curves and surfaces beside", ball,
         formats.obj(ball, after="cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend")),
    ]
    for k in make.numbers(len(variants)):
        note, mesh, data = variants[k]
        make.write("obj", data, "fill", note, mesh)


def strips_of(rows, columns, mesh):
    """Triangle strips of a grid that is closed both ways, with the diagonals of the mesh."""
    strips = []
    for i in range(rows):
        strip = []
        for j in range(columns + 1):
            strip += [(i + 1) % rows * columns + j % columns, i * columns + j % columns]
        strips.append(strip)
    return strips


@kind
def ply_variants(make):
    """The freedoms of PLY files."""
    rng = make.rng
    ball = solid(rng).single()
    box, quads = quads_of_box()
    ring = shapes.outward(shapes.torus(1, 0.35, 32, 16)).single()
    strips = strips_of(32, 16, ring)
    little, big = "binary_little_endian", "binary_big_endian"
    variants = [
        ("ascii", ball, formats.ply(ball)), ("little-endian", ball, formats.ply(ball, little)),
        ("big-endian", ball, formats.ply(ball, big)),
        ("big-endian, doubles", ball, formats.ply(ball, big, "double")),
        ("quadrilaterals", box, formats.ply(box, faces=quads)),
        ("quadrilaterals, big-endian, ushort", box,
         formats.ply(box, big, faces=quads, index="ushort", count="ushort")),
        ("vertex_index, uint", ball, formats.ply(ball, little, list_name="vertex_index",
                                                 index="uint")),
        ("colours and flags", ball, formats.ply(ball, little, extra=True)),
        ("colours and flags, ascii", ball, formats.ply(ball, extra=True)),
        ("CRLF", ball, formats.ply(ball, end="\r\n", comment="made by hand")),
        ("triangle strips, ascii", ring, formats.ply(ring, strips=strips)),
        ("triangle strips, little-endian", ring, formats.ply(ring, little, strips=strips)),
        ("triangle strips, big-endian", ring, formats.ply(ring, big, strips=strips)),
        ("float32 and int32", ball, formats.ply(ball, little, "float32", index="int32",
                                                count="uint8")),
        ("CRLF in a binary file's header", ball, formats.ply(ball, little, end="\r\n")),
    ]
    for k in make.numbers(len(variants)):
        note, mesh, data = variants[k]
        make.write("ply", data, "fill", note, mesh)


@kind
def off_variants(make):
    """The freedoms of OFF files."""
    rng = make.rng
    ball = solid(rng).single()
    box, quads = quads_of_box()
    text = formats.off(ball, header="").decode().split("\n", 1)
    variants = [
        ("plain", ball, formats.off(ball)),
        ("comments and empty lines", ball, formats.off(ball, comments=True)),
        ("colours of faces", ball, formats.off(ball, colours=True)),
        ("quadrilaterals", box, formats.off(box, faces=quads)),
        ("counts on the first line", ball, ("OFF " + text[0] + "\n" + text[1]).encode()),
        ("CRLF", ball, formats.off(ball, end="\r\n")),
        ("a number of edges", ball, formats.off(ball, edges=len(ball.faces) * 3 // 2)),
        ("no word OFF", ball, formats.off(ball, header="")),
        ("two numbers of faces and no edges on separate lines", ball,
         formats.off(ball).replace(b" 0\n", b"\n0\n", 1)),
        ("COFF: colours of vertices", ball, b"\n".join(
            line + b" 1 0 0 1" if 2 <= k < 2 + len(ball.vertices) else line
            for k, line in enumerate(formats.off(ball, header="COFF").split(b"\n")))),
    ]
    for k in make.numbers(len(variants)):
        note, mesh, data = variants[k]
        make.write("off", data, "fill", note, mesh)


@kind
def gltf_variants(make):
    """Scenes of glTF: nodes that place, turn, scale and mirror meshes; instances."""
    ball, box = shapes.sphere(3).single(), shapes.box(1, 1, 1, 2).single()
    for i in make.numbers(12):
        scene = formats.Gltf()
        binary = i % 2 == 1
        slack = 0.0
        if i == 0:
            scene.node(mesh=scene.mesh(ball))
            walls, note = ball, "one node"
        elif i == 1:
            scene.node(mesh=scene.mesh(ball, short=True))
            walls, note = ball, "short indices"
        elif i == 2:
            m = scene.mesh(ball)
            scene.node(mesh=m, translation=[3, 0.5, 0], scale=[2, 1, 0.5])
            walls, note = ball.scaled(2, 1, 0.5).moved(3, 0.5, 0), "moved and scaled"
        elif i == 3:
            m = scene.mesh(box)
            for k in range(8):
                scene.node(mesh=m, translation=[2 * k, 0.5 * k, 0])
            walls = shapes.joined(box.moved(2 * k, 0.5 * k, 0) for k in range(8))
            note = "eight instances"
        elif i == 4:
            scene.node(mesh=scene.mesh(ball), scale=[-1, 1, 1])
            walls, note = ball.scaled(-1, 1, 1).flipped(), "mirrored"
        elif i == 5:
            m = scene.mesh(box)
            child = scene.node(root=False, mesh=m, translation=[0, 2, 0])
            scene.node(translation=[4, 0, 0], scale=[2, 2, 2], children=[child])
            walls, note = box.moved(0, 2, 0).scaled(2).moved(4, 0, 0), "a node in a node"
        elif i == 6:
            t = math.sqrt(0.5)
            scene.node(mesh=scene.mesh(shapes.cylinder().single()), rotation=[0, 0, t, t])
            walls = shapes.cylinder().single().mapped(lambda v: (-v[1], v[0], v[2]))
            note, slack = "turned by a quaternion", 1e-6
        elif i == 7:
            scene.node(mesh=scene.mesh(ball), matrix=[0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 1, 2, 3,
                                                      1])
            walls = ball.mapped(lambda v: (2 * v[2] + 1, 2 * v[1] + 2, -2 * v[0] + 3))
            note = "a matrix"
        elif i == 8:
            scene.node(mesh=scene.mesh(ball, indexed=False))
            walls, note = ball, "no indices"
        elif i == 9:
            second = ball.scaled(0.5).moved(2, 0, 0).single()
            scene.node(mesh=scene.mesh(box, second))
            walls, note = box + second, "two primitives"
        elif i == 10:
            halves = [ball.without(k for k in range(len(ball.faces))
                                   if (ball.centre(k)[0] > 0) == side) for side in (False, True)]
            halves = [shapes.without_loose_vertices(h) for h in halves]
            scene.node(mesh=scene.mesh(*halves))
            walls, note = ball, "two materials: the surface is in two primitives"
        else:
            wheel = scene.mesh(shapes.torus(0.5, 0.2, 32, 12).single())
            body = scene.mesh(box.scaled(3, 1, 1.5))
            scene.node(mesh=body)
            parts = [box.scaled(3, 1, 1.5)]
            for x in (-1, 1):
                for z in (-1, 1):
                    scene.node(mesh=wheel, translation=[x, -0.5, z])
                    parts.append(shapes.torus(0.5, 0.2, 32, 12).single().moved(x, -0.5, z))
            walls, note = shapes.joined(parts), "a car of crossing parts"
        if shapes.volume(walls) < 0:
            walls = walls.flipped()
        make.write("glb" if binary else "gltf", scene.binary() if binary else scene.text(), "fill",
                   note, walls, slack=slack)


@kind
def spiky_scans(make):
    """Scans: noise in every vertex, and spikes out of the surface and into it."""
    rng = make.rng
    for i in make.numbers(12):
        mesh = shapes.blob(rng, 4 if i % 2 else 3)
        noise = [0.001, 0.005, 0.01, 0.02][i % 4]
        spikes = set(some_of(rng, range(len(mesh.vertices)), [0.001, 0.005, 0.02][i % 3]))
        vertices = []
        for k, v in enumerate(mesh.vertices):
            s = 1 + rng.gauss(0, noise)
            if k in spikes:
                s *= rng.uniform(0.7, 1.5)
            vertices.append(tuple(c * s + rng.gauss(0, noise / 2) for c in v))
        make.add(Mesh(vertices, mesh.faces), f"noise of {noise:g}, {len(spikes)} spikes")


@kind
def high_genus(make):
    """Solids with many handles: lattices and minimal surfaces."""
    rng = make.rng
    for i in make.numbers(8):
        if i < 4:
            n = [3, 5, 7, 4][i]
            cells = [(x, y, z) for x in range(n) for y in range(n) for z in range(n)
                     if (x % 2 == 0) + (y % 2 == 0) + (z % 2 == 0) >= 2]
            mesh = shapes.cells_mesh(cells)
        else:
            k = [3.2, 4.0, 5.0, 6.3][i - 4]

            def gyroid(x, y, z, k=k, i=i):
                g = (math.sin(k * x) * math.cos(k * y) + math.sin(k * y) * math.cos(k * z)
                     + math.sin(k * z) * math.cos(k * x))
                return max(g if i % 2 else abs(g) - 0.5, x * x + y * y + z * z - 0.85)

            mesh = shapes.implicit(gyroid, 24)
        make.add(mesh.turned(rng) if i % 2 else mesh, "many handles")


@kind
def many_triangles(make):
    """One to four hundred thousand triangles."""
    rng = make.rng
    for i in make.numbers(5):
        if i == 0:
            mesh = shapes.sphere(7)
        elif i == 1:
            mesh = shapes.torus(1, 0.4, 500, 200)
        elif i == 2:
            mesh = shapes.blob(rng, 6)
        elif i == 3:
            mesh = shapes.joined(shapes.sphere(4, 0.3).moved(*(rng.uniform(-1, 1)
                                                               for _ in range(3)))
                                 for _ in range(20))
        else:
            mesh = shapes.sphere(7).mapped(
                lambda v: tuple(c * (1 + rng.gauss(0, 0.002)) for c in v))
        make.add(mesh, f"{len(mesh.faces)} triangles", form="ply" if i % 2 else "stl")


@kind
def loose_ends(make):
    """A solid with fins, loose triangles, sheets across or inside it, and points that nothing uses."""
    rng = make.rng
    for i in make.numbers(12):
        mesh = shapes.sphere(3) if i % 2 else shapes.box(1.6, 1.6, 1.6, 4)
        extra = Mesh()
        if i % 4 == 0:  # fins: triangles on edges
            for f in mesh.faces[::37]:
                a, b = (mesh.vertices[k] for k in f[:2])
                extra += Mesh([a, b, tuple(1.4 * (s + t) / 2 for s, t in zip(a, b))], [(0, 1, 2)])
        elif i % 4 == 1:  # loose triangles outside
            for _ in range(5):
                extra += Mesh([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0)], [(0, 1, 2)]).turned(rng).moved(
                    *(rng.choice((-1, 1)) * rng.uniform(1.2, 3) for _ in range(3)))
        elif i % 4 == 2:  # a sheet inside that touches nothing
            extra = Mesh([(-0.4, 0, -0.4), (0.4, 0, -0.4), (0.4, 0, 0.4), (-0.4, 0, 0.4)],
                         [(0, 2, 1), (0, 3, 2)]).turned(rng)
        else:
            extra = Mesh([(rng.uniform(-9, 9), 0, 0) for _ in range(50)], [])
        make.add(mesh + extra, ["fins", "loose triangles", "a sheet inside", "loose vertices"]
                 [i % 4], walls=mesh, form=("obj", "off", "ply")[i % 3])


@kind
def sheets_through(make):
    """Sheets that cut through a solid, and solids with an open piece beside."""
    rng = make.rng
    for i in make.numbers(8):
        mesh = solid(rng, 2)
        square = Mesh([(-2, 0, -2), (2, 0, -2), (2, 0, 2), (-2, 0, 2)], [(0, 2, 1), (0, 3, 2)])
        half = shapes.sphere(2, 0.5)
        half = half.without(k for k in range(len(half.faces)) if half.centre(k)[1] > 0)
        half = shapes.without_loose_vertices(half)
        extra = square.turned(rng) if i % 2 else half.moved(3, 0, 0)
        # A bowl may be lidded or left alone.
        inside = mesh if i % 2 else mesh + (half + shapes.lids_of(half)).moved(3, 0, 0)
        make.add(mesh + extra, "a sheet through it" if i % 2 else "an open bowl beside it",
                 walls=mesh, inside=inside)


@kind
def combined(make):
    """Two to four faults at once: flips, cuts, holes, copies, crossing pieces, offsets."""
    rng = make.rng
    for i in make.numbers(16):
        mesh = solid(rng, 2)
        if len(mesh.faces) < 300:
            mesh = shapes.blob(rng, 3)
        notes, slack = [], 0.0
        if rng.random() < 0.5:
            mesh = mesh + solid(rng, 1.5).moved(0.8, 0.3, 0)
            notes.append("a crossing piece")
        walls = broken = mesh
        for fault in rng.sample(("flip", "cut", "hole", "copy", "inward", "soup"), rng.randint(2, 3)):
            notes.append(fault)
            faces = broken.faces
            if fault == "flip":
                wrong = set(some_of(rng, range(len(faces)), 0.1))
                broken = Mesh(broken.vertices, [(f[0], f[2], f[1]) if k in wrong else f
                                                for k, f in enumerate(faces)])
            elif fault == "cut":
                broken = opened_along(rng, broken, 0.2, 0)
            elif fault == "hole":
                broken = broken.without(some_of(rng, range(len(faces)), 0.004))
            elif fault == "copy":
                broken = Mesh(broken.vertices, faces + rng.sample(faces, len(faces) // 10))
            elif fault == "inward":
                broken = broken.flipped()
            else:
                broken = broken.soup()
        solid_walls = Mesh(broken.vertices, broken.faces)
        make.add(broken, ", ".join(notes), walls=solid_walls, inside=walls, slack=slack)


@kind
def corrupted(make):
    """Files that end too early, are empty, or hold something else."""
    rng = make.rng
    ball = shapes.sphere(2).single()
    stl = formats.stl_binary(ball)
    binary = formats.ply(ball, "binary_little_endian")
    scene = formats.Gltf()
    scene.node(mesh=scene.mesh(ball))
    glb = scene.binary()
    noise = bytes(rng.randrange(256) for _ in range(3000))
    variants = [
        ("stl", b"", "empty"), ("obj", b"", "empty"), ("ply", b"", "empty"), ("off", b"", "empty"),
        ("gltf", b"", "empty"), ("glb", b"", "empty"),
        ("stl", stl[:len(stl) // 2], "ends in the middle"),
        ("stl", formats.stl_binary(ball, count=0xFFFFFFFF), "claims four thousand million"),
        ("stl", stl[:84], "only the header"), ("ply", binary[:len(binary) // 2], "ends too early"),
        ("ply", binary.replace(b"face 320", b"face 2000000000"), "claims two thousand million"),
        ("ply", binary.replace(b"vertex 162", b"vertex 4000000000"), "claims four thousand million"),
        ("off", formats.off(ball)[:4000], "ends too early"),
        ("off", formats.off(ball).replace(b"162 320", b"162000000 320"), "claims 162 million"),
        ("off", b"OFF\n4000000000 4000000000 0\n", "nothing but large numbers"),
        ("glb", glb[:len(glb) // 2], "ends too early"), ("glb", glb[:20], "only the header"),
        ("gltf", scene.text()[:500], "ends too early"),
        ("stl", noise, "noise"), ("obj", noise, "noise"), ("ply", b"ply\n" + noise, "noise"),
        ("off", b"OFF\n" + noise, "noise"), ("glb", b"glTF" + noise, "noise"),
        ("obj", b"<html><body>404 not found</body></html>\n", "a web page"),
        ("stl", b"solid nothing\nendsolid nothing\n", "a solid without triangles"),
        ("obj", b"\0" * 5000, "zeros"),
        ("ply", formats.ply(ball).replace(b"end_header", b"end_of_it"), "no end of the header"),
        ("off", b"OFF\n" + b"9" * 500 + b" 1 0\n", "a number of 500 digits"),
        ("obj", b"v " + b"1" * 100000 + b" 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
         "a number of a hundred thousand digits"),
    ]
    for k in make.numbers(len(variants)):
        name, data, note = variants[k]
        make.write(name, data, "refuse", note)


@kind
def not_numbers(make):
    """Coordinates that are not finite, or too large for their squares."""
    rng = make.rng
    for i in make.numbers(12):
        mesh = shapes.sphere(2).single()
        bad = [math.nan, math.inf, -math.inf, 1e300, 1e39, 3e38][i % 6]
        vertices = list(mesh.vertices)
        for k in rng.sample(range(len(vertices)), 1 + i // 6 * 20):
            vertices[k] = (vertices[k][0], bad, vertices[k][2])
        broken = Mesh(vertices, mesh.faces)
        form = ("obj", "off", "ply64")[i % 3] if abs(bad) > 1e38 and math.isfinite(bad) else None
        form = form or ("obj", "stl", "ply", "off", "ply-ascii")[i % 5]
        data = {"obj": lambda: formats.obj(broken), "off": lambda: formats.off(broken),
                "stl": lambda: formats.stl_binary(broken), "ply-ascii": lambda: formats.ply(broken),
                "ply": lambda: formats.ply(broken, "binary_little_endian"),
                "ply64": lambda: formats.ply(broken, "binary_little_endian", "double")}[form]()
        # A spike of 1e38 is finite: a program may fill it or refuse it, but not choke on it.
        make.write(form.partition("-")[0].removesuffix("64"), data,
                   "any" if math.isfinite(bad) else "refuse", f"y is {bad}")


@kind
def bad_indices(make):
    """Faces that name vertices that are not there."""
    ball = shapes.sphere(2).single()
    count = len(ball.vertices)
    cases = [count, 10 * count, 2 ** 31 - 1, -count - 5, 2 ** 31 + 5, -1]
    for i in make.numbers(12):
        bad = cases[i % 6]
        faces = list(ball.faces)
        faces[7] = (faces[7][0], bad, faces[7][2])
        broken = Mesh(ball.vertices, faces)
        form = (i + i // 6) % 4
        if form == 0 or bad >= 2 ** 31:
            if bad < 0:
                data = formats.obj(broken).replace(
                    f"f {faces[7][0] + 1} {bad + 1} ".encode(),
                    f"f {faces[7][0] + 1} {bad if bad < -1 else 0} ".encode())
            else:
                data = formats.obj(broken)
            make.write("obj", data, "refuse", f"vertex {bad} of {count}")
        elif form == 1:
            make.write("off", formats.off(broken), "refuse", f"vertex {bad} of {count}")
        elif form == 2:
            make.write("ply", formats.ply(broken, "binary_little_endian"), "refuse",
                       f"vertex {bad} of {count}")
        else:
            make.write("ply", formats.ply(broken), "refuse", f"vertex {bad} of {count}")


@kind
def point_clouds(make):
    """Points and lines, but no faces."""
    rng = make.rng
    cloud = Mesh([tuple(rng.gauss(0, 1) for _ in range(3)) for _ in range(500)]).single()
    points = "\n".join(f"p {k}" for k in range(1, 501))
    lines = "\n".join(f"l {k} {k + 1}" for k in range(1, 500))
    scene = formats.Gltf()
    scene.node(mesh=scene.mesh(Mesh(cloud.vertices, [(0, 1, 2)])))
    scene.document["meshes"][0]["primitives"][0]["mode"] = 0
    variants = [("obj", formats.obj(cloud)), ("obj", formats.obj(cloud, after=points)),
                ("obj", formats.obj(cloud, after=lines)), ("ply", formats.ply(cloud)),
                ("ply", formats.ply(cloud, "binary_little_endian").replace(
                    b"element face 0\nproperty list uchar int vertex_indices\n", b"")),
                ("off", formats.off(cloud)), ("stl", formats.stl_binary(cloud)),
                ("gltf", scene.text())]
    for k in make.numbers(len(variants)):
        make.write(*variants[k], "refuse", "points or lines only")


def fingerprint(seed, kinds, each):
    """Of what the corpus depends on."""
    here = pathlib.Path(__file__).resolve().parent
    sources = [(here / name).read_bytes() for name in ("make_corpus.py", "shapes.py", "formats.py")]
    return hashlib.sha256(b"\0".join([*sources, repr((seed, kinds, each)).encode()])).hexdigest()


def make_corpus(folder, seed=1, kinds=None, each=0, keep=False):
    """Writes the corpus; its records. With `keep` nothing is written that is there already."""
    mark = fingerprint(seed, kinds, each)
    if keep and (folder / "corpus.json").exists():
        known = json.loads((folder / "corpus.json").read_text())
        if known.get("fingerprint") == mark:
            return known["meshes"]
    (folder / "truth").mkdir(parents=True, exist_ok=True)
    records = []
    for name in kinds or KINDS:
        make = Maker(folder, name, seed, each)
        KINDS[name](make)
        records += make.records
    text = json.dumps({"seed": seed, "fingerprint": mark, "kinds": {k: KINDS[k].__doc__.split("\n")[0] for k in
                                               (kinds or KINDS)}, "meshes": records}, indent=1)
    (folder / "corpus.json").write_text(text + "\n")
    return records


def digest(folder, records):
    """One hash over all files."""
    total = hashlib.sha256((folder / "corpus.json").read_bytes())
    for record in records:
        for key in ("file", "walls", "inside"):
            if record.get(key, "run") != "run":
                total.update((folder / record[key]).read_bytes())
    return total.hexdigest()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="OUTPUT_DIR")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", action="append", choices=sorted(KINDS), metavar="K",
                        help="only this kind; may be repeated")
    parser.add_argument("--each", type=int, default=0, help="at most so many of a kind")
    options = parser.parse_args()
    records = make_corpus(options.folder, options.seed, options.kind, options.each)
    print(f"{len(records)} meshes of {len({r['kind'] for r in records})} kinds, "
          f"sha256 {digest(options.folder, records)}")


if __name__ == "__main__":
    main()
