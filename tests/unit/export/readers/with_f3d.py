# SPDX-License-Identifier: MIT
"""F3D: with_f3d.py FOLDER glb. What F3D lists is counted, and what it draws is compared with rays that
are cast here, once without the shell. F3D draws the shell opaque. The shell is seen from inside alone,
so that it does not hide the spheres."""
import json
import os
import re
import struct
import subprocess
import sys
import zlib

import numpy as np

from oracle import Oracle

WIDTH, HEIGHT, ANGLE, DISTANCE = 480, 360, 30.0, 7.5
STATES = ("running", "frozen", "discarded")


def without_shell(source, target):
    data = source.read_bytes()
    size, = struct.unpack_from("<I", data, 12)
    scene, rest = json.loads(data[20:20 + size]), data[20 + size:]
    shell = next(i for i, node in enumerate(scene["nodes"]) if node["name"] == "shell")
    for node in scene["nodes"]:
        if shell in node.get("children", []):
            node["children"].remove(shell)
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A)
    target.write_bytes(head + text + rest)


def ask(*arguments):
    """What F3D says. It has no window, so it needs a screen that is none."""
    done = subprocess.run(["xvfb-run", "-a", "f3d", "--dry-run", "--verbose", *map(str, arguments)],
                          capture_output=True, text=True, check=False, timeout=300,
                          env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"})
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout + done.stderr


def read_png(path):
    """Pixels [height, width, channels] of a PNG with 8 bits a channel."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack_from(">IIBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    channels = {2: 3, 6: 4}[colour]
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + width * channels)
    image = np.zeros((height, width * channels), int)
    for y, row in enumerate(rows.astype(int)):
        above = image[y - 1] if y else np.zeros(width * channels, int)
        for x, value in enumerate(row[1:]):
            left = image[y, x - channels] if x >= channels else 0
            corner = above[x - channels] if x >= channels else 0
            guess = left + above[x] - corner
            paeth = min((left, above[x], corner), key=lambda v: abs(guess - v))
            image[y, x] = (value + (0, left, above[x], (left + above[x]) // 2, paeth)[row[0]]) & 255
    return image.reshape(height, width, channels)


def cast(centres, radii, states):
    """The state of the sphere that each pixel shows, or -1."""
    scale = np.tan(np.radians(ANGLE / 2)) / (HEIGHT / 2)
    x = (np.arange(WIDTH) + 0.5 - WIDTH / 2) * scale
    y = (HEIGHT / 2 - np.arange(HEIGHT) - 0.5) * scale
    rays = np.stack([*np.meshgrid(x, y), -np.ones((HEIGHT, WIDTH))], -1)
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    nearest, shown = np.full((HEIGHT, WIDTH), np.inf), np.full((HEIGHT, WIDTH), -1)
    for centre, radius, state in zip(centres, radii, states):
        to = np.asarray(centre) - [0, 0, DISTANCE]
        along = rays @ to
        inside = radius**2 - (to @ to - along**2)
        depth = np.where(inside > 0, along - np.sqrt(np.maximum(inside, 0)), np.inf)
        shown = np.where(depth < nearest, state, shown)
        nearest = np.minimum(nearest, depth)
    return shown


def middle(mask):
    return [float(where.mean()) for where in np.nonzero(mask)]


run = Oracle(sys.argv[1])
last = run.frames[-1]
listed = re.findall(r"^(\w+) Primitive Geometry:\s+Number of points: (\d+)\s+Number of polygons: (\d+)",
                    ask("--no-render", run.file("run.glb")), re.M)
run.same("spheres by state", [sum(name == state for name, *_ in listed) for state in STATES],
         [last["states"].count(i) for i in range(3)])
run.same("shell", [int(number) for name, *numbers in listed if name == "shell" for number in numbers],
         [len(run.vertices), len(run.triangles)])

def draw(file):
    ask("--output", run.folder / "f3d.png", "--no-background", "--resolution", f"{WIDTH},{HEIGHT}",
        "--camera-position", f"0,0,{DISTANCE}", "--camera-focal-point", "0,0,0", "--camera-view-up", "0,1,0",
        "--camera-view-angle", ANGLE, file)
    return read_png(run.folder / "f3d.png")


without_shell(run.file("run.glb"), run.folder / "spheres.glb")
image = draw(run.folder / "spheres.glb")
with_shell = draw(run.file("run.glb"))
box = [(min(v[i] for v in run.vertices) + max(v[i] for v in run.vertices)) / 2 for i in range(3)]
wanted = cast(np.array(last["centres"]) - box, last["radii"], last["states"])
drawn = image[..., 3] > 0 if image.shape[2] == 4 else image.min(-1) < 255
# The balls have 320 triangles within the sphere, so their outlines are up to 2 % smaller.
run.same("pixels", drawn.sum() / (wanted >= 0).sum(), 1, 0.03)
run.same("middle", middle(drawn), middle(wanted >= 0), 0.5)
both = drawn & (wanted >= 0)
run.same("where pixels are drawn", both.sum() / drawn.sum(), 1, 0.005)
blue = image[..., 2] - image[..., 0] > 40  # frozen; what is discarded is grey
run.same("states", (blue == (wanted == 1))[both].mean(), 1, 0.03)
# The far wall of the near half of the torus hides what is behind it, and nothing else.
same = np.abs(with_shell[..., :3] - image[..., :3]).max(-1) < 12
run.same("spheres seen in the shell", same[both].mean(), 1, 0.3)
run.finish()
