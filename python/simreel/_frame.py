"""Frames and objects: what a scene has at one moment."""
from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy

from ._array import Array
from ._errors import Error, UnknownName
from ._export import Export
from ._pictures import Image

if TYPE_CHECKING:
    from ._scene import Scene


class Frame:
    """Moment of a run. Its data can be read until the scene is stepped, written or closed."""

    def __init__(self, scene: Scene, number: int, seconds: float) -> None:
        self._scene, self._steps = scene, scene._steps
        self.number, self.time = number, seconds

    def _valid(self) -> Scene:
        if self._scene._steps != self._steps:
            raise Error(f"frame {self.number} has passed: read a frame before the scene goes on, and copy what you keep")
        return self._scene

    def __getitem__(self, name: str) -> Object:
        return self._valid()[name]

    def __repr__(self):
        return f"<simreel.Frame {self.number} at {self.time:g} s>"

    @property
    def state_hash(self) -> str:
        """Hash of all state arrays."""
        return self._valid().state_hash

    def image(self) -> Image:
        """Draws the frame: (height, width, 3) uint8, the bytes of `simreel render`."""
        return self._valid().image()

    def layers(self, names: str | Iterable[str]) -> dict[str, numpy.ndarray]:
        """Draws layers of the frame, see Scene.layers()."""
        return self._valid().layers(names)

    def field(self, name: str) -> numpy.ndarray:
        """Returns the values of a field: (rows, columns), float32."""
        return self._valid().field(name)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the picture as PNG."""
        self.image().save(path)

    def _repr_png_(self):
        return self.image()._repr_png_()


def _without_ones(shape):
    return tuple(length for length in shape if length != 1)


def _fitted(name, values, dtype):
    """Returns values as an array of a type, without gaps. Raises Error for values that the type cannot hold."""
    if dtype.names:
        if set(values.dtype.names or ()) != set(dtype.names):
            raise Error(f"{name} holds structures with the members {', '.join(dtype.names)}; take a copy, change members "
                        "of it, and assign it")
        fitted = numpy.zeros(values.shape, dtype)
        for member in dtype.names:
            fitted[member] = _fitted(f"{name}.{member}", values[member], dtype[member].base)
        return fitted
    if values.dtype.kind not in ("fiub" if dtype.kind == "f" else "iub"):
        raise Error(f"{name} holds {dtype}, not {values.dtype}")
    with numpy.errstate(all="ignore"):
        fitted = numpy.ascontiguousarray(values, dtype)
    if dtype.kind in "iu" and values.size:
        least, most = numpy.iinfo(dtype).min, numpy.iinfo(dtype).max
        for value in (values.min(), values.max()):
            if not least <= int(value) <= most:
                raise Error(f"{name} holds {dtype}, and {value} does not fit")
    elif dtype.kind == "f":
        beyond = ~numpy.isfinite(fitted) & numpy.isfinite(values)
        if beyond.any():
            raise Error(f"{name} holds {dtype}, and {values[beyond].flat[0]} does not fit")
    return fitted


class Object:
    """Object of a scene at the present frame.

    Its state arrays are attributes: `scene["flag"].positions`. Reading copies from the device; the array is read-only,
    so take a copy to change numbers in it. Assigning writes the state back, and the scene goes on from there.
    `scene["flag"]["positions"]` is the same.
    """

    _scene: Scene
    name: str

    def __init__(self, scene: Scene, name: str) -> None:
        object.__setattr__(self, "_scene", scene)
        object.__setattr__(self, "name", name)

    @property
    def kind(self) -> str:
        """Kind of the object, such as "cloth"."""
        return self._scene._kinds[self.name]

    @property
    def arrays(self):
        """Description of the state arrays: name: (unit, dtype, shape, writable)."""
        return self._scene._table().get(self.name, {})

    def __getitem__(self, array: str) -> numpy.ndarray:
        """Returns a state array, also one whose name is no name in Python."""
        if array not in self.arrays:
            raise self._unknown(array)
        return self._scene._native.read(self.name, array).view(Array)

    def __setitem__(self, array: str, values: Any) -> None:
        if array not in self.arrays:
            raise self._unknown(array)
        dtype, shape = self.arrays[array][1:3]
        values = numpy.asarray(values)
        if values.ndim == 0:
            values = numpy.broadcast_to(values, shape)
        if _without_ones(values.shape) == _without_ones(shape):  # (24, 40) for (24, 40, 1)
            values = values.reshape(shape)
        if values.shape != shape:
            raise Error(f"{self.name}.{array} has the shape {shape}, not {values.shape}")
        self._scene._native.write(self.name, array, _fitted(f"{self.name}.{array}", values, dtype))
        self._scene._steps += 1

    def __getattr__(self, array: str) -> numpy.ndarray:
        if array in ("_scene", "name") or array.startswith("__"):
            raise AttributeError(array)
        if array not in self.arrays:
            raise self._unknown(array)
        return self[array]

    def __setattr__(self, array: str, values: Any) -> None:
        if array not in self.arrays:
            raise self._unknown(array)
        self[array] = values

    def _unknown(self, array: str) -> UnknownName:
        return UnknownName(f'{self.kind} "{self.name}" has no array "{array}"; it has', array, self.arrays)

    def __dir__(self):
        try:
            return [*super().__dir__(), *self.arrays]
        except Error:
            return super().__dir__()

    def export(self, array: str, member: str | None = None) -> Export:
        """Returns a copy of a state array, or of a member of its structures, for PyTorch, JAX and others (DLPack).

        The copy stays on the card if OpenGL and CUDA share it, and goes through host memory otherwise: Export.path says
        which.
        """
        if array not in self.arrays:
            raise self._unknown(array)
        return Export(self, array, member)

    def measure(self) -> dict[str, float]:
        """Returns what the object measures, such as energies, as a dict."""
        return self._scene._native.measure(self.name)

    def mesh(self) -> dict[str, numpy.ndarray]:
        """Returns the object's triangles in the world: a dict of positions, normals, uvs and triangles."""
        return self._scene._native.mesh(self.name)

    def field(self, part: str | None = None) -> numpy.ndarray:
        """Returns the values of the object's field, or of a part of it: (rows, columns), float32."""
        return self._scene.field(self.name if part is None else f"{self.name}.{part}")

    def __repr__(self):
        try:
            inside = ", ".join(f"{name} {shape}" for name, (_, _, shape, _) in self.arrays.items())
        except Error:  # the scene is closed, or its state is lost
            inside = "no state now"
        return f"<{self.kind} {self.name!r}: {inside or 'no state'}>"
