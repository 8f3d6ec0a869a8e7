# SPDX-License-Identifier: MIT
"""Writes meshes as files: STL, OBJ, PLY, OFF and glTF, and the variants that programs make of them."""

import base64
import json
import math
import struct


def number(x):
    if math.isnan(x):
        return "nan"
    if math.isinf(x):
        return "inf" if x > 0 else "-inf"
    return repr(x)


def normal_of(corners):
    u = [b - a for a, b in zip(corners[0], corners[1])]
    v = [b - a for a, b in zip(corners[0], corners[2])]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.sqrt(sum(c * c for c in n))
    return tuple(c / length for c in n) if length > 0 else (0.0, 0.0, 0.0)


def stl_binary(mesh, header=b"", count=None):
    out = [header[:80].ljust(80, b"\0"),
           struct.pack("<I", len(mesh.faces) if count is None else count)]
    for f in mesh.faces:
        corners = [mesh.vertices[i] for i in f]
        out.append(struct.pack("<12fH", *normal_of(corners), *(c for p in corners for c in p), 0))
    return b"".join(out)


def stl_ascii(mesh, name="part", end="\n", solids=1, upper=False):
    lines = []
    share = -(-len(mesh.faces) // solids)
    for s in range(solids):
        lines.append(f"solid {name}")
        for f in mesh.faces[s * share:(s + 1) * share]:
            corners = [mesh.vertices[i] for i in f]
            lines.append("  facet normal " + " ".join(f"{c:.6g}" for c in normal_of(corners)))
            lines.append("    outer loop")
            lines += ["      vertex " + " ".join(map(number, p)) for p in corners]
            lines += ["    endloop", "  endfacet"]
        lines.append(f"endsolid {name}")
    text = end.join(lines) + end
    return (text.upper() if upper else text).encode()


def obj(mesh, end="\n", faces=None, style="{0}", relative=False, before="", after="", groups=0,
        encoding="utf-8"):
    """`faces`: polygons in place of the triangles. `style`: a corner; {0} is its index."""
    lines = [before] if before else []
    lines += ["v " + " ".join(map(number, p)) for p in mesh.vertices]
    if "/" in style:
        lines += ["vt 0.5 0.5", "vn 0 1 0"]
    for k, f in enumerate(faces if faces is not None else mesh.faces):
        if groups and k % groups == 0:
            lines += [f"g part{k}", "usemtl none", "s off"]
        lines.append("f " + " ".join(
            style.format(i - len(mesh.vertices) if relative else i + 1) for i in f))
    if after:
        lines.append(after)
    return (end.join(lines) + end).encode(encoding)


def off(mesh, faces=None, header="OFF", comments=False, colours=False, edges=0, end="\n"):
    faces = mesh.faces if faces is None else faces
    lines = [header] if header else []
    if comments:
        lines += ["# a comment", ""]
    lines.append(f"{len(mesh.vertices)} {len(faces)} {edges}")
    lines += [" ".join(map(number, p)) for p in mesh.vertices]
    if comments:
        lines += ["", "# the faces"]
    lines += [f"{len(f)} " + " ".join(map(str, f)) + (" 0.5 0.5 0.5" if colours else "")
              for f in faces]
    return (end.join(lines) + end).encode()


def ply(mesh, form="ascii", coordinate="float", faces=None, strips=None, list_name="vertex_indices",
        index="int", count="uchar", extra=False, end="\n", comment=""):
    """`strips`: triangle strips in place of faces, each ended by -1, all in one list."""
    faces = mesh.faces if faces is None else faces
    header = ["ply", f"format {form} 1.0"]
    if comment:
        header.append("comment " + comment)
    header.append(f"element vertex {len(mesh.vertices)}")
    header += [f"property {coordinate} {axis}" for axis in "xyz"]
    if extra:
        header += ["property uchar red", "property float quality"]
    if strips is None:
        header.append(f"element face {len(faces)}")
        header.append(f"property list {count} {index} {list_name}")
        if extra:
            header.append("property uchar flags")
    else:
        header += ["element tristrips 1", f"property list int {index} vertex_indices"]
    header.append("end_header")
    head = (end.join(header) + end).encode()
    lists = faces if strips is None else [[i for s in strips for i in [*s, -1]]]
    if form == "ascii":
        lines = [" ".join(map(number, p)) + (" 255 0.5" if extra else "") for p in mesh.vertices]
        lines += [f"{len(f)} " + " ".join(map(str, f)) + (" 0" if extra and strips is None else "")
                  for f in lists]
        return head + (end.join(lines) + end).encode()
    order = "<" if "little" in form else ">"
    code = {"float": "f", "double": "d", "int": "i", "uint": "I", "uchar": "B", "ushort": "H",
            "short": "h", "float32": "f", "int32": "i", "uint8": "B"}
    out = [head]
    for p in mesh.vertices:
        out.append(struct.pack(order + 3 * code[coordinate], *p))
        if extra:
            out.append(struct.pack(order + "Bf", 255, 0.5))
    for f in lists:
        out.append(struct.pack(order + ("i" if strips is not None else code[count]), len(f)))
        out.append(struct.pack(order + len(f) * code[index], *f))
        if extra and strips is None:
            out.append(struct.pack(order + "B", 0))
    return b"".join(out)


class Gltf:
    """A scene of glTF 2.0 in one file: meshes, and nodes that place them."""

    def __init__(self):
        self.buffer = b""
        self.document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}],
                         "nodes": [], "meshes": [], "accessors": [], "bufferViews": [],
                         "buffers": []}

    def view(self, data, target):
        self.buffer += b"\0" * (-len(self.buffer) % 4)
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.buffer),
                                             "byteLength": len(data), "target": target})
        self.buffer += data
        return len(self.document["bufferViews"]) - 1

    def accessor(self, **given):
        self.document["accessors"].append(given)
        return len(self.document["accessors"]) - 1

    def mesh(self, *parts, short=False, indexed=True):
        """A mesh of one primitive for each part; its number."""
        primitives = []
        for part in parts:
            if not indexed:
                part = part.soup()
            data = b"".join(struct.pack("<3f", *p) for p in part.vertices)
            columns = list(zip(*part.vertices))
            primitive = {"attributes": {"POSITION": self.accessor(
                bufferView=self.view(data, 34962), componentType=5126, type="VEC3",
                count=len(part.vertices), min=[min(c) for c in columns],
                max=[max(c) for c in columns])}, "mode": 4}
            if indexed:
                flat = [i for f in part.faces for i in f]
                data = struct.pack(f"<{len(flat)}{'H' if short else 'I'}", *flat)
                primitive["indices"] = self.accessor(
                    bufferView=self.view(data, 34963), componentType=5123 if short else 5125,
                    type="SCALAR", count=len(flat))
            primitives.append(primitive)
        self.document["meshes"].append({"primitives": primitives})
        return len(self.document["meshes"]) - 1

    def node(self, root=True, **given):
        self.document["nodes"].append(given)
        number_ = len(self.document["nodes"]) - 1
        if root:
            self.document["scenes"][0]["nodes"].append(number_)
        return number_

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.buffer).decode()
        self.document["buffers"] = [{"byteLength": len(self.buffer), "uri": uri}]
        return json.dumps(self.document).encode()

    def binary(self):
        self.document["buffers"] = [{"byteLength": len(self.buffer)}]
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        data = self.buffer + b"\0" * (-len(self.buffer) % 4)
        chunks = (struct.pack("<II", len(text), 0x4E4F534A) + text
                  + struct.pack("<II", len(data), 0x004E4942) + data)
        return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks
