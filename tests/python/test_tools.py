"""Tests the module's pytest plugin, its types for mypy, and the example notebook; each is skipped without its tool."""
import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

from module_case import SCENE, SOURCE, ModuleCase

TESTS = '''
import pytest, simreel

def test_frames(assert_frames):
    assert_frames("scene.json", frames=[0, 3])

def test_image(assert_image):
    with simreel.load("scene.json") as scene:
        image = scene.image()
    if BRIGHTER:
        image = image // 2 + 100
    assert_image(image, "golden/first.png", max_channel_diff=1, max_diff_ratio=0.01)

def test_rule(assert_image):
    with pytest.raises(TypeError, match="there is no rule 'max_dif'"):
        assert_image(None, "golden/first.png", max_dif=1)
    with pytest.raises(TypeError, match="of uint8, not .* of float64"):
        assert_image([[[0.5, 0.5, 0.5]]], "golden/first.png")
'''

GOOD = '''
import simreel
scene = simreel.load({"version": 2, "objects": {"flag": {"cloth": {"fabric": "silk", "position": [0, 1.5, 0]}}}})
for frame in scene.frames(0, 3):
    frame["flag"].positions = frame["flag"].positions + 1
    shape: tuple[int, ...] = frame.image().shape
scene.save("out.mp4", range(3))
'''
BAD = '''
import simreel
simreel.load({"objects": {"flag": {"cloth": {"fabrik": "silk"}}}})
'''


def run(*words, folder):
    return subprocess.run([sys.executable, "-m", *words], cwd=folder, capture_output=True, text=True, check=False)


@unittest.skipUnless(importlib.util.find_spec("pytest"), "no python3-pytest")
class Plugin(ModuleCase):
    def pytest(self, *words, brighter=False):
        self.write("test_scene.py", TESTS.replace("BRIGHTER", str(brighter)))
        done = run("pytest", "-q", "-p", "no:cacheprovider", *words, folder=self.folder)
        return done.returncode, done.stdout + done.stderr

    def test_pictures_are_compared_with_baselines_and_baselines_are_written(self):
        code, text = self.pytest()
        self.assertEqual(code, 1, text)
        self.assertIn("2 failed, 1 passed", text)
        self.assertIn("--simreel-update writes the baselines", text)
        self.assertIn(f"there is no baseline {self.folder / 'golden/first.png'}", text)
        self.assertNotRegex(text, "/simreel-(image|report)-|To accept")
        code, text = self.pytest("--simreel-update")
        self.assertEqual(code, 0, text)
        self.assertEqual(sorted(file.name for file in self.folder.glob("golden/**/*.png")),
                         ["000000.png", "000003.png", "first.png"])
        self.assertEqual(self.pytest()[0], 0)
        code, text = self.pytest("--simreel-report", "reports", brighter=True)
        self.assertEqual(code, 1, text)
        self.assertIn("1 failed, 2 passed", text)
        self.assertIn("first", text)
        self.assertTrue((self.folder / "reports/test_image-1/index.html").exists())

    def test_a_scene_s_own_test_is_that_of_the_program(self):
        self.write("scene.json", {**SCENE, "test": {"frames": [0]}})
        self.write("test_own.py", 'def test_own(assert_frames):\n    assert_frames("scene.json")\n')
        self.assertEqual(run("pytest", "-q", "test_own.py", folder=self.folder).returncode, 1)
        done = run("pytest", "-q", "test_own.py", "--simreel-update", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(run("pytest", "-q", "test_own.py", folder=self.folder).returncode, 0)


@unittest.skipUnless(importlib.util.find_spec("mypy"), "no mypy")
class Types(ModuleCase):
    @classmethod
    def setUpClass(cls):
        # The strict runs share what mypy has read of numpy, which takes most of the time.
        cls.cache = cls.enterClassContext(tempfile.TemporaryDirectory(prefix="simreel-types-"))

    def test_types_find_a_wrong_name(self):
        self.write("good.py", GOOD)
        self.write("bad.py", BAD)
        done = run("mypy", "--cache-dir", self.cache, "--strict", "good.py", "bad.py", folder=self.folder)
        found = re.findall(r"^\w+\.py:\d+: error: .*", done.stdout, re.M)
        self.assertEqual(len(found), 1, done.stdout)
        self.assertIn("fabrik", found[0])

    def test_the_examples_of_the_guide_have_the_right_types(self):
        """Takes 15 s."""
        for page in ("18-python", "19-analysing"):
            text = (SOURCE / f"assets/guide/{page}.md").read_text(encoding="utf-8")
            for name, code in re.findall(r"^```python\n# (\w+\.py)\n(.*?)^```", text, re.M | re.S):
                self.write(name, code.replace("fabrik", "fabric"))
        files = sorted(file.name for file in self.folder.glob("*.py"))
        self.assertGreater(len(files), 8)
        done = run("mypy", "--cache-dir", self.cache, "--strict", *files, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_the_module_itself_has_no_wrong_types(self):
        """Takes 10 s."""
        done = run("mypy", "-p", "simreel", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout)


@unittest.skipUnless(importlib.util.find_spec("nbconvert") and importlib.util.find_spec("ipykernel"), "no nbconvert")
class Notebook(ModuleCase):
    def test_the_notebook_runs(self):
        notebook = json.loads((SOURCE / "examples/cloth.ipynb").read_text(encoding="utf-8"))
        self.assertTrue(all(not cell.get("outputs") for cell in notebook["cells"]), "the notebook is kept without outputs")
        self.write("cloth.ipynb", notebook)
        environment = {**os.environ, "IPYTHONDIR": str(self.folder), "JUPYTER_RUNTIME_DIR": str(self.folder)}
        done = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--inplace",
                               "cloth.ipynb"], cwd=self.folder, env=environment, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        cells = json.loads((self.folder / "cloth.ipynb").read_text(encoding="utf-8"))["cells"]
        shown = [kind for cell in cells for output in cell.get("outputs", []) for kind in output.get("data", {})]
        self.assertGreaterEqual(shown.count("image/png"), 3)


if __name__ == "__main__":
    unittest.main()
