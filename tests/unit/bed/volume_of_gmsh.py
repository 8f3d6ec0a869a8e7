# SPDX-License-Identifier: MIT
"""Compares the volume and the count of gmsh's tetrahedra with what a summary says: MESH SUMMARY KEY TOLERANCE."""
import json
import sys


def volume(a, b, c, d):
    u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
    return abs(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
               + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


nodes, total, cells, section = {}, 0.0, 0, None
for line in open(sys.argv[1]):
    words = line.split()
    if line.startswith("$"):
        section = words[0]
    elif section == "$Nodes" and len(words) == 4:
        nodes[words[0]] = [float(word) for word in words[1:]]
    elif section == "$Elements" and len(words) > 3 and words[1] == "4":
        cells += 1
        total += volume(*(nodes[word] for word in words[3 + int(words[2]):]))
summary = json.load(open(sys.argv[2]))
found = total / summary["container_volume"]
print("porosity", found, "stated", summary[sys.argv[3]])
estimate = summary.get("estimated_cells", cells)
print("cells", cells, "estimate", estimate)
sys.exit(abs(found - summary[sys.argv[3]]) > float(sys.argv[4]) or not 0.7 < estimate / cells < 1.3)
