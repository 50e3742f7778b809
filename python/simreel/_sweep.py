"""Sweeps: many values of a scene, each as a job in a process of its own, by the program `simreel sweep`."""
from __future__ import annotations

import concurrent.futures
import csv
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from . import _arguments, _native
from ._device import device_words
from ._errors import Error
from ._folder import folder_of
from ._scene import _Kernels, _frames_text, _pairs, _plain, _value_text

if TYPE_CHECKING:
    from ._scene import Numbers, Source


def program() -> str:
    """Returns the path of the program `simreel`: $SIMREEL, the one of this build or installation, or that in $PATH."""
    here = pathlib.Path(__file__).resolve().parent
    beside = [here.parents[1] / "simreel", *(folder / "bin/simreel" for folder in here.parents[:5])]
    for path in [os.environ.get("SIMREEL"), *map(str, beside), shutil.which("simreel")]:
        if path and os.path.isfile(path) and os.access(path, os.X_OK):
            return path
    raise Error("the program simreel is not found; set SIMREEL to its path", "inputOutput")


def run_program(*words, accepted=(0,), cwd=None):
    """Runs the program and returns the finished process. Raises Error with its message for other exit codes."""
    done = subprocess.run([program(), *map(str, words)], capture_output=True, text=True, check=False, cwd=cwd)
    if done.returncode not in accepted:
        kind = {1: "different", 2: "usage", 4: "device", 6: "inputOutput"}.get(done.returncode, "internal")
        raise Error((done.stderr or done.stdout).strip().removeprefix("simreel: error: "), kind)
    return done


def _word(value):
    """Returns a value as a list of --vary takes it."""
    text = value if isinstance(value, str) else _value_text("a value", value)
    if "," in text and not text.startswith(("[", "{")):
        raise Error(f"a sweep cannot take the value {text!r}, which has a comma")
    return text


class Sweep:
    """Finished sweep: a folder as `simreel sweep` writes it. table() has one row for each job."""

    def __init__(self, folder: str | os.PathLike[str], keeper: Any) -> None:
        self.folder, self._keeper = pathlib.Path(folder), keeper
        self._device: list[str] = []
        self._jobs: int | str = 1

    def __repr__(self) -> str:
        return f"<simreel.Sweep in {str(self.folder)!r}>"

    def rows(self, frames: Numbers = None) -> list[dict[str, Any]]:
        """Returns the jobs as dicts, with numbers where a column holds numbers.

        `frames`: frame numbers, or "last" or "all". Returns a row for each job and frame then: the job's values, frame,
        time, and what the objects measure, as OBJECT.QUANTITY. Each job is simulated once more for it, without pictures.
        """
        if frames is None:
            with open(self.folder / "table.csv", encoding="utf-8", newline="") as file:
                return [{key: _number(value) for key, value in row.items()} for row in csv.DictReader(file)]
        return _measured(self.folder, _frames_text(frames), self._jobs, self._device)

    def table(self, frames: Numbers = None) -> Any:
        """Returns a pandas.DataFrame of rows(frames) if pandas is installed, else the rows."""
        rows = self.rows(frames)
        try:
            import pandas  # type: ignore[import]
        except ImportError:
            return rows
        return pandas.DataFrame(rows)

    def _repr_png_(self):
        sheet = self.folder / "sheet.png"
        return sheet.read_bytes() if sheet.exists() else None


def _measured(folder, frames, jobs, device):
    """Returns a row for each job of a sweep and frame, from `simreel bake --format csv`."""
    plan = json.loads((folder / "plan.json").read_text(encoding="utf-8"))
    given = [word for change in plan["overrides"] for word in ("-D", change)]
    assets = [word for place in plan["assets"] for word in ("--assets", place)]

    def work(number):
        values = dict(change.split("=", 1) for change in plan["jobs"][number]["values"])
        changes = [word for change in values.items() for word in ("-D", "=".join(change))]
        with tempfile.TemporaryDirectory(prefix="simreel-rows-") as spare:
            chosen = [] if frames == "all" else ["--frames", frames]
            run_program("bake", folder / "scene.json", *given, *changes, *assets, *device, "--format", "csv", *chosen,
                        "-o", spare)
            rows = {}
            for file in sorted(pathlib.Path(spare).glob("*.csv")):
                with open(file, encoding="utf-8", newline="") as lines:
                    for line in csv.DictReader(lines):
                        frame, seconds = int(line.pop("frame")), float(line.pop("time"))
                        row = rows.setdefault(frame, {"job": number, **{path: _number(value) for path, value in values.items()},
                                                      "frame": frame, "time": seconds})
                        row.update({f"{file.stem}.{name}": _number(value) for name, value in line.items()})
        return [rows[frame] for frame in sorted(rows)]

    threads = (os.cpu_count() or 1) if jobs == "auto" else jobs
    with concurrent.futures.ThreadPoolExecutor(threads) as pool:
        return [row for rows in pool.map(work, range(len(plan["jobs"]))) for row in rows]


def _number(text):
    for convert in (int, float):
        try:
            return convert(text)
        except ValueError:
            pass
    return text


def sweep(source: Source, values: Mapping[str, Iterable[Any]], *, jobs: int | str = 1, frames: Numbers = None,
          output: str | os.PathLike[str] | None = None, changes: Mapping[str, Any] | None = None,
          pair: bool = False) -> Sweep:
    """Renders a scene with every combination of values, and returns the Sweep.

    `values`: lists of values by dotted path. `pair`: combines the first values, then the second ones, and so on.
    `jobs`: jobs at once, or "auto". `output`: folder that is kept; None: a temporary one. `frames`: frames of each job,
    as for Scene.save().
    """
    kernels, words = _Kernels(), []
    several = _several(values)
    if not several:
        raise Error("nothing varies; give a list of values for at least one path")
    if jobs != "auto" and _arguments.integer("jobs", jobs) < 1:
        raise Error(f"jobs is at least 1 or \"auto\", not {jobs}")
    spare = pathlib.Path(folder_of(kernels, "sweep"))
    text, assets = None, []
    if isinstance(source, dict):
        text = json.dumps(kernels.write({"version": 2, **source}), default=_plain, indent=1)
        assets = [os.getcwd()] + ([] if kernels.folder is None else [kernels.folder])
        source = spare / "scene.json"
        source.write_text(text, encoding="utf-8")
    source = _arguments.path("a scene that is no dict", source)
    given = _pairs(changes)
    _validate(kernels, source, text, given, _tried(several, pair), assets)
    folder = pathlib.Path(_arguments.path("output", output)) if output is not None else spare / "sweep"
    for place in assets:
        words += ["--assets", place]
    for path, value in given:
        words += ["-D", f"{path}={value}"]
    for path, choices in several.items():
        words += ["--vary", f"{path}={','.join(choices)}"]
    if pair:
        words.append("--zip")
    if frames is not None:
        words += ["--frames", _frames_text(frames)]
    words += device_words()
    run_program("sweep", source, *words, "-o", folder, "--jobs", jobs, "--progress", "none", "--overwrite",
                accepted=(0, 1))
    run_program("sweep", "collect", folder, accepted=(0, 1))
    made = Sweep(folder, kernels)
    made._jobs, made._device = jobs, device_words()
    return made


def _several(values):
    """Returns the varied values as lists of words."""
    if not isinstance(values, Mapping):
        raise TypeError(f"values are a dict of lists by dotted path, not {values!r}")
    several = {}
    for path, choices in values.items():
        _arguments.text("a path of values", path)
        if isinstance(choices, str):
            raise TypeError(f"the values of {path} are a list, not {choices!r}")
        several[path] = _arguments.values(f"the values of {path}", choices, lambda _, value: _word(value))
        if not several[path]:
            raise Error(f"there are no values of {path}")
    return several


def _tried(several, pair):
    """Returns combinations of the values in which each value occurs: all pairs, or else each with the first others."""
    first = [(path, choices[0]) for path, choices in several.items()]
    if pair:
        return [list(zip(several, words)) for words in zip(*several.values())]
    return [first] + [[(one, value if one == path else word) for one, word in first]
                      for path, choices in several.items() for value in choices[1:]]


def _validate(kernels, source, text, given, tried, assets):
    """Raises Error with the place of a mistake in the scene or in a value, as load() does."""
    try:
        for changes in tried:
            _native.validate("<scene>" if text else source, text, given + changes, assets)
    except Error as error:
        raise kernels.renamed(error) from None
