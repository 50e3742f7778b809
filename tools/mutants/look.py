"""Who notices a mutant: pictures, tests, baselines."""
import concurrent.futures
import functools
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time

import exact_pictures
from mutants import code, compiled, selection
from mutants.changes import GLSL, ROOT
from mutants.processes import run

FIRST_SCENES = 5  # are drawn before the first group of tests, which takes as long as ten, runs
FRAME = 8  # of the small pictures
PATIENCE = 120  # s that a picture may take: a mutant that never ends is caught
ARGUMENTS = []  # a variant's


def drivers():
    """tools/drivers."""
    loader = importlib.machinery.SourceFileLoader("drivers", str(ROOT / "tools/drivers"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("drivers", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


def variants():
    """Names of all variants that tools/drivers knows on a machine without a card."""
    found = drivers().variants("storage")
    try:
        mesa = "Mesa " + drivers().newer_mesa()[0].split("-")[0]
        newer = [f"{mesa}, {variant.name}" for variant in found if variant.newer]
    except Exception as reason:  # pylint: disable=broad-exception-caught
        print(f"No newer Mesa is tried: {reason}.")
        newer = []
    return [variant.name for variant in found] + newer


def take_variant(name):
    """From here on programs run as tools/drivers' variant of this name does."""
    env = {}
    wanted = name
    if name.startswith("Mesa "):
        version, folder = drivers().newer_mesa()
        mesa, _, wanted = name.partition(", ")
        if mesa != "Mesa " + version.split("-")[0]:
            sys.exit(f"there is no {mesa}, but {version}")
        env = drivers().environment_of(folder)
    known = {variant.name: variant for variant in drivers().variants("storage")}
    if wanted not in known:
        sys.exit(f"there is no variant {wanted!r}, but {', '.join(known)}")
    variant = known[wanted].with_software()
    os.environ.update({**env, **variant.env, "MESA_SHADER_CACHE_DIR": tempfile.mkdtemp(prefix="cache-")})
    ARGUMENTS.extend(variant.arguments)
    if "--memory-path" in ARGUMENTS:
        os.environ["SIMREEL_TEST_MEMORY_PATH"] = ARGUMENTS[ARGUMENTS.index("--memory-path") + 1]


def looked_through(folder, program, scene, frame):
    """The scene's exact picture, the files of the chosen code that it is made with, how long it takes (s), and a folder with
    what the driver compiles for it."""
    copy, sources = pathlib.Path(folder) / scene, pathlib.Path(folder) / f"{scene}-sources"
    shutil.copytree(GLSL, copy)
    sources.mkdir()
    files = [file for file in copy.rglob("*") if file.is_file()]
    for file in files:
        os.utime(file, (0, time.time()))  # a first look shows, however seldom the file system notes them
    begin = time.monotonic()
    entry = exact_pictures.drawn(program, scene, frame, *ARGUMENTS,
                                 env={"SIMREEL_GLSL": str(copy), "MESA_SHADER_DUMP_PATH": str(sources)})
    seconds = time.monotonic() - begin
    read = {str(file.relative_to(copy)) for file in files if file.stat().st_atime > 0}
    shutil.rmtree(copy)
    if not read:
        sys.exit(f"{folder} does not note when files are read; set TMPDIR to a place that does")
    return entry, {name for name in read if code.chosen.has(name)}, seconds, sources


class Scenes:
    """What each shipped scene (or those of `names`) compiles, and how it looks."""

    def __init__(self, program, jobs, names=None):
        self.program = program
        self.compiled = {}  # of mutants: whether a scene compiles the place
        names = selection.scenes(exact_pictures.scenes()) if names is None else sorted(names)
        with tempfile.TemporaryDirectory(prefix="simreel-mutate-") as folder, \
                concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            found = dict(zip(names, pool.map(lambda scene: looked_through(folder, program, scene, FRAME), names)))
            files, known = compiled.Files(), {}
            # Of drivers that do not say which lines they compile, nothing.
            self.lines = {scene: compiled.lines_of(at, files, known) or None for scene, (_, _, _, at) in found.items()}
        self.unchanged = {scene: entry for scene, (entry, _, _, _) in found.items()}
        if wrong := [f"{scene} {entry}" for scene, entry in self.unchanged.items() if "pixels" not in entry]:
            sys.exit(f"without a change, too, pictures cannot be drawn: {', '.join(wrong)}")
        self.lock, self.sound = threading.Lock(), set()  # scenes that are as their baselines
        self.quickest = sorted(found, key=lambda scene: found[scene][2])
        self.read = {scene: read for scene, (_, read, _, _) in found.items()}

    def files(self):
        return sorted(set().union(*self.read.values()))

    def reading(self, file):
        return [scene for scene in self.quickest if file in self.read[scene]]

    def of(self, mutant):
        """Scenes that may compile the place."""
        return [scene for scene in self.reading(mutant.file) if
                (self.lines[scene] is None or (mutant.file, mutant.number) in self.lines[scene])]

    def drawn(self, scene, glsl):
        """What is drawn instead of the picture, or nothing; and whether a shader does not compile."""
        try:
            entry = exact_pictures.drawn(self.program, scene, FRAME, *ARGUMENTS, env={"SIMREEL_GLSL": str(glsl)}, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return "slow", False
        words = exact_pictures.difference(self.unchanged[scene], entry)
        if words and "pixels" in entry:
            return entry["pixels"][:8], False
        return words and "failed", words is not None and re.search(r"does not (compile|link)|syntax error|glsl/", words) is not None

    def baseline_differs(self, scene, glsl):
        """Whether its tested frames are not those of its baseline, at another size and at later times than above."""
        with self.lock:
            if scene not in self.sound and tested_frames_differ(self.program, scene, GLSL):
                print(f"without a change, too, {scene} is not as its baseline", file=sys.stderr, flush=True)
                os._exit(2)
            self.sound.add(scene)
        # The first of them tells most.
        return tested_frames_differ(self.program, scene, glsl, 1) or tested_frames_differ(self.program, scene, glsl)

    def reads(self, mutant, folder):
        """Whether a scene compiles the place."""
        names = self.of(mutant)
        if any(self.lines[scene] for scene in names):
            return True
        if mutant not in self.compiled:
            poisoned = mutant.written(pathlib.Path(folder) / "poisoned", "@")
            self.compiled[mutant] = any(self.drawn(scene, poisoned)[0] for scene in names)
        return self.compiled[mutant]


def tested_frames_differ(program, scene, glsl, frames=None):
    """Whether `simreel test` fails, of the scene or of so many frames of it."""
    with tempfile.TemporaryDirectory(prefix="tested-") as folder:
        file = ROOT / f"assets/scenes/{scene}.json"
        if frames is not None:
            # A string is kept, a comment goes.
            text = json.loads(re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda m: m.group(1) or "", file.read_text(encoding="utf-8")))
            text["test"]["frames"] = text["test"]["frames"][:frames]
            file = pathlib.Path(folder) / file.name
            file.write_text(json.dumps(text), encoding="utf-8")
            (file.parent / "golden").symlink_to(ROOT / "assets/scenes/golden")
        done, _ = run([program, "test", file, "--repeat", "1", *ARGUMENTS], 4 * PATIENCE,
                      env={**os.environ, "SIMREEL_GLSL": str(glsl), "SIMREEL_ASSETS": str(ROOT / "assets")})
    return done != 0


@functools.cache
def groups_of_tests():
    """Arguments of test_gpu for each."""
    return [[*group, *selection.without(group)] for group in code.chosen.tests]


def check_tests(names=None):
    """They (or those of `names`) notice nothing where nothing is changed."""
    folder = tempfile.gettempdir()
    groups = groups_of_tests() if names is None else [["--test-case=" + ",".join(map(pattern, names))]]
    for group in groups:
        if test := test_that_fails(folder, GLSL, *group):
            sys.exit(f"without a change, too, a test fails: {test}")


def pattern(test):
    """The name as test_gpu takes it."""
    return re.sub(r"[,*]", "?", test)


def test_that_fails(folder, glsl, *files, env=None):
    """The name of the first test that notices, or nothing."""
    done, words = run([pathlib.Path(tempfile.gettempdir()) / "test_gpu", *files, "--no-colors", "--abort-after=1"], 6 * PATIENCE, cwd=folder,
                      env=env or {**os.environ, "SIMREEL_GLSL": str(glsl), "TMPDIR": folder})
    if done == 0:
        return None
    named = re.findall(r"^TEST CASE: +(.*)", words, re.M)
    return named[-1] if named else "took too long" if done is None else "ended"


def confirmed(mutant, by, test, scenes):
    """Of what caught it before: by the same test, or the same other picture; "survived" where that shows nothing."""
    with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
        glsl = mutant.written(folder)
        if test:
            return ("caught", by, test) if test_that_fails(folder, glsl, f"--test-case={pattern(test)}") else ("survived", by, test)
        scene, words = by.split(maxsplit=1)
        if words == "(test)":
            return ("caught" if scenes.baseline_differs(scene, glsl) else "survived"), by, ""
        found, _ = scenes.drawn(scene, glsl)
        return ("caught", by, "") if found == words else ("survived" if not found else "other bytes", f"{scene} {found}", "")


def outcome(mutant, scenes, with_tests):
    """"caught", "survived", "equivalent", "not compiled" or "not reached"; by what; and a test's name."""
    names = scenes.of(mutant)
    if not names:
        return "not reached", "", ""
    with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
        glsl = mutant.written(folder)
        small = ""
        for count, scene in enumerate(names):
            words, mistake = scenes.drawn(scene, glsl)
            if mistake:
                return "not compiled", scene, ""
            if words and scenes.baseline_differs(scene, glsl):
                return "caught", f"{scene} {words}", ""
            small = small or words and f"{scene} {words}, not its baseline"
            if count + 1 != min(FIRST_SCENES, len(names)):
                continue
            if with_tests and scenes.reads(mutant, folder) and (test := test_that_fails(folder, glsl, *groups_of_tests()[0])):
                return "caught", "test_gpu", test
        if not scenes.reads(mutant, folder):
            return "not reached", "", ""
        for group in groups_of_tests()[1:] if with_tests else ():
            if test := test_that_fails(folder, glsl, *group):
                return "caught", "test_gpu", test
        for scene in scenes.reading(mutant.file) if with_tests else []:
            if scenes.baseline_differs(scene, glsl):
                return "caught", f"{scene} (test)", ""
    return ("equivalent" if mutant.changes_nothing() else "survived"), "", small
