#!/usr/bin/env python3
"""Makes every call of simreel that can fail do so, in one run for each, and checks the result.

A run with a failing call must not crash, hang, end with 0 while something is missing, or leave a file that a later
--resume wrongly trusts. It must end with a documented code and one clear line, or with 0 and the same folder as an
undisturbed run. The same command, run again without failures, must produce that folder byte for byte.

    SIMREEL=build/simreel FAULTS_LIBRARY=build/tests/faults/libfaults.so tests/faults/test_faults.py [--all]

Without --all, these calls fail: every call for files and processes; for threads and the display, which every command
starts in the same way, every call of the first command and every fifth of the others; the first 100 allocations and GL
calls, then every 613th. --stride N: every Nth call for files and processes of all commands but the first. --first N:
every Nth call of the first command. --runs and --classes choose commands and classes."""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SIMREEL = os.environ.get("SIMREEL", "simreel")
LIBRARY = os.environ.get("FAULTS_LIBRARY", "libfaults.so")
KEEP = os.environ.get("FAULTS_KEEP")  # folder for the files of failed checks; not kept if unset
SECONDS = 120  # time limit of one run, in seconds
MANY = ("alloc", "gl")  # classes with thousands of calls
FIRST, STRIDE = 100, 613
ALIKE = ("thread", "egl")  # classes whose calls are the same in most commands
CRASHES = ("terminate called", "internal error", "std::", "AddressSanitizer", "Assertion")

SCENE = {
    "version": 1, "title": "faults", "render": {"size": [96, 54], "samples": 1}, "time": {"fps": 30, "duration": 0.13},
    "camera": {"position": [0, 1, 3], "target": [0, 1, 0]}, "sun": {"shadowSize": 64},
    "lights": {"lamp": {"position": [0.5, 1.5, 1], "shadowSize": 32, "flicker": {}}},
    "objects": {
        "flag": {"cloth": {"size": [9, 7], "spacing": 0.1, "position": [0, 1, 0], "rotation": [90, 0, 0],
                           "jitter": 0.01, "substeps": 4}},
        "ill": {"epidemic": {"size": [32, 24], "infected": 0.1, "display": {"layer": "behind"}}}},
    "test": {"frames": [0, 2]}, "checks": [{"what": "no-nan"}],
}
FRAMES = ["render", "scene.json", "-o", "out/", "--fields", "npy", "--checkpoint", "0.000001"]


class Run:
    """A command, the initial content of its folder, and the command that a user runs after a failure."""

    def __init__(self, command, again, before=None, made="out", codes=(2, 4, 6)):
        self.command, self.again, self.before, self.made, self.codes = command, again, before, made, codes


def interrupted(folder):
    """Makes the folder of an interrupted run: two frames and a checkpoint."""
    simreel(folder, FRAMES + ["--frames", "0-1"])
    environment = os.environ | {"LD_PRELOAD": LIBRARY, "FAULTS": "rename:9"}
    subprocess.run([SIMREEL, *FRAMES, "--resume"], cwd=folder, env=environment, capture_output=True, timeout=SECONDS)


RUNS = {
    "frames": Run(FRAMES, FRAMES + ["--resume"]),
    "resume": Run(FRAMES + ["--resume"], FRAMES + ["--resume"], before=interrupted),
    "video": Run(["render", "scene.json", "-o", "out/a.mp4"], ["render", "scene.json", "-o", "out/a.mp4", "--overwrite"]),
    "bake": Run(["bake", "scene.json", "-o", "out/"], ["bake", "scene.json", "-o", "out/", "--overwrite"]),
    "sequence": Run(["bake", "scene.json", "-o", "out/", "--sequence"],
                    ["bake", "scene.json", "-o", "out/", "--sequence", "--overwrite"]),
    "cache": Run(["bake", "scene.json", "-o", "out/", "--format", "pc2"],
                 ["bake", "scene.json", "-o", "out/", "--format", "pc2", "--overwrite"]),
    "update": Run(["test", "scene.json", "--update"], ["test", "scene.json", "--update"], made="golden",
                  codes=(1, 2, 4, 6)),
}


def simreel(folder, arguments, fault=None, log=None):
    environment = dict(os.environ)
    if fault:
        environment |= {"LD_PRELOAD": LIBRARY, "FAULTS": fault, "FAULTS_LOG": str(log)}
    ran = subprocess.Popen([SIMREEL, *arguments], cwd=folder, env=environment, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, start_new_session=True)
    try:
        _, message = ran.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(ran.pid, signal.SIGKILL)
        ran.communicate()
        return None, ""
    return ran.returncode, message.decode(errors="replace")


def contents(folder):
    """Returns {path: bytes} of a folder; for run.json, which contains times and machines, only its existence."""
    return {str(f.relative_to(folder)): b"" if f.name.endswith("run.json") and not f.name.endswith("as-run.json") else f.read_bytes()
            for f in sorted(folder.rglob("*")) if f.is_file()}


def signature(folder):
    """Returns a hash of the folder that the next run finds, so that equal folders are tried only once."""
    def told(name, data):
        return re.sub(rb"[\d.]+", b"0", data) if name.endswith("run.json") and not name.endswith("as-run.json") else data

    return hashlib.sha256(repr([(str(f.relative_to(folder)), told(f.name, f.read_bytes()) if f.is_file() else b"")
                                for f in sorted(folder.rglob("*")) if f.name != "fault.log"]).encode()).digest()


def prepare(folder, before):
    (folder / "scene.json").write_text(json.dumps(SCENE))
    if before is not None:
        shutil.copytree(before, folder, dirs_exist_ok=True)


def different(found, wanted, forgiven=()):
    """Describes the differences of two folders; empty if they are equal. A remaining lock file is ignored, because the
    kernel releases the lock."""
    return ", ".join([f"{n} is missing" for n in wanted if n not in found] +
                     [f"{n} is too much" for n in found if n not in wanted and not n.endswith(".lock") and
                      n not in forgiven] +
                     [f"{n} differs" for n in wanted if n in found and found[n] != wanted[n]])


class Disturbed:
    """The shared state of all disturbed runs of one command."""

    def __init__(self, name, scratch, first, stride):
        self.name, self.run, self.first, self.stride = name, RUNS[name], first, stride
        self.before = None
        self.tried = {}  # exit status and output of the following run, by the contents of the folder in which it starts
        if self.run.before:
            self.before = scratch / f"{name}.before"
            self.before.mkdir()
            prepare(self.before, None)
            self.run.before(self.before)
        with tempfile.TemporaryDirectory(dir=scratch) as folder_name:
            folder, log = pathlib.Path(folder_name), scratch / f"{name}.log"
            prepare(folder, self.before)
            code, message = simreel(folder, self.run.command, "none", log)
            if code != 0:
                sys.exit(f"{name} fails undisturbed: {message}")
            self.wanted = contents(folder / self.run.made)
            lines = [line.split() for line in log.read_text().splitlines()]
            self.counts = {line[1]: int(line[2]) for line in lines if line[0] == "count"}

    def faults(self, everything, classes):
        for kind, count in self.counts.items():
            if classes and kind not in classes and not (kind not in MANY and "few" in classes):
                continue
            for number in range(1, count + 1):
                if everything or self.chosen(kind, number):
                    yield f"{kind}:{number}"

    def chosen(self, kind, number):
        if kind in MANY:
            return number <= FIRST or (number - FIRST) % STRIDE == 0
        if self.name == next(iter(RUNS)):
            return (number - 1) % self.first == 0
        return number % (5 if kind in ALIKE else self.stride) == 0

    def problem(self, fault, scratch):
        """Returns a description of the problem after this call failed, with the failed call and the messages; None
        without a problem."""
        with tempfile.TemporaryDirectory(dir=scratch) as folder_name:
            folder = pathlib.Path(folder_name)
            log = folder / "fault.log"
            prepare(folder, self.before)
            code, message = simreel(folder, self.run.command, fault, log)
            what = " ".join(line for line in log.read_text().splitlines() if line.startswith("failed")) if log.exists() else ""
            wrong = self.judge(folder, fault, code, message)
            if wrong and KEEP:
                shutil.copytree(folder, pathlib.Path(KEEP) / f"{self.name}-{fault.replace(':', '-')}", dirs_exist_ok=True)
            return f"{self.name} {fault} ({what}): {wrong}; code {code}, said: {message.strip()[-400:]}" if wrong else None

    def judge(self, folder, fault, code, message):
        if code is None:
            return f"hangs: no end after {SECONDS} s"
        if code < 0:
            return f"killed by {signal.Signals(-code).name}"
        for word in CRASHES:
            if word in message:
                return f"says \"{word}\""
        made = folder / self.run.made
        if code == 0:
            # A checkpoint may remain if it could not be removed or may belong to another run. Only --resume reads it,
            # and --resume checks it.
            forgiven = ["checkpoint"] if "cannot remove" in message or fault.startswith("lock:") else []
            missing = different(contents(made), self.wanted, forgiven)
            return f"ends with 0, but {missing}" if missing else None
        if code not in self.run.codes:
            return "an undocumented code"
        errors = [line for line in message.splitlines() if line.startswith("simreel: error: ")]
        if self.name != "update" and len(errors) != 1:
            return f"{len(errors)} lines of error"
        if not contents(made):
            return None  # No files remain that could mislead a later run.
        found = signature(folder)
        if found not in self.tried:
            self.tried[found] = self.next_run(folder)
        return self.tried[found]

    def next_run(self, folder):
        code, message = simreel(folder, self.run.again)
        if code != 0:
            return f"the next run ends with {code}, saying {message.strip()[-300:]}"
        wrong = different(contents(folder / self.run.made), self.wanted)
        return f"after the next run {wrong}" if wrong else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true", help="every call")
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--stride", type=int, default=1)
    parser.add_argument("--runs", nargs="+", choices=RUNS, default=list(RUNS))
    parser.add_argument("--classes", nargs="+", help="open, write, alloc, gl ...; few: all but alloc and gl")
    parser.add_argument("--fault", help="only this one, for example write:3")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    begin = time.monotonic()
    problems = []
    with tempfile.TemporaryDirectory(prefix="simreel-faults-") as name:
        scratch = pathlib.Path(name)
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for run in options.runs:
                if run == "video" and not shutil.which("ffmpeg"):
                    print("video: skipped, ffmpeg is not installed")
                    continue
                disturbed = Disturbed(run, scratch, options.first, options.stride)
                faults = [options.fault] if options.fault else list(disturbed.faults(options.all, options.classes))
                found = [p for p in pool.map(lambda f: disturbed.problem(f, scratch), faults) if p]
                kinds = {}
                for fault in faults:
                    kinds[fault.split(":")[0]] = kinds.get(fault.split(":")[0], 0) + 1
                of = ", ".join(f"{n} of {disturbed.counts[kind]} {kind}" for kind, n in kinds.items())
                print(f"{run}: {len(faults)} calls failed ({of}); {len(found)} problems; "
                      f"{len(disturbed.tried)} different folders were left to the next run", flush=True)
                for problem in found:
                    print("  " + problem, flush=True)
                problems += found
    print(f"{len(problems)} problems in {time.monotonic() - begin:.0f} s")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
