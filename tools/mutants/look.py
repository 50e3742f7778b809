"""Who notices a mutant: pictures, tests, baselines."""
import concurrent.futures
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import exact_pictures
from mutants.changes import GLSL, ROOT
from mutants.processes import run

FIRST_SCENES = 5  # are drawn before the tests of exact drawing, which take as long as ten, run
FRAME = 8  # of the small pictures
PATIENCE = 120  # s that a picture may take: a mutant that never ends is caught
EXACT_TESTS = "--source-file=*gpu/draw/exact/*"
OTHER_TESTS = ["--source-file=*gpu/draw/*", "--source-file-exclude=*gpu/draw/exact/*"]
ARGUMENTS = []  # a variant's


def take_variant(name):
    """From here on programs run as tools/drivers' variant of this name does."""
    loader = importlib.machinery.SourceFileLoader("drivers", str(ROOT / "tools/drivers"))
    drivers = importlib.util.module_from_spec(importlib.util.spec_from_loader("drivers", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(drivers)
    env = {}
    wanted = name
    if name.startswith("Mesa "):
        version, folder = drivers.newer_mesa()
        mesa, _, wanted = name.partition(", ")
        if mesa != "Mesa " + version.split("-")[0]:
            sys.exit(f"there is no {mesa}, but {version}")
        env = drivers.environment_of(folder)
    known = {variant.name: variant for variant in drivers.variants("storage")}
    if wanted not in known:
        sys.exit(f"there is no variant {wanted!r}, but {', '.join(known)}")
    variant = known[wanted].with_software()
    os.environ.update({**env, **variant.env, "MESA_SHADER_CACHE_DIR": tempfile.mkdtemp(prefix="cache-")})
    ARGUMENTS.extend(variant.arguments)


def read_files(folder, program, scene, frame):
    """The files of glsl/draw that the scene's exact picture is made with, and how long it takes (s)."""
    copy = pathlib.Path(folder) / scene
    shutil.copytree(GLSL, copy)
    files = [file for file in copy.rglob("*") if file.is_file()]
    for file in files:
        os.utime(file, (0, time.time()))  # a first look shows, however seldom the file system notes them
    begin = time.monotonic()
    entry = exact_pictures.drawn(program, scene, frame, *ARGUMENTS, env={"SIMREEL_GLSL": str(copy)})
    seconds = time.monotonic() - begin
    read = {str(file.relative_to(copy)) for file in files if file.stat().st_atime > 0}
    shutil.rmtree(copy)
    if not read:
        sys.exit(f"{folder} does not note when files are read; set TMPDIR to a place that does")
    return entry, {name for name in read if name.startswith("draw/")}, seconds


class Scenes:
    """What each shipped scene reads, and how it looks."""

    def __init__(self, program, jobs):
        self.program = program
        self.compiled = {}  # of mutants: whether a scene compiles the place
        with tempfile.TemporaryDirectory(prefix="simreel-mutate-") as folder, \
                concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            names = exact_pictures.scenes()
            found = dict(zip(names, pool.map(lambda scene: read_files(folder, program, scene, FRAME), names)))
        self.unchanged = {scene: entry for scene, (entry, _, _) in found.items()}
        if wrong := [f"{scene} {entry}" for scene, entry in self.unchanged.items() if "pixels" not in entry]:
            sys.exit(f"without a change, too, pictures cannot be drawn: {', '.join(wrong)}")
        if scene := baselines_differ(program, names, GLSL):
            sys.exit(f"without a change, too, {scene} is not as its baseline")
        self.quickest = sorted(found, key=lambda scene: found[scene][2])
        self.read = {scene: files for scene, (_, files, _) in found.items()}

    def files(self):
        return sorted(set().union(*self.read.values()))

    def of(self, file):
        return [scene for scene in self.quickest if file in self.read[scene]]

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

    def reads(self, mutant, folder):
        """Whether a scene compiles the place."""
        if mutant not in self.compiled:
            poisoned = mutant.written(pathlib.Path(folder) / "poisoned", "@")
            self.compiled[mutant] = any(self.drawn(scene, poisoned)[0] for scene in self.of(mutant.file))
        return self.compiled[mutant]


def baselines_differ(program, names, glsl):
    """The first scene whose tested frames are not those of its baseline, at another size and at later times than above."""
    for name in names:
        done, _ = run([program, "test", ROOT / f"assets/scenes/{name}.json", "--repeat", "1", *ARGUMENTS],
                      4 * PATIENCE, env={**os.environ, "SIMREEL_GLSL": str(glsl)})
        if done != 0:
            return name
    return None


def check_tests():
    """They notice nothing where nothing is changed."""
    folder = tempfile.gettempdir()
    if test := test_that_fails(folder, GLSL, EXACT_TESTS) or test_that_fails(folder, GLSL, *OTHER_TESTS):
        sys.exit(f"without a change, too, a test fails: {test}")


def test_that_fails(folder, glsl, *files):
    """The name of the first test that notices, or nothing."""
    done, words = run([pathlib.Path(tempfile.gettempdir()) / "test_gpu", *files, "--no-colors", "--abort-after=1"], 6 * PATIENCE, cwd=folder,
                      env={**os.environ, "SIMREEL_GLSL": str(glsl), "TMPDIR": folder})
    if done == 0:
        return None
    named = re.findall(r"^TEST CASE: +(.*)", words, re.M)
    return named[-1] if named else "took too long" if done is None else "ended"


def confirmed(mutant, by, test, scenes):
    """As outcome(), of what caught it before alone: by the same test, or the same other picture."""
    with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
        glsl = mutant.written(folder)
        if test:
            name = re.sub(r"[,*]", "?", test)
            return ("caught", by, test) if test_that_fails(folder, glsl, f"--test-case={name}") else ("survived", by, test)
        scene, words = by.split(maxsplit=1)
        if words == "(test)":
            return ("caught" if baselines_differ(scenes.program, [scene], glsl) else "survived"), by, ""
        found, _ = scenes.drawn(scene, glsl)
        return ("caught", by, "") if found == words else ("survived" if not found else "other bytes", f"{scene} {found}", "")


def outcome(mutant, scenes, with_tests):
    """"caught", "survived", "not compiled" or "not reached"; by what; and a test's name."""
    with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
        glsl = mutant.written(folder)
        names = scenes.of(mutant.file)
        small = ""
        for count, scene in enumerate(names):
            words, mistake = scenes.drawn(scene, glsl)
            if mistake:
                return "not compiled", scene, ""
            if words and baselines_differ(scenes.program, [scene], glsl):
                return "caught", f"{scene} {words}", ""
            small = small or words and f"{scene} {words}, not its baseline"
            if count + 1 != min(FIRST_SCENES, len(names)):
                continue
            if mutant.changes_nothing():
                return "equivalent", "", small
            if with_tests and scenes.reads(mutant, folder) and (test := test_that_fails(folder, glsl, EXACT_TESTS)):
                return "caught", "test_gpu", test
        if not scenes.reads(mutant, folder):
            return "not reached", "", ""
        if with_tests and (test := test_that_fails(folder, glsl, *OTHER_TESTS)):
            return "caught", "test_gpu", test
        if with_tests and (scene := baselines_differ(scenes.program, names, glsl)):
            return "caught", f"{scene} (test)", ""
    return "survived", "", small
