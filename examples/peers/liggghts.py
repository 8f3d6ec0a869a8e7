#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""LIGGGHTS, soft spheres by Hertz's law, as an engine of `frostfill-lab peers` and `frostfill-lab rest`.

    apt-get install liggghts
    frostfill-lab peers --peer LIGGGHTS=examples/peers/liggghts.py

LIGGGHTS reads its commands from a pipe: a step of the protocol is as many steps of its own as its contacts
need. The environment variable STIFFNESS is Young's modulus in units of density times g r (4.5e4).
"""

import math
import os
import subprocess
import sys
import tempfile
import threading

POISSON = 0.3
LEAST_RESTITUTION = 0.051  # that LIGGGHTS takes
SHARE_OF_RAYLEIGH = 0.2  # as its own manual advises
STIFFNESS = float(os.environ.get("STIFFNESS", 4.5e4))

SETUP = """atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
soft_particles yes
region all block {low[0]} {high[0]} {low[1]} {high[1]} {low[2]} {high[2]} units box
create_box 1 all
neighbor 0.4 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {stiffness}
fix m2 all property/global poissonsRatio peratomtype {poisson}
fix m3 all property/global coefficientRestitution peratomtypepair 1 {restitution}
fix m4 all property/global coefficientFriction peratomtypepair 1 {friction}
pair_style gran model hertz tangential {tangential}
pair_coeff * *
timestep {step}
fix pull all gravity 1 vector 0 -1 0
fix object all mesh/surface file {stl} type 1
fix walls all wall/gran model hertz tangential {tangential} mesh n_meshes 1 meshes object
fix motion all nve/sphere
thermo_modify norm no lost ignore
"""


def read_task():
    """What stands before `start`, by its word."""
    task = {}
    for line in iter(sys.stdin.readline, ""):
        word, *rest = line.split()
        if word == "start":
            return task
        if word in ("vertices", "triangles"):
            task[word] = [[float(x) for x in sys.stdin.readline().split()] for _ in range(int(rest[0]))]
        else:
            task[word] = float(rest[0])
    sys.exit(1)


def write_stl(path, vertices, triangles):
    with open(path, "w", encoding="ascii") as file:
        file.write("solid object\n")
        for triangle in triangles:
            file.write("facet normal 0 0 0\nouter loop\n")
            for corner in triangle:
                file.write("vertex {:.9g} {:.9g} {:.9g}\n".format(*vertices[int(corner)]))
            file.write("endloop\nendfacet\n")
        file.write("endsolid object\n")


class Liggghts:
    def __init__(self, task, folder):
        self.folder = folder
        self.count = 0
        shear = STIFFNESS / (2 * (1 + POISSON))
        rayleigh = math.pi * math.sqrt(1 / shear) / (0.1631 * POISSON + 0.8766)
        self.steps = math.ceil(task["step"] / (SHARE_OF_RAYLEIGH * rayleigh))
        self.pending = 0
        write_stl(f"{folder}/object.stl", task["vertices"], task["triangles"])
        # Without a log or a screen it crashes at the mesh.
        self.program = subprocess.Popen(["liggghts", "-log", os.devnull], cwd=folder, text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        threading.Thread(target=self.watch, daemon=True).start()
        columns = list(zip(*task["vertices"]))
        self.say(SETUP.format(
            low=[min(column) - 2 for column in columns], high=[max(column) + 2 for column in columns],
            stiffness=STIFFNESS, poisson=POISSON, friction=task["friction"],
            restitution=max(task["restitution"], LEAST_RESTITUTION),
            tangential="history" if task["friction"] > 0 else "off", step=task["step"] / self.steps,
            stl="object.stl"))

    def watch(self):
        """Without LIGGGHTS there is nothing to wait for."""
        if self.program.wait() != 0:
            os.write(2, b"LIGGGHTS has failed\n")
            os._exit(1)

    def say(self, text):
        self.program.stdin.write(text)

    def run(self):
        if self.pending:
            self.say(f"run {self.pending * self.steps}\n")
            self.pending = 0

    def add(self, place):
        self.run()
        self.count += 1
        self.say("create_atoms 1 single {} {} {} units box\n".format(*place))
        self.say(f"group new id {self.count}\nset group new diameter 2 density 1\ngroup new delete\n")

    def places(self):
        """Asked of LIGGGHTS by a pipe that it opens as a file."""
        if not self.count:
            return []
        self.run()
        path = f"{self.folder}/places.txt"
        os.mkfifo(path)
        self.say("dump last all custom 1 places.txt id x y z\n"
                 'dump_modify last sort id format "%d %.17g %.17g %.17g"\nrun 0\nundump last\n')
        self.program.stdin.flush()
        with open(path, encoding="ascii") as file:
            lines = file.read().splitlines()
        os.remove(path)
        return [line.split()[1:] for line in lines[lines.index(next(
            line for line in lines if line.startswith("ITEM: ATOMS"))) + 1:]]


def main():
    task = read_task()
    with tempfile.TemporaryDirectory() as folder:
        engine = Liggghts(task, folder)
        print("ready", flush=True)
        for line in iter(sys.stdin.readline, ""):
            word, *numbers = line.split()
            if word == "add":
                engine.add(numbers)
            elif word == "step":
                engine.pending += 1
            elif word == "places":
                places = engine.places()
                print(f"places {len(places)}", *(" ".join(place) for place in places), sep="\n", flush=True)
            elif word == "end":
                break
        engine.program.stdin.close()
        engine.program.wait()


if __name__ == "__main__":
    main()
