# SPDX-License-Identifier: MIT
"""Pictures as arrays."""

from __future__ import annotations

from os import PathLike

import numpy

from . import _frostfill


class Picture(numpy.ndarray):
    """A picture: uint8 [height, width, 3 or 4], sRGB, rows from the top; the fourth is alpha.

    A NumPy array that shows itself in a notebook.
    """

    def __repr__(self) -> str:
        if not self._is_picture():
            return super().__repr__()
        return f"<frostfill.Picture of {self.shape[1]} x {self.shape[0]} pixels>"

    def save(self, file: str | PathLike[str]) -> None:
        """Writes a PNG file; an incomplete one never appears."""
        _frostfill.save_png(self, file)

    def _repr_png_(self) -> bytes | None:
        return _frostfill.encode_png(self) if self._is_picture() else None

    def _is_picture(self) -> bool:
        return self.ndim == 3 and self.size > 0 and self.shape[2] in (3, 4) and self.dtype == "u1"
