# SPDX-License-Identifier: MIT
"""Reads a run file without Frostfill: python3 examples/read_run.py output/torus/run.frost. docs/run-file.md says what it holds."""
import collections, struct, sys, zlib
import numpy as np, zstandard

def records(data):
    """Kind, numbers of frames and unpacked bytes of each whole record."""
    assert data[:12] == b"frostrun\x02\0\0\0", "no run file of version 2"
    at = 12
    while at + 24 <= len(data):
        kind, count, size, raw, total, own = struct.unpack_from("<6I", data, at)
        body = data[at + 24:at + 24 + size]
        if zlib.crc32(data[at:at + 20]) != own or len(body) < size or zlib.crc32(body) != total: return
        yield kind, struct.unpack_from(f"<{count}I", body), zstandard.decompress(body[4 * count:], raw)
        at += 24 + size

class Reader:
    def __init__(self, data): self.data, self.at = data, 0
    def raw(self, kind, n=1):
        values = np.frombuffer(self.data, kind, n, self.at); self.at += values.nbytes
        return values
    def count(self):
        byte = self.raw("u1")[0].item(); return byte if byte < 128 else byte - 128 + 128 * self.count()
    def difference(self):
        folded = self.count(); return folded >> 1 if folded % 2 == 0 else -(folded >> 1) - 1
    def ids(self): return np.cumsum([self.count() for _ in range(self.count())], dtype=int)

def streams(data):
    r, found = Reader(data), collections.defaultdict(lambda: Reader(b""))
    sizes = [(r.raw("u1", r.count()).tobytes().decode(), r.count()) for _ in range(r.count())]
    for name, size in sizes: found[name] = Reader(r.raw("u1", size))
    return found

def frames(path):
    """Number, time, centres [n, 3], radii [n], states [n] (0 running, 1 frozen, 2 discarded, 3 waiting), columns of each frame."""
    place = step = np.zeros((0, 3), int); centres = np.zeros((0, 3)); states = radii = np.zeros(0, int)
    newest, radius, columns = np.zeros(3, int), 0, {}
    for kind, numbers, data in records(open(path, "rb").read()):
        if kind == 1: grid, *origin = struct.unpack_from("<4d", data)
        s = streams(data) if kind == 3 else None
        for number in numbers:
            if (flags := s["frames"].count()) != 2:
                time, facts = s["times"].raw("<f8")[0], [s["frames"].difference() for _ in range(6)]
                pose, n, renewed = s["poses"].raw("<f8", 12 * flags), s["changes"].count(), s["changes"].ids()
                ran = np.flatnonzero(states[:n] == 0)
                before = place, step, centres, radii, states
                place, step, centres, radii, states = (np.resize(each, (n, *each.shape[1:])) for each in before)
                for i in renewed:
                    newest, radius = newest + [s[axis].difference() for axis in "xyz"], radius + s["radius"].difference()
                    states[i], place[i], step[i], radii[i] = s["state"].count(), newest, 0, radius
                for i in s["changes"].ids(): states[i] = s["state"].count()
                moving = np.setdiff1d(np.union1d(ran, np.flatnonzero(states == 0)), renewed)
                for i in moving:
                    step[i] += [s[axis].difference() for axis in "xyz"]; place[i] += step[i]
                for i in (*renewed, *moving):
                    centres[i] = s["exact"].raw("<f8", 3) if states[i] in (1, 2) else origin + grid * place[i]
                step[states != 0], polygons = 0, s["changes"].ids()
                for stream, (name, numbers_of) in [(each, each.split(":")) for each in s if ":" in each]:
                    known = columns.get(name, np.zeros(0, numbers_of))[:n]
                    columns[name] = v = np.append(known, np.zeros(n - len(known), known.dtype))
                    for i in s[stream].ids(): v[i] = v[i] + s[stream].difference() if v.dtype == "u4" else s[stream].raw("<f4")[0]
            yield number, time, centres, radii.view(float), states, columns

if __name__ == "__main__":
    for number, time, centres, radii, states, columns in frames(sys.argv[1]):
        print(f"frame {number}, {time:.3f} s: {len(radii)} spheres, {np.isin(states, (1, 2)).sum()} at rest")
