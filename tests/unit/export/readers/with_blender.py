# SPDX-License-Identifier: MIT
"""Blender: blender -b --factory-startup --python with_blender.py -- FOLDER glb"""
import pathlib
import sys

import bpy
import numpy

numpy.bool = bool  # the importer of Debian 12's Blender asks for this name, which NumPy 1.24 has dropped

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from oracle import Oracle  # noqa: E402

run = Oracle(sys.argv[sys.argv.index("--") + 1])
try:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = 1000  # the reader takes times to frames with it
    bpy.ops.import_scene.gltf(filepath=str(run.file("run.glb")))
    balls = sorted((o for o in bpy.data.objects if o.name.startswith("sphere ")),
                   key=lambda o: int(o.name.split()[1]))
    last = run.frames[-1]
    run.same("objects", len(balls), len(last["radii"]))
    # In Blender z points up, where it is y in the torus.
    for k in (0, len(run.frames) // 2, -1):
        frame = run.frames[k]
        time = 1000 * (frame["time"] - run.frames[0]["time"])
        bpy.context.scene.frame_set(int(time), subframe=time - int(time))
        places = [ball.matrix_world.translation for ball in balls]
        lows = [min(v[i] for v in run.vertices) for i in range(3)]
        highs = [max(v[i] for v in run.vertices) for i in range(3)]
        middle = [(a + b) / 2 for a, b in zip(lows, highs)]
        count = len(frame["radii"])
        found = [[p[0] + middle[0], p[2] + middle[1], -p[1] + middle[2]] for p in places[:count]]
        run.same(f"Blender, frame {k}, centres", found, frame["centres"], 2e-5)
        sizes = [ball.matrix_world.to_scale()[0] for ball in balls]
        run.same(f"Blender, frame {k}, radii", sizes,
                 frame["radii"] + [0.0] * (len(balls) - count), 1e-5)
    run.finish()
except SystemExit:
    raise
except Exception as error:  # Blender would end with 0
    print(error)
    raise SystemExit(1)
