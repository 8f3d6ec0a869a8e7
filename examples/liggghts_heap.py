# SPDX-License-Identifier: MIT
# %% [markdown]
# # The angle of repose, beside LIGGGHTS
#
# Grains come through an inlet above a smooth floor and form a heap. LIGGGHTS pours as many through the same inlet,
# as fast as there is room in it, and both heaps are measured by the same rule.
#
# As a program, it writes its files into the folder that is given; behind it you may say friction, rolling friction
# and how many seeds: `scripts/python examples/liggghts_heap.py heaps 0.6 0.3 3`. It needs Debian's package liggghts.
# One heap takes each program about ten seconds.

# %%
import subprocess
import sys
from pathlib import Path

import frostfill
import numpy as np

words = [word for word in sys.argv[1:] if not word.startswith("-")]
folder = Path(words[0] if words else "heaps")
FRICTION = float(words[1]) if len(words) > 1 else 0.6
ROLLING = float(words[2]) if len(words) > 2 else 0.3
SEEDS = int(words[3]) if len(words) > 3 else 1

# %% [markdown]
# ## The heap of Frostfill
#
# The cube reaches from -1 to 1. The inlet is 28 radii above its floor and 6 radii wide.

# %%
COUNT, RADIUS, HEIGHT, OPENING = 1500, 0.025, -0.3, 0.15


def pour_here(seed):
    return frostfill.fill("cube", radius=RADIUS, count=COUNT, inlet=f"0,{HEIGHT},0,{OPENING}", motion="granular",
                          rest="joint", friction=FRICTION, rest_rolling_friction=ROLLING, seed=seed)


# %% [markdown]
# ## That of LIGGGHTS
#
# In units of radius, gravity and density. Contacts are Hertz's; rolling friction is `epsd2`, whose moment has the
# same limit as ours: rolling friction times normal force times reduced radius. Collisions keep a third of their
# speed, as they do here. Under the heap grains sink into one another by less than a hundredth of a radius.

# %%
YOUNG, POISSON, RESTITUTION = 1e5, 0.3, 0.34
SCRIPT = """atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
soft_particles yes
hard_particles yes
region all block -{w1} {w1} -{w1} {w1} -{w1} {w1} units box
create_box 1 all
neighbor 0.4 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {young}
fix m2 all property/global poissonsRatio peratomtype {poisson}
fix m3 all property/global coefficientRestitution peratomtypepair 1 {restitution}
fix m4 all property/global coefficientFriction peratomtypepair 1 {friction}
fix m5 all property/global coefficientRollingFriction peratomtypepair 1 {rolling}
pair_style gran model hertz tangential history rolling_friction epsd2
pair_coeff * *
timestep {step}
fix pull all gravity 1 vector 0 -1 0
fix w1 all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 xplane -{w}
fix w2 all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 xplane {w}
fix w3 all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 yplane -{w}
fix w4 all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 zplane -{w}
fix w5 all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 zplane {w}
region inlet cylinder y 0 0 {opening} {low} {high} units box
fix kind all particletemplate/sphere {seed[0]} atom_type 1 density constant 1 radius constant 1
fix kinds all particledistribution/discrete {seed[1]} 1 kind 1.0
fix pour all insert/pack seed {seed[2]} distributiontemplate kinds maxattempt 50 insert_every {pour} &
    overlapcheck yes all_in no vel constant 0 0 0 region inlet particles_in_region 40
fix motion all nve/sphere
variable calm atom "sqrt(vx*vx+vy*vy+vz*vz) < 0.01"
compute share all reduce ave v_calm
thermo_style custom step atoms c_share
thermo {window}
thermo_modify norm no lost ignore
variable present equal atoms
variable pouring loop 10000
label pour
run {pour} pre no post no
if "${{present}} >= {count}" then "jump heap.in poured"
next pouring
jump heap.in pour
label poured
unfix pour
group surplus id > {count}
delete_atoms group surplus compress no
run {fall}
variable windows loop 400
label next
run {window}
variable now equal c_share
if "${{now}} >= 0.99" then "jump heap.in over"
next windows
jump heap.in next
label over
dump last all custom 1 places.txt id x y z
dump_modify last sort id format "%d %.9g %.9g %.9g"
run 0
"""
PRIMES = [15485863, 15485867, 32452843, 49979687, 67867967, 86028121, 104395301, 122949823]  # its seeds have to be


def pour_there(seed):
    """Centres, in radii."""
    there = folder / f"liggghts-{seed}"
    there.mkdir(parents=True, exist_ok=True)
    rayleigh = np.pi * np.sqrt(2 * (1 + POISSON) / YOUNG) / (0.1631 * POISSON + 0.8766)
    step = 0.2 * rayleigh
    (there / "heap.in").write_text(SCRIPT.format(
        w=1 / RADIUS, w1=1 / RADIUS + 1, young=YOUNG, poisson=POISSON, restitution=RESTITUTION, friction=FRICTION,
        rolling=ROLLING, step=step, opening=OPENING / RADIUS - 1, low=HEIGHT / RADIUS - 0.01,
        high=HEIGHT / RADIUS + 0.01, seed=[PRIMES[(seed + k) % len(PRIMES)] for k in range(3)],
        pour=int(0.1 / step) + 1, window=int(1 / step) + 1, fall=int(np.sqrt(2 / RADIUS) / step), count=COUNT))
    subprocess.run(["liggghts", "-in", "heap.in", "-log", "none"], cwd=there, check=True, stdout=subprocess.DEVNULL)
    rows = (there / "places.txt").read_text().split("ITEM: ATOMS")[1].splitlines()[1:]
    return np.array([row.split() for row in rows], float)[:, 1:4]


# %% [markdown]
# ## The slope
#
# Rings two radii wide are cut into 16 sectors. The height of a ring is the mean of the highest points in its
# sectors, and the slope that of the line through the rings between a fifth and four fifths of the heap's radius,
# within which 95 % of the grains lie. It is the rule of `error.heaps` in `summary.json`.

# %%
SECTORS = 16


def slope_of(centres):
    """In degrees, of centres in radii about the vertical axis."""
    across = np.hypot(centres[:, 0], centres[:, 2])
    sector = ((np.arctan2(centres[:, 2], centres[:, 0]) / (2 * np.pi) + 0.5) * SECTORS).astype(int) % SECTORS
    ring = (across / 2).astype(int)
    foot = np.percentile(across, 95)
    points = []
    for k in range(int(0.4 * foot) + 1):
        tops = [centres[here, 1].max() for s in range(SECTORS) if (here := (ring == k) & (sector == s)).any()]
        if 2 * len(tops) >= SECTORS and 0.2 * foot <= 2 * k + 1 <= 0.8 * foot:
            points.append((2 * k + 1, np.mean(tops)))
    return -np.degrees(np.arctan(np.polyfit(*np.array(points).T, 1)[0]))


# %%
ours, theirs, known = [], [], []
for seed in range(1, SEEDS + 1):
    run = pour_here(seed)
    ours.append(slope_of(run.centres / RADIUS))
    known.append(run.summary["error"]["heaps"][0]["slope_degree"])
    theirs.append(slope_of(pour_there(seed)))
    print(f"friction {FRICTION}, rolling friction {ROLLING}, seed {seed}: {ours[-1]:.1f} degrees, "
          f"LIGGGHTS {theirs[-1]:.1f}", flush=True)
if SEEDS > 1:
    print(f"mean {np.mean(ours):.1f}, LIGGGHTS {np.mean(theirs):.1f}")
