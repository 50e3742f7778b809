"""Tests simreel sweep: plan, jobs, the states of jobs, and collected results."""
import contextlib
import csv
import json
import os
import pathlib
import shutil
import signal
import tempfile

from common import PATIENCE, SLOW, Case, main, png_rows, with_values

DISH = {"version": 1, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.1},
        "objects": {"dish": {"grayScott": {"size": [48, 48], "steps": 20}},
                    "town": {"epidemic": {"size": [32, 24], "infected": 0.1, "display": {"layer": "behind"}}}},
        "checks": [{"what": "no-nan"}, {"what": "meanV", "frames": [1, 2], "max": 0.325}, {"what": "not-blank", "frames": [1, 2]}]}
FEED, KILL = "objects.dish.grayScott.feed", "objects.dish.grayScott.kill"


class Sweep(Case):
    def setUp(self):
        super().setUp()
        self.write("dish.json", DISH)

    def status(self, code):
        done = self.run_program("sweep", "status", "sw")
        self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout.decode().splitlines()

    def result(self, job):
        return json.loads((self.folder / f"sw/jobs/{job:04}/result.json").read_text())

    def test_jobs_queued_on_a_cluster_are_counted(self):
        """Uses a stub of squeue: a plan with several submissions, one with an offset; jobs of other users; no
        answer."""
        self.good("sweep", "dish.json", "--vary", f"{FEED}=0.02:0.04:0.01", "-o", "sw/", "--plan-only")
        self.write("sw/slurm/submitted.txt", "shared 11 0\nsweep 12 0\nsweep 13 2\n")
        self.write("bin/squeue", "#!/bin/sh\nprintf '%s\\n' 11 12_1 13_0 12_7 14_0 112_0 12_x\n")
        (self.folder / "bin/squeue").chmod(0o755)
        path = {"PATH": f"{self.folder}/bin:{os.environ['PATH']}"}
        done = self.run_program("sweep", "status", "sw", env=path)
        self.assertEqual((done.returncode, done.stdout.decode().splitlines()), (7, [
            "0000  missing  feed=0.02", "0001  queued   feed=0.03", "0002  queued   feed=0.04", "3 jobs: 0 done, 2 queued, 1 missing"]))
        self.good("sweep", "job", "sw", "1", "0")
        done = self.run_program("sweep", "status", "sw", env=path)
        self.assertEqual((done.returncode, done.stdout.decode().splitlines()[-1]), (7, "3 jobs: 2 done, 1 queued"))
        done = self.run_program("sweep", "status", "sw", env={"PATH": "/nowhere"})
        self.assertEqual((done.returncode, done.stdout.decode().splitlines()[-1]), (3, "3 jobs: 2 done, 1 missing"))
        self.assertIn("squeue failed (No such file or directory)", done.err)
        # Local runs do not wait for the cluster.
        self.good("sweep", "retry", "sw", env=path)
        self.assertEqual(self.status(0), ["3 jobs: 3 done"])

    def test_the_last_frame_of_each_job(self):
        # This test takes 2 s.
        self.good("sweep", "dish.json", "--vary", "time.duration=0.1,0.2", "-o", "sw/", "--frames", "last")
        self.assertEqual([sorted(file.name for file in (self.folder / f"sw/jobs/000{job}").rglob("*.png")) for job in (0, 1)], [["000002.png"], ["000005.png"]])

    def test_from_plan_to_page(self):
        vary = ("--vary", f"{FEED}=0.02:0.04:0.01", "--vary", f"{KILL}=0.055,0.06")
        self.good("sweep", "dish.json", *vary, "-o", "sw/", "--plan-only")
        self.assertEqual(self.status(3), [f"{i:04}  missing  feed={f} kill={k}" for i, (f, k) in enumerate(
            (f, k) for f in ("0.02", "0.03", "0.04") for k in ("0.055", "0.06"))] + ["6 jobs: 0 done, 6 missing"])
        # Jobs 5 and 2 run one by one, as an external scheduler would run them.
        self.good("sweep", "job", "sw", "5", "2")
        # Jobs 2 and 5 pass the scene's check, so the status mentions no failed checks.
        self.assertEqual(self.status(3)[-1], "6 jobs: 2 done, 4 missing")
        done = self.run_program("sweep", "dish.json", *vary, "-o", "sw/", "--jobs", "2", "--progress", "ndjson")
        # A check fails for a pattern that has grown a lot. The pictures are written nevertheless.
        self.assertEqual(done.returncode, 1, done.err)
        events = [json.loads(line) for line in done.err.splitlines()]
        self.assertEqual(sorted(e["job"] for e in events if e["event"] == "job"), ["0000", "0001", "0003", "0004"])
        self.assertEqual(len([e for e in events if e["event"] == "check" and e["job"] == "0000"]), 3 + 2 + 2)
        self.assertEqual([e["town.infected"] > 0 for e in events if e["event"] == "counts" and e["job"] == "0000"], [True] * 3)
        lines = self.status(1)
        self.assertRegex(lines[-1], r"^6 jobs: 6 done \(\d with failed checks\)$")
        self.assertIn("meanV of dish is 0.3", lines[0])
        # A job must equal a render with the job's values.
        self.good("render", "dish.json", "-o", "alone/", "-D", f"{FEED}=0.04", "-D", f"{KILL}=0.055")
        job, alone = self.content("sw/jobs/0004"), self.content("alone")
        self.assertEqual({name: job[name] for name in alone}, alone)
        self.assertEqual(sorted(set(job) - set(alone)), ["job.json", "result.json"])
        self.assertEqual(json.loads(job["job.json"])["values"], {FEED: "0.04", KILL: "0.055"})

        done = self.run_program("sweep", "collect", "sw")
        self.assertEqual(done.returncode, 1)
        rows = list(csv.DictReader((self.folder / "sw/table.csv").read_text().splitlines()))
        self.assertEqual([(row[FEED], row[KILL], row["state"]) for row in rows[:3]],
                         [("0.02", "0.055", "done"), ("0.02", "0.06", "done"), ("0.03", "0.055", "done")])
        last = {q["what"]: q["value"] for q in self.result(3)["quantities"]}
        self.assertEqual(float(rows[3]["meanU of dish"]), last["meanU of dish"])
        self.assertEqual(rows[3]["town.infected"], dict(self.result(3)["counts"])["town.infected"])
        self.assertEqual({row["passed meanV of dish"] for row in rows}, {"yes", "no"})
        counts = (self.folder / "sw/counts.csv").read_text().splitlines()
        one = job["counts.csv"].decode().splitlines()
        self.assertEqual(counts[0], "job," + one[0])
        self.assertEqual([c[5:] for c in counts if c.startswith("0004,")], one[1:])
        width, height, _ = png_rows((self.folder / "sw/sheet.png").read_bytes())
        self.assertTrue(width > 2 * 64 and height > 3 * 36, (width, height))
        done = self.run_program("sweep", "collect", "sw", "--frames", "0-1", "-o", "side_####.png")
        self.assertEqual(done.returncode, 1)
        self.assertEqual((self.folder / "side_0001.png").read_bytes()[16:24], (self.folder / "sw/sheet.png").read_bytes()[16:24])
        self.assertNotEqual(png_rows((self.folder / "side_0000.png").read_bytes()), png_rows((self.folder / "side_0001.png").read_bytes()))
        self.bad(2, "have no frame 3", "sweep", "collect", "sw", "--frames", "0-9", "-o", "side_####.png")
        self.bad(2, "need each other", "sweep", "collect", "sw", "--frames", "0")
        sheet = (self.folder / "sw/sheet.png").read_bytes()
        self.bad(2, "--frame 77: no job of sw has this frame; jobs 0000, 0001, 0002, 0003, 0004, 0005 have frames 0 to 2", "sweep", "collect", "sw", "--frame", "77")
        self.assertEqual((self.folder / "sw/sheet.png").read_bytes(), sheet)
        page = (self.folder / "sw/index.html").read_text()
        data = json.loads(page.split('id="data">')[1].split("</script>")[0])
        self.assertEqual([j["values"] for j in data["jobs"][:2]], [["0.02", "0.055"], ["0.02", "0.06"]])
        self.assertTrue(all(j["picture"].startswith("data:image/png;base64,") for j in data["jobs"]))
        self.assertTrue(all((self.folder / "sw" / j["file"]).exists() for j in data["jobs"]))
        self.assertNotIn("http", page.replace("http-equiv", ""))

    def test_one_camera_frames_the_objects_of_all_jobs(self):
        ball = {"version": 1, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.03},
                "objects": {"b": {"sphere": {}}}}
        def cameras(scene, *vary):
            self.write("ball.json", scene)
            self.good("sweep", "ball.json", *vary, "-o", "sw/", "--plan-only", "--overwrite")
            return dict(change.split("=", 1) for change in json.loads((self.folder / "sw/plan.json").read_text())["overrides"])
        radii = ("--vary", "objects.b.sphere.radius=0.5,1,2")
        shared = cameras(ball, *radii)
        self.assertIn("camera.position", shared)
        self.assertEqual(shared["camera.position"], cameras(ball, "--vary", "objects.b.sphere.radius=2,1,0.5")["camera.position"])
        self.assertNotEqual(shared["camera.position"], cameras(ball, "--vary", "objects.b.sphere.radius=0.5,1")["camera.position"])
        placed = {**ball, "camera": {"position": [0, 1, 5], "target": [0, 0, 0]}}
        self.assertEqual(cameras(placed, *radii), {})
        self.assertEqual(cameras(ball, "--vary", "camera.fieldOfView=20,40"), {})
        # All jobs use the camera that the largest ball has on its own.
        self.assertIn(shared["camera.position"], self.good("explain", "ball.json", "-D", "objects.b.sphere.radius=2", "camera.position").stdout.decode())

    def test_failed_aborted_and_missing(self):
        self.write("slow.json", with_values(SLOW | {"time.duration": 3000}))  # A scene that would take hours to render.
        self.good("sweep", "slow.json", "--vary", "objects.flag.cloth.air.velocity=[1,0,0],[2,0,0],[3,0,0]", "-o", "sw/", "--plan-only",
                  "--frames", "0-89999")
        # The first job cannot be written. The second is interrupted, and the third has not started.
        self.write("sw/jobs", "a file")
        self.bad(6, "sw/jobs/0000", "sweep", "job", "sw", "0")
        (self.folder / "sw/jobs").unlink()
        self.write("sw/jobs/0000/000000.png", {"no": "picture"})
        (self.folder / "sw/jobs/0000/result.json").write_text(json.dumps(
            {"format": "simreel-job", "version": 1, "hash": json.loads((self.folder / "sw/plan.json").read_text())["jobs"][0]["hash"],
             "code": 6, "message": "No space left", "frames": 0, "checks": [], "quantities": [], "counts": []}))
        code, _ = self.signal_after(3, "sw/jobs/0001", signal.SIGTERM, "sweep", "job", "sw", "1")
        self.assertEqual(code, 128 + signal.SIGTERM)
        self.assertTrue((self.folder / "sw/jobs/0001/checkpoint").exists())
        lines = self.status(1)
        self.assertEqual([line.split()[1] for line in lines[:3]], ["failed", "aborted", "missing"])
        self.assertIn("No space left", lines[0])
        process = self.start("sweep", "job", "sw", "1")
        self.wait_until(lambda: "running" in "".join(self.status(1)), process)
        self.assertEqual(self.status(1)[-1], "3 jobs: 0 done, 1 failed, 1 running, 1 missing")
        process.kill()
        process.communicate()
        (self.folder / "sw/jobs/0000/result.json").unlink()
        self.assertEqual(self.status(7)[-1], "3 jobs: 0 done, 1 aborted, 2 missing")

    def test_an_interrupted_and_retried_job_equals_an_undisturbed_one(self):
        """Also compares the results of checks made before the interrupt."""
        scene = with_values(SLOW | {"time.duration": 0.7})
        scene["checks"] = [{"what": "energy", "frames": [1, 2, 18], "drift": 9}, {"what": "not-blank", "frames": [1, 20]}]
        scene["test"] = {"frames": [1, 20]}
        self.write("slow.json", scene)
        sweep = ("sweep", "slow.json", "--vary", "objects.flag.cloth.air.velocity=[1,0,0]", "-o")
        code, messages = self.signal_when(lambda: len(list(self.folder.glob("sw/jobs/0000/*.png"))) >= 5, "sw", signal.SIGINT, *sweep, "sw/")
        self.assertEqual(code, 130, messages)
        self.assertIn("sweep retry", messages)
        self.assertEqual(self.status(7)[-1], "1 job: 0 done, 1 aborted")
        self.good("sweep", "retry", "sw")
        self.good(*sweep, "whole/")
        self.assertEqual(self.content("sw/jobs/0000"), self.content("whole/jobs/0000"))
        self.assertEqual([c["frame"] for c in self.result(0)["checks"]], [1, 1, 2, 18, 20])

    def test_a_killed_process_loses_only_its_job(self):
        self.write("slow.json", with_values(SLOW | {"time.duration": 0.5}))
        for _ in range(20):  # Repeats until the run is still active when the signal arrives.
            process = self.start("sweep", "slow.json", "--vary", "seed=1,2", "-o", "sw/", "--overwrite")
            self.wait_until((self.folder / "sw/jobs/0000/run.json").exists, process)
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.runs("sw/jobs/0000")[0]["process"], signal.SIGKILL)
            process.communicate(timeout=PATIENCE)
            if process.returncode != 0 and "failed" in self.run_program("sweep", "status", "sw").stdout.decode().split("\n")[0]:
                break
            shutil.rmtree(self.folder / "sw")
        self.assertEqual(process.returncode, 1)
        self.assertIn("failed", self.status(1)[0])
        self.assertIn("signal 9", self.status(1)[0])
        self.good("sweep", "retry", "sw")
        self.assertEqual(self.status(0), ["2 jobs: 2 done"])

    def test_shared_work_is_done_once(self):
        """Pre-roll, presteps and counts are independent of the varied values, so they run only once."""
        scene = with_values({"time.start": 0.5, "objects.dish.grayScott.presteps": 300}, DISH)
        self.write("dish.json", scene)
        vary = ("--vary", "camera.roll=0,10", "--vary", "render.exposure=0,1")
        begins = "beginning at frame 0 of sw/shared/checkpoint.000000"
        done = self.run_program("-v", "sweep", "dish.json", *vary, "-o", "sw/")
        self.assertEqual(done.err.count(begins), 4, done.err)
        self.assertEqual(sorted(self.content("sw/shared")), ["checkpoint.000000"])
        self.good("render", "dish.json", "-o", "alone/", "-D", "camera.roll=10", "-D", "render.exposure=0")
        job, alone = self.content("sw/jobs/0002"), self.content("alone")
        self.assertEqual({name: job[name] for name in alone}, alone)
        # A damaged shared state is made again, or the jobs run without it. The shared state of an outdated plan is
        # removed together with the plan's jobs.
        state = self.folder / "sw/shared/checkpoint.000000"
        whole = state.read_bytes()
        (self.folder / "sw/jobs/0002/000001.png").unlink()
        state.write_bytes(whole[:-9])
        self.assertIn("simulating from the start", self.run_program("sweep", "job", "sw", "2").err)
        (self.folder / "sw/jobs/0002/result.json").unlink()
        (self.folder / "sw/jobs/0003/result.json").unlink()
        self.assertNotIn("simulating from the start", self.run_program("sweep", "retry", "sw").err)
        self.assertEqual(state.read_bytes(), whole)
        self.assertEqual(self.content("sw/jobs/0002"), job)
        self.write("dish.json", scene | {"seed": 5})
        again = ("sweep", "dish.json", "--vary", "camera.roll=0,10", "-o", "sw/")
        self.bad(6, "another sweep", *again)
        self.assertEqual(self.run_program("-v", *again, "--overwrite").err.count(begins), 2)
        self.assertNotEqual(state.read_bytes(), whole)
        self.assertEqual(sorted(p.name for p in (self.folder / "sw/jobs").iterdir()), ["0000", "0001"])
        # The varied value affects the simulation, so no state is shared.
        self.run_program("sweep", "dish.json", *vary, "--vary", f"{FEED}=0.03,0.04", "-o", "other/", "--plan-only")
        self.assertIsNone(json.loads((self.folder / "other/plan.json").read_text())["sharedFrame"])

    def test_scratch(self):
        """Uses another file system if available. A job that is drawn there counts as running."""
        disk = tempfile.mkdtemp(prefix="simreel-node-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
        self.addCleanup(shutil.rmtree, disk, True)
        scratch = ("--scratch", "$NODE/disk")
        env = os.environ | {"NODE": disk}
        self.write("slow.json", with_values(SLOW | {"time.duration": 0.5}))
        sweep = ("sweep", "slow.json", "--vary", "seed=1")
        self.good(*sweep, "-o", "sw/", "--plan-only")
        self.write("sw/jobs/0000/mine.txt", "kept")
        self.bad(6, ["sw/jobs/0000 contains files that do not belong to a job"], "sweep", "job", "sw", "0")
        self.assertEqual(list(self.content("sw/jobs/0000")), ["mine.txt"])
        (self.folder / "sw/jobs/0000/mine.txt").unlink()
        drawn = pathlib.Path(disk) / "disk"
        for _ in range(20):  # Repeats until the job is still active when it is stopped.
            process = self.start("sweep", "job", "sw", "0", *scratch, env=env)
            self.wait_until(lambda: list(drawn.glob("*/*.png")), process)
            process.send_signal(signal.SIGSTOP)
            if process.poll() is None:
                break
            shutil.rmtree(self.folder / "sw/jobs/0000")
        self.assertEqual(self.status(7)[-1], "1 job: 0 done, 1 running")
        self.bad(6, "is in use by another simreel process", "sweep", "job", "sw", "0")
        self.bad(6, "sw/jobs/0000 is in use", *sweep, "-o", "sw/", "--frames", "1", "--overwrite")
        process.kill()
        process.communicate()
        self.assertEqual(len(left := list(drawn.iterdir())), 1)  # The next attempt removes the remaining files.
        # An interrupted job copies its state back. After the state has been used, it is removed from both folders.
        self.signal_when(lambda: [file for own in drawn.iterdir() if own not in left for file in own.glob("*.png")], "sw/jobs/0000",
                         signal.SIGTERM, "sweep", "job", "sw", "0", *scratch, env=env)
        self.assertTrue((self.folder / "sw/jobs/0000/checkpoint").exists())
        self.write("sw/jobs/0000/mine.txt", "kept")
        self.good("sweep", "retry", "sw", *scratch, env=env)
        self.good(*sweep, "-o", "plain/")
        job = self.content("sw/jobs/0000")
        self.assertEqual(job.pop("mine.txt"), b"kept")
        self.assertEqual(job, self.content("plain/jobs/0000"))
        self.assertEqual(list(drawn.iterdir()), [])
        self.bad(2, "$NOWHERE is not set", *sweep, "-o", "sw2/", "--scratch", "$NOWHERE")

    def test_lost_files_are_made_again(self):
        self.write("dish.json", with_values({"checks": []}, DISH))
        self.good("sweep", "dish.json", "--vary", f"{FEED}=0.03,0.02", "-o", "sw/")
        job = self.content("sw/jobs/0001")
        (self.folder / "sw/jobs/0001/000001.png").unlink()
        self.assertEqual(self.status(7)[0], "0001  aborted  feed=0.02  it was done, but 1 of its files is missing")
        # Two retries at the same time divide the jobs between them.
        both = [self.start("sweep", "retry", "sw") for _ in range(2)]
        for process in both:
            self.assertIn(process.wait(PATIENCE), (0, 7))
        self.assertEqual(self.content("sw/jobs/0001"), job)
        # A finished job is left unchanged.
        before = (self.folder / "sw/jobs/0001/manifest.json").stat().st_ino
        self.good("sweep", "job", "sw", "1")
        self.assertEqual((self.folder / "sw/jobs/0001/manifest.json").stat().st_ino, before)

    def test_no_worker_outlives_a_killed_sweep(self):
        """No worker continues to finish its frame and write its state, because the next run would have to wait for
        it."""
        self.write("slow.json", with_values(SLOW))
        for arguments, places in ((("sweep", "slow.json", "--vary", "seed=1,2", "-o", "sw/", "--jobs", "2"), "sw/jobs/*"),
                                  (("render", "slow.json", "-o", "out/", "--pieces", "2", "--jobs", "2"), "out/pieces/*")):
            process = self.start(*arguments)
            self.wait_until(lambda: list(self.folder.glob(f"{places}/*.png")), process)
            workers = [int(name) for name in (pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()).split()]
            self.assertGreater(len(workers), 0)
            process.kill()
            process.wait(PATIENCE)
            self.wait_until(lambda: not any(pathlib.Path(f"/proc/{worker}").exists() for worker in workers))
            self.assertEqual(list(self.folder.glob(f"{places}/checkpoint")), [])

    def test_each_device_gets_one_process(self):
        """Runs one process per device, whatever --jobs is; also in `simreel test`."""
        self.write("dish.json", with_values({"checks": []}, DISH))
        done = self.good("sweep", "dish.json", "--vary", f"{FEED}=0.02:0.0209:0.0001", "-o", "sw/", "--frames", "0", "--device", "0,none")
        self.assertIn("the work continues with one process less, because that process no device matches --device none", done.err.replace("was ended: ", ""))
        self.assertEqual(self.status(0), ["10 jobs: 10 done"])

    def test_a_thousand_jobs_are_planned_quickly(self):
        """Measured in processor time: the plan takes a tenth of a second; reading the scene for every job would take a
        minute."""
        begin = os.times()
        self.good("sweep", "dish.json", "--vary", f"{FEED}=0:0.0999:0.0001", "-o", "sw/", "--plan-only")
        used = os.times().children_user - begin.children_user + os.times().children_system - begin.children_system
        self.assertLess(used, 10)
        self.assertEqual((self.folder / "sw/plan.json").read_text().count('{"job":'), 1000)

    def test_mistakes(self):
        vary = ("--vary", f"{FEED}=0.02,0.03")
        for words, arguments in (
                (["--vary", "first:last:step"], ("dish.json", "--vary", FEED, "-o", "sw/")),
                (["nothing varies"], ("dish.json", "-o", "sw/")),
                (["give a scene"], (*vary, "-o", "sw/")),
                (["-o folder"], ("dish.json", *vary)),
                (["exclude each other"], ("dish.json", *vary, "-o", "sw/", "--zip", "--grid")),
                (["--sample", "-D seed=3"], ("dish.json", *vary, "-o", "sw/", "--seed", "3")),
                (["has no step", "--sample"], ("dish.json", "--vary", f"{FEED}=0:1", "-o", "sw/")),
                (["--jobs"], ("dish.json", *vary, "-o", "sw/", "--jobs", "none")),
                (["--sbatch", "not closed"], ("dish.json", *vary, "-o", "sw/", "--slurm", "--sbatch", "'x")),
                (["contains no sweep"], ("status", "nowhere"))):
            self.bad(2, words, "sweep", *arguments)
        self.bad_scene([f"-D {FEED}=9: error"], "sweep", "dish.json", "--vary", f"{FEED}=0.02,9", "-o", "other/")
        self.assertFalse((self.folder / "other").exists())
        self.good("sweep", "dish.json", *vary, "-o", "sw/", "--plan-only")
        self.bad(6, ["another sweep", "--overwrite"], "sweep", "dish.json", "--vary", f"{FEED}=0.02", "-o", "sw/")
        self.bad(2, ["no job 2", "0 to 1"], "sweep", "job", "sw", "2")
        self.bad(2, ["0.020", "twice, also as 0.02"], "sweep", "dish.json", "--vary", f"{FEED}=0.02,0.020", "-o", "other/")
        scene = (self.folder / "sw/scene.json").read_text()
        self.write("sw/scene.json", scene.replace("48", "40"))
        self.bad(2, ["sw/scene.json was changed after the sweep was planned", "--overwrite"], "sweep", "job", "sw", "0")
        self.write("sw/scene.json", scene)
        self.bad(2, ["scontrol", "--plan-only"], "sweep", "retry", "sw", "--slurm", env={"PATH": "/nowhere"})
        text = (self.folder / "sw/plan.json").read_text()
        self.write("sw/plan.json", text.replace('"program": "', '"program": "9'))
        self.bad(2, ["sw/plan.json was written by simreel 9", "this is"], "sweep", "retry", "sw")
        for wrong in ("", "{", text.replace('"version": 1', '"version": 7'), text.replace('"job":1', '"job":5')):
            self.write("sw/plan.json", wrong)
            self.bad(2, ["plan sw/plan.json cannot be read"], "sweep", "status", "sw")


if __name__ == "__main__":
    main()
