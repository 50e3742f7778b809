"""Messages of the library as Python warnings."""
from __future__ import annotations

import os
import sys
import warnings
from typing import Any

from . import _native
from ._errors import Warning

_HERE = os.path.dirname(__file__) + os.sep


def warn(text: str) -> None:
    """Warns at the line outside this package that called it."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_HERE):
        level, frame = level + 1, frame.f_back
    warnings.warn(text, Warning, stacklevel=level)


def report() -> None:
    """Passes the library's warnings on. Called after each call, and ten times a second while a call waits."""
    for kind, text in _native.messages():
        if kind == "warning":
            warn(text)


class Reporting:
    """Scene of the library whose functions report the library's warnings when they end, also with an error."""

    def __init__(self, scene: Any) -> None:
        self._scene = scene

    def __getattr__(self, name: str) -> Any:
        function = getattr(self._scene, name)

        def call(*values: Any) -> Any:
            try:
                return function(*values)
            finally:
                report()
        self.__dict__[name] = call
        return call
