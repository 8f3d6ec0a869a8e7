# SPDX-License-Identifier: MIT
"""LAMMPS: with_lammps.py FOLDER lammps-dump. It reads a frame into the spheres of lammps.data, runs 0
steps and writes a dump of its own, which is read back."""
import subprocess
import sys

from oracle import Oracle

run = Oracle(sys.argv[1])
DUMP = """
dump own all custom 1 {out} id type x y z radius
dump_modify own sort id format float %.17g
run 0 post no
"""
SCRIPT = """
units si
atom_style sphere
boundary f f f
read_data {data}
comm_modify cutoff 1
neigh_modify every 1
{read}
pair_style none
fix move all nve/sphere
timestep 1e-9
""" + DUMP


def ask(read, out):
    text = SCRIPT.format(data=run.file("lammps.data"), read=read, out=out)
    script = run.folder / "in.lammps"
    script.write_text(text)
    done = subprocess.run(["lmp", "-in", str(script), "-log", "none", "-echo", "none"],
                          cwd=run.folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout[-2000:], done.stderr[-1000:])
        raise SystemExit(1)
    lines = out.read_text().splitlines()
    return [list(map(float, line.split())) for line in lines[9:]]


OUT = run.folder / "lammps.out"
frame = run.frames[len(run.frames) // 2]
rows = ask(f"read_dump {run.file('spheres.dump')} {frame['number']} x y z box yes trim yes", OUT)
count = len(frame["radii"])
run.same("ids", [row[0] - 1 for row in rows], frame["ids"])
run.same("radii", [row[5] for row in rows], frame["radii"], 1e-15)
# LAMMPS shifts what lies on the border of its box by rounding.
run.same("centres", [row[2:5] for row in rows], frame["centres"], 1e-12)
run.finish()
