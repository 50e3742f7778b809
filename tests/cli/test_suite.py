"""`simreel test` and `simreel accept` as a user meets them."""
import json
import os
import shutil
import signal
import subprocess
import threading
import time

from common import PROGRAM, main
from golden_common import TESTED, GoldenCase, png, png_rows, with_values

RED = {"objects.flag.material": {"color": [0.9, 0.1, 0.1]}}
# Another green by a hair: pixels differ by a few units, state does not.
HAIR = {"objects.flag.material": {"color": [0.8, 0.705, 0.6]}}


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
        self.assertEqual((scene["status"], scene["profile"], scene["sameNumerics"]), ("pass", "any", True))
        self.assertEqual([f["state"] for f in scene["frames"]], ["equal"] * 3)
        self.assertEqual(scene["repeats"], 2)
        self.one(0, "--update")
        self.assertEqual(self.tree("scenes"), before, "an update that changes nothing writes nothing")

    def test_baselines_are_what_render_makes(self):
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

    def test_accept_promotes_exactly_those_pixels(self):
        self.make_baselines()
        self.set_scene(RED)
        self.write("scenes/b.json", TESTED)
        report, _ = self.run_suite(1)
        self.assertEqual([s["status"] for s in report["scenes"]], ["fail", "missing"])
        kept = {f["frame"]: (self.folder / f["actualImage"]).read_bytes() for f in report["scenes"][0]["frames"]}
        # Nothing is rendered: the program runs where no device can be had.
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

    def test_accept_refuses_what_has_changed(self):
        self.make_baselines()
        self.set_scene(RED)
        self.run_suite(1)
        shutil.copy(self.folder / "report.json", self.folder / "old.json")
        shutil.copytree(self.folder / "report-files", self.folder / "kept")
        self.set_scene(HAIR)
        self.good("test", "scenes", "--update")
        self.bad(1, ["a:", "frame 0 has changed since"], "accept", "old.json")
        # A picture that is not the one of that run.
        self.set_scene(RED)
        self.run_suite(1)
        picture = next((self.folder / "report-files").rglob("candidate/any/000003.png"))
        picture.write_bytes(self.golden("a/any/000003.png").read_bytes())
        self.bad(1, ["a:", "000003.png", "pixels of that run"], "accept", "report.json")
        picture.unlink()
        self.bad(1, ["a:", "000003.png"], "accept", "report.json")
        for content, words in (("{", "not JSON"), ("{}", "simreel"), ("[]", "report.json")):
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
        # Only what differs: the state is the same, so its files stay as they were.
        after = self.tree("scenes/golden")
        self.assertEqual(after["a/state.json"], before["a/state.json"])
        self.assertNotEqual(after["a/any/000000.png"], before["a/any/000000.png"])

    def test_frames_that_are_no_longer_tested_leave_with_an_update(self):
        self.make_baselines()
        self.set_scene({"test.frames": [0, 4]})
        scene = self.one(3)
        self.assertTrue(any("frame 3" in note for note in scene["notes"]), scene["notes"])
        self.one(0, "--update")
        self.assertEqual(sorted(p.name for p in self.golden("a/any").glob("*.png")), ["000000.png", "000004.png"])
        self.assertEqual(self.one(0)["notes"], [])

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
        # As the baseline it replaces all of them.
        self.good("accept", "report.json")
        self.one(0)
        self.assertEqual(len(list(self.golden("a/any").glob("*.png"))), 3)

    def test_beside_the_scene(self):
        self.write("scenes/a.test.json", {"test": {"frames": [1], "size": [32, 18]}})
        self.make_baselines()
        self.assertEqual([p.name for p in self.golden("a/any").glob("*.png")], ["000001.png"])
        self.assertEqual(png_rows(self.golden("a/any/000001.png").read_bytes())[:2], (32, 18))


class Ladder(GoldenCase):
    def test_state_differs_is_located(self):
        self.make_baselines()
        mutated = self.mutated_glsl("cloth/model.glsl", "precise float scale = 1.0f - ratio;",
                                    "precise float scale = 1.0f - ratio * 1.01f;")
        scene = self.one(1, env=mutated)
        self.assertEqual([f["state"] for f in scene["frames"]], ["equal", "different", "different"])
        divergence = scene["divergence"]
        self.assertEqual((divergence["frame"], divergence["step"], divergence["steps"]), (1, 1, 4))
        self.assertEqual(divergence["object"], "flag")
        self.assertIn("frame 1, step 1 of 4", scene["text"])
        # The state of exact numerics is everybody's: another fingerprint does not excuse it.
        self.pretend_other_numerics()
        self.assertEqual(self.one(1, env=mutated)["frames"][1]["state"], "different")
        # Accepting takes state and steps along.
        self.good("accept", "report.json")
        self.assertEqual(self.one(0, env=mutated)["status"], "pass")
        self.one(1)

    def test_same_numerics_ask_for_equal_pixels(self):
        self.make_baselines()
        self.set_scene(HAIR)
        scene = self.one(1)
        self.assertLessEqual(max(f["metrics"]["worst"] for f in scene["frames"]), 12)
        self.assertIn("equal numerics", scene["text"])

    def test_other_numerics_have_a_tolerance(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene(HAIR)
        scene = self.one(0)
        self.assertFalse(scene["sameNumerics"])
        self.assertEqual(scene["tolerance"]["max_channel_diff"], {"value": 12, "origin": "default"})
        self.set_scene(RED)
        scene = self.one(1)
        self.assertIn("max_diff_ratio", scene["text"])

    def test_every_bound_holds(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene(HAIR)
        for bounds in ({"max_channel_diff": 0, "max_diff_ratio": 0}, {"max_channel_diff": 0, "max_diff_pixels": 3},
                       {"max_flip_mean": 0}, {"hard_fail": 0},
                       {"max_channel_diff": 0, "max_diff_ratio": 1, "window_size": 4, "max_window_ratio": 0.5}):
            self.set_scene({**HAIR, "test.tolerance": bounds})
            scene = self.one(1)
            field = list(bounds)[-1]
            self.assertIn(field, scene["text"])
            self.assertEqual(scene["tolerance"][field]["origin"], "scenes/a.json")
        self.set_scene({**HAIR, "test.tolerance": {"max_channel_diff": 0, "max_diff_ratio": 1}})
        self.one(0)
        # The command line wins over the scene, and a baseline's own tolerance over the scene's.
        self.assertEqual(self.one(1, "--max-diff-ratio", "0")["tolerance"]["max_diff_ratio"],
                         {"value": 0, "origin": "--max-diff-ratio"})
        self.edit_json(self.golden("a/any/baseline.json"), lambda b: b.update(tolerance={"max_diff_ratio": 0}))
        self.assertEqual(self.one(1)["tolerance"]["max_diff_ratio"]["origin"], "scenes/golden/a/any/baseline.json")

    def test_loose_tolerances_are_told(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene({**HAIR, "test.tolerance": {"hard_fail": 255}})
        scene = self.one(0)
        self.assertTrue(any("hard_fail is 255" in note for note in scene["notes"]), scene["notes"])

    def test_another_size_is_a_failure(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene({"test.size": [65, 36]})
        self.assertIn("65x36, its baseline 64x36", self.one(1)["text"])

    def test_own_profile_before_the_shared_one(self):
        self.make_baselines()
        self.pretend_other_numerics()
        self.set_scene(RED)
        # Another driver's baseline is left alone: this one's goes beside it, complete.
        before = self.golden("a/any/baseline.json").read_bytes()
        scene = self.one(0, "--update")
        self.assertNotEqual(scene["profile"], "any")
        self.assertEqual(self.golden("a/any/baseline.json").read_bytes(), before)
        self.assertEqual(len(list(self.golden("a", scene["profile"]).glob("*.png"))), 3)
        self.assertEqual(self.one(0)["profile"], scene["profile"])

    def test_fast_numerics_keep_their_state_by_profile(self):
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
        self.set_scene({**RED, "test.xfail": "not mended yet", "test.tolerance": {"hard_fail": 20}})
        self.assertEqual(self.one(1)["status"], "fail", "hard_fail is never bypassed")

    def test_checks(self):
        self.set_scene({"checks": [{"what": "max", "object": "flag", "of": "positions.y", "most": 1.0}]})
        scene = self.one(1, "--update")
        self.assertEqual(scene["status"], "fail")
        self.assertFalse(self.golden().exists(), "what fails its own check is no baseline")
        self.assertRegex(scene["text"], r"frame 0: max of flag positions.y is [\d.]+, above 1")
        self.set_scene({"checks": [{"what": "max", "object": "flag", "of": "positions.y", "most": 5},
                                   {"what": "not-blank"}, {"what": "no-nan"}]})
        scene = self.one(0, "--update")
        self.assertEqual(len(scene["checks"]), 9)

    def test_a_blank_picture(self):
        self.set_scene({"checks": [{"what": "not-blank"}], "render.exposure": -20})
        self.assertIn("one colour", self.one(1, "--update")["text"])


class Running(GoldenCase):
    def test_which_scenes(self):
        for name in ("b", "c", "deep/d"):
            self.write(f"scenes/{name}.json", TESTED)
        self.write("scenes/notes.json", {"colour": "blue"})
        self.write("scenes/.hidden/e.json", TESTED)
        def listed(*arguments):
            done = self.good("test", "--list", *arguments)
            return [line.split("\t")[0] for line in done.stdout.decode().splitlines()]
        self.assertEqual(listed("scenes"), ["a", "b", "c", "deep/d"])
        self.assertEqual(listed("scenes", "--filter", "deep/*"), ["deep/d"])
        self.assertEqual(listed("scenes", "--filter", "[ab]", "--filter", "c"), ["a", "b", "c"])
        self.assertEqual(listed("scenes/b.json", "scenes/deep"), ["b", "d"])
        self.assertEqual(listed("scenes", "--shard", "1/2") + listed("scenes", "--shard", "2/2"), ["a", "c", "b", "deep/d"])
        # Two of one name: told apart by their paths, and never a way out of the report's folder.
        self.write("more/a.json", TESTED)
        self.assertEqual(listed("scenes/a.json", self.folder / "more/a.json"),
                         sorted([str(self.folder / "more/a")[1:], "scenes/a"]))
        self.bad(5, "no scene to test", "test", "scenes", "--filter", "nobody")
        self.bad(5, "no scene to test", "test", "scenes", "--shard", "9/9")
        self.bad(2, "nowhere", "test", "nowhere")
        for shard in ("0/2", "3/2", "x", "1/", "1/2/3", ""):
            self.bad(2, "--shard", "test", "scenes", f"--shard={shard or 'x'}")
        self.bad(2, "--profile", "test", "scenes", "--profile", "../x")
        self.bad(2, "--reason", "test", "scenes", "--reason", "x")

    def test_one_bad_scene_does_not_stop_the_others(self):
        self.write("scenes/b.json", "{\"version\": 1, \"objects\": {\"x\": {\"clothh\": {}}}}")
        self.write("scenes/c.json", "no json")
        self.write("scenes/d.json", with_values({"checks": [{"what": "mass", "object": "nobody", "most": 1}]}, TESTED))
        self.write("scenes/e.json", TESTED)
        report, done = self.run_suite(2, "--update")
        self.assertEqual([s["status"] for s in report["scenes"]], ["updated", "error", "error", "error", "updated"])
        self.assertIn("clothh", " ".join(report["scenes"][1]["messages"]))
        self.assertIn("nobody", " ".join(report["scenes"][3]["messages"]))
        self.assertIn("b.json:1:", done.out)

    def test_a_lost_simulation_is_its_own_error(self):
        self.set_scene({"objects.flag.cloth.stiffness": 1e9, "objects.flag.cloth.substeps": 1})
        self.write("scenes/b.json", TESTED)
        report, _ = self.run_suite(4, "--update")
        self.assertEqual([s["status"] for s in report["scenes"]], ["error", "updated"])
        self.assertIn("blew up", report["scenes"][0]["messages"][-1])

    def test_nondeterministic(self):
        """The shaders change while the runs go on."""
        self.make_baselines()
        env = self.mutated_glsl("cloth/model.glsl", "precise float scale = 1.0f - ratio;",
                                "precise float scale = 1.0f - ratio;")
        timer = threading.Timer(1.0, lambda: self.mutated_glsl(
            "cloth/model.glsl", "precise float scale = 1.0f - ratio;", "precise float scale = 1.0f - ratio * 1.01f;"))
        timer.start()
        self.addCleanup(timer.join)
        scene = self.one(1, "--repeat", "500", env=env)
        self.assertEqual(scene["status"], "nondeterministic")
        self.assertIn("runs 1 and", scene["text"])
        self.assertEqual(scene["candidate"] or "", "")

    def test_flaky(self):
        self.make_baselines()
        env = self.mutated_glsl("cloth/model.glsl", "precise float scale = 1.0f - ratio;",
                                "precise float scale = 1.0f - ratio * 1.01f;")
        def mend():
            time.sleep(1.0)
            self.mutated_glsl("cloth/model.glsl", "precise float scale = 1.0f - ratio;",
                              "precise float scale = 1.0f - ratio;")
        for code, arguments in ((1, []), (0, ["--allow-flaky"])):
            self.mutated_glsl("cloth/model.glsl", "precise float scale = 1.0f - ratio;",
                              "precise float scale = 1.0f - ratio * 1.01f;")
            thread = threading.Thread(target=mend)
            thread.start()
            scene = self.one(code, "--retries", "100", *arguments, env=env)
            thread.join()
            self.assertEqual(scene["status"], "flaky")
            self.assertGreaterEqual(len(scene["attempts"]), 1)
            self.assertEqual({a["status"] for a in scene["attempts"]} - {"nondeterministic"}, {"fail"})

    def test_interrupt(self):
        for k in range(40):
            self.write(f"scenes/s{k:02}.json", TESTED)
        process = self.start("test", "scenes", "--update", "--json", "report.json")
        end = time.monotonic() + 40
        while time.monotonic() < end and not self.golden("s01").exists():
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        messages = process.communicate(timeout=40)[1].decode()
        self.assertEqual(process.returncode, 130, messages)
        report = json.loads((self.folder / "report.json").read_text())
        self.assertLess(1, len(report["scenes"]))
        self.assertLess(len(report["scenes"]), 41)
        self.assertEqual({s["status"] for s in report["scenes"]}, {"updated"})
        self.assertEqual(list(self.folder.rglob("*.part")), [])


class Outputs(GoldenCase):
    def test_report_folder(self):
        self.make_baselines()
        self.set_scene(RED)
        done = self.run_program("test", "scenes", "--report", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("simreel accept out/report.json", done.stdout.decode())
        page = (self.folder / "out/index.html").read_text(encoding="utf-8")
        self.assertNotRegex(page, r"https?://(?!www\.w3\.org)")
        report = json.loads((self.folder / "out/report.json").read_text())
        for frame in report["scenes"][0]["frames"]:
            self.assertTrue((self.folder / "out" / frame["actualImage"]).exists())
        # A second run replaces it; a folder of somebody else's is left alone.
        self.set_scene({})
        self.good("test", "scenes", "--report", "out")
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), ["index.html", "report.json"])
        self.bad(2, ["scenes", "not empty"], "test", "scenes", "--report", "scenes")
        self.bad(2, ["scenes/a.json", "file"], "test", "scenes", "--report", "scenes/a.json")

    def test_junit(self):
        self.make_baselines()
        self.write("scenes/b.json", with_values({**RED}, TESTED))
        self.write("scenes/c.json", "no json")
        self.write("scenes/d.json", with_values({"test.xfail": "a <reason>"}, TESTED))
        self.run_program("test", "scenes", "--junit", "out.xml")
        text = (self.folder / "out.xml").read_text(encoding="utf-8")
        self.assertIn('tests="4"', text)
        self.assertIn("<error", text)
        self.assertIn("<failure", text)
        xmllint = shutil.which("xmllint")
        if xmllint is None:
            self.skipTest("xmllint is not installed (apt install libxml2-utils)")
        schema = os.path.join(os.path.dirname(__file__), "..", "unit", "junit.xsd")
        done = subprocess.run([xmllint, "--noout", "--schema", schema, self.folder / "out.xml"], capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_github(self):
        self.make_baselines()
        self.set_scene(RED)
        summary = self.write("summary.md", "# Before\n")
        done = self.run_program("test", "scenes", "--github", env={"GITHUB_STEP_SUMMARY": str(summary)})
        self.assertEqual(done.returncode, 1)
        self.assertIn("::error file=scenes/a.json,title=", done.stdout.decode())
        text = summary.read_text(encoding="utf-8")
        self.assertTrue(text.startswith("# Before\n"))
        self.assertIn("| a |", text.replace("`", ""))


class BadInput(GoldenCase):
    def test_pictures(self):
        """One clear line each, and the others go on."""
        self.make_baselines()
        self.write("scenes/b.json", TESTED)
        self.good("test", "scenes", "--update")
        self.pretend_other_numerics()
        self.set_scene(HAIR)
        whole = self.golden("a/any/000003.png").read_bytes()
        row = bytes(64 * 3)
        for content, words in (
                (whole[:len(whole) // 2], "cut off"), (b"", "empty"), (b"GIF89a" + whole, "not a PNG"),
                (whole[:60] + bytes([whole[60] ^ 1]) + whole[61:], "checksum"),
                (png(64, 36, [bytes(64 * 6)] * 36, depth=16), "16"), (png(64, 36, [bytes(64)] * 36, kind=3), "palette"),
                (png(64, 35, [row] * 35), "64x35"), (png(64, 36, [row] * 36), "does not have the pixels")):
            self.golden("a/any/000003.png").write_bytes(content)
            report, done = self.run_suite(1)
            self.assertEqual([s["status"] for s in report["scenes"]], ["fail", "pass"], words)
            messages = [m for m in report["scenes"][0]["messages"] if "000003.png" in m]
            self.assertEqual(len(messages), 1, report["scenes"][0]["messages"])
            self.assertIn(words, messages[0])
        self.golden("a/any/000003.png").unlink()
        self.set_scene({})
        report, _ = self.run_suite(1)
        self.assertIn("missing", report["scenes"][0]["messages"][0])
        self.run_suite(0, "--update")
        self.assertEqual(self.run_suite(0)[0]["scenes"][0]["status"], "pass")

    def test_baseline_json(self):
        self.make_baselines()
        path = self.golden("a/any/baseline.json")
        whole = path.read_text()
        changes = ((lambda b: b.update(colour=1), "colour is unknown"), (lambda b: b.update(format=7), "format is 7"),
                   (lambda b: b["frames"]["3"].update(x=1), "frames.3.x is unknown"),
                   (lambda b: b["frames"]["3"].pop("pixels"), "frames.3.pixels is missing"),
                   (lambda b: b.update(width="wide"), "width must be"), (lambda b: b.update(frames=[]), "frames"),
                   (lambda b: b["frames"].update({"x": {"pixels": "", "fingerprint": ""}}), "\"x\" is no number"),
                   (lambda b: b["frames"]["3"].update(alternates=["a"] * 4), "alternates"),
                   (lambda b: b.update(tolerance={"max": 1}), "tolerance.max is unknown"))
        for change, words in changes:
            path.write_text(whole)
            self.edit_json(path, change)
            scene = self.one(6)
            self.assertEqual(scene["status"], "error")
            self.assertEqual(len(scene["messages"]), 1)
            self.assertIn("golden/a/any/baseline.json", scene["messages"][0])
            self.assertIn(words, scene["messages"][0])
        path.write_text(whole[:50])
        self.assertIn("not valid JSON", self.one(6)["messages"][0])
        self.golden("a/state.json").write_text("{\"format\": 1, \"frames\": 3}")
        path.write_text(whole)
        self.assertIn("state.json", self.one(6)["messages"][0])
        self.one(0, "--update")
        self.assertEqual(self.one(0)["status"], "pass")
        # A damaged steps.bin matters only when the state differs.
        self.golden("a/steps.bin").write_bytes(b"nonsense")
        self.one(0)

    def test_read_only_folder(self):
        self.write("scenes/golden/a", "a file where a folder has to be")
        self.write("scenes/b.json", TESTED)
        report, _ = self.run_suite(6, "--update")
        self.assertEqual([s["status"] for s in report["scenes"]], ["error", "updated"])
        self.assertIn("scenes/golden/a", report["scenes"][0]["messages"][-1])

    def test_full_disk(self):
        disk = self.golden()
        disk.mkdir()
        mounted = os.geteuid() == 0 and subprocess.run(["mount", "-t", "tmpfs", "-o", "size=24k", "tmpfs", disk],
                                                       capture_output=True, check=False).returncode == 0
        if not mounted:
            self.skipTest("a small file system can be mounted by root only")
        try:
            self.write("scenes/b.json", TESTED)
            report, _ = self.run_suite(6, "--update")
            self.assertIn("error", [s["status"] for s in report["scenes"]])
            messages = [s["messages"][-1] for s in report["scenes"] if s["status"] == "error"]
            self.assertTrue(all("No space left" in m for m in messages), messages)
            self.assertEqual(list(disk.rglob("*.part")), [])
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_report_on_a_full_disk(self):
        self.make_baselines()
        for flag in ("--json", "--junit"):
            self.bad(6, ["nowhere/x"], "test", "scenes", flag, "nowhere/x")
        done = self.bad(6, ["job summary"], "test", "scenes", "--github", env={"GITHUB_STEP_SUMMARY": "/dev/full"})
        self.assertIn("pass", done.stdout.decode())


if __name__ == "__main__":
    assert PROGRAM
    main()
