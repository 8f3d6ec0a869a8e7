# SPDX-License-Identifier: MIT
"""Reads binary glTF 2.0 with the standard library, and asks for what the specification asks for."""
import json
import struct
from collections import Counter

WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
PATHS = {"translation": "VEC3", "rotation": "VEC4", "scale": "VEC3"}
NAMES = ["running", "frozen", "discarded"]


class Glb:
    """A binary glTF file with its accessors."""

    def __init__(self, path, oracle):
        data = path.read_bytes()
        assert struct.unpack_from("<4sII", data) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON" and size % 4 == 0
        self.json = json.loads(data[20:20 + size])
        length, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0" and length % 4 == 0 and 28 + size + length == len(data)
        self.buffer = data[28 + size:]
        self.oracle = oracle
        oracle.equal("asset", self.json["asset"]["version"], "2.0")
        buffers = self.json["buffers"]
        oracle.equal("buffers", (len(buffers), 0 <= length - buffers[0]["byteLength"] < 4), (1, True))
        end = 0
        for view in self.json["bufferViews"]:  # one behind the other
            oracle.same("view", [view["buffer"], view["byteOffset"]], [0, end])
            end += view["byteLength"]
        oracle.same("bytes of views", end, buffers[0]["byteLength"])
        for index in range(len(self.json["accessors"])):
            self.values(index)
        self.check_nodes()

    def values(self, index, kind=None):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        wide = WIDTHS[accessor["type"]]
        letter = {5126: "f", 5125: "I"}[accessor["componentType"]]
        at = view["byteOffset"] + accessor["byteOffset"]
        assert at % 4 == 0 and accessor["count"] > 0
        assert accessor["byteOffset"] + 4 * wide * accessor["count"] <= view["byteLength"]
        flat = struct.unpack_from(f"<{wide * accessor['count']}{letter}", self.buffer, at)
        rows = [flat[i:i + wide] for i in range(0, len(flat), wide)]
        for name, extreme in (("min", min), ("max", max)):
            if name in accessor:
                self.oracle.same(f"{name} of accessor {index}", accessor[name],
                                 [extreme(column) for column in zip(*rows)], 1e-6)
        if kind is not None:
            self.oracle.equal(f"accessor {index}", (accessor["type"], letter), kind)
        return rows if wide > 1 else list(flat)

    def check_nodes(self):
        """Each node is in the scene once."""
        nodes = self.json["nodes"]
        scene, = self.json["scenes"]
        self.oracle.same("scene", self.json["scene"], 0)
        below = Counter(child for node in nodes for child in node.get("children", []))
        below.update(scene["nodes"])
        self.oracle.equal("nodes", below, Counter(range(len(nodes))))
        self.root = next(node for node in nodes if node["name"] == "object")
        world = nodes[scene["nodes"][0]]
        self.oracle.equal("root", (world["name"], world["children"]), ("world", [nodes.index(self.root)]))
        self.oracle.same("up", turned(world["rotation"], (0, 1, 0)), (0, 1, 0), 1e-6)

    def check_shapes(self):
        """A ball for each state, and the mesh about its middle."""
        oracle, meshes, materials = self.oracle, self.json["meshes"], self.json["materials"]
        oracle.equal("meshes", [mesh["name"] for mesh in meshes], NAMES + ["shell"])
        oracle.equal("materials", [material["name"] for material in materials], NAMES + ["shell"])
        colours = [tuple(material["pbrMetallicRoughness"]["baseColorFactor"]) for material in materials]
        oracle.equal("colours", (len(set(colours)), all(0 <= x <= 1 for c in colours for x in c)), (4, True))
        for i, mesh in enumerate(meshes):
            part, = mesh["primitives"]
            oracle.same("material", part["material"], i)
            places = self.values(part["attributes"]["POSITION"], ("VEC3", "f"))
            corners = self.values(part["indices"], ("SCALAR", "I"))
            oracle.equal("extent", all(name in self.json["accessors"][part["attributes"]["POSITION"]]
                                       for name in ("min", "max")), True)
            self.target(part["attributes"]["POSITION"], 34962)
            self.target(part["indices"], 34963)
            if i == 3:
                oracle.same("shell", places, [[a - b for a, b in zip(v, oracle.origin)]
                                              for v in oracle.vertices], 1e-6)
                # Seen from inside alone, so that a viewer without transparency shows what it holds.
                inwards = [corner for a, b, c in oracle.triangles for corner in (a, c, b)]
                oracle.same("triangles of the shell", corners, inwards)
                oracle.equal("sides", materials[3].get("doubleSided", False), False)
                continue
            oracle.equal("normals", part["attributes"]["NORMAL"], part["attributes"]["POSITION"])
            oracle.same("radii of the ball", [sum(x * x for x in p) ** 0.5 for p in places], [1] * len(places), 1e-6)
            edges = Counter((corners[t + s], corners[t + (s + 1) % 3])
                            for t in range(0, len(corners), 3) for s in range(3))
            oracle.equal("a closed ball", all(n == 1 and (b, a) in edges for (a, b), n in edges.items()), True)
            oracle.same("vertices of a ball with these triangles", len(places), len(corners) // 6 + 2)

    def target(self, accessor, wanted):
        view = self.json["bufferViews"][self.json["accessors"][accessor]["bufferView"]]
        self.oracle.equal("target", view["target"], wanted)

    def channels(self):
        """Times, values and interpolation by node and path."""
        oracle, channels = self.oracle, {}
        animation, = self.json["animations"]
        oracle.equal("samplers", [channel["sampler"] for channel in animation["channels"]],
                     list(range(len(animation["samplers"]))))
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            key = channel["target"]["node"], channel["target"]["path"]
            times = self.values(sampler["input"], ("SCALAR", "f"))
            values = self.values(sampler["output"], (PATHS[key[1]], "f"))
            oracle.equal(f"a channel of {key}", (key in channels, len(values)), (False, len(times)))
            oracle.equal("keys ascend", all(a < b for a, b in zip(times, times[1:])), True)
            oracle.equal("extent of times", {"min", "max"} <= set(self.json["accessors"][sampler["input"]]), True)
            oracle.equal("interpolation", sampler["interpolation"] in ("LINEAR", "STEP"), True)
            channels[key] = (times, values, sampler["interpolation"])
        return channels


def turned(q, p):
    """p turned by the quaternion x, y, z, w."""
    x, y, z, w = q
    uv = (y * p[2] - z * p[1], z * p[0] - x * p[2], x * p[1] - y * p[0])
    uuv = (y * uv[2] - z * uv[1], z * uv[0] - x * uv[2], x * uv[1] - y * uv[0])
    return [p[i] + 2 * (w * uv[i] + uuv[i]) for i in range(3)]


def single(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def read_glb(oracle):
    glb = Glb(oracle.file("run.glb"), oracle)
    glb.check_shapes()
    nodes, channels, last = glb.json["nodes"], glb.channels(), oracle.frames[-1]
    spheres = len(last["ids"])
    start = oracle.frames[0]["time"]
    oracle.equal("nodes", [node["name"] for node in nodes],
                 [f"sphere {i}" for i in last["ids"]] + ["shell", "object", "world"])
    oracle.equal("below the object", glb.root["children"], list(range(spheres + 1)))
    oracle.same("shell", nodes[spheres]["mesh"], 3)
    oracle.same("keys are those of frames", sorted({time for times, _, _ in channels.values() for time in times}
                                                   - {single(frame["time"] - start) for frame in oracle.frames}), [])

    def value(node, path, time):
        if (node, path) not in channels:
            return nodes[node][path]
        times, values, interpolation = channels[node, path]
        index = max((i for i, t in enumerate(times) if t <= time), default=0)
        if interpolation == "LINEAR" and index + 1 < len(times) and time > times[index]:
            share = (time - times[index]) / (times[index + 1] - times[index])
            return [a + share * (b - a) for a, b in zip(values[index], values[index + 1])]
        return list(values[index])

    root = nodes.index(glb.root)
    for k, frame in enumerate(oracle.frames):
        time = single(frame["time"] - start)
        offset, turn = value(root, "translation", time), value(root, "rotation", time)
        count = len(frame["radii"])
        places = [[a + b + c for a, b, c in zip(turned(turn, value(i, "translation", time)), offset, oracle.origin)]
                  for i in range(count)]
        oracle.same(f"glb, frame {k}, centres", places, frame["centres"], 3e-6)
        sizes = [value(i, "scale", time) for i in range(spheres)]
        wanted = frame["radii"] + [0.0] * (spheres - count)
        oracle.same(f"glb, frame {k}, radii", sizes, [[r] * 3 for r in wanted], 1e-7)
    oracle.same("states", [node["mesh"] for node in nodes[:spheres]], last["states"])
    oracle.same("contacts", [node["extras"]["contacts"] for node in nodes[:spheres]], last["contacts"])


def read_instanced(oracle):
    glb = Glb(oracle.file("packing.glb"), oracle)
    glb.check_shapes()
    name = "EXT_mesh_gpu_instancing"
    oracle.equal("extensions", (glb.json["extensionsRequired"], glb.json["extensionsUsed"]), ([name], [name]))
    last = oracle.frames[-1]
    nodes = [node for node in glb.json["nodes"] if "extensions" in node]
    oracle.equal("states", [node["mesh"] for node in nodes], sorted(set(last["states"])))
    oracle.equal("shell", [node["mesh"] for node in glb.json["nodes"] if node["name"] == "shell"], [3])
    for node in nodes:
        fields = node["extensions"][name]["attributes"]
        oracle.equal("name", node["name"], f"spheres of state {node['mesh']}")
        ids = [i for i in last["ids"] if last["states"][i] == node["mesh"]]
        places = [[a + b + c for a, b, c in zip(turned(glb.root["rotation"], p), glb.root["translation"],
                                                oracle.origin)]
                  for p in glb.values(fields["TRANSLATION"], ("VEC3", "f"))]
        oracle.same("places", places, [last["centres"][i] for i in ids], 3e-6)
        oracle.same("sizes", glb.values(fields["SCALE"], ("VEC3", "f")), [[last["radii"][i]] * 3 for i in ids], 1e-7)
        oracle.same("contacts", glb.values(fields["_CONTACTS"], ("SCALAR", "f")), [last["contacts"][i] for i in ids])
        for attribute in set(fields) - {"TRANSLATION", "SCALE"}:
            oracle.same(attribute, len(glb.values(fields[attribute])), len(ids))
