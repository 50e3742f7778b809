"""Tests `simreel test` in several processes and on several machines: --jobs, --shard, `simreel report merge`, and
accepting merged results."""
import json
import os
import pathlib
import re
import shutil
import signal

from common import PATIENCE, SLOW, main
from golden_common import HAIR, RED, TESTED, GoldenCase, with_values

# A scene that would take hours.
LONG = with_values({**SLOW, "time.duration": 3000, "test": {"frames": [89999], "size": [64, 36], "samples": 1}}, TESTED)
TIMES = re.compile(rb'"(seconds|simulateSeconds)": ?[0-9.e+-]+|"(command|acceptCommand)": ?"[^"]*"')


def alive(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Several(GoldenCase):
    """Base class with four equal scenes that no test run modifies."""
    made = {}  # Baselines of one scene, which are made once for all tests.

    def setUp(self):
        super().setUp()
        for name in ("b", "c", "d"):
            self.set_scene({}, name)

    def make_baselines(self):
        if not self.made:
            self.good("test", "scenes/a.json", "--update")
            self.made.update(self.tree("scenes/golden/a"))
        for name in "abcd":
            for path, content in self.made.items():
                self.write(f"scenes/golden/{name}/{path}", content)

    def same_but_times(self, one, other):
        """Compares two report folders. index.html is compared only through report.json, because it contains report.json
        compressed, with times and commands."""
        def told(name):
            # PNG files are excluded, because their bytes may contain the folder's name by chance.
            return {path: content if path.endswith(".png") else TIMES.sub(b"", content.replace(name.encode(), b"R"))
                    for path, content in self.tree(name).items()}
        one, other = told(one), told(other)
        self.assertEqual(sorted(one), sorted(other))
        # Names are compared instead of bytes, because printing a difference of bytes would take minutes.
        self.assertEqual([name for name in one if one[name] != other[name] and name != "index.html"], [])

    def workers_of(self, process):
        return [int(word) for word in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]

    def wait_for_the_last(self, process):
        """Waits until the program has seen a worker end, and returns the remaining worker."""
        def only():
            found = self.workers_of(process)
            # The kernel counts page faults of children after the parent has waited for them.
            ended = int(pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[8])
            return found if len(found) == 1 and ended > 0 else None
        found = self.wait_until(only, process)
        self.assertTrue(found, process.poll())
        return found


class Jobs(Several):
    def test_reports_do_not_depend_on_the_number_of_jobs(self):
        """Covers scenes that pass, fail, are missing or invalid, and baselines without a scene."""
        self.make_baselines()
        self.set_scene(RED, "b")
        self.set_scene({"checks": [{"what": "mass", "max": 0.001}]}, "d")
        self.write("scenes/e.json", "no json")
        self.write("scenes/f.json", TESTED)
        (self.folder / "scenes/c.json").unlink()
        self.assertEqual(self.run_program("test", "scenes", "--jobs", "auto", "--filter", "[ab]").returncode, 1)
        for jobs in ("1", "3"):
            done = self.run_program("test", "scenes", "--report", f"r{jobs}", "--junit", f"r{jobs}/j.xml", "--jobs", jobs,
                                    "--repeat", "1")
            self.assertEqual(done.returncode, 1, done.err)
            (self.folder / f"r{jobs}/out").write_bytes(re.sub(rb"[0-9.]+ s\b", b"", done.stdout))
            xml = self.folder / f"r{jobs}/j.xml"
            xml.write_bytes(re.sub(rb' time="[0-9.]+"', b"", xml.read_bytes()))
        report = json.loads((self.folder / "r3/report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["status"] for s in report["scenes"]], ["pass", "fail", "fail", "error", "missing"])
        self.assertIn("c", report["stale"][0]["path"])
        self.same_but_times("r1", "r3")

    def test_baselines_do_not_depend_on_the_number_of_jobs(self):
        self.set_scene(RED, "b")
        self.good("test", "scenes", "--update", "--repeat", "1", "--jobs", "1")
        one = self.tree("scenes/golden")
        shutil.rmtree(self.golden())
        self.good("test", "scenes", "--update", "--repeat", "1", "--jobs", "4")
        self.assertEqual(self.tree("scenes/golden"), one)
        # Two new scenes look like a removed one. The first of them in order must take its baseline, regardless of which
        # finishes first.
        (self.folder / "scenes/b.json").unlink()
        for name in ("m", "n", "o"):
            self.set_scene(RED, name)
        self.good("test", "scenes", "--update", "--jobs", "4", "--json", "report.json")
        report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["name"] for s in report["scenes"] if any("moved" in n for n in s["notes"])], ["m"])

    def test_a_killed_worker_loses_only_its_scene(self):
        self.make_baselines()
        self.write("scenes/b.json", LONG)
        process = self.start("test", "scenes", "--jobs", "2", "--report", "r", "--repeat", "1")
        for worker in self.wait_for_the_last(process):  # The remaining worker has the long scene.
            os.kill(worker, signal.SIGKILL)
        process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 4)
        report = json.loads((self.folder / "r/report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["status"] for s in report["scenes"]], ["pass", "error", "pass", "pass"])
        self.assertIn("was ended by signal 9", report["scenes"][1]["messages"][0])
        self.assertIn("simreel test scenes/b.json", report["scenes"][1]["messages"][0])

    def test_a_scene_whose_worker_was_killed_is_tried_again(self):
        self.make_baselines()
        self.write("scenes/b.json", LONG)
        process = self.start("test", "scenes", "--jobs", "2", "--report", "r", "--repeat", "1", "--retries", "1")
        first = self.wait_for_the_last(process)
        # The second attempt runs a scene that passes.
        self.set_scene({}, "b")
        os.kill(first[0], signal.SIGKILL)
        process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 1)
        report = json.loads((self.folder / "r/report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["status"] for s in report["scenes"]], ["pass", "flaky", "pass", "pass"])
        tried = report["scenes"][1]
        self.assertEqual([attempt["status"] for attempt in tried["attempts"]], ["error"])
        self.assertIn("was ended by signal 9", tried["attempts"][0]["messages"][0])
        self.assertRegex(tried["messages"][0], "^passed on try 2; before that: .*signal 9")

    def test_a_scene_that_takes_too_long_is_ended(self):
        """Only the timeout is tested here; `unit: base/workers` tests with fast processes that other workers
        continue."""
        self.write("scenes/b.json", LONG)
        done = self.run_program("test", "scenes/b.json", "--report", "r", "--repeat", "1", "--timeout", "2")
        self.assertEqual(done.returncode, 4, done.err)
        report = json.loads((self.folder / "r/report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["status"] for s in report["scenes"]], ["error"])
        self.assertEqual(report["scenes"][0]["messages"], ["the process that tested it took longer than 2 s, and was ended "
                                                           "(--timeout). Run it alone: simreel test scenes/b.json"])

    def test_an_interrupt_keeps_finished_scenes(self):
        self.make_baselines()
        self.write("scenes/a.json", LONG)
        process = self.start("test", "scenes", "--jobs", "2", "--report", "r", "--repeat", "1")
        workers = self.wait_for_the_last(process)
        process.send_signal(signal.SIGINT)
        messages = process.communicate(timeout=PATIENCE)[1].decode()
        self.assertEqual(process.returncode, 130, messages)
        self.assertIn("interrupted after 3 of 4 scenes", messages)
        report = json.loads((self.folder / "r/report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["name"] for s in report["scenes"]], ["b", "c", "d"])
        self.assertFalse(any(map(alive, workers)))

    def test_no_worker_outlives_the_program(self):
        for name in "ab":
            self.write(f"scenes/{name}.json", LONG)
        process = self.start("test", "scenes/a.json", "scenes/b.json", "--jobs", "2")
        self.wait_until(lambda: len(self.workers_of(process)) == 2, process)
        workers = self.workers_of(process)
        process.kill()
        process.communicate(timeout=PATIENCE)
        self.wait_until(lambda: not any(map(alive, workers)))

    def test_bad_input(self):
        for jobs in ("0", "-1", "257", "two", "1.5", "1e9", " 1"):
            self.bad(2, "--jobs takes a number from 1 to 256, or auto", "test", "scenes", f"--jobs={jobs}")
        self.bad(4, "--device", "test", "scenes", "--jobs", "2", "--device", "nobody's")
        self.bad(2, "--timeout", "test", "scenes", "--timeout", "0")
        self.bad(2, "--timeout", "test", "--expected", "scenes", "--actual", "scenes/golden", "--timeout", "9")

    def test_commands_run_at_once(self):
        """Each command waits for a file of the other, so the test only ends if both run at once."""
        for name in ("x", "y"):
            self.write(f"in/{name}.txt", name)
        command = ("cp scenes/golden/a/any/000000.png {output}; touch here-$(basename {scene}); "
                   "for i in $(seq 20000); do [ $(ls here-* | wc -l) = 2 ] && exit 0; sleep 0.05; done; exit 1")
        self.make_baselines()
        self.good("test", "--expected", "baselines", "--run", command, "in", "--jobs", "2", "--update")
        self.assertEqual(sorted(self.tree("baselines")), ["x.png", "y.png"])


class Shards(Several):
    def run_shards(self, count, code=None, *arguments):
        for k in range(1, count + 1):
            done = self.run_program("test", "scenes", "--shard", f"{k}/{count}", "--report", f"part{k}", *arguments)
            if code is not None:
                self.assertEqual(done.returncode, code, done.err)
        return [f"part{k}" for k in range(1, count + 1)]

    def report(self, folder):
        return json.loads((self.folder / folder / "report.json").read_text(encoding="utf-8"))

    def test_a_merged_report_equals_one_run(self):
        self.make_baselines()
        self.set_scene(RED, "b")
        self.set_scene(HAIR, "c")
        (self.folder / "scenes/d.json").rename(self.folder / "scenes/e.json")
        whole = self.run_program("test", "scenes", "--report", "whole")
        parts = self.run_shards(2)
        self.assertEqual(self.report("part1")["shard"], "1/2")
        self.assertEqual(self.report("part1")["notes"], ["shard 1/2: 2 of 4 scenes"])
        done = self.run_program("report", "merge", *parts, "-o", "all", "--junit", "all/j.xml", "--markdown", "all/s.md")
        self.assertEqual((whole.returncode, done.returncode), (1, 1), done.err)
        one, merged = self.report("whole"), self.report("all")
        self.assertEqual(merged.pop("notes"), ["merged from 2 reports"])
        for report in (one, merged):
            for key in ("seconds", "command", "acceptCommand", "shard"):
                report.pop(key)
            for scene in report["scenes"]:
                scene.pop("seconds"), scene.pop("simulateSeconds")
        one.pop("notes")
        self.assertEqual(one, merged)
        self.assertEqual(self.tree("whole/files"), self.tree("all/files"))
        self.assertIn(b'tests="4"', (self.folder / "all/j.xml").read_bytes())
        self.assertIn("files/b/", (self.folder / "all/s.md").read_text(encoding="utf-8"))
        self.good("accept", "all/report.json", "--only", "[bc]")
        report, _ = self.run_suite(3)
        self.assertEqual([s["status"] for s in report["scenes"]], ["pass", "pass", "pass", "missing"])

    def test_a_shard_without_scenes_and_one_without_a_report(self):
        self.make_baselines()
        parts = self.run_shards(6, 0)
        self.assertEqual(self.report("part6")["notes"], ["shard 6/6: 0 of 4 scenes"])
        self.good("report", "merge", *parts, "-o", "all")
        self.assertEqual(len(self.report("all")["scenes"]), 4)
        done = self.run_program("report", "merge", *parts[:2], *parts[3:], "-o", "less")
        self.assertEqual(done.returncode, 5, done.err)
        self.assertIn("there is no report of shard 3/6", done.stdout.decode())

    def test_reports_that_do_not_belong_together_are_refused(self):
        self.make_baselines()
        self.set_scene(RED, "b")
        one, two = self.run_shards(2)
        merge = lambda code, words, *parts, to="all": self.bad(code, words, "report", "merge", *parts, "-o", to)
        merge(2, "part1/report.json are both of shard 1/2", one, two, "part1/report.json")
        self.good("test", "scenes/a.json", "--report", "a")
        merge(2, ["a is in part1/report.json and in a/report.json", "give each scene once"], one, two, "a")
        merge(2, "holds part1", one, two, to="part1")
        merge(2, "holds part1/report.json", "part1/report.json", two, to=".")
        merge(2, "nowhere", one, "nowhere")
        merge(2, "is not empty and holds no report", one, two, to="scenes")
        self.write("other/report.json", "{}")
        merge(2, "other/report.json", one, "other")
        (self.folder / "older").mkdir()
        text = (self.folder / "part1/report.json").read_text(encoding="utf-8")
        self.write("older/report.json", text.replace('"format": 5', '"format": 4'))
        merge(2, ["older/report.json: format must be 5", "run simreel test again"], "older", two)
        self.write("older/report.json", text.replace('"simreel": "', '"simreel": "9.'))
        merge(2, ["do not belong together", "version"], "older", two)
        self.write("older/report.json", text[:100])
        merge(2, "older/report.json", "older", two)
        shutil.copytree(self.folder / "part2", self.folder / "torn")
        shutil.rmtree(self.folder / "torn/files")
        done = self.run_program("report", "merge", one, "torn", "-o", "all")
        self.assertEqual(done.returncode, 1, done.err)
        self.assertIn("torn/files/b/candidate of b is missing", done.stdout.decode())
        self.bad(1, "b: ", "accept", "all")
        self.assertFalse((self.folder / "part1/all").exists())

    def test_links_are_not_followed(self):
        self.make_baselines()
        self.set_scene(RED, "b")
        one, two = self.run_shards(2)
        picture = next((self.folder / "part2/files/b").rglob("*.actual.png"), None) or \
            next((self.folder / "part2/files/b").rglob("*.expected.png"))
        picture.unlink()
        picture.symlink_to("/etc/passwd")
        self.run_program("report", "merge", one, two, "-o", "all")
        self.assertNotIn(pathlib.Path("/etc/passwd").read_bytes(), self.tree("all").values())

    def test_pictures_are_tested_in_shards(self):
        self.make_baselines()
        for name in ("x", "y", "z"):
            source = self.golden("a/any/000000.png" if name != "y" else "a/any/000005.png")
            shutil.copy(source, self.write(f"new/{name}.png", b""))
            shutil.copy(self.golden("a/any/000000.png"), self.write(f"old/{name}.png", b""))
        shutil.copy(self.golden("a/any/000003.png"), self.write("old/gone.png", b""))
        given = ["test", "--expected", "old", "--actual", "new"]
        whole = self.run_program(*given, "--json", "whole.json")
        codes = [self.run_program(*given, "--shard", f"{k}/5", "--report", f"part{k}").returncode for k in range(1, 6)]
        self.assertEqual((whole.returncode, codes), (1, [1, 0, 1, 0, 0]))
        self.run_program("report", "merge", *(f"part{k}" for k in range(1, 6)), "-o", "all")
        names = [(s["name"], s["status"]) for s in self.report("all")["scenes"]]
        self.assertEqual(names, [("gone.png", "fail"), ("x.png", "pass"), ("y.png", "fail"), ("z.png", "pass")])
        self.good("accept", "all", "--only", "y.png")
        self.assertEqual(self.run_program(*given, "--shard", "3/5").returncode, 0)
        self.bad(2, "--update=prune", *given, "--shard", "1/2", "--update=prune")
        self.bad(2, "--update=prune", "test", "scenes", "--shard", "1/2", "--update=prune")


class Accepting(Several):
    def test_accept_refuses_a_scene_changed_after_the_run(self):
        self.make_baselines()
        self.set_scene(RED, "b")
        self.run_suite(1, "--filter", "b")
        before = self.tree("scenes/golden")
        kept = (self.folder / "scenes/b.json").read_bytes()
        self.set_scene(HAIR, "b")
        self.bad(1, ["b: scenes/b.json has changed since that run", "run the test again"], "accept", "report.json")
        (self.folder / "scenes/b.json").write_bytes(kept)
        self.write("scenes/b.test.json", {"test": {"frames": [0, 3, 5], "size": [64, 36], "samples": 1}})
        self.bad(1, "b: scenes/b.test.json has come since that run", "accept", "report.json")
        (self.folder / "scenes/b.test.json").unlink()
        self.assertEqual(self.tree("scenes/golden"), before)
        self.edit_json(self.folder / "report.json", lambda report: report["scenes"][0].update(inputs={}))
        self.bad(1, "has no hash of scenes/b.json", "accept", "report.json")
        self.run_suite(1, "--filter", "b")
        self.good("accept", "report.json")

    def test_accept_refuses_an_input_changed_after_the_run(self):
        picture = self.golden("a/any/000000.png")
        self.make_baselines()
        shutil.copy(picture, self.folder / "scenes/cloth.png")
        self.set_scene({"objects.flag.material": {"texture": "cloth.png"}}, "b")
        self.run_suite(1, "--filter", "b")
        shutil.copy(self.golden("a/any/000005.png"), self.folder / "scenes/cloth.png")
        self.bad(1, "b: scenes/cloth.png has changed since that run", "accept", "report.json")
        (self.folder / "scenes/cloth.png").unlink()
        self.bad(1, "b: scenes/cloth.png is gone since that run", "accept", "report.json")
        shutil.copy(picture, self.folder / "scenes/cloth.png")
        self.good("accept", "report.json")

    def test_accept_refuses_a_changed_source_of_a_picture(self):
        self.make_baselines()
        self.write("in/x.txt", "scenes/golden/a/any/000000.png")
        given = ["test", "--expected", "old", "--run", "cp $(cat {scene}) {output}", "in", "--report", "r"]
        self.good(*given, "--update")
        self.write("in/x.txt", "scenes/golden/a/any/000005.png")
        self.assertEqual(self.run_program(*given).returncode, 1)
        self.write("in/x.txt", "scenes/golden/a/any/000003.png")
        self.bad(1, "in/x.txt has changed since that run", "accept", "r")

    def test_two_runs_at_once(self):
        """One run may stop with an error because the other writes the same baselines: every file stays complete, and a
        further run repairs the rest."""
        both = [self.start("test", "scenes/a.json", "scenes/b.json", "--repeat", "1", "--update", "--jobs", "2", "--report", f"r{i}") for i in range(2)]
        for process in both:
            self.assertIn(process.wait(timeout=PATIENCE), (0, 6))
        self.good("test", "scenes/a.json", "scenes/b.json", "--repeat", "1", "--update")
        both = [self.start("test", "scenes/a.json", "scenes/b.json", "--repeat", "1", "--jobs", "2", "--report", f"r{i}") for i in range(2)]
        self.assertEqual([process.wait(timeout=PATIENCE) for process in both], [0, 0])


if __name__ == "__main__":
    main()
