"""Tests `simreel serve` with a tested frame beside its golden baseline. Verdicts and pictures equal those of `simreel
test`, and accepted baselines pass there."""
import json
import os
import unittest

from common import PROGRAM, with_values
from serve_case import ServeCase

os.environ.setdefault("SIMREEL", PROGRAM)
TESTED = with_values({"test": {"frames": [0, 3], "size": [48, 32], "samples": 2}})


class Golden(ServeCase):
    def begin(self, *arguments, scene=None, update=True):
        self.write("scene.json", json.dumps(scene or TESTED, indent=2))
        if update:
            self.good("test", "scene.json", "--update")
        self.server = self.serve(*arguments)
        viewer = self.server.viewer()
        self.addCleanup(viewer.close)
        viewer.rest(0)
        viewer.send(do="compare", on=True)
        return viewer

    def verdict(self, viewer, frame, *verdicts):
        return viewer.until(lambda kind, m: kind == "golden" and m.get("frame") == frame and (not verdicts or m["verdict"] in verdicts))

    def picture(self, name):
        status, headers, body = self.server.get(f"/{self.server.token}/golden-{name}.png?7")
        self.assertEqual((status, headers["content-type"]), (200, "image/png"))
        return self.pixels(body)

    def baseline(self, frame):
        return self.pixels((self.folder / f"golden/scene/any/{frame:06}.png").read_bytes())

    def tree(self):
        return {path.relative_to(self.folder): path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}

    def test_equal_then_different_then_equal(self):
        viewer = self.begin()
        before = self.tree()
        for frame in (0, 3):
            viewer.send(do="seek", frame=frame)
            said = self.verdict(viewer, frame)
            self.assertEqual((said["verdict"], said["words"]), ("pass", "Every pixel is equal to the baseline."))
            self.assertEqual((said["tested"], said["size"], said["baseline"]), ([0, 3], [48, 32], [48, 32]))
            self.assertEqual(self.picture("ours"), self.baseline(frame))
            self.assertEqual(self.picture("baseline"), self.baseline(frame))
        viewer.send(do="set", path="sun.intensity", value=9)
        said = self.verdict(viewer, 3, "fail")
        self.assertRegex(said["words"], r"^\d+ of 1536 pixels differ \([\d.]+%\), by \d+ of 255 at most, at \(\d+, \d+\); mean FLIP error 0\.\d+, SSIM ")
        # The verdict must equal the result of `simreel test` for a scene with this value.
        self.write("other.json", json.dumps(with_values({"sun.intensity": 9}, TESTED)))
        (self.folder / "golden/other").symlink_to("scene")
        self.run_program("test", "other.json", "--report", "report")
        report = json.loads((self.folder / "report/report.json").read_text())["scenes"][0]["frames"][1]
        metrics = report["metrics"]
        self.assertIn(f"{metrics['differentPixels']} of 1536", said["words"])
        self.assertIn(f"by {metrics['worst']:g} of 255 at most, at ({metrics['worstX']}, {metrics['worstY']})", said["words"])
        self.assertEqual(self.picture("difference"), self.pixels((self.folder / "report" / report["differenceImage"]).read_bytes()))
        self.assertEqual(self.picture("ours"), self.pixels((self.folder / "report" / report["actualImage"]).read_bytes()))
        viewer.send(do="forget")
        self.verdict(viewer, 3, "pass")
        after = self.tree()
        self.assertEqual({path: after[path] for path in before}, before)

    def test_a_different_state_fails(self):
        viewer = self.begin()
        viewer.send(do="seek", frame=3)
        self.verdict(viewer, 3, "pass")
        viewer.send(do="set", path="objects.flag.cloth.jitter", value=0.02)
        said = self.verdict(viewer, 3, "fail")
        self.assertRegex(said["words"], r"Fails: the state differs: flag\.\w+")

    def test_frames_that_are_not_tested_and_scenes_without_baselines(self):
        viewer = self.begin(update=False)
        self.assertEqual(self.verdict(viewer, 0)["words"], "This scene has no baseline yet, so frame 0 cannot be compared.")
        viewer.send(do="seek", frame=2)
        said = self.verdict(viewer, 2)
        self.assertEqual((said["verdict"], said["words"]), ("untested", "Frame 2 is not a tested frame; those are 0, 3. The scene has no baseline yet."))
        for request in ("accept", "testThis"):
            viewer.send(do=request)
            refused = viewer.until(lambda kind, _: kind == "refused")
            self.assertIn("only with simreel serve --edit", refused["text"])
        self.assertEqual(self.tree(), {self.folder_path("scene.json"): (self.folder / "scene.json").read_bytes()})

    def folder_path(self, name):
        return (self.folder / name).relative_to(self.folder)

    def test_motion_blur(self):
        viewer = self.begin(scene=with_values({"camera.shutter": {"angle": 270}, "objects.flag.cloth.position": [0, 1.5, 0]}, TESTED))
        for frame in (3, 0, 3):
            viewer.send(do="seek", frame=frame)
            self.assertEqual(self.verdict(viewer, frame)["verdict"], "pass", frame)

    def test_a_new_baseline_is_noticed(self):
        viewer = self.begin(update=False)
        self.verdict(viewer, 0, "missing")
        self.good("test", "scene.json", "--update")
        self.verdict(viewer, 0, "pass")

    def test_accept(self):
        viewer = self.begin("--edit")
        self.verdict(viewer, 0, "pass")
        viewer.send(do="set", path="sun.intensity", value=9)
        self.verdict(viewer, 0, "fail")
        self.assertEqual(json.loads((self.folder / "scene.json").read_text())["sun"]["intensity"], 9)
        viewer.send(do="accept")
        done = viewer.until(lambda kind, m: kind == "golden" and m["accept"] in ("done", "failed"))
        self.assertEqual(done["accept"], "done", done["said"])
        if done["verdict"] != "pass":  # The new baseline may have been read before its writer ended.
            self.verdict(viewer, 0, "pass")
        self.good("test", "scene.json")
        self.assertEqual(json.loads((self.folder / "golden/scene/any/baseline.json").read_text())["reason"], "accepted in simreel serve")

    def test_accept_refuses_overridden_values(self):
        viewer = self.begin("--edit", "-D", "sun.intensity=9")
        self.verdict(viewer, 0, "fail")
        before = self.tree()
        viewer.send(do="accept")
        self.assertIn("sun.intensity was changed", viewer.until(lambda kind, _: kind == "refused")["text"])
        self.assertEqual(self.tree(), before)

    def test_make_this_a_tested_frame(self):
        viewer = self.begin("--edit")
        text = (self.folder / "scene.json").read_text()
        viewer.send(do="seek", frame=2)
        self.verdict(viewer, 2, "untested")
        viewer.send(do="testThis")
        said = self.verdict(viewer, 2, "missing")
        self.assertEqual((said["tested"], said["words"]), ([0, 2, 3], "Fails: no baseline of its state; no baseline picture."))
        wanted = json.loads(text)
        wanted["test"]["frames"] = [0, 2, 3]
        written = (self.folder / "scene.json").read_text()
        self.assertEqual(json.loads(written), wanted)
        self.assertIn("[0, 2, 3]", written)
        viewer.send(do="accept")
        self.verdict(viewer, 2, "pass")
        self.good("test", "scene.json")
        viewer.send(do="testThis")
        self.assertIn("is a tested frame already", viewer.until(lambda kind, _: kind == "refused")["text"])

    def test_the_test_settings_of_a_sidecar_are_used(self):
        self.write("scene.test.json", json.dumps({"test": {"frames": [1], "size": [32, 32]}}))
        viewer = self.begin("--edit")
        said = self.verdict(viewer, 0, "untested")
        self.assertEqual(said["words"], "Frame 0 is not a tested frame; that is 1.")
        before = self.tree()
        viewer.send(do="testThis")
        self.assertIn("scene.test.json; add 0 to its", viewer.until(lambda kind, _: kind == "refused")["text"])
        self.assertEqual(self.tree(), before)
        viewer.send(do="seek", frame=1)
        self.assertEqual(self.verdict(viewer, 1, "pass")["size"], [32, 32])

    def test_a_damaged_baseline_fails(self):
        viewer = self.begin()
        self.verdict(viewer, 0, "pass")
        (self.folder / "golden/scene/any/000003.png").write_bytes(b"no picture")
        viewer.send(do="seek", frame=3)
        said = self.verdict(viewer, 3)
        self.assertEqual(said["verdict"], "fail")
        self.assertIn("000003.png", said["words"])
        self.assertNotIn("baseline", said)


if __name__ == "__main__":
    unittest.main()
