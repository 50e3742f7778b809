"""Arrays that the module returns."""
from __future__ import annotations

import operator
from typing import Any

import numpy


def _plain(value):
    return value.view(numpy.ndarray) if isinstance(value, Array) else value


class Array(numpy.ndarray):
    """Read-only array in host memory: a change would reach neither the device nor the next array.

    Arrays computed from it are plain numpy arrays, as are its slices and copies. `x += 1` makes a new array, so that
    `scene["flag"].positions += 1` writes the state.
    """

    __array_priority__ = -1.0

    def __array_ufunc__(self, ufunc: Any, method: Any, *inputs: Any, **options: Any) -> Any:
        if "out" in options:
            options["out"] = tuple(_plain(one) for one in options["out"])
        return getattr(ufunc, method)(*(_plain(one) for one in inputs), **options)

    def __dlpack__(self, **options: Any) -> Any:
        """Exports a copy in host memory, because DLPack cannot say that an array is read-only."""
        return numpy.array(_plain(self)).__dlpack__(**options)

    def __getitem__(self, key: Any) -> Any:
        return _plain(self)[key]

    @property  # type: ignore[override]
    def T(self) -> numpy.ndarray:  # noqa: N802  (numpy's name)
        """The transposed array."""
        return _plain(self).T


def _as_plain(name):
    function = getattr(numpy.ndarray, name)

    def work(self, *values, **options):
        return function(_plain(self), *values, **options)
    work.__name__, work.__doc__ = name, function.__doc__
    return work


def _in_place(name):
    change, compute = getattr(numpy.ndarray, f"__i{name}__"), getattr(operator, f"__{name}__")

    def work(self, other):
        return change(self, other) if self.flags.writeable else compute(_plain(self), other)
    work.__name__ = f"__i{name}__"
    return work


for _name in ("astype", "clip", "compress", "copy", "diagonal", "flatten", "ravel", "repeat", "reshape", "round", "squeeze",
              "swapaxes", "take", "transpose"):
    setattr(Array, _name, _as_plain(_name))
for _name in ("add", "sub", "mul", "truediv", "floordiv", "mod", "pow", "and", "or", "xor", "lshift", "rshift"):
    setattr(Array, f"__i{_name}__", _in_place(_name))
