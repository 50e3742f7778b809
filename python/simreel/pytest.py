"""pytest plugin: compares frames of scenes and pictures with baselines, by the program `simreel test`.

Fixtures: assert_frames and assert_image. Options: --simreel-update writes baselines, --simreel-report FOLDER writes the
HTML report of every comparison that fails. Paths are relative to the folder of the test's file.
"""
import json
import pathlib
import re
import shutil
import tempfile

import numpy
import pytest

from . import load
from ._pictures import Image
from ._sweep import run_program

_RULES = {"ignore_antialiased": "ignoreAntialiased", "search_radius": "searchRadius", "masks": "masks"}
_BOUNDS = {"max_channel_diff": "maxChannelDiff", "max_diff_pixels": "maxDiffPixels", "max_diff_ratio": "maxDiffRatio",
           "window_size": "windowSize", "max_window_ratio": "maxWindowRatio", "max_flip_mean": "maxFlipMean",
           "hard_fail": "hardFail"}


def pytest_addoption(parser):
    group = parser.getgroup("simreel")
    group.addoption("--simreel-update", action="store_true", help="write baselines that are missing or changed")
    group.addoption("--simreel-report", metavar="FOLDER", help="folder for the HTML reports of failed comparisons")


class _Golden:
    """Runs `simreel test` for one test function."""

    def __init__(self, request):
        self.update = request.config.getoption("--simreel-update")
        self.reports = request.config.getoption("--simreel-report")
        self.name = re.sub(r"\W+", "-", request.node.name).strip("-")
        self.folder = pathlib.Path(request.node.path).parent
        self.count = 0

    def compare(self, *words, baselines=None):
        """Returns nothing if all is equal; else fails the test with the program's words.

        `baselines`: a temporary folder and the one that its pictures come from, which the message names.
        """
        self.count += 1
        if self.update:
            run_program("test", *words, "--update", accepted=(0, 1, 3))
            return
        with tempfile.TemporaryDirectory(prefix="simreel-report-") as spare:
            report = pathlib.Path(spare) / "report"
            if self.reports is not None:
                report = pathlib.Path(self.reports).absolute() / f"{self.name}-{self.count}"
            done = run_program("test", *words, "--report", report, accepted=(0, 1, 3))
            if done.returncode == 0:
                if self.reports is not None:
                    shutil.rmtree(report, ignore_errors=True)
                return
            kept = f"report: {report}/index.html" if self.reports is not None else \
                "--simreel-report FOLDER keeps the report"
            said = done.stdout + done.stderr
            if baselines is not None:
                said = said.replace(*map(str, baselines))
            # Lines about removed temporary folders are left out.
            lines = [line for line in said.splitlines()
                     if spare not in line and not (baselines and line.startswith("To accept:"))]
            pytest.fail("\n".join([*lines, f"{kept}, --simreel-update writes the baselines"]), pytrace=False)

    def compare_pictures(self, pictures, folder, rules):
        """Compares pictures, by file name, with the baselines in a folder."""
        unknown = [name for name in rules if name not in _RULES and name not in _BOUNDS]
        if unknown:
            raise TypeError(f"there is no rule {unknown[0]!r}, but {', '.join([*_BOUNDS, *_RULES])}")
        with tempfile.TemporaryDirectory(prefix="simreel-image-") as spare:
            expected, actual = pathlib.Path(spare) / "expected", pathlib.Path(spare) / "actual"
            expected.mkdir()
            actual.mkdir()
            for name, picture in pictures.items():
                picture = numpy.asarray(picture)
                if picture.dtype != numpy.uint8 or picture.ndim != 3 or picture.shape[2] not in (3, 4):
                    raise TypeError("a picture is an array (height, width, 3 or 4) of uint8, not "
                                    f"{picture.shape} of {picture.dtype}")
                picture.view(Image).save(actual / name)
                if (folder / name).exists():
                    shutil.copy(folder / name, expected)
            bounds = {_BOUNDS[name]: value for name, value in rules.items() if name in _BOUNDS}
            text = {"tolerance": bounds} if bounds else {}
            text.update({_RULES[name]: value for name, value in rules.items() if name in _RULES})
            (pathlib.Path(spare) / "rules.json").write_text(json.dumps(text), encoding="utf-8")
            self.compare("--expected", expected, "--actual", actual, "--rules", pathlib.Path(spare) / "rules.json",
                         baselines=(expected, folder))
            if self.update:
                folder.mkdir(parents=True, exist_ok=True)
                for name in pictures:
                    shutil.copy(expected / name, folder / name)


@pytest.fixture
def assert_frames(request):
    """Compares frames of a scene with baselines: assert_frames("scene.json", frames=[0, 60]).

    With `frames`, pictures are compared with golden/SCENE/000060.png and so on. `changes` are values by dotted path;
    `name` then names a folder of their own. Without `frames`, runs `simreel test scene.json`: pictures and states at the
    frames of the scene's own test. Further arguments are the rules of assert_image.
    """
    golden = _Golden(request)

    def compare(scene, frames=None, *, changes=None, name=None, **rules):
        source = golden.folder / scene
        if frames is None:
            if changes or rules:
                raise TypeError("assert_frames without frames compares as the scene says; give frames")
            return golden.compare(source)
        pictures = {}
        with load(source, changes) as run:
            for frame in sorted(frames):
                run.advance_to(frame)
                pictures[f"{frame:06}.png"] = run.image()
        return golden.compare_pictures(pictures, source.parent / "golden" / (name or source.stem), rules)

    return compare


@pytest.fixture
def assert_image(request):
    """Compares a picture (height, width, 3 or 4; uint8) with a PNG: assert_image(array, "golden/name.png").

    Rules, as of `simreel test --expected`: max_channel_diff, max_diff_pixels, max_diff_ratio, window_size,
    max_window_ratio, max_flip_mean, hard_fail, ignore_antialiased, search_radius, masks. Without rules, pictures must be
    equal.
    """
    golden = _Golden(request)

    def compare(array, baseline, **rules):
        path = golden.folder / baseline
        return golden.compare_pictures({path.name: array}, path.parent, rules)

    return compare
