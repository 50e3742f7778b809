"""The exception and the warning of the package."""
from __future__ import annotations

import difflib
import re
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


def with_keywords(error: Error) -> Error:
    """Returns an error of the command line with keyword arguments in place of flags: "--frames a" becomes "frames a"."""
    text = str(error)
    for flags, words in (("use --overwrite, --skip-existing or --resume", "use overwrite=True or resume=True"),
                         ("use --overwrite or --skip-existing", "use overwrite=True"), ("--no-manifest", "manifest=False"), ("--overwrite", "overwrite=True"),
                         ("--resume", "resume=True"), (", or - for standard output", "")):
        text = text.replace(flags, words)
    text = re.sub(r"--(output|frames|layers|bits|fields)\b", r"\1", text)
    return Error(text, error.kind, error.mistakes)


class UnknownName(Error, KeyError, AttributeError):
    """Raised for a name that does not exist. It is also a KeyError and an AttributeError, as Python expects."""

    def __init__(self, start: str, name: str, known: Iterable[str]) -> None:
        names = list(known)
        near = difflib.get_close_matches(name, names, 1)
        super().__init__(f"{start} {', '.join(names) or 'none'}" + (f'; did you mean "{near[0]}"?' if near else ""))
        self.suggestion = near[0] if near else None

    def __str__(self) -> str:
        return Exception.__str__(self)
