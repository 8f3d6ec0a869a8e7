# SPDX-License-Identifier: MIT
"""Reads the inputs of other programs as these document them: inputs_by_hand.py FOLDER FORMAT"""
import re
import sys

from oracle import Oracle

run = Oracle(sys.argv[1])
last = run.frames[-1]
assert not any(last["waiting"])
BOX = [[f(v[i] for v in last["vertices"]) for i in range(3)] for f in (min, max)]


def spheres(rows):
    """Compares rows of x, y, z and radius with the run."""
    rows = [[float(word) for word in row] for row in rows]
    run.same("centres", [row[:3] for row in rows], last["centres"])
    run.same("radii", [row[3] for row in rows], last["radii"])


def lines_of(name):
    return run.file(name).read_text().splitlines()


def walls(name):
    """The text form of STL: every triangle of the mesh with its normal."""
    text = run.file(name).read_text()
    facets = re.findall(r"facet normal (\S+) (\S+) (\S+)\s+outer loop\s+vertex (\S+) (\S+) (\S+)\s+"
                        r"vertex (\S+) (\S+) (\S+)\s+vertex (\S+) (\S+) (\S+)\s+endloop\s+endfacet", text)
    run.equal("first and last line", [text.splitlines()[0], text.splitlines()[-1]],
              ["solid walls", "endsolid walls"])
    facets = [[float(word) for word in facet] for facet in facets]
    run.equal("facets", len(facets), len(run.triangles))
    for facet, triangle in zip(facets, run.triangles):
        a, b, c = (last["vertices"][corner] for corner in triangle)
        run.same("corners of a wall", facet[3:], a + b + c, 1e-15)
        u, v = ([q - p for p, q in zip(a, corner)] for corner in (b, c))
        across = [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]
        length = sum(x * x for x in across) ** 0.5
        run.same("normal of a wall", facet[:3], [x / length for x in across], 1e-12)


def data_file(name):
    """LAMMPS, atom_style sphere: id, type, diameter, density, x, y, z. Types as a list."""
    lines = lines_of(name)
    run.equal("heading", [lines[1:5], lines[8:11]],
              [["", f"{len(last['radii'])} atoms", "2 atom types", ""], ["", "Atoms", ""]])
    for axis, line in enumerate(lines[5:8]):
        low, high, *names = line.split()
        run.equal("ends of the box", names, ["xyz"[axis] + "lo", "xyz"[axis] + "hi"])
        run.equal("box around all", [float(low) < BOX[0][axis], float(high) > BOX[1][axis]],
                  [True, True])
    rows = [line.split() for line in lines[11:]]
    run.same("ids", [int(row[0]) - 1 for row in rows], last["ids"])
    spheres([[*row[4:7], float(row[2]) / 2] for row in rows])
    run.equal("densities", {row[3] for row in rows}, {"2500"})
    return [int(row[1]) for row in rows]


def talks(name):
    """The script prints a line of numbers at least ten times in its run."""
    text = run.file(name).read_text()
    wanted = re.search(r"^variable often equal ceil\(v_steps/(\d+)\)$", text, re.M)
    run.equal("often", (int(wanted[1]) >= 10, re.findall("^thermo (.*)$", text, re.M)), (True, ["${often}"]))


def liggghts():
    talks("liggghts.in")
    run.equal("types", set(data_file("liggghts.data")), {1})
    walls("liggghts_walls.stl")


def lammps():
    """The torus is not convex: of type 2 are the spheres that touch it."""
    talks("lammps.in")
    touching = [2 if min(distance(centre, triangle) for triangle in run.triangles) < 1.01 * radius else 1
                for centre, radius in zip(last["centres"], last["radii"])]
    run.equal("types", data_file("lammps.data"), touching)


def distance(point, triangle):
    """From a triangle, by projection on the plane and on the edges."""
    corners = [last["vertices"][corner] for corner in triangle]
    dot = lambda p, q: sum(x * y for x, y in zip(p, q))
    minus = lambda p, q: [x - y for x, y in zip(p, q)]
    cross = lambda u, v: [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]
    normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
    nearest, inside = float("inf"), True
    for a, b in zip(corners, corners[1:] + corners[:1]):
        edge, to = minus(b, a), minus(point, a)
        along = min(1, max(0, dot(edge, to) / dot(edge, edge)))
        gap = [t - along * e for t, e in zip(to, edge)]
        nearest = min(nearest, dot(gap, gap) ** 0.5)
        inside = inside and dot(cross(edge, to), normal) >= 0
    return abs(dot(minus(point, corners[0]), normal)) / dot(normal, normal) ** 0.5 if inside else nearest


def yade():
    lines = lines_of("yade.txt")
    run.equal("format", lines[0], "#format x_y_z_r")
    run.equal("empty lines, which YADE fails on", [line for line in lines if not line.split()], [])
    spheres([line.split() for line in lines if not line.startswith("#")])
    walls = [line.split() for line in lines_of("yade_walls.txt")]
    run.equal("format of the walls", walls[0], ["#format", "x1_y1_z1_x2_y2_z2_x3_y3_z3"])
    run.same("walls", [[float(word) for word in wall] for wall in walls[1:]],
             [[last["vertices"][corner] for corner in triangle] for triangle in run.triangles], 1e-15)


def mercurydpm():
    lines = [line.split() for line in lines_of("mercurydpm.data")]
    run.equal("number", int(lines[0][0]), len(lines) - 1)
    run.same("time", float(lines[0][1]), last["time"])
    low, high = ([float(word) for word in lines[0][i:i + 3]] for i in (2, 5))
    run.equal("box around all", [all(a <= b + 1e-12 for a, b in zip(low, BOX[0])),
                                 all(a >= b - 1e-12 for a, b in zip(high, BOX[1]))], [True, True])
    run.equal("words of a sphere", {len(line) for line in lines[1:]}, {14})
    spheres([[*line[:3], line[6]] for line in lines[1:]])
    run.equal("the rest", {word for line in lines[1:] for word in line[3:6] + line[7:]}, {"0"})


def mfix():
    """Words are read as the Fortran of MFiX reads them: 18 lines are skipped, and three twice."""
    lines = lines_of("particle_input.dat")
    run.equal("version", lines[0], "Version 2.0")
    run.equal("empty lines, which Fortran skips", [line for line in lines if not line.split()], [])
    head = [line.split() for line in lines[18:20]]
    run.equal("head", [head[0], head[1]], [["Dimension:", "3"], ["Particles:", str(len(last["radii"]))]])
    options = {line.split()[0].rstrip(":"): line.split()[1:] for line in lines[23:31]}
    run.equal("options", list(options), ["Coordinates", "Phase_ID", "Diameter", "Density", "Velocity", "Temperature",
                                         "Species", "User_Scalar"])
    run.equal("what is read", [name for name, words in options.items() if words[0] == "T"], ["Coordinates", "Diameter"])
    run.same("phase, density, velocity", [float(word) for name in ("Phase_ID", "Density", "Velocity")
                                          for word in options[name][1:]], [1, 2500, 0, 0, 0])
    rows = [line.split() for line in lines[34:]]
    spheres([[*row[:3], float(row[3]) / 2] for row in rows])


def lethe():
    lines = [[word.strip() for word in line.split(";")] for line in lines_of("particles.input")]
    run.equal("heading", lines[0], ["p_x", "p_y", "p_z", "v_x", "v_y", "v_z", "w_x", "w_y", "w_z", "diameters", ""])
    run.equal("velocities", {word for line in lines[1:] for word in line[3:9]}, {"0"})
    spheres([[*line[:3], float(line[9]) / 2] for line in lines[1:]])


globals()[sys.argv[2]]()
run.finish()
