# SPDX-License-Identifier: MIT
"""Runs that are measured or drawn, through the module frostfill."""

import math

import frostfill
import numpy

OBJECTS = ("torus", "sphere", "cube", "human")
GRIDS = {"search_spheres": "grid", "search_polygons": "grid"}  # the same bits as all pairs, sooner
GRAVITY = 9.81


def panel(side):
    """Pictures as figures have them: square, small, no legend, in the style for print."""
    return {"size": f"{side}x{side}", "style": "paper", "legend": False}


def finished(mesh, **options):
    """A simulation at its end."""
    simulation = frostfill.Simulation(mesh, **options)
    simulation.advance()
    return simulation


def in_bulk(analysis):
    """Which spheres of an analysis lie four radii from the walls and below the surface of the bed."""
    far = 4 * analysis.radii.max()
    return (analysis.wall_distances >= far) & (analysis.depths >= far)


def moments(mesh, spheres, **options):
    """The simulation at each moment when so many spheres are present (ascending) and the newest have
    been falling for half the time of a fall through the object; its end where it ends before."""
    simulation = frostfill.Simulation(mesh, **options)
    height = numpy.ptp(simulation.vertices[:, 1])
    wait = math.sqrt(2 * height / GRAVITY) / 2
    for count in spheres:
        reached = None
        while simulation.step():
            if reached is None and simulation.sphere_count >= count:
                reached = simulation.time
            if reached is not None and simulation.time - reached >= wait:
                break
        yield simulation


def joined(pictures, columns, strip=0):
    """Pictures of one size side by side, row by row, each above a white strip so many pixels high."""
    height, width = pictures[0].shape[:2]
    rows = -(-len(pictures) // columns)
    whole = numpy.full((rows * (height + strip), columns * width, 3), 255, numpy.uint8)
    for k, picture in enumerate(pictures):
        top, left = k // columns * (height + strip), k % columns * width
        whole[top:top + height, left:left + width] = picture[:, :, :3]
    return whole


def pairs_of_groups(state):
    """Rows i, j, kind, tests: which pairs of groups a step tests, and how often. With the paper's
    method all spheres of a group are in one state."""
    groups = numpy.asarray(state.groups)
    sizes = numpy.bincount(groups)
    states = numpy.zeros(len(sizes), int)
    states[groups] = state.states
    running, frozen, discarded = (int(each) for each in frostfill.SphereState)
    rows = []
    for j, other in enumerate(states):
        for i in range(j + 1):
            if discarded in (states[i], other):
                kind = "discarded"
            elif states[i] == other:
                kind = "running" if other == running else "none"
            else:
                kind = "frozen"
            tests = 0
            if kind in ("running", "frozen"):
                tests = sizes[i] * (sizes[i] - 1) // 2 if i == j else sizes[i] * sizes[j]
            rows.append((i + 1, j + 1, kind, int(tests)))
    return rows
