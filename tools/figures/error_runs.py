# SPDX-License-Identifier: MIT
"""The runs behind the figure `error` that need nothing but the module: steps, discards, volume, layers
and rendering. Each is one run on one thread, with its processor time."""

import math
import time

import numpy

from . import tables

HEAD = ("curve", "setting", "rivals", "seconds", "error", "default")
RANDOM_CLOSE = 0.639  # packing fraction
RULE_FRACTION = 0.5887  # that the rule of two radii divides by, with --motion skip


def _timed(work):
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def _row(curve, setting, rivals, seconds, error, default, *details):
    return (curve, setting, rivals, f"{seconds:.4f}", f"{error:.4e}", int(default),
            *(f"{detail:.6g}" for detail in details))


def overlaps(state):
    """The largest and the mean overlap [r] of running spheres of one size, with all others."""
    moves = numpy.flatnonzero(state.states == 0)
    if not len(moves):
        return 0.0, 0.0
    apart = numpy.linalg.norm(state.centres[moves, None] - state.centres[None], axis=2)
    depth = 2 - apart / state.radii[0]
    # Each pair once: a running sphere with those that rest, and with running ones after it.
    later = (state.states != 0) | (numpy.arange(len(state)) > moves[:, None])
    depth = depth[later & (depth > 0) & (numpy.arange(len(state)) != moves[:, None])]
    return (depth.max(), depth.mean()) if len(depth) else (0.0, 0.0)


def steps(runs, quick):
    """Time steps and contact sweeps against overlap in motion, support and energy; means over seeds."""
    unit = math.sqrt(0.1 / runs.GRAVITY)

    def run(factor, seeds, **options):
        numbers = []
        step = None
        for seed in range(1, seeds + 1):
            start = time.process_time()
            simulation = runs.frostfill.Simulation("cube", radius=0.1, count=100 if quick else 600, seed=seed,
                                                   threads=1, **options)
            if factor != 1:
                step = step or factor * simulation.time_step
                start = time.process_time()
                simulation = runs.frostfill.Simulation("cube", radius=0.1, count=100 if quick else 600,
                                                       seed=seed, threads=1, motion_dt=step, **options)
            looks, looking = [], 0.0
            every = max(1, round(0.5 * unit / simulation.time_step))
            while simulation.advance(every) == every:
                before = time.process_time()
                looks.append(overlaps(simulation.snapshot()))
                looking += time.process_time() - before
            seconds = time.process_time() - start - looking
            quality = simulation.quality()
            numbers.append((seconds, *numpy.mean(looks, axis=0), quality.max_overlap, quality.mean_overlap,
                            quality.unsupported / simulation.sphere_count, quality.energy_gain,
                            quality.energy_excess, quality.centres_outside))
        return simulation.time_step / unit, numpy.mean(numbers, axis=0)

    rows = []
    for curve, rivals, options in (
            ("fast", "fall", {}), ("fast skip", "skip", {"motion": "skip"}),
            ("paper", "fall", {"preset": "paper", **runs.GRIDS}),
            ("paper semi-implicit", "fall", {"preset": "paper", "motion_integrator": "semi-implicit", **runs.GRIDS})):
        fast = "preset" not in options
        # The preset fast divides steps that are longer than twice its default.
        factors = [f for f in (0.1, 0.25, 0.5, 1, 2, 4, 8)
                   if (f <= (1 if rivals == "skip" else 2) if fast else f >= 0.25)
                   and (not quick or f in (0.5, 1, 2))]
        for factor in factors:
            for sweeps in ((1, 16) if quick else (1, 2, 4, 8, 16)) if fast else (1,):
                more = {"motion_sweeps": sweeps} if fast else {}
                step, (seconds, *found) = run(factor, 12 if fast else 3, **options, **more)
                setting = f"step x{factor:g}" + (f", sweeps {sweeps}" if fast else "")
                rows.append(_row(curve, setting, rivals, seconds, found[0] + found[4],
                                 fast and factor == 1 and sweeps == 16, step, sweeps, *found))
    return ("step", "sweeps", "moving_overlap", "mean_moving_overlap", "max_overlap", "mean_overlap",
            "unsupported_share", "energy_gain", "energy_excess", "outside"), rows


def discards(runs, quick):
    """Places with discards against those without."""
    def run(mesh, setting, default, **options):
        usual = {"count": 100 if quick else 300, "threads": 1}
        preset = "paper" if "discard_closeness" in options or "discard_epsilon" in options else "fast"
        without, seconds_without = _timed(lambda: runs.finished(
            mesh, preset=preset, **usual, **{**options, "discard_rule": "none"}))
        kept, seconds = _timed(lambda: runs.finished(mesh, preset=preset, **usual, **options))
        ends = [each.snapshot() for each in (without, kept)]
        far = math.inf
        if len(ends[0]) == len(ends[1]):
            far = numpy.linalg.norm(ends[0].centres - ends[1].centres, axis=1).max() / kept.radius
        quality = kept.quality()
        return _row("exact" if preset == "fast" else "paper", setting, "", seconds, far, default,
                    ends[1].discarded / len(ends[1]), ends[1].discarded_triangles / len(kept.triangles),
                    seconds_without, quality.centres_outside, quality.max_overlap)

    rows = [run("torus", f"epsilon {value:g} r", value == 4, discard_rule="paper", discard_epsilon=value)
            for value in (0.5, 1, 2, 4, 8)]
    rows += [run("torus", f"closeness {value:g} r", False, discard_rule="paper", discard_closeness=value)
             for value in (0.1, 1, 2, 4)]
    rows += [run(mesh, f"exact, {mesh}", True, discard_rule="exact") for mesh in runs.OBJECTS]
    for row in rows:
        if row[0] == "exact" and float(row[4]) != 0:
            raise SystemExit(f"{row[1]}: exact discards change the result")
    return ("spheres_dropped", "polygons_dropped", "seconds_without", "outside", "max_overlap"), rows


def volume(runs, quick):
    """The volume that spheres of one radius tell, for finer and finer ones."""
    rows = []
    for mesh in runs.OBJECTS:
        report = runs.frostfill.inspect(mesh).filled
        length = report.volume / report.area
        most = 8e3 if quick else 1.7e6 if mesh == "cube" else 1.1e5
        fillings = {}

        def fill(x):
            if x not in fillings:
                run, seconds = _timed(lambda: runs.finished(mesh, radius=x * length, count=None,
                                                            motion="skip", threads=1))
                quality = run.quality()
                fillings[x] = (run.sphere_count, quality.sphere_volume / quality.mesh_volume,
                               quality.volume_estimate / quality.mesh_volume - 1, seconds)
            return fillings[x]

        def expected(x):
            return 0.6 * report.volume / (4 / 3 * math.pi * (x * length) ** 3)

        def add(curve, x, count, error, seconds, taken=0.0, default=False):
            setting = f"{mesh}, --estimate-volume" if default else f"{mesh}, rS/V {x:.3g}"
            rows.append(_row(curve, setting, mesh, seconds, abs(error), default, x, count, error, taken))

        for k in range(12):
            # Halves of the radii occur again, for the estimate from two.
            x = 0.6 * (1, math.sqrt(0.5))[k % 2] / 2 ** (k // 2)
            if expected(x) > most:
                break
            count, taken, corrected, seconds = fill(x)
            add("raw", x, count, taken - 1, seconds, taken)
            add("wall-corrected", x, count, corrected, seconds, taken)
            if expected(x / 2) <= most:
                _, finer, _, more = fill(x / 2)
                fraction = 2 * finer - taken
                add("two radii", x, count, fraction / RULE_FRACTION - 1, seconds + more, taken)
        estimate, seconds = _timed(lambda: runs.frostfill.volume(mesh, motion="skip", threads=1))
        add("two radii", estimate.radius / length, estimate.fine,
            estimate.volume / estimate.mesh_volume - 1, seconds, default=True)
    return ("rS_over_V", "spheres", "signed_error", "fraction"), rows


def layers(runs, quick):
    """Layers of spheres in a set against the packing fraction far from walls."""
    diameters = 14 if quick else 25
    cube = runs.frostfill.Simulation("cube", count=1)
    vertices = numpy.asarray(cube.vertices) * diameters / 2
    rows = []
    for by_set in (True, False):
        for size in (7, 20, 70, 210, 400, 700, 1400, 2100):
            if quick and size not in (20, 210):
                continue
            run, seconds = _timed(lambda: runs.finished(
                None, vertices=vertices, triangles=cube.triangles, radius=0.5, count=None, motion_restitution=0,
                freezing_rule="by-set" if by_set else "one-by-one", spheres_group_size=size, spheres_groups_per_set=1,
                threads=1))
            state, quality = run.snapshot(), run.quality()
            found = runs.frostfill.analyse(state.centres, state.radii, run.vertices, run.triangles, gap=0.02,
                                           only=["porosity", "contacts"])
            bulk = runs.in_bulk(found)
            fraction = 1 - found.summary["porosity"]["bulk"]
            rows.append(_row("by set" if by_set else "one by one", f"{size} a set", "", seconds,
                             RANDOM_CLOSE - fraction, not by_set and size == 70,
                             size / (1.15 * diameters ** 2), fraction,
                             numpy.mean(found.sphere_contacts[bulk]), bulk.sum(),
                             quality.max_overlap, quality.unsupported / len(state)))
    return ("layers", "fraction", "contacts", "spheres_counted", "max_overlap", "unsupported_share"), rows


def rendering(runs, quick):
    """Samples a pixel against a picture of 256, for spheres and for shells."""
    width, height = (240, 135) if quick else (480, 270)
    size = f"{width}x{height}"
    rows = []


    def compare(curve, setting, rivals, reference, run, samples, supersample, triangles, **options):
        def draw():
            return run.render(picture_samples=samples, picture_supersample=supersample, size=size, legend=False,
                              picture_static_layer=False, **options)
        draw()
        picture, seconds = min((_timed(draw) for _ in range(5)), key=lambda each: each[1])
        apart = picture[:, :, :3] - reference
        rows.append(_row(curve, setting, rivals, seconds, math.sqrt(numpy.mean(apart ** 2)),
                         samples == 4 and supersample == 1, samples, supersample, triangles,
                         abs(apart).max(), (abs(apart).max(axis=2) > 8).sum()))

    run = runs.finished("torus", count=200 if quick else 1000, motion="skip")
    # Of 256 samples a pixel: a picture twice as large, whose pixels are averaged by four.
    fine = run.render(picture_samples=1, picture_supersample=8, size=f"{2 * width}x{2 * height}", legend=False, shell=False)
    fine = fine[:, :, :3].reshape(height, 2, width, 2, 3).mean(axis=(1, 3))
    for samples, supersample in ((1, 1), (2, 1), (4, 1), (1, 2), (1, 3), (1, 4)):
        compare("exact spheres", f"{samples} samples, {supersample}x{supersample}", "", fine, run, samples,
                supersample, 0, shell=False)
    for along in (48, 192, 768):
        vertices, triangles = torus(along)
        run = runs.frostfill.Simulation(vertices=vertices, triangles=triangles, count=1, radius=0.05)
        # Its lines are one pixel wide, so its size stays.
        fine = run.render(picture_samples=4, picture_supersample=8, size=size, legend=False)[:, :, :3].astype(float)
        name = f"{len(triangles)} triangles"
        for samples in (1, 4):
            compare("shell", f"{name}, {samples} samples", "shell of " + name, fine, run, samples, 1,
                    len(triangles))
    return ("samples", "supersample", "triangles", "largest", "pixels_apart"), rows


def torus(along):
    """Vertices and triangles, with so many quads along the tube and a quarter of that around it."""
    around = along // 4
    u, v = numpy.meshgrid(2 * numpy.pi * numpy.arange(along) / along,
                          2 * numpy.pi * numpy.arange(around) / around, indexing="ij")
    ring = 1 + 0.4 * numpy.cos(v)
    vertices = numpy.stack((ring * numpy.cos(u), ring * numpy.sin(u), 0.4 * numpy.sin(v)), axis=2)
    at = numpy.arange(along * around).reshape(along, around)
    next_u, next_v = numpy.roll(at, -1, axis=0), numpy.roll(at, -1, axis=1)
    next_both = numpy.roll(next_u, -1, axis=1)
    triangles = numpy.concatenate((numpy.stack((at, next_u, next_both), axis=2).reshape(-1, 3),
                                   numpy.stack((at, next_both, next_v), axis=2).reshape(-1, 3)))
    return vertices.reshape(-1, 3), triangles


def measure(folder, quick):
    from . import runs
    for study in (steps, discards, volume, layers, rendering):
        details, rows = study(runs, quick)
        tables.write(folder / f"error-{study.__name__}.csv", HEAD + details, rows)
