"""The exception and the warning of the package."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple


class Mistake(NamedTuple):
    """One mistake in a scene or a kernel. Members are None if unknown; `line` and `column` count from 1."""

    file: str | None
    line: int | None
    column: int | None
    path: str | None
    message: str
    suggestion: str | None


class Warning(UserWarning):  # noqa: A001  (simreel.Warning)
    """A message that the command line would print as a warning."""


class Error(Exception):
    """Raised by all functions of simreel.

    `kind` is "scene", "usage", "device", "different", "inputOutput", "process", "interrupted" or "internal". Errors about the text
    of a scene or a kernel have every mistake in `mistakes`; file, line, column, path and suggestion are those of the
    first one, and None if unknown.
    """

    def __init__(self, message: str, kind: str = "usage", mistakes: Iterable[Any] = ()) -> None:
        super().__init__(message)
        self.kind = kind
        self.mistakes = [Mistake(file or None, line or None, column or None, path or None, text, suggestion or None)
                         for file, line, column, path, text, suggestion in mistakes]
        first = self.mistakes[0] if self.mistakes else Mistake(None, None, None, None, message, None)
        self.file, self.line, self.column = first.file, first.line, first.column
        self.path, self.suggestion = first.path, first.suggestion

    def __reduce__(self):  # allows pickling, so that errors of worker processes keep all their members
        return Error, (str(self), self.kind, [tuple(one) for one in self.mistakes])
