"""Tests exit code 0: the results of each command without errors."""
import json
import os
import re
import shutil
import subprocess
import unittest

from common import FRAMES, PATIENCE, PROGRAM, SOURCE, Case, main, png_rows, with_values


class Success(Case):
    def test_folder(self):
        done = self.good("render", "scene.json", "-o", "out/")
        self.assertEqual(self.assert_manifest_is_whole("out"), list(range(FRAMES)))
        names = {f"{i:06}.png" for i in range(FRAMES)} | {"as-run.json", "manifest.json"}
        self.assertEqual(set(self.content("out")), names)
        self.assertEqual(done.stdout, b"")
        self.assertIn("6 frames", done.err)
        self.assertEqual(len(done.err.splitlines()), 1)

    def test_patterns(self):
        for pattern, first in (("p/f_####.png", "f_0000.png"), ("q/g%04d.png", "g0000.png"), ("r/%d.png", "0.png")):
            self.good("render", "scene.json", "-o", pattern, "--frames", "0-2")
            self.assertTrue((self.folder / pattern).parent.joinpath(first).exists(), pattern)

    def test_one_picture(self):
        self.good("render", "scene.json", "-o", "one.png", "--frames", "3")
        self.assertEqual(png_rows((self.folder / "one.png").read_bytes())[:2], (64, 36))

    def test_options_in_any_order(self):
        self.good("render", "--frames", "0", "-o", "a/", "--size", "32x20", "scene.json", "-q")
        self.good("-q", "render", "scene.json", "--size", "32x20", "--frames=0", "--output=b/")
        self.good("render", "-q", "-o", "c/", "scene.json", "--frames", "0", "-D", "render.size=[32,20]")
        self.assertEqual(self.content("a"), self.content("b"))
        self.assertEqual(self.content("a"), self.content("c"))

    def test_quiet_and_verbose(self):
        done = self.good("render", "scene.json", "-o", "a/", "-q")
        self.assertEqual((done.stdout, done.err), (b"", ""))
        done = self.good("render", "scene.json", "-o", "b/", "-v")
        self.assertEqual(done.stdout, b"")
        self.assertIn("device", done.err)

    def test_validate(self):
        self.write("other scene.json", with_values({"title": "ü"}))
        done = self.good("validate", "scene.json", "other scene.json")
        self.assertEqual(done.stdout.decode().splitlines(), ["scene.json: ok", "other scene.json: ok"])
        self.assertEqual(done.err, "")
        self.good("validate", *sorted((SOURCE / "assets/scenes").glob("*.json")))

    def test_the_committed_schema_is_up_to_date(self):
        done = self.good("schema")
        self.assertEqual(done.stdout, (SOURCE / "assets/scene.schema.json").read_bytes())
        json.loads(done.stdout)

    def test_list(self):
        self.assertIn(b"cloth", self.good("list").stdout)
        self.assertIn(b"stiffness", self.good("list", "cloth").stdout)
        self.assertIn(b"kineticEnergy", self.good("list", "cloth").stdout)
        self.assertNotIn(b"Measured", self.good("list", "sphere").stdout)
        self.assertIn(b"fieldOfView", self.good("list", "camera").stdout)

    def test_doctor(self):
        done = self.good("doctor")
        self.assertIn(b"Chosen: ", done.stdout)
        self.assertIn(b"Exact numerics: hold", done.stdout)
        self.assertRegex(done.stdout, rb"\nRasterizer: (driver|exact), the default \(")

    def test_software_drivers_get_two_threads_per_available_processor(self):
        """The processors come from the affinity mask; a user's own LP_NUM_THREADS is kept."""
        own = {"LP_NUM_THREADS": "3"}
        both = sorted(os.sched_getaffinity(0))[:2]
        for processors, env, threads in ((both[:1], {}, 2), (both, {}, 2 * len(both)), (None, own, 3)):
            with self.subTest(processors=processors):
                run = ["taskset", "-c", ",".join(map(str, processors))] if processors else []
                done = subprocess.run([*run, PROGRAM, "doctor"], capture_output=True, text=True, timeout=PATIENCE, check=True,
                                      env={**{k: v for k, v in os.environ.items() if k != "LP_NUM_THREADS"}, **env})
                if "(software)" in done.stdout:
                    self.assertIn(f"Driver's threads: {threads} ", done.stdout)

    def test_the_drawing_fingerprint_depends_only_on_the_driver(self):
        """The fingerprint changes if the driver draws the probe differently, and does not depend on the passes that
        draw scenes."""
        def fingerprint(name, old, new):
            shutil.rmtree(self.folder / "glsl", ignore_errors=True)
            shutil.copytree(SOURCE / "glsl", self.folder / "glsl")
            text = (SOURCE / "glsl" / name).read_text(encoding="utf-8")
            self.assertEqual(text.count(old), 1, f"{old!r} stands once in {name}")
            self.write(f"glsl/{name}", text.replace(old, new))
            done = self.good("doctor", env={"SIMREEL_GLSL": str(self.folder / "glsl")}).stdout.decode()
            return re.search("^Drawing fingerprint: ([0-9a-f]{16})$", done, re.M).group(1)
        own = fingerprint("draw/surface/surface.frag", "vec3 base = color;", "vec3 base = 2.0 * color;")
        for change in (("triangles.frag", "0.2 + sun", "0.2001 + sun"), ("triangles.frag", "0.7 * uv", "0.7001 * uv"),
                       ("triangles.frag", "vec3(uv, fract", "vec3(1.01 * uv, fract"),
                       ("triangles.vert", "vec4(first.xyz, 1.0)", "vec4(first.xyz, 1.0001)"),
                       ("finish.frag", "mean + 0.6", "mean + 0.59")):
            self.assertNotEqual(fingerprint("probe/" + change[0], *change[1:]), own, change)
        self.assertEqual(fingerprint("probe/finish.vert", "whole picture", "picture"), own)

    def test_version_and_help(self):
        self.assertRegex(self.good("--version").stdout, rb"^simreel \d+\.\d+\.\d+\n$")
        for arguments in (["--help"], ["render", "--help"], ["validate", "-h"]):
            self.assertIn(b"Usage", self.good(*arguments).stdout)

    def test_texture_beside_a_scene_given_by_its_bare_name(self):
        shutil.copy(SOURCE / "assets/textures/flag.png", self.folder / "my flag.png")
        self.write("scene.json", with_values({"objects.flag.material": {"texture": "my flag.png"}}))
        for name in ("scene.json", "./scene.json", self.folder / "scene.json"):
            self.good("render", name, "-o", "out/", "--frames", "0", "--overwrite")


class Streams(Case):
    def test_raw_stream(self):
        done = self.good("render", "scene.json", "-o", "-")
        self.assertEqual(len(done.stdout), 64 * 36 * 4 * FRAMES)

    def test_y4m_stream(self):
        done = self.good("render", "scene.json", "-o", "-", "--stream-format", "y4m")
        header, _, rest = done.stdout.partition(b"\n")
        self.assertTrue(header.startswith(b"YUV4MPEG2 W64 H36 F30:1 "), header)
        self.assertEqual(len(rest), FRAMES * (len(b"FRAME\n") + 64 * 36 * 3))

    def test_progress_lines_are_json(self):
        done = self.good("render", "scene.json", "-o", "out/", "--progress", "ndjson", "-q")
        events = [json.loads(line) for line in done.err.splitlines()]
        self.assertEqual([e["event"] for e in events], ["start"] + ["frame"] * FRAMES + ["end"])
        self.assertEqual([e["frame"] for e in events[1:-1]], list(range(FRAMES)))
        self.assertEqual(events[-1]["status"], "ok")

    def test_stage_times_of_frames_add_up_to_those_of_the_run(self):
        """All time for simulating, drawing and reading back is assigned to a frame, including frames that are simulated
        but not drawn."""
        self.write("scene.json", with_values({"objects.flag.cloth.substeps": 40}))
        for frames in ("0-5", "1,5"):
            done = self.good("render", "scene.json", "-o", "out/", "--progress", "ndjson", "-q", "--frames", frames, "--overwrite")
            events = [json.loads(line) for line in done.err.splitlines()]
            for stage in ("simulate", "draw", "readBack"):
                of_frames = sum(e[stage] for e in events if e["event"] == "frame")
                self.assertAlmostEqual(of_frames, events[-1][stage], delta=1e-5)
                self.assertGreater(of_frames, 0)
            self.assertGreater(events[-1]["encode"], 0)
            self.assertLessEqual(sum(e["encode"] for e in events if e["event"] == "frame"), events[-1]["encode"] + 1e-5)

    def test_a_video_of_every_third_frame_has_the_same_duration(self):
        done = self.good("render", "scene.json", "-o", "-", "--stream-format", "y4m", "--frames", "0-5x3")
        self.assertIn(b" F10:1 ", done.stdout.partition(b"\n")[0])
        done = self.good("render", "scene.json", "-o", "-", "--stream-format", "y4m", "--frames", "0,1,5")
        self.assertIn(b" F30:1 ", done.stdout.partition(b"\n")[0])
        self.assert_words("the frames are not evenly spaced", done)

    def test_all_messages_are_json(self):
        """Covers warnings, errors of every kind and the closing line."""
        def lines(*arguments):
            done = self.run_program("render", *arguments, "--progress", "ndjson", "-v")
            return [json.loads(line) for line in done.err.splitlines()]
        events = lines("scene.json", "-o", "out/", "-D", "objects.flag.cloth.substeps=1",
                       "-D", "objects.flag.cloth.stiffness=8000")
        levels = {e["level"] for e in events if e["event"] == "message"}
        self.assertLessEqual({"warning", "detail"}, levels)
        self.assertIn("start", lines("scene.json", "-o", "good/")[-1]["text"])
        for arguments in (("scene.json", "-o", "good/"), ("nothing.json", "-o", "a/"), ("scene.json", "--nonsense"),
                          ("scene.json", "-o", "a/", "-D", "objects.flag.cloth.size=3")):
            self.assertEqual(lines(*arguments)[-1]["level"], "error", arguments)

    def test_steps_before_the_first_frame_are_reported(self):
        dish = {"size": [256, 256], "presteps": 3000}
        self.write("dish.json", {"version": 1, "render": {"size": [32, 32]}, "objects": {"dish": {"grayScott": dish}}})
        done = self.good("render", "dish.json", "-o", "out/", "--frames", "0", "--progress", "ndjson")
        events = [json.loads(line) for line in done.err.splitlines()]
        self.assertEqual([(e["done"], e["total"]) for e in events if e["event"] == "prepare"][-1], (3000, 3000))
        self.assertNotIn("simulate 0.0 s", events[-1]["text"])

    def test_terminal_progress_leaves_a_clean_line(self):
        done = self.good("render", "scene.json", "-o", "out/", "--progress", "tty", "-q")
        self.assertTrue(done.err.endswith("\r\x1b[K"), repr(done.err))

    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_video(self):
        self.good("render", "scene.json", "-o", "a video.mp4")
        probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames",
                                "-of", "csv=p=0", "a video.mp4"], cwd=self.folder, capture_output=True, check=True)
        self.assertEqual(int(probe.stdout), FRAMES)
        self.good("render", "scene.json", "-o", "again.mp4")
        self.assertEqual((self.folder / "a video.mp4").read_bytes(), (self.folder / "again.mp4").read_bytes())
        self.bad(6, ["a video.mp4", "exists", "--overwrite"], "render", "scene.json", "-o", "a video.mp4")
        self.good("render", "scene.json", "-o", "a video.mp4", "--skip-existing")
        self.assertEqual([p.name for p in self.folder.glob("*part*")], [])


class OddButRight(Case):
    """Tests unusual but valid input."""

    def test_unusual_file_names(self):
        scene = self.write("größe 图/scène ÿ.json", with_values({"title": "ein \"Titel\" 🏴\n"}))
        self.good("render", scene, "-o", "mit Leerzeichen 布/", "--frames", "0")
        self.assertEqual(self.assert_manifest_is_whole("mit Leerzeichen 布"), [0])
        self.good("render", "scene.json", "-o", "-D####.png", "--frames=1")
        self.assertTrue((self.folder / "-D0001.png").exists())

    def test_the_smallest_cloth_and_picture(self):
        self.write("two.json", with_values({"objects.flag.cloth.size": [2, 2], "render.size": [1, 1],
                                            "time.duration": 0}))
        self.good("render", "two.json", "-o", "out/")
        self.assertEqual(self.assert_manifest_is_whole("out"), [0])

    def test_no_objects(self):
        scene = with_values({})
        scene["objects"] = {}
        self.write("none.json", scene)
        self.good("render", "none.json", "-o", "out/", "--frames", "0")

    def test_slow_clock_and_late_start(self):
        self.good("render", "scene.json", "-o", "a/", "--fps", "0.001", "-D", "objects.flag.cloth.substeps=1024",
                  "-D", "objects.flag.cloth.stiffness=0", "-D", "objects.flag.cloth.gravity=[0,0,0]")
        self.good("render", "scene.json", "-o", "b/", "-D", "time.start=10", "--frames", "0")

    def test_overrides_of_list_items(self):
        pins = [{"corners": ["top-left"]}, {"corners": ["top-right"]}]
        self.write("pins.json", with_values({"objects.flag.cloth.pins": pins}))
        self.good("render", "pins.json", "-o", "a/", "-D", "objects.flag.cloth.pins.1.corners=[\"bottom-left\"]",
                  "-D", "render.size.0=32", "--frames", "0")
        self.assertEqual(self.manifest("a")["width"], 32)
        override = "objects.flag.cloth.pins.2.corners=[\"top-left\"]"
        done = self.bad_scene([], "render", "pins.json", "-o", "b/", "-D", override)
        self.assertEqual(done.err.splitlines(), [
            f"-D {override}: error: no item 2; the list has 2, counted from 0",
            "  " + override,
            "  " + " " * override.index("2") + "^"])

    def test_frames_beyond_the_end(self):
        self.good("render", "scene.json", "-o", "out/", "--frames", "20,3-5x2,3")
        self.assertEqual(self.assert_manifest_is_whole("out"), [3, 5, 20])

    def test_closed_standard_error(self):
        """With closed standard error the run continues, and no message is written into a file that got the
        descriptor."""
        for closing in ("2>&-", ">&-", ">&- 2>&-", "<&-"):
            script = f'exec "$0" render scene.json -o out/ --overwrite {closing}'
            done = subprocess.run(["sh", "-c", script, self.program()], cwd=self.folder, timeout=PATIENCE, check=False,
                                  capture_output=True)
            self.assertEqual(done.returncode, 0, closing)
            self.assertEqual(self.assert_manifest_is_whole("out"), list(range(FRAMES)))
        done = subprocess.run(["sh", "-c", 'exec "$0" render nothing.json -o out/ 2>&-', self.program()],
                              cwd=self.folder, timeout=PATIENCE, check=False, capture_output=True)
        self.assertEqual(done.returncode, 2)

    @staticmethod
    def program():
        from common import PROGRAM
        return PROGRAM


if __name__ == "__main__":
    main()
