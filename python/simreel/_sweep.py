"""Sweeps: many values of a scene, each as a job in a process of its own, by the program `simreel sweep`."""
from __future__ import annotations

import csv
import json
import os
import pathlib
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from ._errors import Error
from ._folder import folder_of
from ._scene import _Kernels, _frames_text, _plain

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
        kind = {2: "usage", 4: "device", 6: "inputOutput"}.get(done.returncode, "internal")
        raise Error((done.stderr or done.stdout).strip().removeprefix("simreel: error: "), kind)
    return done


def _word(value):
    """Returns a value as a list of --vary takes it."""
    text = value if isinstance(value, str) else json.dumps(value, default=_plain)
    if "," in text and not text.startswith(("[", "{")):
        raise Error(f"a sweep cannot take the value {text!r}, which has a comma")
    return text


class Sweep:
    """Finished sweep: a folder as `simreel sweep` writes it. table() has one row for each job."""

    def __init__(self, folder: str | os.PathLike[str], keeper: Any) -> None:
        self.folder, self._keeper = pathlib.Path(folder), keeper

    def rows(self) -> list[dict[str, Any]]:
        """Returns the jobs as dicts, with numbers where a column holds numbers."""
        with open(self.folder / "table.csv", encoding="utf-8", newline="") as file:
            return [{key: _number(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def table(self) -> Any:
        """Returns a pandas.DataFrame if pandas is installed, else the rows."""
        try:
            import pandas
        except ImportError:
            return self.rows()
        return pandas.DataFrame(self.rows())

    def _repr_png_(self):
        sheet = self.folder / "sheet.png"
        return sheet.read_bytes() if sheet.exists() else None


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
    spare = pathlib.Path(folder_of(kernels, "sweep"))
    if isinstance(source, dict):
        scene = spare / "scene.json"
        scene.write_text(json.dumps(kernels.write({"version": 2, **source}), default=_plain), encoding="utf-8")
        words += ["--assets", os.getcwd()]
        if kernels.folder is not None:
            words += ["--assets", kernels.folder]
        source = scene
    folder = pathlib.Path(output) if output is not None else spare / "sweep"
    for path, value in (changes or {}).items():
        words += ["-D", f"{path}={json.dumps(value, default=_plain)}"]
    for path, several in values.items():
        words += ["--vary", f"{path}={','.join(_word(value) for value in several)}"]
    if pair:
        words.append("--zip")
    if frames is not None:
        words += ["--frames", _frames_text(frames)]
    run_program("sweep", source, *words, "-o", folder, "--jobs", jobs, "--progress", "none", "--overwrite",
                accepted=(0, 1))
    run_program("sweep", "collect", folder, accepted=(0, 1))
    return Sweep(folder, kernels)
