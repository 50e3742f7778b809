"""Pictures and videos that show themselves in notebooks."""
from __future__ import annotations

import base64
import os
import pathlib

import numpy

from . import _arguments, _native
from ._array import Array
from ._errors import Error


def _write(file, data):
    try:
        file.write_bytes(data)
    except OSError as error:
        raise Error(f"cannot write {file}: {error.strerror}", "inputOutput") from None


class Image(Array):
    """Picture as an array (height, width, 3 or 4) of uint8, sRGB encoded, rows from the top.

    It is read-only. Slices, copies and results are plain numpy arrays; `array.view(simreel.Image)` makes a picture.
    """

    def _repr_png_(self) -> bytes | None:
        if self.ndim == 3 and self.shape[2] in (3, 4) and self.dtype == numpy.uint8:
            return _native.encode_png(numpy.ascontiguousarray(self))
        return None

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a PNG file: the path ends in ".png"."""
        file = pathlib.Path(_arguments.path("the file of a picture", path))
        if file.suffix.lower() != ".png":
            raise Error(f"{file} does not end in .png, and pictures are saved as PNG; scene.save() also writes .exr "
                        "pictures and videos, and other libraries take the picture as a numpy array")
        _write(file, _native.encode_png(numpy.ascontiguousarray(self)))


class Video:
    """Video file that a notebook shows."""

    def __init__(self, file: str | os.PathLike[str]) -> None:
        self.file = pathlib.Path(file)
        self.data = self.file.read_bytes()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the video to another file."""
        _write(pathlib.Path(_arguments.path("the file of a video", path)), self.data)

    def _repr_html_(self) -> str:
        data = base64.b64encode(self.data).decode("ascii")
        return f'<video controls loop autoplay muted src="data:video/mp4;base64,{data}"></video>'
