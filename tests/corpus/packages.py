# SPDX-License-Identifier: MIT
"""Meshes that Debian packages ship, and whether they have an interior.

A mesh is read here by a reader of its own, and its winding number is taken at points at random:

- closed after welding, with a volume: it has an interior and must fill;
- a whole number at 95 of 100 points, and not 0 at some: the same, with small faults;
- above 1/2 at 2 of 100 points: open; it needs a lid or a skin;
- else: a sheet, or no mesh; to refuse it is right.

packages.txt overrules this, with a reason for each line. `any` stands for both: to fill and to
refuse is right there."""

import fnmatch
import gzip
import hashlib
import json
import pathlib
import struct
import subprocess
import tarfile

EXTENSIONS = (".obj", ".stl", ".ply", ".off", ".gltf", ".glb")
PACKAGES = ("assimp-testmodels", "libcgal-demo", "openscad-testing-data", "geomview",
            "glmark2-data", "gmsh-doc")
SAMPLES = 400


def files_of(package):
    """Paths of a package's files, or None if it is not installed."""
    try:
        done = subprocess.run(["dpkg", "-L", package], capture_output=True, text=True)
    except FileNotFoundError:
        return None
    return done.stdout.splitlines() if done.returncode == 0 else None


def fetch(package, folder):
    """Copies a package's meshes, those in archives too; paths below `folder`, or the reason why
    there are none."""
    files = files_of(package)
    if files is None:
        return [], f"{package} is not installed"
    found = []

    def keep(name, data):
        target = folder / package / name.lstrip("/")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
        found.append(target)

    for name in sorted(files):
        lower, path = name.lower(), pathlib.Path(name)
        if not path.is_file():
            continue
        if lower.endswith(EXTENSIONS) or lower.endswith(".bin"):
            keep(path.name if package != "assimp-testmodels" else name.split("/models/")[-1],
                 path.read_bytes())
        elif lower.endswith(".gz") and lower[:-3].endswith(EXTENSIONS):
            keep(path.name[:-3], gzip.decompress(path.read_bytes()))
        elif lower.endswith("data.tar.gz"):
            with tarfile.open(path) as archive:
                for member in sorted(archive.getmembers(), key=lambda m: m.name):
                    if member.isfile() and member.name.lower().endswith(EXTENSIONS):
                        keep(member.name, archive.extractfile(member).read())
    found = [f for f in found if f.suffix.lower() in EXTENSIONS]
    return found, "" if found else f"{package} has no meshes"


def overrides(path):
    """Lines `pattern expected reason`; the first pattern that fits counts."""
    rules = []
    for line in path.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            pattern, expected, reason = line.split(None, 2)
            rules.append((pattern, expected, reason))
    return rules


def read_triangles(path):
    """n x 3 x 3 coordinates, or None for what this simple reader does not know."""
    import numpy as np
    data, kind = path.read_bytes(), path.suffix.lower()
    vertices, faces = [], []
    if kind == ".stl":
        count = struct.unpack("<I", data[80:84])[0] if len(data) >= 84 else 0
        if len(data) == 84 + 50 * count and count:
            records = np.frombuffer(data, np.dtype([("n", "<3f4"), ("v", "<f4", (3, 3)),
                                                    ("a", "<u2")]), count, 84)
            return records["v"].astype(float)
        words = [line.split() for line in data.decode("latin-1").splitlines()]
        corners = [[float(c) for c in w[1:4]] for w in words if w and w[0].lower() == "vertex"]
        return np.array(corners).reshape(-1, 3, 3)
    if kind == ".obj":
        for line in data.decode("latin-1").replace("\\\n", " ").splitlines():
            words = line.split()
            if words and words[0] == "v":
                vertices.append([float(c) for c in words[1:4]])
            elif words and words[0] == "f":
                index = [int(w.split("/")[0]) for w in words[1:]]
                faces.append([i - 1 if i > 0 else len(vertices) + i for i in index])
    elif kind == ".off":
        words = " ".join(line.partition("#")[0]
                         for line in data.decode("latin-1").splitlines()).split()
        if not words or words[0] not in ("OFF", "COFF", "NOFF"):
            return None
        lines = [line.partition("#")[0].split() for line in data.decode("latin-1").splitlines()]
        lines = [line for line in lines if line]
        lines[0] = lines[0][1:]
        lines = lines if lines[0] else lines[1:]
        count, polygons = int(lines[0][0]), int(lines[0][1])
        vertices = [[float(c) for c in line[:3]] for line in lines[1:1 + count]]
        for line in lines[1 + count:1 + count + polygons]:
            faces.append([int(w) for w in line[1:1 + int(line[0])]])
    elif kind == ".ply" and b"element face" not in data[:4000]:
        return np.zeros((0, 3, 3))
    elif kind == ".ply" and b"format ascii" in data[:200]:
        head, _, body = data.partition(b"end_header")
        elements = [line.split() for line in head.decode("latin-1").splitlines()]
        rows = iter(body.decode("latin-1").split("\n")[1:])
        for element in (e for e in elements if e and e[0] == "element"):
            for _ in range(int(element[2])):
                words = next(rows).split()
                if element[1] == "vertex":
                    vertices.append([float(c) for c in words[:3]])
                elif element[1] == "face":
                    faces.append([int(w) for w in words[1:1 + int(words[0])]])
    else:
        return None
    points = np.array(vertices, float).reshape(-1, 3)
    fans = [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]
    return points[np.array(fans, int).reshape(-1, 3)]


def judge(path):
    """(expected, why) of a mesh by its geometry."""
    try:
        import numpy as np
        import check_packing
    except ImportError:
        return "any", "numpy is missing"
    try:
        triangles = read_triangles(path)
    except (ValueError, IndexError, StopIteration, UnicodeDecodeError, struct.error) as error:
        return "refuse", f"cannot be read: {type(error).__name__}"
    if triangles is None:
        return "any", "no reader here for this format"
    if len(triangles) < 4:
        return "refuse", f"{len(triangles)} triangles"
    if not np.isfinite(triangles).all():
        return "refuse", "coordinates that are not finite"
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    size = float((high - low).max())
    if size == 0:
        return "refuse", "no extent"
    keys = np.round((triangles.reshape(-1, 3) - low) / (size * 1e-6)).astype(np.int64)
    _, welded = np.unique(keys, axis=0, return_inverse=True)
    faces = welded.reshape(-1, 3)
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    faces = faces[whole]
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    _, uses = np.unique(edges, axis=0, return_counts=True)
    a, b, c = ((triangles[whole] - low)[:, k] for k in range(3))
    volume = float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6
    if len(faces) and (uses == 2).all() and abs(volume) > 1e-9 * size ** 3:
        return "fill", "closed after welding"
    rng = np.random.default_rng(1)
    points = low + rng.random((SAMPLES, 3)) * (high - low)
    winding = check_packing.winding_numbers(points, triangles)
    near = np.abs(winding - np.round(winding)) < 0.01
    some = near & (np.abs(np.round(winding)) >= 1)
    if near.mean() >= 0.95 and some.mean() > 0.005:
        return "fill", f"winding number whole at {near.mean():.0%} of points"
    share = float((np.abs(winding) > 0.5).mean())
    if share >= 0.02:
        return "open", f"winding number above 1/2 at {share:.0%}, whole at {near.mean():.0%}"
    return "refuse", f"a sheet: winding number above 1/2 at {share:.1%}"


def collect(folder, rules, keep=False):
    """Records of all meshes of packages, and what was skipped, with the reason. With `keep` those
    that are known from an earlier call are not judged again."""
    file = folder / "packages.json"
    known = json.loads(file.read_text()) if keep and file.exists() else []
    earlier = {r["name"]: (r["judged"], r["judgement"]) for r in known if "judged" in r}
    rule_itself = pathlib.Path(__file__).read_bytes()
    records, skipped = [], []
    for package in PACKAGES:
        files, reason = fetch(package, folder)
        if reason:
            skipped.append(reason)
        for path in files:
            name = str(path.relative_to(folder))
            record = {"file": str(path), "name": name, "kind": package}
            rule = next((r for r in rules if fnmatch.fnmatch(name, r[0])), None)
            if rule:
                record["expected"], record["note"] = rule[1:]
            else:
                mark = hashlib.sha256(path.read_bytes() + rule_itself).hexdigest()
                if earlier.get(name, ("",))[0] == mark:
                    judgement = earlier[name][1]
                else:
                    judgement = list(judge(path))
                record["judged"], record["judgement"] = mark, judgement
                record["expected"], record["note"] = judgement
            records.append(record)
    file.write_text(json.dumps(records, indent=1) + "\n")
    return records, skipped
