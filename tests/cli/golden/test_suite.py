"""Tests the verdicts of `simreel test`, and `simreel accept`, through the command line."""
import json
import shutil

from common import main
from golden_common import HAIR, OTHER_PROCESSOR, RED, TESTED, GoldenCase, png_rows


class Baselines(GoldenCase):
    def test_missing_then_update_then_pass(self):
        scene = self.one(3)
        self.assertEqual(scene["status"], "missing")
        self.assertFalse(self.golden().exists(), "nothing is written without --update")
        scene = self.one(0, "--update", "--reason", "first look")
        self.assertEqual(scene["status"], "updated")
        names = sorted(self.tree("scenes/golden/a"))
        self.assertEqual(names, ["any/000000.png", "any/000003.png", "any/000005.png", "any/baseline.json", "state.json",
                                 "steps.bin"])
        baseline = json.loads(self.golden("a/any/baseline.json").read_text())
        self.assertEqual(baseline["reason"], "first look")
        self.assertEqual((baseline["width"], baseline["height"]), (64, 36))
        state = json.loads(self.golden("a/state.json").read_text())
        self.assertEqual(sorted(state["frames"]["3"]), ["flag.positions", "flag.velocities"])
        before = self.tree("scenes")
        scene = self.one(0)
        self.assertEqual((scene["status"], scene["profile"], scene["asked"]), ("pass", "any", "exact"))
        self.assertEqual([f["state"] for f in scene["frames"]], ["equal"] * 3)
        self.assertEqual(scene["repeats"], 2)
        self.one(0, "--update")
        self.assertEqual(self.tree("scenes"), before, "an update that changes nothing writes nothing")

    def test_baselines_equal_rendered_pictures(self):
        self.make_baselines()
        self.good("render", "scenes/a.json", "-o", "out/", "--frames", "3")
        self.assertEqual(png_rows((self.folder / "out/000003.png").read_bytes()),
                         png_rows(self.golden("a/any/000003.png").read_bytes()))

    def test_pixels_differ(self):
        self.make_baselines()
        before = self.tree("scenes/golden")
        self.set_scene(RED)
        scene = self.one(1)
        self.assertEqual(scene["status"], "fail")
        for frame in scene["frames"]:
            self.assertEqual((frame["status"], frame["state"]), ("fail", "equal"))
            self.assertGreater(frame["metrics"]["worst"], 20)
            for image in ("expectedImage", "actualImage", "differenceImage"):
                self.assertEqual(png_rows((self.folder / frame[image]).read_bytes())[:2], (64, 36), image)
        self.assertEqual(self.tree("scenes/golden"), before)

    def test_accept_stores_exactly_the_reported_pixels(self):
        self.make_baselines()
        self.set_scene(RED)
        self.write("scenes/b.json", TESTED)
        report, _ = self.run_suite(1)
        self.assertEqual([s["status"] for s in report["scenes"]], ["fail", "missing"])
        kept = {f["frame"]: (self.folder / f["actualImage"]).read_bytes() for f in report["scenes"][0]["frames"]}
        # `accept` renders nothing, so it must work without a device.
        done = self.good("accept", "report.json", "--only", "a", "--reason", "red is in",
                         env={"__EGL_VENDOR_LIBRARY_FILENAMES": "/nothing"})
        self.assertEqual(done.stdout.decode(), "accepted  a\n")
        for frame, content in kept.items():
            self.assertEqual(self.golden(f"a/any/{frame:06}.png").read_bytes(), content)
        self.assertEqual(json.loads(self.golden("a/any/baseline.json").read_text())["reason"], "red is in")
        self.assertFalse(self.golden("b").exists())
        self.good("accept", "report.json")
        self.run_suite(0)
        self.bad(5, "nothing to accept", "accept", "report.json")
        self.bad(2, ["scenes/a.json is no report of `simreel test`", "--report"], "accept", "scenes/a.json")

    def test_accept_stays_inside_the_folder(self):
        """A report from elsewhere cannot name a scene outside this folder, whether by "..", an absolute path or a
        link."""
        self.make_baselines()
        self.set_scene(RED)
        report, done = self.run_suite(1)
        self.assertIn("To accept: simreel accept report.json\n", done.out)
        outside = self.folder.with_name(self.folder.name + "-outside")
        self.addCleanup(shutil.rmtree, outside, True)
        shutil.copytree(self.folder / "scenes", outside)
        shutil.rmtree(outside / "golden")
        (self.folder / "link").symlink_to(outside)
        for file in (f"../{outside.name}/a.json", str(outside / "a.json"), "link/a.json"):
            inputs = {file if k == "scenes/a.json" else k.replace("scenes/", file[:-6]): v for k, v in report["scenes"][0]["inputs"].items()}
            self.write("report.json", json.dumps({**report, "scenes": [{**report["scenes"][0], "file": file, "inputs": inputs}]}))
            self.bad(1, ["its baselines would be written to", "which is outside of this folder", "--scenes FOLDER"], "accept", "report.json")
            self.assertFalse((outside / "golden").exists())
        (self.folder / "scenes/golden").rename(self.folder / "golden before")
        (self.folder / "scenes/golden").symlink_to(outside)
        self.write("report.json", json.dumps(report))
        self.bad(1, ["which is outside of this folder"], "accept", "report.json")
        # A test of scenes outside the current folder prints a command that accepts them. The printed command must work.
        done = self.run_program("test", str(outside), "--json", "there.json")
        words = f"simreel accept there.json --scenes {outside}"
        self.assertIn(f"To accept: {words}\n", done.stdout.decode())
        self.good(*words.split()[1:])
        self.assertTrue((outside / "golden/a/any/baseline.json").exists())

    def test_accept_refuses_changed_results(self):
        self.make_baselines()
        self.set_scene(RED)
        self.run_suite(1)
        shutil.copy(self.folder / "report.json", self.folder / "old.json")
        shutil.copytree(self.folder / "report-files", self.folder / "kept")
        self.set_scene(HAIR)
        self.good("test", "scenes", "--update")
        self.set_scene(RED)
        self.bad(1, ["a:", "frame 0 has changed since"], "accept", "old.json")
        # The stored picture does not belong to the run of the report.
        self.set_scene(RED)
        self.run_suite(1)
        picture = next((self.folder / "report-files").rglob("candidate/any/000003.png"))
        picture.write_bytes(self.golden("a/any/000003.png").read_bytes())
        self.bad(1, ["a:", "000003.png", "pixels of that run"], "accept", "report.json")
        picture.unlink()
        self.bad(1, ["a:", "000003.png"], "accept", "report.json")
        for content, words in (("{", "not valid JSON"), ("{}", "simreel"), ("[]", "report.json")):
            self.write("report.json", content)
            self.bad(2, [words], "accept", "report.json")
        self.bad(2, ["nowhere.json"], "accept", "nowhere.json")

    def test_update_modes(self):
        self.make_baselines()
        before = self.tree("scenes/golden")
        self.set_scene(RED)
        self.write("scenes/b.json", TESTED)
        report, _ = self.run_suite(1, "--update=missing")
        self.assertEqual([s["status"] for s in report["scenes"]], ["fail", "updated"])
        after = self.tree("scenes/golden")
        self.assertEqual({k: after[k] for k in before}, before)
        self.assertIn("b/any/000005.png", after)
        shutil.rmtree(self.golden("b"))
        report, _ = self.run_suite(3, "--update=changed")
        self.assertEqual([s["status"] for s in report["scenes"]], ["updated", "missing"])
        self.assertFalse(self.golden("b").exists())
        # Only differing files are replaced. The state is equal, so its files stay unchanged.
        after = self.tree("scenes/golden")
        self.assertEqual(after["a/state.json"], before["a/state.json"])
        self.assertNotEqual(after["a/any/000000.png"], before["a/any/000000.png"])

    def test_frames_that_are_no_longer_tested_are_stale(self):
        self.make_baselines()
        self.set_scene({"test.frames": [0, 3]})
        stale = {f"scenes/golden/a/{name}" for name in ("state.json", "any/000005.png")}
        for code, arguments in ((0, []), (0, ["--update"]), (1, ["--strict"])):
            report, _ = self.run_suite(code, *arguments)
            self.assertEqual({(s["path"], s["message"], s["removed"]) for s in report["stale"]},
                             {(path, "frame 5 is not tested", False) for path in stale})
        report, _ = self.run_suite(0, "--update=prune")
        self.assertEqual({(s["path"], s["removed"]) for s in report["stale"]}, {(path, True) for path in stale})
        self.assertEqual(sorted(p.name for p in self.golden("a/any").glob("*.png")), ["000000.png", "000003.png"])
        self.assertEqual(self.run_suite(0, "--strict")[0]["stale"], [])
        # The files that an update writes replace all files of earlier updates.
        self.set_scene({"test.frames": [0, 4]})
        self.one(0, "--update")
        self.assertEqual(sorted(p.name for p in self.golden("a/any").glob("*.png")), ["000000.png", "000004.png"])
        self.assertEqual(self.run_suite(0, "--strict")[0]["stale"], [])

    def test_alternates(self):
        self.make_baselines()
        shades = [{"objects.flag.material": {"color": [0.8, 0.1 * k, 0.1]}} for k in range(4)]
        for k in range(3):
            self.set_scene(shades[k])
            self.run_suite(1)
            self.good("accept", "report.json", "--alternate")
        for k in range(3):
            self.set_scene(shades[k])
            self.assertEqual([f["alternate"] for f in self.one(0)["frames"]], [k + 1] * 3)
        self.set_scene({})
        self.assertEqual([f["alternate"] for f in self.one(0)["frames"]], [0] * 3)
        self.set_scene(shades[3])
        self.run_suite(1)
        self.bad(1, ["3 alternates already"], "accept", "report.json", "--alternate")
        # Accepting without --alternate replaces the baseline and removes all alternates.
        self.good("accept", "report.json")
        self.one(0)
        self.assertEqual(len(list(self.golden("a/any").glob("*.png"))), 3)

    def test_settings_in_a_sidecar_are_used(self):
        self.write("scenes/a.test.json", {"test": {"frames": [1], "size": [32, 18]}})
        self.make_baselines()
        self.assertEqual([p.name for p in self.golden("a/any").glob("*.png")], ["000001.png"])
        self.assertEqual(png_rows(self.golden("a/any/000001.png").read_bytes())[:2], (32, 18))


class Exact(GoldenCase):
    def test_exact_pictures_must_be_equal_on_every_machine(self):
        self.make_baselines()
        baseline = json.loads(self.golden("a/any/baseline.json").read_text())
        for frame in baseline["frames"].values():
            self.assertEqual(sorted(frame), ["passes", "pixels", "rasterizer"])
        self.set_scene(HAIR)
        scene = self.one(1)
        self.assertEqual([f["asked"] for f in scene["frames"]], ["exact"] * 3)
        self.assertIn("in exact pictures no pixel may differ", scene["text"])
        for step in (1, 3):
            self.set_scene({})
            self.make_baselines()
            self.change_baseline(3, 20, 10, step)
            scene = self.one(1)
            self.assertEqual([f["status"] for f in scene["frames"]], ["pass", "fail", "pass"])
            self.assertIn(f"1 pixels differ, by {step} at most; in exact pictures no pixel may differ", scene["text"])
        # No tolerance applies to exact pictures, and a given tolerance causes a note.
        self.set_scene({"test.tolerance": {"maxDiffRatio": 1}})
        scene = self.one(1, "--max-channel-diff", "255")
        self.assertEqual(scene["notes"], ["unused tolerance: maxChannelDiff (--max-channel-diff); exact pictures must be equal",
                                          "unused tolerance: maxDiffRatio (scenes/a.json); exact pictures must be equal"])

    def test_a_baseline_of_the_other_rasterizer_is_reported(self):
        self.make_baselines()
        self.set_scene({"render.rasterizer": "driver"})
        scene = self.one(1)
        self.assertIn("the baseline was drawn by the exact rasterizer, this picture by the driver", scene["text"])
        self.one(0, "--update=changed")
        self.assertEqual(self.one(0)["profile"], "any")
        self.set_scene({})
        scene = self.one(1)
        self.assertIn("the baseline was drawn by a driver, this picture by the exact rasterizer", scene["text"])
        self.assertIsNotNone(scene["frames"][1]["metrics"])
        self.one(0, "--update")
        self.assertEqual(self.one(0)["asked"], "exact")

    def test_exact_pictures_have_one_baseline_for_all_drivers(self):
        self.make_baselines("--profile", "mine")
        self.assertEqual([p.name for p in self.golden("a").iterdir() if p.is_dir()], ["any"])
        shutil.copytree(self.golden("a/any"), self.golden("a/mine"))
        self.set_scene(HAIR)
        self.one(0, "--update", "--profile", "mine")
        report, _ = self.run_suite(0, "--profile", "mine")
        self.assertEqual([(s["profile"], s["status"]) for s in report["scenes"]], [("any", "pass")])
        self.assertEqual([(s["path"], s["message"]) for s in report["stale"]],
                         [("scenes/golden/a/mine", "exact pictures have one baseline for all machines")])

    def test_fast_numerics_must_be_equal_with_the_same_driver(self):
        self.set_scene({"numerics": "fast"})
        self.make_baselines()
        self.assertEqual(self.one(0)["asked"], "equal")


class Ladder(GoldenCase):
    rasterizer = "driver"

    def test_a_state_difference_is_located(self):
        self.make_baselines()
        mutated = self.mutated_glsl("cloth/model.glsl", "(1.0f - restLength * exactInverseSqrt(squared)) * stiffness;",
                                    "(1.0f - restLength * exactInverseSqrt(squared) * 1.01f) * stiffness;")
        scene = self.one(1, env=mutated)
        self.assertEqual([f["state"] for f in scene["frames"]], ["equal", "different", "different"])
        divergence = scene["divergence"]
        self.assertEqual((divergence["frame"], divergence["step"], divergence["steps"]), (1, 1, 4))
        self.assertEqual(divergence["object"], "flag")
        self.assertIn("frame 1, step 1 of 4", scene["text"])
        # Exact state is equal on every driver, so a different fingerprint does not excuse a difference.
        self.pretend_other_numerics()
        self.assertEqual(self.one(1, env=mutated)["frames"][1]["state"], "different")
        # `accept` also takes over state and steps.
        self.good("accept", "report.json")
        self.assertEqual(self.one(0, env=mutated)["status"], "pass")
        self.one(1)

    def test_the_machine_of_the_baseline_requires_equal_pixels(self):
        self.make_baselines()
        self.set_scene(HAIR)
        scene = self.one(1)
        self.assertLessEqual(max(f["metrics"]["worst"] for f in scene["frames"]), 12)
        self.assertIn("on the machine that drew the baseline no pixel may differ", scene["text"])
        self.assertNotIn("Pictures compared", scene["text"])
        for step in (1, 3):
            self.set_scene({})
            self.make_baselines()
            self.assertEqual(self.one(0)["asked"], "equal")
            self.change_baseline(3, 20, 10, step)
            scene = self.one(1)
            self.assertEqual([f["status"] for f in scene["frames"]], ["pass", "fail", "pass"])
            self.assertIn(f"1 pixels differ, by {step} at most", scene["text"])

    def test_another_machine_with_equal_numerics_may_differ_slightly(self):
        self.make_baselines()
        self.pretend_another_machine()
        self.change_baseline(3, 20, 10, 1)
        scene = self.one(0)
        self.assertEqual((scene["asked"], scene["baselineProcessor"]), ("near", OTHER_PROCESSOR))
        self.assertEqual([f["asked"] for f in scene["frames"]], ["near"] * 3)
        self.assertEqual(scene["frames"][1]["metrics"]["differentPixels"], 1)
        self.assertIn("1 scene within 2 of 255 (another machine", scene["text"])
        shutil.rmtree(self.golden())
        self.make_baselines()
        self.pretend_another_machine()
        self.change_baseline(3, 20, 10, 3)
        scene = self.one(1)
        self.assertIn("frame 3: the pixel at x 20, y 10 differs by 3 (on another machine by 2 at most)", scene["text"])
        # State must be equal on all machines.
        mutated = self.mutated_glsl("cloth/model.glsl", "(1.0f - restLength * exactInverseSqrt(squared)) * stiffness;",
                                    "(1.0f - restLength * exactInverseSqrt(squared) * 1.01f) * stiffness;")
        self.assertEqual(self.one(1, env=mutated)["frames"][1]["state"], "different")

    def test_old_baselines_without_a_machine_are_read(self):
        self.make_baselines()
        def forget(baseline):
            for frame in baseline["frames"].values():
                del frame["machine"], frame["drawing"]
        self.edit_json(self.golden("a/any/baseline.json"), forget)
        self.assertEqual(self.one(0)["asked"], "near")
        self.change_baseline(3, 20, 10, 2)
        self.one(0)
        self.change_baseline(3, 20, 10, 2)
        self.one(1)

    def test_the_baseline_stores_the_machine(self):
        self.make_baselines()
        done = self.good("doctor").stdout.decode()
        for frame in json.loads(self.golden("a/any/baseline.json").read_text())["frames"].values():
            self.assertIn(f"Processor: {frame['machine']['processor']}\n", done)
            self.assertIn(frame["machine"]["driver"].split(", OpenGL")[0], done)
            self.assertIn(f"Drawing fingerprint: {frame['drawing']}\n", done)
            self.assertIn(f"Numerics fingerprint: {frame['fingerprint']}\n", done)
        # An option that changes the software driver's target processor counts as another processor.
        self.assertEqual(self.one(0, env={"GALLIVM_PERF": "nopt"})["asked"], "near")

    def test_different_numerics_use_the_tolerance(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene(HAIR)
        scene = self.one(0)
        self.assertEqual(scene["asked"], "tolerance")
        self.assertEqual(scene["tolerance"]["maxChannelDiff"], {"value": 12, "origin": "default"})
        self.set_scene(RED)
        scene = self.one(1)
        self.assertIn("maxDiffRatio", scene["text"])

    def test_every_tolerance_bound_is_checked(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene(HAIR)
        for bounds in ({"maxChannelDiff": 0, "maxDiffRatio": 0}, {"maxChannelDiff": 0, "maxDiffPixels": 3},
                       {"maxFlipMean": 0}, {"hardFail": 0},
                       {"maxChannelDiff": 0, "maxDiffRatio": 1, "windowSize": 4, "maxWindowRatio": 0.5}):
            self.set_scene({**HAIR, "test.tolerance": bounds})
            scene = self.one(1)
            field = list(bounds)[-1]
            self.assertIn(field, scene["text"])
            self.assertEqual(scene["tolerance"][field]["origin"], "scenes/a.json")
        self.set_scene({**HAIR, "test.tolerance": {"maxChannelDiff": 0, "maxDiffRatio": 1}})
        self.one(0)
        # The command line takes precedence over the baseline's own tolerance, which takes precedence over the scene.
        self.assertEqual(self.one(1, "--max-diff-ratio", "0")["tolerance"]["maxDiffRatio"],
                         {"value": 0, "origin": "--max-diff-ratio"})
        for name in ("max_diff_ratio", "maxDiffRatio"):  # The first name is an earlier spelling of the second.
            self.edit_json(self.golden("a/any/baseline.json"), lambda b: b.update(tolerance={name: 0}))
            self.assertEqual(self.one(1)["tolerance"]["maxDiffRatio"]["origin"], "scenes/golden/a/any/baseline.json")

    def test_loose_tolerances_are_reported(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene({**HAIR, "test.tolerance": {"hardFail": 255}})
        scene = self.one(0)
        self.assertTrue(any("hardFail is 255" in note for note in scene["notes"]), scene["notes"])

    def test_a_different_size_fails(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene({"test.size": [65, 36]})
        self.assertIn("65x36, its baseline 64x36", self.one(1)["text"])

    def test_the_own_profile_takes_precedence_over_the_shared_one(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene(RED)
        # Another driver's baseline stays unchanged. A complete baseline of this driver is added next to it.
        before = self.golden("a/any/baseline.json").read_bytes()
        scene = self.one(0, "--update")
        self.assertNotEqual(scene["profile"], "any")
        self.assertEqual(self.golden("a/any/baseline.json").read_bytes(), before)
        self.assertEqual(len(list(self.golden("a", scene["profile"]).glob("*.png"))), 3)
        self.assertEqual(self.one(0)["profile"], scene["profile"])

    def test_fast_numerics_store_states_by_profile(self):
        self.set_scene({"numerics": "fast"})
        self.make_baselines()
        self.assertFalse(self.golden("a/state.json").exists())
        self.assertTrue(self.golden("a/any/state.json").exists())
        self.assertEqual(self.one(0)["frames"][1]["state"], "equal")
        self.pretend_other_numerics()
        self.assertEqual(self.one(0)["frames"][1]["state"], "not compared")

    def test_expected_failures(self):
        self.make_baselines()
        self.set_scene({"test.xfail": "not mended yet"})
        scene = self.one(1)
        self.assertEqual(scene["status"], "xpass")
        self.set_scene({**RED, "test.xfail": "not mended yet"})
        scene = self.one(0)
        self.assertEqual((scene["status"], scene["xfail"]), ("xfail", "not mended yet"))
        before = self.tree("scenes/golden")
        self.one(0, "--update")
        self.assertEqual(self.tree("scenes/golden"), before)
        self.pretend_other_numerics()
        self.set_scene({**RED, "test.xfail": "not mended yet", "test.tolerance": {"hardFail": 20}})
        self.assertEqual(self.one(1)["status"], "fail", "hardFail is never bypassed")

    def test_checks(self):
        self.set_scene({"checks": [{"what": "max", "object": "flag", "of": "positions.y", "max": 1.0}]})
        scene = self.one(1, "--update")
        self.assertEqual(scene["status"], "fail")
        self.assertFalse(self.golden().exists(), "what fails its own check is no baseline")
        self.assertRegex(scene["text"], r"frame 0: max of flag positions.y is [\d.]+, above 1")
        self.set_scene({"checks": [{"what": "max", "object": "flag", "of": "positions.y", "max": 5},
                                   {"what": "not-blank"}, {"what": "no-nan"}]})
        scene = self.one(0, "--update")
        self.assertEqual(len(scene["checks"]), 9)

    def test_a_blank_picture_fails(self):
        self.set_scene({"checks": [{"what": "not-blank"}], "render.exposure": -20})
        self.assertIn("one colour", self.one(1, "--update")["text"])


if __name__ == "__main__":
    main()
