"""State for other libraries through DLPack: on the card with CUDA, otherwise through host memory."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy

from . import _native
from ._errors import Error

if TYPE_CHECKING:
    from ._frame import Object

_CPU, _CUDA = 1, 2  # device types of DLPack


class Export:
    """Copy of a state array for a library that reads DLPack, such as `torch.from_dlpack(export)`.

    `path` is "device" if the copy was made on the card, and "host" if it went through host memory; `reason` says why then.
    A copy on the device can be taken once.
    """

    def __init__(self, thing: Object, array: str, member: str | None) -> None:
        native = thing._scene._native
        made = native.read_on_device(thing.name, array, member or "")
        self.reason: str | None = None
        self._capsule: Any = None
        self._host: Any = None
        if made is not None:
            self._capsule, self._number = made
            self.path = "device"
            return
        self.path = "host"
        self.reason = _native.why_through_host() or "the array is not stored as one array on the card"
        values = thing[array]
        self._host = numpy.array(values if member is None else values[member])

    def __dlpack_device__(self) -> tuple[int, int]:
        return (_CPU, 0) if self.path == "host" else (_CUDA, self._number)

    def __dlpack__(self, **options: Any) -> Any:
        """Returns the capsule. The copy is finished, so it suits every stream."""
        if self.path == "host":
            options = {name: value for name, value in options.items() if name != "stream"}
            return self._host.__dlpack__(**options)
        if self._capsule is None:
            raise Error("this export was taken already; export the array again")
        capsule, self._capsule = self._capsule, None
        return capsule

    def __repr__(self) -> str:
        return f"<simreel.Export on the {self.path}{f' ({self.reason})' if self.reason else ''}>"
