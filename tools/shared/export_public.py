#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Makes an object file export what the public headers declare, and nothing else.

    export_public.py OBJECT MAP NODE HEADER...

The sources are compiled with hidden names, once, for the program, the static libraries and the shared
one. A linker cannot export a hidden name, so this clears the mark "hidden" (st_other of the ELF symbol
table, System V ABI) of each definition in OBJECT that belongs to a name which a HEADER declares in
namespace frostfill, and writes the linker's version script MAP with exactly those symbols in NODE.
"""
import re
import struct
import subprocess
import sys

HIDDEN, VISIBILITY = 2, 3
LOCAL = 0
SYMBOL_TABLE = 2


def outermost_declarations(text):
    """The declarations directly in a namespace, with bodies and comments left out."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\])*\"|^\s*#[^\n]*", " ", text, flags=re.S | re.M)
    opened, declaration = [], ""
    for part in re.split(r"([{};])", text):
        if part == "{":
            opened.append(re.match(r"\s*(inline\s+)?namespace\b", declaration) is not None)
            if all(opened):
                declaration = ""
        elif part in ("}", ";"):
            if part == "}":
                opened.pop()
            if all(opened):
                yield declaration
                declaration = ""
        elif all(opened):
            declaration += part


def public_names(headers):
    """Types and functions that are declared in the namespace, and types that only have a name there."""
    names, incomplete = set(), set()
    for header in headers:
        with open(header, encoding="utf-8") as file:
            text = file.read()
        for declaration in outermost_declarations(text):
            declaration = re.sub(r"\[\[[^\]]*\]\]|template\s*<[^<>]*>", " ", declaration)
            kind = re.match(r"\s*(?:class|struct|enum(?:\s+class)?)\s+(\w+)", declaration)
            function = re.search(r"(operator[^\w\s(]+|\w+)\s*\(", declaration)
            if kind:
                names.add(kind.group(1))
            elif function and not re.match(r"\s*using\b", declaration):
                names.add(function.group(1))
        names.update(re.findall(r"\bfriend\b[^;{]*?(operator[^\w\s(]+|\w+)\s*\(", text))
        incomplete.update(re.findall(r"^ +(?:struct|class) (\w+);", text, flags=re.M))
    return names, incomplete


def demangled(symbols):
    text = subprocess.run(["c++filt"], input="\n".join(symbols), capture_output=True, text=True, check=True)
    return text.stdout.split("\n")


def is_public(name, names, incomplete):
    found = re.match(r"(?:[a-z -]+ (?:for|to) )?frostfill::(operator[^\w\s(]+|\w+)(?:::(\w+))?", name)
    return bool(found) and found.group(1) in names and found.group(2) not in incomplete and "{lambda" not in name


def hidden_definitions(data):
    """(offset of st_other, symbol) of each hidden definition of a 64-bit little-endian object."""
    if data[:6] != b"\x7fELF\x02\x01":
        raise SystemExit("export_public.py: not a 64-bit little-endian ELF object")
    (sections,) = struct.unpack_from("<Q", data, 0x28)
    size, count = struct.unpack_from("<HH", data, 0x3A)
    if count == 0:  # more than fit into e_shnum
        (count,) = struct.unpack_from("<Q", data, sections + 0x20)
    headers = [struct.unpack_from("<IIQQQQIIQQ", data, sections + i * size) for i in range(count)]
    for _, kind, _, _, begin, length, link, _, _, each in headers:
        if kind != SYMBOL_TABLE:
            continue
        names = headers[link][4]
        for at in range(begin, begin + length, each):
            name, info, other, section = struct.unpack_from("<IBBH", data, at)
            if section != 0 and info >> 4 != LOCAL and other & VISIBILITY == HIDDEN:
                yield at + 5, data[names + name : data.index(b"\0", names + name)].decode()


def main(path, map_path, node, *headers):
    names, incomplete = public_names(headers)
    with open(path, "rb") as file:
        data = bytearray(file.read())
    found = list(hidden_definitions(data))
    exported = []
    for (at, symbol), name in zip(found, demangled([symbol for _, symbol in found])):
        if is_public(name, names, incomplete):
            data[at] &= ~VISIBILITY
            exported.append(symbol)
    if not exported:
        raise SystemExit(f"export_public.py: {path} defines nothing that the headers declare")
    with open(path, "wb") as file:
        file.write(data)
    with open(map_path, "w", encoding="utf-8") as file:
        symbols = "".join(f"        {symbol};\n" for symbol in sorted(exported))
        file.write(f"{node} {{\n    global:\n{symbols}    local:\n        *;\n}};\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
