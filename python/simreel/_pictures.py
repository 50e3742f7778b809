"""Pictures and videos that show themselves in notebooks."""
from __future__ import annotations

import base64
import os
import pathlib

import numpy

from . import _native
from ._array import Array


class Image(Array):
    """Picture as an array (height, width, 3 or 4) of uint8, sRGB encoded, rows from the top.

    It is read-only. Slices, copies and results are plain numpy arrays; `array.view(simreel.Image)` makes a picture.
    """

    def _repr_png_(self) -> bytes | None:
        if self.ndim == 3 and self.shape[2] in (3, 4) and self.dtype == numpy.uint8:
            return _native.encode_png(numpy.ascontiguousarray(self))
        return None

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a PNG file."""
        pathlib.Path(path).write_bytes(_native.encode_png(numpy.ascontiguousarray(self)))


class Video:
    """Video file that a notebook shows."""

    def __init__(self, file: str | os.PathLike[str]) -> None:
        self.file = pathlib.Path(file)
        self.data = self.file.read_bytes()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the video to another file."""
        pathlib.Path(path).write_bytes(self.data)

    def _repr_html_(self) -> str:
        data = base64.b64encode(self.data).decode("ascii")
        return f'<video controls loop autoplay muted src="data:video/mp4;base64,{data}"></video>'
