# SPDX-License-Identifier: MIT
"""Prints frostfill/__init__.pyi from the module itself: what it has, and the options of its table.

    PYTHONPATH=build/release/python python3 python/make_stub.py > python/frostfill/__init__.pyi
"""
import inspect
import re
import sys

sys.path.pop(0)  # this folder, where the package lies without what is compiled

import frostfill  # noqa: E402
from frostfill._keywords import _annotation  # noqa: E402

HEAD = '''# SPDX-License-Identifier: MIT
# Printed by python/make_stub.py from the module; a test compares. Do not edit.
import enum
from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal, NamedTuple, TypedDict, Unpack

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str
'''

# How pybind11 names types, and what they are in a stub.
TYPES = [
    (r"\bfrostfill\._frostfill\.", ""),
    (r"\b_frostfill\.|\bfrostfill\._\w+\.", ""),
    (r"numpy\.ndarray\[numpy\.(\w+)\[3, 1\]\]", r"NDArray[numpy.\1]"),
    (r"numpy\.ndarray\[numpy\.(\w+)\]", r"NDArray[numpy.\1]"),
    (r"\bnumpy\.ndarray\b", "NDArray[Any]"),
    (r"Optional\[(\w+)\]", r"\1 | None"),
    (r"\bos\.PathLike\b|\bpathlib\.Path\b", "Path"),
    (r"\bobject\b|\bhandle\b", "Any"),
]
# Properties of arrays say their type in the first word of their help.
ARRAY = re.compile(r"(u?int\d+|float\d+) \[|(structured) array")


def stub_type(text):
    for pattern, name in TYPES:
        text = re.sub(pattern, name, text)
    return text


def of_pybind(function):
    """The signature in the first line of the help of a function in C++."""
    line = (function.__doc__ or "").split("\n")[0]
    parameters, _, result = line.partition("(")[2].rpartition(") -> ")
    parameters = re.sub(r"self: [\w.]+", "self", parameters)
    return f"({stub_type(parameters)}) -> {stub_type(result)}"


def annotated(name, annotation):
    return name if annotation is inspect.Parameter.empty else f"{name}: {stub_type(str(annotation))}"


# The classes of options by their use, each with those that it has besides its own.
USES = {"loading": ("LoadOptions", []), "judging": ("JudgeOptions", ["loading"]),
        "pictures": ("PictureOptions", []), "filling": ("FillOptions", ["judging", "pictures"])}


def options_stub(use):
    """A class with the options of a use, so that no function repeats them."""
    name, others = USES[use]
    known = {row["keyword"] for other in others for row in frostfill._frostfill.keywords(other)}
    bases = ", ".join([USES[other][0] for other in others] or ["TypedDict"])
    rows = [row for row in frostfill._frostfill.keywords(use) if row["keyword"] not in known]
    fields = "".join(f"    {row['keyword']}: {stub_type(_annotation(row))}\n" for row in rows)
    return f"class {name}({bases}, total=False):\n{fields}"


def signature_of(function):
    if not inspect.isfunction(function):
        return of_pybind(function)
    signature = inspect.signature(function)
    use = getattr(function, "use", None)
    options = {row["keyword"] for row in frostfill._frostfill.keywords(use)} if use else set()
    parts = []
    for parameter in signature.parameters.values():
        if parameter.name in options:
            continue
        if parameter.kind is parameter.KEYWORD_ONLY and "*" not in parts:
            parts.append("*")
        default = "" if parameter.default is parameter.empty else " = ..."
        parts.append(annotated(parameter.name, parameter.annotation) + default)
    parts += [f"**options: Unpack[{USES[use][0]}]"] if use else []
    result = signature.return_annotation
    returned = "None" if result is signature.empty else stub_type(str(result))
    if len(parts) > 6:
        return "(\n        " + ",\n        ".join(parts) + f",\n    ) -> {returned}"
    return f"({', '.join(parts)}) -> {returned}"


def property_type(value):
    getter = value.fget
    if inspect.isfunction(getter):
        return stub_type(getter.__annotations__.get("return", "Any"))
    array = ARRAY.match((value.__doc__ or "").strip())
    if array:
        return f"NDArray[numpy.{'void' if array.group(2) else array.group(1)}]"
    return stub_type((getter.__doc__ or "").split("\n")[0].rpartition("-> ")[2]) or "Any"


def function_stub(name, function, indent=""):
    return f"{indent}def {name}{signature_of(function)}: ...\n"


MEMBERS = ("__init__", "__iter__", "__next__", "__len__", "__getitem__")


def class_stub(name, value):
    if issubclass(value, BaseException):
        bases = ", ".join(base.__name__ for base in value.__bases__)
        code = "" if value is frostfill.Error else "    code: int\n"
        return f"class {name}({bases}):\n{code or '    ...'}"
    if issubclass(value, int):
        body = "".join(f"    {m.name} = {m.value}\n" for m in value)
        return f"class {name}(enum.IntEnum):\n{body}"
    if issubclass(value, tuple):
        body = "".join(f"    {f}: {stub_type(t if isinstance(t, str) else t.__forward_arg__)}\n"
                       for f, t in value.__annotations__.items())
        return f"class {name}(NamedTuple):\n{body}"
    base = "(NDArray[numpy.uint8])" if name == "Picture" else ""
    text = f"class {name}{base}:\n"
    members = {}
    for each in reversed(value.__mro__):
        if each.__module__.startswith("frostfill"):
            members.update(vars(each))
    for member, what in members.items():
        hidden = member.startswith("_") and member not in MEMBERS
        if hidden or member in ("draw_frame", "draw_into", "export_into", "summary_text"):
            continue
        if isinstance(what, property):
            text += f"    @property\n    def {member}(self) -> {property_type(what)}: ...\n"
        elif member == "__init__" and not inspect.isfunction(what):
            continue
        elif member == "__iter__":
            text += "    def __iter__(self) -> Iterator[Snapshot]: ...\n"
        elif callable(what):
            text += function_stub(member, getattr(value, member), "    ")
    return text


def main():
    print(HEAD)
    for use in USES:
        print(options_stub(use))
    for name in frostfill.__all__:
        value = getattr(frostfill, name)
        if inspect.isclass(value):
            print(class_stub(name, value))
        elif callable(value):
            print(function_stub(name, value))


main()
