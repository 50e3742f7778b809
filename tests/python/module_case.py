"""Shared helpers of the Python module's tests."""
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from common import CLOTH, PROGRAM, SCENE, SOURCE, Case, with_values  # noqa: E402, F401

try:
    import numpy
    import simreel
except ImportError as missing:
    print(f"skipped: {missing}; install python3-numpy, pybind11-dev and python3-dev, and build again")
    sys.exit(1 if os.environ.get("CI") else 77)

DISH = {"version": 2, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.2},
        "objects": {"dish": {"grayScott": {"size": [48, 32], "steps": 5}}}}
SPARKS = {"version": 1, "stage": False, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.2},
          "camera": {"position": [0, 1, 6], "target": [0, 1, 0]},
          "objects": {"sparks": {"particles": {"emitters": [{"rate": 400, "lifetime": 0.5}]}}}}


class ModuleCase(Case):
    """Base class: tests load scene.json from a folder of their own."""

    def scene(self, values=None, **options):
        scene = simreel.load(self.folder / "scene.json", values, **options)
        self.addCleanup(scene.close)
        return scene

    def assert_same(self, one, other):
        self.assertEqual(one.dtype, other.dtype)
        self.assertTrue(numpy.array_equal(one, other, equal_nan=one.dtype.kind == "f"))

    def rendered(self, *arguments):
        """Renders with the program; returns the states and the pictures' files by frame."""
        self.good("-q", "render", "scene.json", "-o", "rendered/", *arguments)
        frames = self.manifest("rendered")["frames"]
        return ({one["frame"]: one["state"] for one in frames},
                {one["frame"]: (self.folder / "rendered" / one["file"]).read_bytes() for one in frames})


def picture_of(png):
    """Returns the pixels of a PNG by another reader."""
    import io

    from PIL import Image
    return numpy.asarray(Image.open(io.BytesIO(png)))
