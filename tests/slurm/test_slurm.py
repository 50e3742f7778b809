#!/usr/bin/env python3
"""Tests sweeps and pieces on a real Slurm of three nodes, all on this machine (cluster.py).

Skipped with exit code 77 if Slurm or munge is not installed; fails instead if $SIMREEL_REQUIRE_SLURM is set.
"""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from cluster import Cluster, missing_programs  # noqa: E402
from common import PROGRAM, SLOW, Case, with_values  # noqa: E402

DISH = {"version": 1, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.1},
        "objects": {"dish": {"grayScott": {"size": [48, 48], "steps": 20}}}, "checks": [{"what": "no-nan"}]}
# Drawing takes most of the time: a piece of 25 frames takes about a second.
FLAG = with_values(SLOW | {"render.size": [640, 360], "render.samples": 4, "time.duration": 5, "objects.flag.cloth.substeps": 16})


def parent(pid):
    return int(pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])


def is_held(process):
    """True if the process is still stopped and has no pending signal to end."""
    try:
        status = pathlib.Path(f"/proc/{process}/status").read_text()
    except OSError:
        return False
    words = dict(line.split(":", 1) for line in status.splitlines())
    return words["State"].split()[0] == "T" and not (1 << signal.SIGTERM - 1) & (int(words["SigPnd"], 16) | int(words["ShdPnd"], 16))


def numbers(text):
    """Returns the frames that run.json abbreviates as 0-3,5,8-12x2."""
    found = []
    for part in text.split(","):
        first, last, step = re.fullmatch(r"(\d+)(?:-(\d+)(?:x(\d+))?)?", part).groups()
        found += range(int(first), int(last or first) + 1, int(step or 1))
    return found


def sent(process, number):
    """Sends a signal; True if the process existed."""
    try:
        os.kill(process, number)
        return True
    except ProcessLookupError:
        return False


class OnCluster(Case):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp(prefix="simreel-slurm-"))
        cls.addClassCleanup(shutil.rmtree, cls.place, True)
        cls.cluster = Cluster(cls.place, max_array=8)
        cls.addClassCleanup(cls.cluster.stop)
        cls.cluster.start()

    def simreel(self, code, *arguments):
        done = self.run_program(*arguments, env=self.cluster.environment | {"LP_NUM_THREADS": "1"})
        self.assertEqual(done.returncode, code, done.err + done.stdout.decode())
        return done.err + done.stdout.decode()

    def queue(self, states=""):
        """Returns [job, node, state, name] of each waiting or running job."""
        extra = ["-t", states] if states else []
        return [line.split("|") for line in self.cluster.call("squeue", "-h", "-r", "-o", "%i|%N|%T|%j", *extra).splitlines()]

    def start_waiting(self):
        """Starts requeued jobs at once, because Slurm delays them for two minutes. A job may start by itself meanwhile."""
        for job, _, state, _ in self.queue("PENDING"):
            reason = self.cluster.attempt("squeue", "-h", "-r", "-j", job, "-o", "%r").strip()
            if reason == "BeginTime":
                self.cluster.attempt("scontrol", "update", f"JobId={job}", "StartTime=now")

    def wait_for(self, until, seconds=3000):
        end = time.monotonic() + seconds
        while not until():
            self.assertLess(time.monotonic(), end, self.cluster.call("squeue", "-r") + self.cluster.logs()[-3000:])
            self.start_waiting()
            time.sleep(0.2)

    def logs(self, folder):
        return "".join(f"{p.name}: {p.read_text()}" for p in sorted((self.folder / folder / "slurm").glob("*.log")))

    def test_sweep_and_a_full_disk(self):
        """12 jobs in two arrays; the scratch disk of one node is full at first."""
        self.write("dish.json", DISH)
        small = self.place / "scratch/n2"
        small.mkdir(parents=True)
        full = os.getuid() == 0 and subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "none", str(small)]).returncode == 0
        if full:
            self.addCleanup(subprocess.run, ["umount", str(small)], capture_output=True)
        sweep = ("sweep", "dish.json", "--vary", "objects.dish.grayScott.feed=0.02:0.035:0.005", "--vary",
                 "objects.dish.grayScott.kill=0.055,0.06,0.065", "-o", "sweep/", "--slurm", "--scratch",
                 f"{self.place}/scratch/$SLURMD_NODENAME")
        self.assertIn("12 jobs submitted as ", self.simreel(0, *sweep, "--sbatch", "--hold"))
        self.assertIn("12 jobs: 0 done, 12 queued", self.simreel(7, "sweep", "status", "sweep"))
        self.assertIn("12 of 12 jobs are queued already", self.simreel(0, "sweep", "retry", "sweep", "--slurm"))
        held = sorted(job for job, *_ in self.queue())
        self.assertEqual(len(held), 12)
        self.cluster.call("scontrol", "release", ",".join(sorted({job.partition("_")[0] for job in held})))
        self.wait_for(lambda: not self.queue())
        if full:
            told = self.simreel(1, "sweep", "status", "sweep")
            self.assertIn("No space left on device", told)
            self.assertRegex(told, r"12 jobs: \d+ done, \d+ failed")
            subprocess.run(["umount", str(small)], check=True)
            self.simreel(0, "sweep", "retry", "sweep", "--slurm")
            self.wait_for(lambda: not self.queue())
        self.assertEqual(self.simreel(0, "sweep", "status", "sweep"), "12 jobs: 12 done\n", self.logs("sweep"))
        self.simreel(0, "sweep", "collect", "sweep")
        table = (self.folder / "sweep/table.csv").read_text().splitlines()
        self.assertEqual(len(table), 13)
        for name in ("sheet.png", "index.html"):
            self.assertTrue((self.folder / "sweep" / name).exists())
        # A job must equal the run that a user would start by hand.
        self.good("render", "dish.json", "-o", "alone/", "-D", "objects.dish.grayScott.feed=0.03", "-D",
                  "objects.dish.grayScott.kill=0.065")
        job, alone = self.content("sweep/jobs/0008"), self.content("alone")
        self.assertEqual({name: job[name] for name in alone}, alone)
        self.assertEqual(sorted(set(job) - set(alone)), ["job.json", "result.json"])

    def drawing(self):
        """Returns {piece: (process, existing frames)} of the pieces being drawn."""
        folder = self.folder / "out/pieces"
        found = {}
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                words = (process / "cmdline").read_text().split("\0")
            except OSError:
                continue
            if words[1:4] == ["pieces", "draw", str(folder)]:
                found[int(words[4])] = int(process.name), len(list((folder / f"{int(words[4]):04}").glob("*.png")))
        return found

    def catch_one(self, on=None):
        """Stops a piece that is being drawn, perhaps on a certain node, and returns (piece, process, Slurm job). The
        process is stopped, because it might end before Slurm reports its job."""
        end = time.monotonic() + 3000
        first, asked = {}, 0
        while time.monotonic() < end:
            # Earlier attempts may have left frames. One more frame than these proves that this process draws. Some
            # frames must be missing, so that the piece can continue.
            held = [(piece, process) for piece, (process, frames) in self.drawing().items()
                    if frames < 20 and frames != first.setdefault(process, frames) and sent(process, signal.SIGSTOP)]
            running = self.queue("RUNNING") if held else []
            caught = [(piece, process, job) for piece, process in held for job, node, _, name in running
                      if name == "simreel-draw" and job.endswith(f"_{piece}") and on in (None, node)]
            for _, process in held:
                if not caught or process != caught[0][1]:
                    sent(process, signal.SIGCONT)
            if caught:
                return caught[0]
            if time.monotonic() > asked + 1:
                self.start_waiting()
                asked = time.monotonic()
            time.sleep(0.01)
        self.fail(f"nothing is drawn on {on}: {self.queue()}")

    def test_pieces_with_a_requeue_and_a_dead_node(self):
        self.write("flag.json", FLAG)
        self.good("render", "flag.json", "-o", "whole/", env={"LP_NUM_THREADS": "2"})
        pieces = ("render", "flag.json", "-o", "out/", "--pieces", "6", "--slurm")
        self.simreel(0, *pieces)
        self.assertIn("0 done, 6 queued or being drawn, states under way", self.simreel(7, "pieces", "status", "out/pieces"))
        self.assertIn("the cluster still has jobs of these pieces", self.simreel(2, *pieces, "--resume"))
        # A node fails together with its processes. Slurm detects the failure and restarts the job on another node.
        piece, process, job = self.catch_one("n3")
        step = parent(process)
        self.cluster.daemons["n3"].kill()
        self.cluster.daemons.pop("n3").wait()
        os.kill(step, signal.SIGKILL)
        os.kill(process, signal.SIGKILL)
        # The job is requeued. The program gets the signal, and the new run continues from the existing frames.
        piece, process, job = self.catch_one()
        (path,) = (self.folder / "out/pieces/slurm").glob(f"draw.*_{piece}.log")
        log = self.enterContext(path.open())  # Opens the file now, because its path is removed when the pieces are
                                              # joined.
        self.cluster.call("scontrol", "requeue", job)
        self.wait_for(lambda: not is_held(process))
        sent(process, signal.SIGCONT)
        self.wait_for(lambda: not pathlib.Path(f"/proc/{process}").exists())
        self.assertTrue((self.folder / f"out/pieces/{piece:04}/checkpoint").exists(), self.logs("out/pieces"))
        self.wait_for(lambda: not self.queue())
        self.assertTrue((self.folder / "out/manifest.json").exists(), self.logs("out/pieces"))
        self.assertEqual(self.content("out"), self.content("whole"))
        self.assertIn("resuming from the checkpoint of frame", log.read())
        # Each frame is recorded only for the process that drew it last.
        noted = [frame for run in self.runs("out") for frame in numbers(run["frames"])]
        self.assertEqual(sorted(noted), list(range(150)))


if __name__ == "__main__":
    if missing := missing_programs():
        print("skipped: not installed:", *missing)
        sys.exit(1 if os.environ.get("SIMREEL_REQUIRE_SLURM") else 77)
    unittest.main(verbosity=2)
