"""Tests tools/cycles: objects transferred to Blender have the same position and lighting as in simreel, and parts that
cannot be transferred are refused. Runs Blender only in tools/test all (SIMREEL_LONG=1), and only if it is installed."""
import copy
import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from common import PATIENCE, PROGRAM, SOURCE, Case, main, png_rows, unfiltered, with_values

CYCLES = SOURCE / "tools/cycles"
sys.dont_write_bytecode = True
sys.path.insert(0, str(CYCLES))
from carried import flat_color, refusals  # noqa: E402

DULL = {"color": [0.6, 0.6, 0.6], "roughness": 0.9}
SMALL = {
    "version": 1, "stage": False, "time": {"fps": 30, "duration": 0.2}, "render": {"size": [96, 54]},
    "sun": {"direction": [-0.7, 0.5, 0.4], "color": [1, 0.9, 0.8], "intensity": 2, "diameter": 5},
    "sky": {"zenith": [0.1, 0.2, 0.4], "horizon": [0.5, 0.5, 0.5], "ground": [0.2, 0.1, 0.1]},
    "ground": {"height": 0.1, "color": [0.5, 0.45, 0.4], "roughness": 0.9, "fadeStart": 50, "fadeEnd": 50.1},
    "camera": {"position": [1.5, 1.9, 4.1], "target": [0.2, 0.6, -0.1], "fieldOfView": 35},
    "lights": {"window": {"type": "area", "position": [1.9, 2.2, 1.2], "color": [1, 0.7, 0.4], "intensity": 8, "area": {"target": [0.4, 0, -0.2], "width": 0.4, "height": 1.1}},
               "lamp": {"position": [-1.6, 0.7, 1.2], "color": [0.4, 0.6, 1], "intensity": 1.5, "radius": 0.1, "glow": 0}},
    "objects": {
        "ring": {"mesh": {"shape": "torus", "radius": 0.4, "tube": 0.13, "resolution": [65, 33], "position": [-0.9, 0.7, 0.2], "rotation": [60, 20, 0]}, "material": DULL},
        "rod": {"capsule": {"position": [0.9, 0.6, -0.3], "rotation": [20, 30, 50], "radius": 0.15, "length": 0.8}, "material": DULL},
        "ball": {"sphere": {"position": [0.3, 0.4, 0.6], "radius": 0.3}, "material": {"color": [0.9, 0.7, 0.4], "metallic": 1, "roughness": 0.3}},
        "flag": {"cloth": {"size": [9, 7], "spacing": 0.1, "position": [0.1, 1.1, -0.6], "rotation": [80, 15, 0], "substeps": 4}, "material": {**DULL, "translucency": 0.3}}},
    "test": {"frames": [3]},
}


def blender_missing():
    if os.environ.get("SIMREEL_LONG") != "1":
        return "left to tools/test all"
    return "" if shutil.which("blender") else "Blender is not installed"


class Cycles(Case):
    def test_unsupported_parameters_are_refused(self):
        self.assertEqual(refusals(SMALL), [])
        for scene in sorted((CYCLES / "scenes").glob("*.json")):
            self.assertEqual(refusals(json.loads(scene.read_text())), [], scene)
        for path, value, words in (("camera.orbit", {"turn": 3}, "camera.orbit: not carried over"),
                                   ("render.tone", "aces", "render.tone: aces"),
                                   ("lights.window.type", "spot", "lights.window.type: spot"),
                                   ("lights.lamp.glow", 1, "lights.lamp.glow"),
                                   ("sun.intensity", {"keys": [[0, 1], [1, 2]]}, "sun.intensity: moves along keyframes"),
                                   ("ground.fadeEnd", 70, "ground: dissolves"),
                                   ("objects.ball.material.metallic", 0.5, "objects.ball.material.metallic: 0.5"),
                                   ("objects.ball.material.clearCoat", 1, "objects.ball.material.clearCoat: not carried over"),
                                   ("objects.fog", {"grayScott": {}}, "objects.fog.grayScott: not carried over")):
            scene = with_values({path: value}, SMALL)
            self.assertTrue(any(line.startswith(words) for line in refusals(scene)), (words, refusals(scene)))
            self.write("scene.json", scene)
            done = subprocess.run([CYCLES / "compare", "--simreel", PROGRAM, self.folder / "scene.json"], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertIn(words, done.stderr)

    def cycles(self, samples):
        self.good("bake", "scene.json", "-o", "baked", "--format", "ply", "--frames", "3", "--overwrite")
        # Blender runs the first python3 in PATH. Another one than the system's may lack modules that Blender needs.
        done = subprocess.run([shutil.which("blender"), "-b", "--factory-startup", "--python-exit-code", "1", "--python", CYCLES / "scene.py", "--",
                               "scene.json", "baked", self.folder / "cycles.png", str(samples)], cwd=self.folder, env={**os.environ, "PATH": "/usr/bin:/bin"},
                              capture_output=True, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])

    def pixels(self, name):
        width, height, rows = png_rows((self.folder / name).read_bytes())
        step = len(rows) // height // width
        lines = unfiltered(rows, step * width, step)
        return {(x, y): tuple(line[step * x:step * x + 3]) for y, line in enumerate(lines) for x in range(width)}

    @unittest.skipIf(blender_missing(), blender_missing())
    def test_objects_are_at_the_same_place(self):
        scene = copy.deepcopy(SMALL)
        self.write("scene.json", scene)
        self.cycles(0)
        scene["sun"]["intensity"] = 0
        scene["sky"].update(zenith=[0, 0, 0], horizon=[0, 0, 0], ground=[0, 0, 0])
        scene["ground"]["color"] = [0, 0, 0]
        scene["render"].update(quality="draft", tone="plain", samples=1)
        del scene["lights"]
        for number, thing in enumerate(scene["objects"].values(), 1):
            thing["material"] = {"color": [0, 0, 0], "emission": flat_color(number)}
        self.write("scene.json", scene)
        self.good("render", "scene.json", "-o", "ours.png", "--frames", "3")
        ours, theirs = self.pixels("ours.png"), self.pixels("cycles.png")
        # The picture shows all four objects and the ground.
        self.assertGreaterEqual(len({tuple(c // 40 for c in p) for p in ours.values()}), 5)

        def around(pixels, x, y):
            return [pixels[i, j] for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1) if (i, j) in pixels]

        # Cycles places a sample at a random position in its pixel, and simreel places it at the centre. At an edge,
        # either surface may be visible.
        apart = [at for a, b in ((ours, theirs), (theirs, ours)) for at, p in a.items()
                 if not any(max(abs(c - d) for c, d in zip(p, q)) <= 4 for q in around(b, *at))]
        self.assertLess(len(apart), 6, apart[:20])

    @unittest.skipIf(blender_missing(), blender_missing())
    def test_light_is_similar(self):
        for name, lights in (("sun and sky", {}), ("lamps", SMALL["lights"])):
            scene = {**copy.deepcopy(SMALL), "lights": lights}
            if lights:
                scene["sun"]["intensity"] = 0
                scene["sky"].update(zenith=[0, 0, 0.02], horizon=[0.02, 0.02, 0.02], ground=[0, 0, 0])
            scene["render"].update(quality="high", tone="plain", raySamples=64, size=[64, 36])
            self.write("scene.json", scene)
            self.good("render", "scene.json", "-o", "ours.png", "--frames", "3", "--overwrite")
            self.cycles(128)
            found = json.loads(subprocess.run([PROGRAM, "diff", "ours.png", "cycles.png", "--json"], cwd=self.folder, capture_output=True, check=False).stdout)
            self.assertLess(found["metrics"]["flipMean"], 0.06, name)


if __name__ == "__main__":
    main()
