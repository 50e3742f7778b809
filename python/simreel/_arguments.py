"""Checks of arguments, so that errors name what a caller gave."""
from __future__ import annotations

import operator
import os

from ._errors import Error

_MOST = 2**31 - 1


def integer(name, value):
    """Returns an argument as an int, also numpy's integers."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is an integer, not {value!r}") from None
    if abs(number) > _MOST:
        raise Error(f"{name} is at most {_MOST}, not {number}")
    return number


def frame_number(name, value):
    """Returns the number of a frame."""
    number = integer(name, value)
    if number < 0:
        raise Error(f"frames count from 0; {name} is {number}")
    return number


def text(name, value):
    """Returns an argument that must be a str."""
    if not isinstance(value, str):
        raise TypeError(f"{name} is a str, not {value!r}")
    return value


def flag(name, value):
    """Returns an argument that must be True or False."""
    if value is not True and value is not False:
        raise TypeError(f"{name} is True or False, not {value!r}")
    return value


def path(name, value):
    """Returns a path as a str."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name} is a path, not {value!r}")
    given = str(os.fspath(value))
    try:
        given.encode("utf-8")
    except UnicodeEncodeError:
        raise Error(f"{name} has bytes that are not UTF-8: {given!r}; rename the file") from None
    return given


def folder(name, value):
    """Returns the path of a folder that exists as a str."""
    given = path(name, value)
    if not os.path.isdir(given):
        raise Error(f"{name} {given}: there is no such folder")
    return given


def values(name, given, one):
    """Returns an iterable argument as a list, with each value checked by one(name, value)."""
    try:
        given = list(given)
    except TypeError:
        raise TypeError(f"{name} is a list, not {given!r}") from None
    return [one(f"{name}[{i}]", value) for i, value in enumerate(given)]
