"""Decides if pictures, tests or baselines catch a mutant."""
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

FIRST_SCENES = 5  # number of scenes that are drawn before the first group of tests; that group takes as long as ten
                  # scenes
FRAME = 8  # frame number of the small pictures
PATIENCE = 120  # time limit in seconds per picture; a mutant that exceeds it counts as caught
ARGUMENTS = []  # arguments that select the driver variant


def drivers():
    """Loads tools/drivers as a module."""
    loader = importlib.machinery.SourceFileLoader("drivers", str(ROOT / "tools/drivers"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("drivers", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


def variants():
    """Returns the names of all variants of tools/drivers on a machine without a graphics card."""
    found = drivers().variants("storage")
    try:
        mesa = "Mesa " + drivers().newer_mesa()[0].split("-")[0]
        newer = [f"{mesa}, {variant.name}" for variant in found if variant.newer]
    except Exception as reason:  # pylint: disable=broad-exception-caught
        print(f"No newer Mesa is tried: {reason}.")
        newer = []
    return [variant.name for variant in found] + newer


def take_variant(name):
    """Makes all programs started from now on run as this variant of tools/drivers."""
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
    """Draws a scene. Returns its exact picture, the files of the chosen code that it reads, the time (s), and a folder
    with the sources that the driver compiles."""
    copy, sources = pathlib.Path(folder) / scene, pathlib.Path(folder) / f"{scene}-sources"
    shutil.copytree(GLSL, copy)
    sources.mkdir()
    files = [file for file in copy.rglob("*") if file.is_file()]
    for file in files:
        # The access time is set to 0, so that a later read is detected even if the file system rarely updates access
        # times.
        os.utime(file, (0, time.time()))
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
    """For each shipped scene (or those in `names`): the shader lines that it compiles, and its unchanged picture."""

    def __init__(self, program, jobs, names=None):
        self.program = program
        self.compiled = {}  # maps a mutant to true if any scene compiles the mutated line
        names = selection.scenes(exact_pictures.scenes()) if names is None else sorted(names)
        with tempfile.TemporaryDirectory(prefix="simreel-mutate-") as folder, \
                concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            found = dict(zip(names, pool.map(lambda scene: looked_through(folder, program, scene, FRAME), names)))
            files, known = compiled.Files(), {}
            # The value is `None` if the driver does not report the lines that it compiles.
            self.lines = {scene: compiled.lines_of(at, files, known) or None for scene, (_, _, _, at) in found.items()}
        self.unchanged = {scene: entry for scene, (entry, _, _, _) in found.items()}
        if wrong := [f"{scene} {entry}" for scene, entry in self.unchanged.items() if "pixels" not in entry]:
            sys.exit(f"without a change, too, pictures cannot be drawn: {', '.join(wrong)}")
        # scenes whose pictures have been checked to match their baselines
        self.lock, self.sound = threading.Lock(), set()
        self.quickest = sorted(found, key=lambda scene: found[scene][2])
        self.read = {scene: read for scene, (_, read, _, _) in found.items()}

    def files(self):
        return sorted(set().union(*self.read.values()))

    def reading(self, file):
        return [scene for scene in self.quickest if file in self.read[scene]]

    def of(self, mutant):
        """Returns the scenes that may compile the mutant's line."""
        return [scene for scene in self.reading(mutant.file) if
                (self.lines[scene] is None or (mutant.file, mutant.number) in self.lines[scene])]

    def drawn(self, scene, glsl):
        """Draws the scene with changed shaders. Returns the differing picture's entry, or None if it is equal; and True
        if a shader does not compile."""
        try:
            entry = exact_pictures.drawn(self.program, scene, FRAME, *ARGUMENTS, env={"SIMREEL_GLSL": str(glsl)}, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return "slow", False
        words = exact_pictures.difference(self.unchanged[scene], entry)
        if words and "pixels" in entry:
            return entry["pixels"][:8], False
        return words and "failed", words is not None and re.search(r"does not (compile|link)|syntax error|glsl/", words) is not None

    def baseline_differs(self, scene, glsl):
        """True if the scene's tested frames differ from its baseline. They have another size than the small pictures
        and later times."""
        with self.lock:
            if scene not in self.sound and tested_frames_differ(self.program, scene, GLSL):
                print(f"without a change, too, {scene} is not as its baseline", file=sys.stderr, flush=True)
                os._exit(2)
            self.sound.add(scene)
        # The first tested frame reveals most mutants, so it is tested alone before the other frames.
        return tested_frames_differ(self.program, scene, glsl, 1) or tested_frames_differ(self.program, scene, glsl)

    def reads(self, mutant, folder):
        """True if a scene compiles the mutant's line."""
        names = self.of(mutant)
        if any(self.lines[scene] for scene in names):
            return True
        if mutant not in self.compiled:
            poisoned = mutant.written(pathlib.Path(folder) / "poisoned", "@")
            self.compiled[mutant] = any(self.drawn(scene, poisoned)[0] for scene in names)
        return self.compiled[mutant]


def tested_frames_differ(program, scene, glsl, frames=None):
    """True if `simreel test` fails for the scene, or for its first `frames` tested frames."""
    with tempfile.TemporaryDirectory(prefix="tested-") as folder:
        file = ROOT / f"assets/scenes/{scene}.json"
        if frames is not None:
            # removes comments but not text in strings
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
    """Returns the arguments of test_gpu for each group of tests."""
    return [[*group, *selection.without(group)] for group in code.chosen.tests]


def check_tests(names=None):
    """Checks that the tests (or those in `names`) pass with unchanged shaders."""
    folder = tempfile.gettempdir()
    groups = groups_of_tests() if names is None else [["--test-case=" + ",".join(map(pattern, names))]]
    for group in groups:
        if test := test_that_fails(folder, GLSL, *group):
            sys.exit(f"without a change, too, a test fails: {test}")


def pattern(test):
    """Returns the test's name escaped for test_gpu's filter."""
    return re.sub(r"[,*]", "?", test)


def test_that_fails(folder, glsl, *files, env=None):
    """Returns the name of the first failing test, or None."""
    done, words = run([pathlib.Path(tempfile.gettempdir()) / "test_gpu", *files, "--no-colors", "--abort-after=1"], 6 * PATIENCE, cwd=folder,
                      env=env or {**os.environ, "SIMREEL_GLSL": str(glsl), "TMPDIR": folder})
    if done == 0:
        return None
    named = re.findall(r"^TEST CASE: +(.*)", words, re.M)
    return named[-1] if named else "took too long" if done is None else "ended"


def confirmed(mutant, by, test, scenes):
    """Runs again only the test or scene that caught the mutant before; returns "survived" if the test passes or the
    picture is equal."""
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
    """Returns "caught", "survived", "equivalent", "not compiled" or "not reached"; the scene or program that caught the
    mutant; and the test's name."""
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
