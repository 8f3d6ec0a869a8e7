# SPDX-License-Identifier: MIT
"""Keywords from the one table of options, from which the command line comes too."""

import inspect

from . import _frostfill


class _AsUsual:
    """The default of a keyword, which may depend on the mesh and on other keywords."""

    def __repr__(self):
        return "..."


_AS_USUAL = _AsUsual()


def _literal(words):
    return f"Literal[{', '.join(repr(word) for word in words)}]"


def _annotation(row):
    """The type of an option's values, as a stub has it."""
    kinds = {
        "boolean": ["bool"],
        "integer": ["int"],
        "number": ["float"],
        "vector": ["Sequence[float]"],
        "radii": ["float", "tuple[float, float]", "str", "PathLike[str]"],
        "text": [_literal(row["choices"])] if row["choices"] else ["str"],
    }[row["type"]]
    if {"on", "off"} <= set(row["choices"]):
        kinds = kinds + ["bool"]
    if row["type"] == "text" and not row["choices"]:
        kinds = kinds + ["int", "Sequence[float]", "Sequence[str]"]
    words = row["words"] + ([row["nothing"]] if row["nothing"] else [])
    if words and row["type"] not in ("text", "radii"):
        kinds = kinds + [_literal(words)]
    return " | ".join(kinds + (["None"] if row["nothing"] else []))


def _help(rows):
    lines = []
    group = None
    for row in rows:
        if row["group"] != group:
            group = row["group"]
            lines.append(f"\n{group}:")
        usual = f"; usually {row['default']}" if row["default"] else ""
        lines.append(f"    {row['keyword']}: {row['help']} ({row['allowed']}{usual})")
    return "\n".join(lines)


def takes_options(use):
    """Gives a function that takes **options the signature and the help of their table."""

    def complete(function):
        rows = _frostfill.keywords(use)
        signature = inspect.signature(function)
        own = [
            parameter
            for parameter in signature.parameters.values()
            if parameter.kind is not inspect.Parameter.VAR_KEYWORD
        ]
        options = [
            inspect.Parameter(
                row["keyword"],
                inspect.Parameter.KEYWORD_ONLY,
                default=_AS_USUAL,
                annotation=_annotation(row),
            )
            for row in rows
        ]
        function.__signature__ = signature.replace(parameters=own + options)
        function.use = use  # for the stub
        if function.__doc__:
            function.__doc__ = (
                inspect.cleandoc(function.__doc__)
                + "\n\nOptions, whose usual values are those of the torus:\n"
                + _help(rows)
                + "\n"
            )
        return function

    return complete
