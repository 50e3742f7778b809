"""Tests the choice of scenes of `simreel test`, how runs end, the written files, and bad input."""
import json
import os
import shutil
import signal
import subprocess
import threading

from common import main
from golden_common import HAIR, RED, TESTED, GoldenCase, Readings, png, with_values


class Running(GoldenCase):
    def test_scenes_are_selected_by_folder_and_filter(self):
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
        # Two scenes with the same name are distinguished by their paths. No path may lead out of the report's folder.
        self.write("more/a.json", TESTED)
        self.assertEqual(listed("scenes/a.json", self.folder / "more/a.json"),
                         sorted([str(self.folder / "more/a")[1:], "scenes/a"]))
        self.bad(5, "no scene to test", "test", "scenes", "--filter", "nobody")
        # This shard has no scenes; the other shards contain them.
        self.assertEqual(listed("scenes", "--shard", "9/9"), [])
        self.bad(2, "nowhere", "test", "nowhere")
        for shard in ("0/2", "3/2", "x", "1/", "1/2/3", ""):
            self.bad(2, "--shard", "test", "scenes", f"--shard={shard or 'x'}")
        self.bad(2, "--profile", "test", "scenes", "--profile", "../x")
        self.bad(2, "--reason", "test", "scenes", "--reason", "x")

    def test_one_bad_scene_does_not_stop_the_others(self):
        self.write("scenes/b.json", "{\"version\": 1, \"objects\": {\"x\": {\"clothh\": {}}}}")
        self.write("scenes/c.json", "no json")
        self.write("scenes/d.json", with_values({"checks": [{"what": "mass", "object": "nobody", "max": 1}]}, TESTED))
        self.write("scenes/e.json", TESTED)
        report, done = self.run_suite(2, "--update")
        self.assertEqual([s["status"] for s in report["scenes"]], ["updated", "error", "error", "error", "updated"])
        self.assertIn("clothh", " ".join(report["scenes"][1]["messages"]))
        self.assertIn("nobody", " ".join(report["scenes"][3]["messages"]))
        self.assertIn("b.json:1:", done.out)

    def test_a_diverged_simulation_is_an_error_of_its_scene(self):
        self.set_scene({"objects.flag.cloth.stiffness": 1e9, "objects.flag.cloth.substeps": 1})
        self.write("scenes/b.json", TESTED)
        report, _ = self.run_suite(4, "--update")
        self.assertEqual([s["status"] for s in report["scenes"]], ["error", "updated"])
        self.assertIn("blew up", report["scenes"][0]["messages"][-1])

    def changed_after(self, readings, path, change):
        """Starts a thread that makes the change once the file has been read `readings` times."""
        watched = Readings(path)
        def look():
            with watched:
                left = readings
                while left > 0 and (seen := watched.wait()):
                    left -= seen
            change()
        thread = threading.Thread(target=look)
        thread.start()
        self.addCleanup(thread.join)

    def readings(self, path, env, *arguments):
        """Returns a lower bound for the number of reads of the file in one attempt: the kernel may merge two events."""
        with Readings(path) as watched:
            self.run_suite(None, *arguments, env=env)
            found = watched.wait(0)
        self.assertGreater(found, 0)
        return found

    def stiffer(self, by):
        """Returns $SIMREEL_GLSL with springs longer by this factor; the file is replaced atomically, because others may
        be reading it."""
        text = "(1.0f - restLength * exactInverseSqrt(squared)) * stiffness;"
        # With one thread, no kernel is compiled in advance. Otherwise the number of reads would depend on the driver's
        # cache.
        return self.mutated_glsl("cloth/model.glsl", text, text.replace("(squared)", f"(squared){by}")) | {"LP_NUM_THREADS": "1"}

    def until(self, status, once, attempt):
        """Repeats an attempt with later changes of the shader until the scene has this status, because readings are
        counted only roughly: on a busy machine the change may come before the first run has read the shader."""
        for times in (3, 6, 9, 15):
            scene = attempt(times * once)
            if scene["status"] == status:
                break
        self.assertEqual(scene["status"], status, scene["text"])
        return scene

    def test_nondeterministic(self):
        """The shaders change between the runs."""
        self.make_baselines()
        env, path = self.stiffer(""), self.folder / "glsl/cloth/model.glsl"
        once = self.readings(path, env, "--repeat", "1")

        def attempt(readings):
            self.stiffer("")
            self.changed_after(readings, path, lambda: self.stiffer(" * 1.01f"))
            return self.one(None, "--repeat", "20", env=env)
        scene = self.until("nondeterministic", once, attempt)
        self.assertEqual(scene["code"], 1)
        self.assertIn("runs 1 and", scene["text"])
        self.assertEqual(scene["candidate"] or "", "")

    def test_flaky(self):
        self.make_baselines()
        env, path = self.stiffer(" * 1.01f"), self.folder / "glsl/cloth/model.glsl"
        once = self.readings(path, env)
        for code, arguments in ((1, []), (0, ["--allow-flaky"])):
            def attempt(readings):
                self.stiffer(" * 1.01f")
                self.changed_after(readings, path, lambda: self.stiffer(""))
                return self.one(None, "--retries", "20", *arguments, env=env)
            scene = self.until("flaky", once, attempt)
            self.assertEqual(scene["code"], code)
            self.assertGreaterEqual(len(scene["attempts"]), 1)
            # The status depends on whether the shader changed within an attempt.
            self.assertLessEqual({a["status"] for a in scene["attempts"]}, {"fail", "nondeterministic"})

    def test_interrupt(self):
        for k in range(40):
            self.write(f"scenes/s{k:02}.json", TESTED)
        code, messages = self.signal_when(self.golden("s01").exists, "scenes", signal.SIGINT, "test", "scenes", "--update", "--json", "report.json")
        self.assertEqual(code, 130, messages)
        report = json.loads((self.folder / "report.json").read_text())
        self.assertLess(1, len(report["scenes"]))
        self.assertLess(len(report["scenes"]), 41)
        self.assertEqual({s["status"] for s in report["scenes"]}, {"updated"})
        self.assertEqual(list(self.folder.rglob("*.part")), [])

    def test_interrupt_of_a_comparison(self):
        self.make_baselines()
        kept = {path: path.read_bytes() for path in self.golden().rglob("*") if path.is_file()}
        for k in range(40):
            self.write(f"scenes/s{k:02}.json", TESTED)
        code, messages = self.signal_when(lambda: any((self.folder / "r").rglob("*.png")), "r", signal.SIGINT, "test", "scenes", "--report", "r", "--repeat", "1")
        self.assertEqual(code, 130, messages)
        self.assertRegex(messages, r"interrupted after \d+ of \d+ scenes")
        report = json.loads((self.folder / "r/report.json").read_text(encoding="utf-8"))
        self.assertLess(0, len(report["scenes"]))
        self.assertLess(len(report["scenes"]), 41)
        self.assertEqual({path: path.read_bytes() for path in self.golden().rglob("*") if path.is_file()}, kept)
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
        # A second run replaces the report. A folder with other content is left unchanged.
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
        schema = os.path.join(os.path.dirname(__file__), "..", "..", "unit", "junit.xsd")
        done = subprocess.run([xmllint, "--noout", "--schema", schema, self.folder / "out.xml"], capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_github(self):
        self.make_baselines()
        self.set_scene(RED)
        summary = self.write("summary.md", "# Before\n")
        done = self.run_program("test", "scenes", "--github", env={"GITHUB_STEP_SUMMARY": str(summary)})
        self.assertEqual(done.returncode, 1)
        self.assertIn("::error file=scenes/a.json,line=", done.stdout.decode())
        text = summary.read_text(encoding="utf-8")
        self.assertTrue(text.startswith("# Before\n"))
        self.assertIn("| a |", text.replace("`", ""))


class BadInput(GoldenCase):
    rasterizer = "driver"  # Baselines of the driver's rasterizer consist of the most files.

    def test_pictures(self):
        """Each damaged file gives one clear line, and other scenes continue."""
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
                (png(64, 36, [bytes(64 * 6)] * 36, depth=16), "16 bits"), (png(64, 36, [bytes(64)] * 36, kind=3), "does not have the pixels"),
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
                   (lambda b: b["frames"]["3"]["machine"].pop("driver"), "frames.3.machine.driver is missing"),
                   (lambda b: b["frames"]["3"].update(drawing=1), "frames.3.drawing must be"),
                   (lambda b: b.update(width="wide"), "width must be"), (lambda b: b.update(frames=[]), "frames"),
                   (lambda b: b["frames"].update({"x": {"pixels": "", "fingerprint": ""}}), "\"x\" is no number"),
                   (lambda b: b["frames"]["3"].update(alternates=["a"] * 4), "alternates"),
                   (lambda b: b["frames"]["3"].update(rasterizer="driver"), "frames.3.rasterizer is not \"exact\""),
                   (lambda b: b["frames"]["3"].update(rasterizer="exact"), "frames.3.drawing is unknown"),
                   (lambda b: b.update(tolerance={"max": 1}), "tolerance.max is unknown"),
                   (lambda b: b.update(tolerance={"hard_fail": 1, "hardFail": 1}), "tolerance.hard_fail is unknown"))
        for change, words in changes:
            path.write_text(whole)
            self.edit_json(path, change)
            scene = self.one(6)
            self.assertEqual(scene["status"], "error")
            self.assertEqual(len(scene["messages"]), 1)
            self.assertIn("golden/a/any/baseline.json", scene["messages"][0])
            self.assertIn(words, scene["messages"][0])
        path.write_text(whole[:50])
        self.assertIn("is cut off after 50 bytes", self.one(6)["messages"][0])
        path.write_text(whole.replace(":", ";", 1))
        self.assertIn("not valid JSON", self.one(6)["messages"][0])
        self.golden("a/state.json").write_text("{\"format\": 1, \"frames\": 3}")
        path.write_text(whole)
        self.assertIn("state.json", self.one(6)["messages"][0])
        self.one(0, "--update")
        self.assertEqual(self.one(0)["status"], "pass")
        # A damaged file is reported even if the state is equal, because a later test will need the file.
        self.golden("a/steps.bin").write_bytes(b"nonsense")
        self.assertIn("steps.bin", self.one(1)["messages"][0])

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
    main()
