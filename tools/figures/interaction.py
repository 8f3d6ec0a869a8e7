# SPDX-License-Identifier: MIT
"""PAPER, Figure 2: spheres and polygons, a covered polygon, and the pairs of three sets of groups.

Sections through the torus; lengths are in radii."""

import matplotlib.collections
import matplotlib.patches
import numpy

from . import style, tables
from .volume import draw_pairs


class Plane:
    """A plane with axes of its own, in mesh coordinates; lengths in `unit`."""

    def __init__(self, origin, across, upward, unit):
        self.origin, self.unit = numpy.asarray(origin, float), unit
        self.axes = numpy.array((across, upward, numpy.cross(across, upward)))

    def local(self, points):
        """Along the axes, and away from the plane."""
        return (numpy.asarray(points) - self.origin) @ self.axes.T / self.unit


def circles(state, plane):
    """Rows state, x, y, radius: in which the plane cuts spheres."""
    names = ("running", "frozen", "discarded")
    rows = []
    for (x, y, away), radius, number in zip(plane.local(state.centres), state.radii / plane.unit,
                                            state.states):
        if abs(away) < radius:
            rows.append((names[number], f"{x:.5f}", f"{y:.5f}", f"{(radius ** 2 - away ** 2) ** 0.5:.5f}"))
    return rows


def traces(vertices, triangles, states, plane):
    """Rows state, polygon, x, y, dx, dy: in which the plane cuts triangles."""
    local = plane.local(vertices)
    rows = []
    for number, triangle in enumerate(triangles):
        cuts = []
        for a, b in zip(triangle, numpy.roll(triangle, -1)):
            if (local[a, 2] < 0) != (local[b, 2] < 0):
                share = local[a, 2] / (local[a, 2] - local[b, 2])
                cuts.append((local[a] + (local[b] - local[a]) * share)[:2])
        if len(cuts) == 2:
            (x, y), (dx, dy) = cuts[0], cuts[1] - cuts[0]
            rows.append(("discarded" if states[number] else "active", number,
                         *(f"{value:.5f}" for value in (x, y, dx, dy))))
    return rows


def vertex_normal(vertices, triangles, vertex):
    """Inwards: the normals of the triangles around a vertex, weighted by their angles there."""
    total = numpy.zeros(3)
    for triangle in triangles[(triangles == vertex).any(axis=1)]:
        at = list(triangle).index(vertex)
        here, after, before = (vertices[triangle[(at + k) % 3]] for k in range(3))
        a, b = after - here, before - here
        normal = numpy.cross(a, b)
        angle = numpy.arctan2(numpy.linalg.norm(normal), a @ b)
        total -= angle * normal / numpy.linalg.norm(normal)
    return total / numpy.linalg.norm(total)


def covered_polygon(run, state, unit):
    """The lowest discarded polygon, and the plane through its longest edge and into the object."""
    corners = run.vertices[run.triangles]
    covered = numpy.flatnonzero(state.triangle_states)
    polygon = covered[numpy.argmin(corners[covered, :, 1].sum(axis=1))] if len(covered) else 0
    triangle = corners[polygon]
    sides = numpy.roll(triangle, -1, axis=0) - triangle
    edge = int(numpy.argmax(numpy.linalg.norm(sides, axis=1)))
    inward = -numpy.cross(sides[0], sides[1])
    a, b = triangle[edge], triangle[(edge + 1) % 3]
    plane = Plane((a + b) / 2, (b - a) / numpy.linalg.norm(b - a), inward / numpy.linalg.norm(inward), unit)
    return polygon, edge, plane


def measure(folder, quick):
    from . import runs
    options = dict(preset="paper", **runs.GRIDS, **({"count": 60} if quick else {}))
    new = runs.frostfill.Simulation("torus", **options)
    unit = new.radius
    (moment,) = runs.moments("torus", [new.expected_spheres * 3 // 5], **options)
    state = moment.snapshot()
    low, high = moment.vertices.min(axis=0), moment.vertices.max(axis=0)
    middle = Plane((low + high) / 2, (1, 0, 0), (0, 1, 0), unit)  # the torus stands upright
    circle, trace = ("state", "x", "y", "radius"), ("state", "polygon", "x", "y", "dx", "dy")
    tables.write(folder / "interaction-spheres.csv", circle, circles(state, middle))
    tables.write(folder / "interaction-polygons.csv", trace,
                 traces(moment.vertices, moment.triangles, state.triangle_states, middle))

    end = runs.finished("torus", **options)
    state = end.snapshot()
    polygon, edge, plane = covered_polygon(end, state, unit)
    tables.write(folder / "interaction-covering.csv", circle, circles(state, plane))
    rays = []
    for k in range(3):
        vertex = end.triangles[polygon][(edge + k) % 3]
        x, y, _ = plane.local(end.vertices[vertex])
        normal = plane.axes @ vertex_normal(end.vertices, end.triangles, vertex)
        rays.append(("edge" if k < 2 else "beside", *(f"{v + 0.0:.5f}" for v in numpy.round((x, y, *normal[:2]), 5))))
    tables.write(folder / "interaction-rays.csv", ("where", "x", "y", "dx", "dy"), rays)

    # The paper's example: three groups a set, and the third set runs.
    group = new.options["spheres_group_size"] or 10
    options.update(radius=unit, spheres_groups_per_set=3, freezing_every_sets=1, discard_rule="none", count=9 * group)
    (moment,) = runs.moments("torus", [9 * group], **options)
    tables.write(folder / "interaction-pairs.csv", ("i", "j", "kind", "tests"),
                 runs.pairs_of_groups(moment.snapshot()))


def _add_circles(ax, table):
    for x, y, radius, state in zip(table["x"], table["y"], table["radius"], table.words("state")):
        ax.add_patch(matplotlib.patches.Circle((x, y), radius, facecolor=style.STATES[state],
                                               edgecolor="#404040", linewidth=0.8))


def draw(folder):
    width, height, side = 1020, 400, 310
    figure = style.canvas(width, height)
    section, covered, pairs = (figure.add_axes((left / width, (below + side - part) / height, part / width,
                                                part / height))
                               for left, below, part in ((10, 50, side), (350, 50, side), (725, 50, 275)))
    _add_circles(section, tables.read(folder / "interaction-spheres.csv"))
    lines = tables.read(folder / "interaction-polygons.csv")
    for state, colour, width in (("active", style.BLACK, 1.6), ("discarded", style.DISCARDED_POLYGON, 4)):
        rows = lines.where(state=state)
        starts = numpy.column_stack((rows["x"], rows["y"]))
        ends = starts + numpy.column_stack((rows["dx"], rows["dy"]))
        section.add_collection(matplotlib.collections.LineCollection(
            numpy.stack((starts, ends), axis=1), colors=colour, linewidths=width))
    section.autoscale_view()
    _add_circles(covered, tables.read(folder / "interaction-covering.csv"))
    rays = tables.read(folder / "interaction-rays.csv")
    edge = rays.where(where="edge")
    covered.plot(edge["x"], edge["y"], color=style.DISCARDED_POLYGON, linewidth=4)
    covered.quiver(rays["x"], rays["y"], rays["dx"], rays["dy"], color=style.VERMILLION, angles="xy",
                   scale_units="xy", scale=1, width=0.008, zorder=3)
    covered.plot(rays["x"], rays["y"], color=style.BLACK, marker="o", linestyle="none", zorder=4)
    covered.set(xlim=(-3, 3), ylim=(-1.2, 4.8))
    for ax in (section, covered):
        ax.set(aspect="equal", xticks=[], yticks=[])
        ax.spines[:].set_visible(ax is covered)
    draw_pairs(pairs, tables.read(folder / "interaction-pairs.csv"))
    pairs.set(xticks=range(1, 10), yticks=range(1, 10))
    for ax, title in ((section, "(A) spheres and polygons"), (covered, "(B) a covered polygon"),
                      (pairs, "(C) three sets of three groups")):
        ax.set_title(title)
    figure.legend(handles=[style.swatch("polygon", style.BLACK, "_"),
                           style.swatch("discarded polygon", style.DISCARDED_POLYGON, "s"),
                           *(style.swatch(name, colour) for name, colour in style.STATES.items()),
                           style.swatch("not tested", style.NOT_TESTED, "s")], loc="lower center", ncols=6)
    return figure
