"""Tests simreel bench: tables, JSON, chart, and errors. Times are not tested, except that they add up."""
import json
import signal
import subprocess
import xml.etree.ElementTree as xml

from common import PATIENCE, PROGRAM, SLOW, SOURCE, Case, main, with_values

FEW = ("--frames", "7", "--warm-up", "2")
MASS = "objects.flag.cloth.mass"


class BenchCase(Case):
    def bench(self, scene, *arguments):
        """Runs bench and returns the JSON, after checking rules that hold for every run."""
        done = self.good("bench", scene, "--json", "-", *arguments)
        result = json.loads(done.stdout)
        for row in result["rows"]:
            self.check_row(row, result)
        return result

    def check_row(self, row, result):
        self.assertEqual(row["frames"], len(row["samples"]["ms"]))
        self.assertEqual(row["samples"]["frame"], sorted(set(row["samples"]["frame"])))
        self.assertEqual(row["frame"]["most"], max(row["samples"]["ms"]))
        self.assertAlmostEqual(row["frame"]["mean"], sum(row["samples"]["ms"]) / row["frames"], 5)
        self.assertAlmostEqual(row["framesPerSecond"], 1e3 / row["frame"]["mean"], delta=1e-3 * row["framesPerSecond"])
        busy = row["processor"]["mean"] / row["frame"]["mean"] / result["processors"]
        self.assertAlmostEqual(row["processorsBusy"], busy, 4)
        self.assertTrue(0 < busy < 1.05)
        for side in ("cpu", "gpu"):
            if side == "gpu" and result["timing"] != "query":
                self.assertTrue(all(stage["gpu"] is None for stage in row["stages"]))
                continue
            # With frames in flight, a stage's time may belong to frames before the measured ones. Stages lie within
            # their frame only if the program waits for each stage.
            if result["timing"] == "wait":
                spent = sum(stage[side]["mean"] for stage in row["stages"])
                self.assertLessEqual(spent, row["frame"]["mean"] * 1.0001)
        for spread in [row["frame"]] + [stage["cpu"] for stage in row["stages"]]:
            ordered = [spread[key] for key in ("least", "p5", "median", "p95", "most")]
            self.assertEqual(ordered, sorted(ordered))
            self.assertGreaterEqual(ordered[0], 0)

    def names(self, row):
        return [stage["name"] for stage in row["stages"]]


class Bench(BenchCase):
    def test_stages_of_a_small_scene(self):
        result = self.bench("scene.json", *FEW)
        (row,) = result["rows"]
        self.assertEqual((result["bench"], result["framesAsked"], result["warmUp"], result["interrupted"]),
                         (1, 7, 2, False))
        self.assertEqual((row["name"], row["frames"], row["size"], row["set"]), ("scene", 7, [64, 36], {}))
        self.assertEqual(self.names(row), ["step flag", "state hash", "shadow", "visibility", "surfaces", "tone map", "readback"])
        self.assertTrue(row["boundBy"])
        # Frame 0 and the warm-up are not measured.
        self.assertGreaterEqual(row["samples"]["frame"][0], 3)

    def test_flag(self):
        result = self.bench(SOURCE / "assets/scenes/flag.json", "--size", "96x54", *FEW, "--rounds", "2")
        (row,) = result["rows"]
        self.assertEqual((row["name"], row["size"], row["frames"]), ("flag", [96, 54], 7))
        self.assertIn("step pole", self.names(row))
        self.assertIn("visibility", self.names(row))

    def test_rays_of_quality_high(self):
        def rays(sun, quality="high"):
            self.write("sheet.json", {"version": 1, "stage": False, "sun": {"intensity": sun},
                                      "render": {"size": [65, 37], "samples": 1, "quality": quality, "raySamples": 8},
                                      "camera": {"position": [0, 2, 0.01], "target": [0, 0, 0], "fieldOfView": 40},
                                      "objects": {"sheet": {"mesh": {"shape": "plane", "size": [50, 0, 50]}}}})
            return self.bench("sheet.json", "--frames", "1", "--warm-up", "0", "--rounds", "1")["rows"][0]["rays"]

        each = 65 * 37 * 8  # number of samples in pixels that show only the sheet
        dark = rays(0)
        self.assertGreaterEqual(dark, each)  # Each sample traces a ray into the sky, and a few trace reflections.
        self.assertLess(dark, 1.1 * each)
        self.assertEqual(rays(3), dark + each)  # Each sample also traces a ray to the sun.
        self.assertEqual(rays(3, "draft"), 0)

    def test_instances_and_bloom(self):
        self.write("stars.json", {"version": 1, "render": {"size": [64, 36], "bloom": {"strength": 0.2}},
                                  "objects": {"stars": {"particles": {"groups": [{"count": 77}]}}}})
        names = self.names(self.bench("stars.json", *FEW, "--rasterizer", "driver")["rows"][0])
        self.assertIn("instances", names)
        self.assertIn("bloom", names)
        exact = self.names(self.bench("stars.json", *FEW)["rows"][0])
        self.assertNotIn("instances", exact, "what adds no light is shaded with the surfaces")
        self.assertIn("bloom", exact)

    def test_vary(self):
        result = self.bench("scene.json", *FEW, "--vary", f"{MASS}=1,2", "--vary", "render.size=[32,18],[48,27]")
        self.assertEqual([row["name"] for row in result["rows"]],
                         ["mass=1, size=[32,18]", "mass=1, size=[48,27]", "mass=2, size=[32,18]", "mass=2, size=[48,27]"])
        self.assertEqual([row["size"] for row in result["rows"]], [[32, 18], [48, 27]] * 2)
        self.assertEqual(result["rows"][2]["set"], {MASS: "2", "render.size": "[32,18]"})
        self.assertEqual(len({row["sceneHash"] for row in result["rows"]}), 4)
        self.assertEqual({row["frames"] for row in result["rows"]}, {7})

    def test_tables_and_files(self):
        done = self.good("bench", "scene.json", *FEW, "--vary", f"{MASS}=1,2", "--json", "a.json", "--chart", "a.svg")
        lines = done.stdout.decode().splitlines()
        self.assertIn("64x36", lines[0])
        self.assertRegex(lines[1], r"^frames, ms +measured +median +5th +95th +frames/s +processors busy +"
                                   r"beyond 3 medians +bounded by$")
        self.assertRegex(lines[2], r"^mass=1 +7 ")
        self.assertRegex(lines[3], r"^mass=2 +7 ")
        self.assertTrue(any(line.startswith("stages, median ms") for line in lines))
        self.assertEqual(len(json.loads((self.folder / "a.json").read_text())["rows"]), 2)
        svg = xml.parse(self.folder / "a.svg").getroot()
        texts = [node.text for node in svg.iter("{http://www.w3.org/2000/svg}text")]
        self.assertIn("mass=2", texts)
        self.assertIn("ms", texts)
        self.assertIn("Time of a frame: scene.json", texts)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.json", "a.svg", "scene.json"])

    def test_timing_by_queries(self):
        """A software driver's queries do not measure compute shaders, but run through the same code."""
        (row,) = self.bench("scene.json", *FEW, "--timing", "query", "--chart", "a.svg")["rows"]
        self.assertIn("surfaces", self.names(row))
        self.assertTrue(all(stage["gpu"]["least"] >= 0 for stage in row["stages"]))
        self.assertGreater(sum(stage["gpu"]["mean"] for stage in row["stages"]), 0)
        texts = [node.text for node in xml.parse(self.folder / "a.svg").iter("{http://www.w3.org/2000/svg}text")]
        self.assertIn("GPU", texts)

    def test_timing_by_waiting(self):
        (row,) = self.bench("scene.json", "--frames", "40", "--timing", "wait")["rows"]
        # Minima are compared, because on a busy machine most frames may be interrupted between two stages.
        spent = sum(stage["cpu"]["least"] for stage in row["stages"])
        self.assertGreater(spent, 0.5 * row["frame"]["least"])
        self.bad(2, "--timing", "bench", "scene.json", "--timing", "guess")

    def test_timing_of_whole_frames(self):
        result = self.bench("scene.json", *FEW, "--timing", "whole")
        self.assertEqual((result["timing"], result["rows"][0]["stages"], result["rows"][0]["boundBy"]), ("whole", [], ""))
        self.good("bench", "scene.json", *FEW, "--timing", "whole", "--chart", "a.svg")
        xml.parse(self.folder / "a.svg")

    def test_more_rounds_than_frames_and_no_warm_up(self):
        (row,) = self.bench("scene.json", "--frames", "2", "--warm-up", "0", "--rounds", "9")["rows"]
        self.assertEqual(row["samples"]["frame"][0], 1)
        self.assertEqual(row["frames"], 2)

    def test_the_pre_roll_is_not_measured(self):
        """The pre-roll precedes frame 0, which is never measured."""
        self.write("late.json", with_values({"time.start": 2}))
        for timing in ("wait", "query", "whole"):
            (row,) = self.bench("late.json", "--frames", "5", "--warm-up", "0", "--timing", timing)["rows"]
            self.assertEqual(row["samples"]["frame"][0], 1)


class Mistakes(BenchCase):
    def test_counts(self):
        for flag, value in (("--frames", "0"), ("--frames", "-3"), ("--frames", "10000000"), ("--warm-up", "-1"),
                            ("--rounds", "0")):
            self.bad(2, flag, "bench", "scene.json", flag, value)
        self.bad(2, "--frames", "bench", "scene.json", "--frames", "many")

    def test_values(self):
        self.bad_scene(["-D objects.flag.cloth.nonsense=1", "unknown"], "bench", "scene.json", "--vary",
                       "objects.flag.cloth.nonsense=1,2")
        self.bad_scene("-D time.fps=no", "bench", "scene.json", "--vary", "time.fps=30,no")
        for text in ("time.fps", "=3", "time.fps=", "time.fps=30,,60"):
            self.bad(2, "--vary", "bench", "scene.json", "--vary", text)
        self.bad(2, "64 combinations", "bench", "scene.json", "--vary", "seed=" + ",".join(map(str, range(65))))

    def test_techniques(self):
        for word in ("all", "magic"):
            self.bad(2, [f"--technique {word}", "no object of this scene"], "bench", "scene.json", "--technique", word)

    def test_files_are_checked_before_anything_runs(self):
        endless = ("bench", "scene.json", "--frames", "1000000")
        self.bad(6, "nowhere/a.json", *endless, "--json", "nowhere/a.json")
        self.bad(6, "nowhere/a.svg", *endless, "--chart", "nowhere/a.svg")
        (self.folder / "folder.svg").mkdir()
        self.bad(6, "it is a folder", *endless, "--chart", "folder.svg")
        for name in ("a.png", "a", "a.svgz"):
            self.bad(2, ["--chart", ".svg"], *endless, "--chart", name)
        self.assertFalse(any(p.name.endswith(".part") for p in self.folder.iterdir()))

    def test_an_old_file_stays_when_the_run_fails(self):
        self.write("a.json", "old")
        self.bad(4, "no device matches", "bench", "scene.json", "--json", "a.json", "--device", "nonsense")
        self.assertEqual((self.folder / "a.json").read_text(), "old")

    def test_a_diverged_state_is_reported_with_its_row(self):
        self.bad(4, ["stiffness=1e7", "blew up"], "bench", "scene.json", *FEW, "-D", f"{MASS}=0.01", "--vary",
                 "objects.flag.cloth.stiffness=10,1e7")

    def test_interrupted(self):
        self.write("slow.json", with_values(SLOW))
        with open(self.folder / "out", "wb") as out, subprocess.Popen(
                [PROGRAM, "bench", "slow.json", "--frames", "100000", "--warm-up", "1", "--json", "a.json", "--progress",
                 "ndjson"], cwd=self.folder, stdout=out, stderr=subprocess.PIPE) as process:
            for line in process.stderr:
                if b'"done":4' in line:
                    break
            process.send_signal(signal.SIGINT)
            messages = process.stderr.read().decode()
            self.assertEqual(process.wait(timeout=PATIENCE), 128 + signal.SIGINT, messages)
        self.assertIn("interrupted", messages)
        self.assertIn("measured", (self.folder / "out").read_text())
        result = json.loads((self.folder / "a.json").read_text())
        self.assertTrue(result["interrupted"])
        self.assertGreaterEqual(result["rows"][0]["frames"], 2)
        self.assertLess(result["rows"][0]["frames"], 100000)


if __name__ == "__main__":
    main()
