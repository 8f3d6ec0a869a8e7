#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fills objects by scenes whose options are drawn at random, and looks at how each run ends.

Every run must end by itself within a limit of processor time, with a documented exit code. A run
that fills its object must have no centre outside, nothing that is not finite, and the same state
hash with another number of threads. Some runs get a signal, which must end them.

Exits with 1 if a scene fails, and prints the command of each. Equal seeds draw equal scenes.
"""

import argparse
import collections
import json
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

# Objects with radii at which some ten to some thousand spheres fit.
OBJECTS = {
    "torus": (0.09, 0.2),
    "sphere": (0.09, 0.3),
    "cube": (0.08, 0.3),
    "human": (0.028, 0.06),
}
FILLED = (0,)
STOPPED = 75
DOCUMENTED = {0, 64, 65, 69, 70, 71, STOPPED}
OVERLAP = 1e-6  # of a radius; the preset fast
PROCESSOR_SECONDS = 150
WALL_SECONDS = 3600  # for what waits without end


def number(value):
    return f"{value:.6g}"


class Draw:
    """The options of one scene."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.options = []

    def chance(self, share):
        return self.random.random() < share

    def between(self, low, high):
        return self.random.uniform(low, high)

    def give(self, share, name, *values):
        """Gives an option in this share of all scenes, with one of the values or without any."""
        if self.chance(share):
            given = [name]
            if values:
                value = self.random.choice(values)
                given.append(value() if callable(value) else value)
            self.options += given if name.startswith("--") else ["--set", "=".join(given)]

    def sizes(self, low, high):
        mean = self.between(low, high)
        kind = self.random.choice(["normal", "lognormal", "weibull", "ends"])
        spread = self.between(0.02, 0.3) * mean
        if kind == "weibull":
            curve = f"weibull:{number(mean)},{number(self.between(2, 9))}"
            curve += f",{number(0.5 * mean)}..{number(1.3 * mean)}"
        elif kind == "ends":
            ratio = self.between(1.1, 4)
            curve = f"lognormal:{number(mean)},{number(spread)}"
            curve += f",{number(mean / ratio)}..{number(mean * math.sqrt(ratio))}"
        else:
            curve = f"{kind}:{number(mean)},{number(spread)}"
        self.options += ["--sizes", curve, "--by", self.random.choice(["mass", "number"])]
        self.give(0.7, "spheres.curve_within", "none", "1", "0", lambda: number(self.between(0, 0.2)))
        self.give(0.2, "spheres.fill_gaps=true")

    def spheres(self, low, high, is_paper, is_joint):
        kind = self.random.choice(["radius", "range", "count"] + 3 * ["sizes"] * (not is_paper))
        radius = self.between(low, high)
        if kind == "radius":
            self.options += ["--radius", number(radius)]
        elif kind == "range":
            self.options += ["--radius",
                             f"{number(radius)}..{number(radius * self.between(1, 3))}"]
        elif kind == "sizes":
            self.sizes(low, high)
        # Many spheres that rest together take minutes, and more of them when they are elastic.
        count = str(self.random.randint(1, 40 if is_joint else 400))
        if kind == "count" or is_joint:
            self.options += ["--count", count]
        else:
            self.give(0.4, "--count", count)
        if not is_joint:
            self.give(0.1, "spheres.until_full=true")
        self.give(0.2, "spheres.group_size", "1", "7", "60", "1500")
        self.give(0.2, "spheres.groups_per_set", "1", "3", "20")
        if self.chance(0.07):
            place = ",".join(number(self.between(-0.3, 0.3)) for _ in range(3))
            self.options += ["--inlet", f"{place},{number(self.between(1, 4) * radius)}"]

    def motion(self, motion, is_joint=False):
        if motion:
            self.options += ["--motion", motion]
        self.give(0.2, "motion.gravity", "1e-3", "1.6", "100")
        self.give(0.1, "motion.dt", "1e-4", "0.01", "10")
        self.give(0.4, "motion.restitution", "0", "0.5", *(() if is_joint else ("0.9", "1")))

    def move(self):
        self.give(0.3, "move.tilt", "20", "180")
        self.give(0.3, "move.turn", "90", "-400")
        self.give(0.3, "move.shake", "0.02")
        self.give(0.1, "move.frequency", "0.5", "5")
        self.give(0.1, "move.duration", "0.5", "2")

    def joint_rest(self):
        self.options += ["--rest", "joint"]
        self.give(0.7, "--friction", "0", "0.3", "0.8")
        self.give(0.2, "rest.wall_friction", "0", "0.5")
        self.give(0.2, "rest.rolling_friction", "0.05")
        self.give(0.1, "--fraction", "0.58", "0.62", "densest")
        self.give(0.2, "rest.orientation=true")

    def paper(self):
        self.options += ["--preset", "paper"]
        self.motion(None)
        self.give(0.4, "discard.rule", "none", "paper")
        self.give(0.2, "discard.closeness", "0.1")
        self.give(0.3, "search.spheres", "all-pairs", "grid")
        self.give(0.3, "search.polygons", "loop", "list", "quadtree", "grid")
        self.give(0.3, "motion.integrator", "explicit", "semi-implicit")
        self.give(0.2, "freezing.every_sets", "0", "1", "5")

    def fast(self, is_joint):
        motions = ["fall", "skip", "skip", "descend", "descend"]
        motion = self.random.choice(motions + ["granular"] * 3 * is_joint)
        self.motion(motion, is_joint)
        if is_joint:
            self.joint_rest()
        elif motion != "descend":
            self.give(0.1, "rest.rolling_friction", "0.05")
            self.give(0.15, "freezing.rule=by-set")
            if self.chance(0.15):
                self.move()
        self.give(0.1, "motion.sweeps", "1", "4", "60")
        self.give(0.3, "discard.rule", "none", "exact")
        self.give(0.1, "search.neighbour_lists=false")

    def anything(self):
        """Options that mostly do not go together."""
        self.give(0.3, "--preset", "paper", "fast")
        self.motion(self.random.choice(["fall", "skip", "descend", "granular"]), True)
        self.move()
        self.give(0.3, "--rest", "each")
        self.give(0.3, "--friction", "0.3")
        self.give(0.3, "discard.rule", "paper")
        self.give(0.3, "spheres.fill_gaps=true")

    def scene(self):
        name = self.random.choice(list(OBJECTS))
        self.options += ["--seed", str(self.random.randint(0, 1000))]
        self.give(0.2, "--up", "x", "y", "z")
        self.give(0.1, "--units", "mm", "ft")
        is_paper = self.chance(0.1)
        is_joint = not is_paper and self.chance(0.12)
        self.spheres(*OBJECTS[name], is_paper, is_joint)
        if self.chance(0.07):
            self.anything()
        else:
            self.paper() if is_paper else self.fast(is_joint)
        self.give(0.1, "freezing.set_time_limit", "5", "200")
        self.give(0.07, "judge.friction", "0", "0.5")
        if self.chance(0.1):
            self.options += ["--frames", self.random.choice(["last", "0..3", "all"]),
                             "--size", "64x48", "--set", "frames.limit=5"]
            self.give(0.5, "--style", "clean", "paper", "dark", "studio")
            self.give(0.3, "--color-by", "speed", "contacts", "group", "unbalance")
        else:
            self.options += ["--frames", "none"]
        signal_after = self.between(0.02, 0.6) if self.chance(0.1) else None
        return [name] + self.options, signal_after


def limit_processor():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def fill(program, arguments, folder, signal_after=None):
    """Returns the exit code, the messages and the summary, if there is one."""
    command = [program, "fill", *arguments, "--quiet", "--overwrite", "--out", str(folder)]
    with tempfile.TemporaryFile() as messages:
        child = subprocess.Popen(command, stdout=messages, stderr=messages,
                                 preexec_fn=limit_processor)
        try:
            if signal_after is not None:
                time.sleep(signal_after)
                child.send_signal(signal.SIGTERM)
            code = child.wait(timeout=WALL_SECONDS)
        except subprocess.TimeoutExpired:
            child.kill()
            code = child.wait()
        messages.seek(0)
        text = messages.read().decode(errors="replace").strip()
    path = folder / "summary.json"
    summary = json.loads(path.read_text()) if code in DOCUMENTED and path.exists() else None
    return code, text, summary


def not_finite(folder):
    """Numbers of the tables that are not finite; times of sets that took no time have none."""
    rows = (folder / "spheres.csv").read_text().splitlines()[1:]
    values = [value for row in rows for value in row.split(",")]
    return sum(1 for value in values if value in ("nan", "-nan", "inf", "-inf"))


def faults_of(program, arguments, signal_after, folder):
    """What is wrong with a scene, and its exit code."""
    code, text, summary = fill(program, arguments + ["--set", "threads=1"], folder, signal_after)
    if code == -signal.SIGXCPU or code == -signal.SIGKILL:
        return [f"does not end within {PROCESSOR_SECONDS} s of processor time"], code
    if code not in DOCUMENTED:
        return [f"ends with {code}, which is not documented: {text[-300:]}"], code
    if code == STOPPED and signal_after is None:
        return [f"is stopped without a signal: {text[-300:]}"], code
    if code not in FILLED:
        return [] if text or code == STOPPED else ["ends without a sentence"], code
    faults = []
    error = summary["error"]
    for key in ("centres_outside", "not_finite"):
        if error[key] != 0:
            faults.append(f"{key}: {error[key]}")
    if summary["scene"]["preset"] == "fast":
        for key in ("max_overlap_over_radius", "max_wall_overlap_over_radius"):
            if not error[key] <= OVERLAP:
                faults.append(f"{key}: {error[key]}")
    if count := not_finite(folder):
        faults.append(f"{count} values in spheres.csv are not finite")
    again, text, other = fill(program, arguments + ["--set", "threads=3"], folder)
    if again != code:
        faults.append(f"ends with {code} on one thread and {again} on three: {text[-300:]}")
    elif summary["state_hash"] != other["state_hash"]:
        faults.append("has another state with three threads")
    return faults, code


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--scenes", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="this scene alone")
    asked = parser.parse_args()
    program = os.path.abspath(asked.program)
    codes = collections.Counter()
    failed = 0
    for k in [asked.only] if asked.only is not None else range(asked.scenes):
        arguments, signal_after = Draw(f"{asked.seed} {k}").scene()
        with tempfile.TemporaryDirectory() as folder:
            faults, code = faults_of(program, arguments, signal_after, pathlib.Path(folder) / "run")
        codes[code] += 1
        failed += 1 if faults else 0
        for fault in faults:
            print(f"scene {k} {fault}\n    frostfill fill {' '.join(arguments)}", flush=True)
        if asked.only is not None:
            print(f"exit code {code}: frostfill fill {' '.join(arguments)}")
    print("exit codes:", ", ".join(f"{code}: {count}" for code, count in sorted(codes.items())))
    print(f"{failed} scenes failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
