# SPDX-License-Identifier: MIT
"""Solids of which the corpus is made. Every solid is closed and wound outward."""

import array
import math
import struct


def to_single(x):
    """The number that a file in single precision holds."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


class Mesh:
    """Vertices and triangles by index."""

    def __init__(self, vertices=(), faces=()):
        self.vertices = [tuple(v) for v in vertices]
        self.faces = [tuple(f) for f in faces]

    def __add__(self, other):
        n = len(self.vertices)
        return Mesh(self.vertices + other.vertices,
                    self.faces + [tuple(i + n for i in f) for f in other.faces])

    def mapped(self, function):
        return Mesh([function(v) for v in self.vertices], self.faces)

    def moved(self, x, y, z):
        return self.mapped(lambda v: (v[0] + x, v[1] + y, v[2] + z))

    def scaled(self, x, y=None, z=None):
        y, z = (x if y is None else y), (x if z is None else z)
        return self.mapped(lambda v: (v[0] * x, v[1] * y, v[2] * z))

    def turned(self, rng):
        """Turned at random."""
        q = [rng.gauss(0, 1) for _ in range(4)]
        n = math.sqrt(sum(c * c for c in q))
        w, x, y, z = (c / n for c in q)
        rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
                (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
                (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
        return self.mapped(lambda v: tuple(r[0] * v[0] + r[1] * v[1] + r[2] * v[2] for r in rows))

    def flipped(self):
        return Mesh(self.vertices, [(a, c, b) for a, b, c in self.faces])

    def single(self):
        return self.mapped(lambda v: tuple(to_single(c) for c in v))

    def without(self, faces):
        gone = set(faces)
        return Mesh(self.vertices, [f for i, f in enumerate(self.faces) if i not in gone])

    def soup(self):
        """Three vertices of its own for each triangle."""
        corners = [self.vertices[i] for f in self.faces for i in f]
        return Mesh(corners, [(i, i + 1, i + 2) for i in range(0, len(corners), 3)])

    def size(self):
        return max(max(c) - min(c) for c in zip(*self.vertices))

    def centre(self, face):
        corners = [self.vertices[i] for i in self.faces[face]]
        return tuple(sum(c) / 3 for c in zip(*corners))

    def bytes(self):
        """Nine coordinates a triangle in double precision, little-endian."""
        numbers = array.array("d", (c for f in self.faces for i in f for c in self.vertices[i]))
        if struct.pack("=d", 1) != struct.pack("<d", 1):
            numbers.byteswap()
        return numbers.tobytes()


def joined(parts):
    """One mesh of many, in a time that grows with their sum."""
    vertices, faces = [], []
    for part in parts:
        n = len(vertices)
        vertices += part.vertices
        faces += [tuple(i + n for i in f) for f in part.faces]
    return Mesh(vertices, faces)


def grid_faces(rows, columns, closed_rows, closed_columns):
    """Two triangles for each field of a grid of vertices."""
    faces = []
    for i in range(rows if closed_rows else rows - 1):
        for j in range(columns if closed_columns else columns - 1):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            c, d = (i + 1) % rows * columns + j, (i + 1) % rows * columns + (j + 1) % columns
            faces += [(a, b, d), (a, d, c)]
    return faces


def box(x=1, y=1, z=1, cells=1):
    """A box about the origin with cells x cells x 2 triangles a side."""
    index, vertices, faces = {}, [], []

    def at(p):
        if p not in index:
            index[p] = len(vertices)
            vertices.append(tuple((c / cells - 0.5) * s for c, s in zip(p, (x, y, z))))
        return index[p]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, cells):
            for i in range(cells):
                for j in range(cells):
                    quad = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = side, i + di, j + dj
                        quad.append(at(tuple(p)))
                    if side == 0:
                        quad.reverse()
                    faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return Mesh(vertices, faces)


def sphere(levels=3, radius=1):
    """An icosahedron divided again and again: 20 x 4^levels triangles."""
    g = (1 + math.sqrt(5)) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middle, finer = {}, []
        for a, b, c in faces:
            m = []
            for p, q in ((a, b), (b, c), (c, a)):
                key = (min(p, q), max(p, q))
                if key not in middle:
                    middle[key] = len(vertices)
                    vertices.append(tuple((s + t) / 2 for s, t in zip(vertices[p], vertices[q])))
                m.append(middle[key])
            finer += [(a, m[0], m[2]), (b, m[1], m[0]), (c, m[2], m[1]), (m[0], m[1], m[2])]
        faces = finer

    def out(v):
        n = math.sqrt(sum(c * c for c in v))
        return tuple(radius * c / n for c in v)

    return Mesh([out(v) for v in vertices], faces)


def torus(ring=1, tube=0.35, around=48, about=24):
    vertices = []
    for i in range(around):
        s = 2 * math.pi * i / around
        for j in range(about):
            t = 2 * math.pi * j / about
            d = ring + tube * math.cos(t)
            vertices.append((d * math.cos(s), tube * math.sin(t), d * math.sin(s)))
    return Mesh(vertices, grid_faces(around, about, True, True))


def lathe(profile, about=32, closed=True):
    """Turns a profile of (radius, height), from bottom to top, about the axis y.

    Ends of radius 0 are points. With `closed` other ends get a flat lid."""
    vertices, rings = [], []
    for radius, height in profile:
        if radius == 0:
            rings.append([len(vertices)] * about)
            vertices.append((0.0, height, 0.0))
        else:
            rings.append(list(range(len(vertices), len(vertices) + about)))
            vertices += [(radius * math.cos(2 * math.pi * j / about), height,
                          radius * math.sin(2 * math.pi * j / about)) for j in range(about)]
    faces = []
    for low, high in zip(rings, rings[1:]):
        for j in range(about):
            k = (j + 1) % about
            for f in ((low[j], high[j], high[k]), (low[j], high[k], low[k])):
                if len(set(f)) == 3:
                    faces.append(f)
    if closed:
        for ring, height, bottom in ((rings[0], profile[0][1], True),
                                     (rings[-1], profile[-1][1], False)):
            if len(set(ring)) == about:
                middle = len(vertices)
                vertices.append((0.0, height, 0.0))
                for j in range(about):
                    k = (j + 1) % about
                    faces.append((middle, ring[j], ring[k]) if bottom
                                 else (middle, ring[k], ring[j]))
    return Mesh(vertices, faces)


def cylinder(radius=0.5, height=1, about=32):
    return lathe([(radius, -height / 2), (radius, height / 2)], about)


def cone(radius=0.7, height=1.4, about=32):
    return lathe([(radius, 0), (0, height)], about)


def capsule(radius=0.4, height=1, about=24, rings=8):
    low = [(radius * math.sin(math.pi / 2 * i / rings),
            -height / 2 - radius * math.cos(math.pi / 2 * i / rings)) for i in range(rings + 1)]
    low[0] = (0, low[0][1])
    return lathe(low + [(r, -h) for r, h in reversed(low)], about)


def pipe(outer=0.5, inner=0.45, height=2, about=32):
    """A tube with a bore: a ring of rectangular section."""
    section = [(outer, -height / 2), (outer, height / 2), (inner, height / 2),
               (inner, -height / 2)]
    return ring_of(section, about)


def ring_of(section, about):
    """Turns a closed section of (radius, height), counterclockwise, about the axis y."""
    vertices = []
    for j in range(about):
        t = 2 * math.pi * j / about
        vertices += [(r * math.cos(t), h, r * math.sin(t)) for r, h in section]
    return outward(Mesh(vertices, grid_faces(about, len(section), True, True)))


def extruded(outline, height=1):
    """A prism over a polygon that is seen whole from its first vertex's average: star-shaped."""
    n = len(outline)
    middle = (sum(p[0] for p in outline) / n, sum(p[1] for p in outline) / n)
    vertices = [(x, -height / 2, z) for x, z in outline] + [(x, height / 2, z) for x, z in outline]
    vertices += [(middle[0], -height / 2, middle[1]), (middle[0], height / 2, middle[1])]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, 2 * n), (n + j, n + i, 2 * n + 1), (j, i, n + i), (j, n + i, n + j)]
    return outward(Mesh(vertices, faces))


def gear(teeth=10, inner=0.7, height=0.6):
    outline = []
    for i in range(4 * teeth):
        r = 1 if i % 4 < 2 else inner
        t = 2 * math.pi * i / (4 * teeth)
        outline.append((r * math.cos(t), r * math.sin(t)))
    return extruded(outline, height)


def blob(rng, levels=4, bumps=6, height=0.25):
    """A sphere with soft bumps; star-shaped, so it never crosses itself."""
    waves = [([rng.gauss(0, 1.6) for _ in range(3)], rng.uniform(0, 6.28)) for _ in range(bumps)]

    def out(v):
        s = 1 + height * sum(math.sin(sum(a * b for a, b in zip(k, v)) + p) for k, p in waves) / 3
        return tuple(c * max(s, 0.3) for c in v)

    return sphere(levels).mapped(out)


def tube_along(curve, radius, steps=120, about=16, closed=True):
    """A tube around a curve t -> point, t from 0 to 1. It crosses itself where the curve is near
    itself. An open curve gets flat ends."""
    def sub(a, b):
        return tuple(s - t for s, t in zip(a, b))

    def unit(a):
        n = math.sqrt(sum(c * c for c in a)) or 1
        return tuple(c / n for c in a)

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    count = steps if closed else steps + 1
    points = [curve(i / steps) for i in range(count)]
    vertices, normal = [], None
    frames = []
    for i in range(count):
        after = points[(i + 1) % count] if closed else points[min(i + 1, count - 1)]
        before = points[i - 1] if closed or i > 0 else points[0]
        tangent = unit(sub(after, before))
        if normal is None:
            axis = min(((1, 0, 0), (0, 1, 0), (0, 0, 1)),
                       key=lambda a: abs(sum(s * t for s, t in zip(a, tangent))))
            normal = cross(tangent, axis)
        along = sum(s * t for s, t in zip(normal, tangent))
        normal = unit(tuple(s - along * t for s, t in zip(normal, tangent)))
        frames.append((points[i], normal, cross(tangent, normal)))
    # Where the tube closes, the frame has turned; every ring takes its share of the difference.
    twist = 0.0
    if closed:
        _, first, second = frames[0]
        _, last, _ = frames[-1]
        twist = -math.atan2(sum(s * t for s, t in zip(last, second)),
                            sum(s * t for s, t in zip(last, first)))
    for i, (p, n, b) in enumerate(frames):
        r = radius(i / steps) if callable(radius) else radius
        for j in range(about):
            t = 2 * math.pi * j / about + twist * i / count
            vertices.append(tuple(q + r * (math.cos(t) * s + math.sin(t) * u)
                                  for q, s, u in zip(p, n, b)))
    faces = grid_faces(count, about, closed, True)
    if not closed:
        for end, ring in ((0, 0), (count - 1, (count - 1) * about)):
            middle = len(vertices)
            vertices.append(points[end])
            for j in range(about):
                k = (j + 1) % about
                f = (middle, ring + k, ring + j)
                faces.append(f if end == 0 else (f[0], f[2], f[1]))
    return outward(Mesh(vertices, faces))


def cells_mesh(cells, apart=False):
    """The boundary of a set of unit cells. Cells that share only an edge share it: four triangles.
    With `apart` each cell is a closed box."""
    cells = set(cells)
    if apart:
        return joined(box().moved(x + 0.5, y + 0.5, z + 0.5) for x, y, z in sorted(cells))
    index, vertices, faces = {}, [], []
    for cell in sorted(cells):
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * side - 1
                if tuple(beside) in cells:
                    continue
                quad = []
                for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = list(cell)
                    p[axis] += side
                    p[u] += du
                    p[v] += dv
                    p = tuple(p)
                    if p not in index:
                        index[p] = len(vertices)
                        vertices.append(tuple(map(float, p)))
                    quad.append(index[p])
                if side == 0:
                    quad.reverse()
                faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return Mesh(vertices, faces)


TETRAHEDRA = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7))


def implicit(function, cells, half=1.0):
    """The surface of function < 0 in the cube [-half, half]^3 by marching tetrahedra; what reaches
    the cube's side is closed there."""
    n = cells + 1
    step = 2 * half / cells

    def place(i, j, k):
        return (i * step - half, j * step - half, k * step - half)

    values = []
    for i in range(n):
        for j in range(n):
            for k in range(n):
                edge = min(i, j, k) == 0 or max(i, j, k) == cells
                value = 1.0 if edge else function(*place(i, j, k))
                values.append(value if abs(value) > 1e-3 else math.copysign(1e-3, value))
    offsets = [(c >> 2 & 1, c >> 1 & 1, c & 1) for c in range(8)]
    steps = [a * n * n + b * n + c for a, b, c in offsets]
    index, vertices, faces = {}, [], []

    def between(a, b):
        key = (a, b) if a < b else (b, a)
        if key not in index:
            a, b = key
            t = values[a] / (values[a] - values[b])
            p = place(a // (n * n), a // n % n, a % n)
            q = place(b // (n * n), b // n % n, b % n)
            index[key] = len(vertices)
            vertices.append(tuple(s + t * (u - s) for s, u in zip(p, q)))
        return index[key]

    for i in range(cells):
        for j in range(cells):
            base = i * n * n + j * n
            for k in range(cells):
                corner = [base + k + s for s in steps]
                signs = sum(values[c] < 0 for c in corner)
                if signs in (0, 8):
                    continue
                for tetrahedron in TETRAHEDRA:
                    t = [corner[c] for c in tetrahedron]
                    inside = [c for c in t if values[c] < 0]
                    outside = [c for c in t if values[c] >= 0]
                    if not inside or not outside:
                        continue
                    if len(inside) == 2:
                        (a, b), (c, d) = inside, outside
                        quad = [between(a, c), between(a, d), between(b, d), between(b, c)]
                        new = [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
                    elif len(inside) == 1:
                        new = [tuple(between(inside[0], c) for c in outside)]
                    else:
                        new = [tuple(between(c, outside[0]) for c in inside)]
                    away = place(outside[0] // (n * n), outside[0] // n % n, outside[0] % n)
                    within = place(inside[0] // (n * n), inside[0] // n % n, inside[0] % n)
                    for f in new:
                        p, q, r = (vertices[v] for v in f)
                        u = [s - t for s, t in zip(q, p)]
                        v = [s - t for s, t in zip(r, p)]
                        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                  u[0] * v[1] - u[1] * v[0])
                        if sum(m * (s - t) for m, s, t in zip(normal, away, within)) < 0:
                            f = (f[0], f[2], f[1])
                        faces.append(f)
    return Mesh(vertices, faces)


def volume(mesh):
    total = 0.0
    for f in mesh.faces:
        a, b, c = (mesh.vertices[i] for i in f)
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                  + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


def outward(mesh):
    return mesh if volume(mesh) > 0 else mesh.flipped()


def lids_of(mesh):
    """Fans over the loops of edges that only one triangle has, for an open mesh in one piece."""
    directed = {(f[i], f[(i + 1) % 3]) for f in mesh.faces for i in range(3)}
    following = {b: a for a, b in directed if (b, a) not in directed}
    vertices, faces = list(mesh.vertices), []
    while following:
        start, loop = next(iter(following)), []
        at = start
        while at in following:
            loop.append(at)
            at = following.pop(at)
        middle = len(vertices)
        vertices.append(tuple(sum(c) / len(loop) for c in zip(*(vertices[i] for i in loop))))
        faces += [(middle, a, b) for a, b in zip(loop, loop[1:] + loop[:1])]
    return Mesh(vertices, faces)


def without_loose_vertices(mesh):
    used = sorted({i for f in mesh.faces for i in f})
    new = {old: k for k, old in enumerate(used)}
    return Mesh([mesh.vertices[i] for i in used], [tuple(new[i] for i in f) for f in mesh.faces])
