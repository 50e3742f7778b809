"""Decides what catches a mutant of a simulation kernel: states of shipped scenes at their last tested frame, tests of
test_gpu, and last the scenes' baselines. Each runs only if it compiles the mutated line, the quickest first."""
import concurrent.futures
import hashlib
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
from mutants import code, compiled, look, selection
from mutants.changes import GLSL, ROOT
from mutants.processes import run


def shaders_hash():
    """Returns a hash of the shaders in the chosen folders and of the shipped scenes."""
    whole = hashlib.sha256()
    for file in sorted([*GLSL.rglob("*.glsl"), *GLSL.rglob("*.comp"), *(ROOT / "assets/scenes").glob("*.json")]):
        if not file.is_relative_to(GLSL) or code.chosen.has(str(file.relative_to(GLSL))):
            whole.update(file.name.encode() + b"\0" + file.read_bytes())
    return whole.hexdigest()


def scene_file(scene):
    return ROOT / f"assets/scenes/{scene}.json"


def last_tested_frame(scene):
    """Returns the last frame that the scene's test compares. Removes comments from the scene's text, but keeps
    strings."""
    text = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda m: m.group(1) or "", scene_file(scene).read_text(encoding="utf-8"))
    return max(json.loads(text)["test"]["frames"])


class Watchers:
    """All scenes and tests, the lines that each compiles, and the time that each takes."""

    def __init__(self, program, jobs, kept, with_tests):
        self.program = program
        self.lock, self.sound = threading.Lock(), set()
        kept = pathlib.Path(kept) if kept else None
        self.all, of = [], shaders_hash()
        if kept and kept.exists():
            stored = json.loads(kept.read_text(encoding="utf-8"))
            # If the shaders have changed, the stored lines and states are discarded.
            self.all = stored["watchers"] if stored["shaders"] == of else []
        known = {(watcher["kind"], watcher["name"]) for watcher in self.all}
        names = [("trace", scene) for scene in selection.scenes(exact_pictures.scenes())]
        if with_tests:
            names += [("test", name) for name in selection.tests(tests())]
        self.all = [watcher for watcher in self.all if (watcher["kind"], watcher["name"]) in names]
        if more := [name for name in names if name not in known]:
            self.all += self.found(jobs, more)
            if kept:
                kept.write_text(json.dumps({"shaders": of, "watchers": self.all}), encoding="utf-8")
        for watcher in self.all:
            watcher["lines"] = {(file, line) for file, line in watcher["lines"]}
        self.all.sort(key=lambda watcher: watcher["seconds"])

    def found(self, jobs, names):
        files, known = compiled.Files(), {}
        with tempfile.TemporaryDirectory(prefix="simreel-watch-") as folder, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            def one(at):
                return self.looked_at(pathlib.Path(folder) / str(at), *names[at])
            each = []
            for watcher, sources in pool.map(one, range(len(names))):
                watcher["lines"] = sorted(compiled.lines_of(sources, files, known))
                shutil.rmtree(sources)
                each.append(watcher)
        return each

    def looked_at(self, sources, kind, name):
        sources.mkdir()
        begin = time.monotonic()
        words = self.said(kind, name, GLSL, {"MESA_SHADER_DUMP_PATH": str(sources)})
        if words.startswith("failed"):
            sys.exit(f"without a change, too, {name} fails: {words}")
        return {"kind": kind, "name": name, "seconds": time.monotonic() - begin, "words": words}, sources

    def said(self, kind, name, glsl, env=None):
        """Runs one scene or test. Returns the state's hash or that the test passed; after a failure "failed" and the
        reason."""
        environment = {**os.environ, "SIMREEL_GLSL": str(glsl), "SIMREEL_ASSETS": str(ROOT / "assets"), **(env or {})}
        if kind == "trace":
            done, words = run([self.program, "trace", scene_file(name), "--frames", last_tested_frame(name), *look.ARGUMENTS],
                              2 * look.PATIENCE, stderr=subprocess.STDOUT, env=environment)
            hashes = re.findall(r"\b[0-9a-f]{16,}\b", words)
            return " ".join(hashes) if done == 0 and hashes else f"failed ({done}) {words[-400:]}"
        failed = look.test_that_fails(tempfile.gettempdir(), glsl, f"--test-case={look.pattern(name)}",
                                      env={**environment, "TMPDIR": tempfile.gettempdir()})
        return f"failed {failed}" if failed else "passed"

    def files(self):
        return sorted({file for watcher in self.all for file, _ in watcher["lines"]})

    def of(self, mutant):
        return [watcher for watcher in self.all if (mutant.file, mutant.number) in watcher["lines"]]

    def baseline_differs(self, scene, glsl):
        with self.lock:
            if scene not in self.sound and look.tested_frames_differ(self.program, scene, GLSL):
                print(f"without a change, too, {scene} is not as its baseline", file=sys.stderr, flush=True)
                os._exit(2)
            self.sound.add(scene)
        return look.tested_frames_differ(self.program, scene, glsl)

    def outcome(self, mutant):
        """Returns the same values as look.outcome()."""
        asked = self.of(mutant)
        if not asked:
            return "not reached", "", ""
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            glsl = mutant.written(folder)
            for watcher in asked:
                words = self.said(watcher["kind"], watcher["name"], glsl)
                if words == watcher["words"]:
                    continue
                if re.search(r"does not (compile|link)|syntax error", words) or not self.compiles(watcher, glsl):
                    return "not compiled", watcher["name"], ""
                if watcher["kind"] == "test":
                    return "caught", "test_gpu", watcher["name"]
                return "caught", f"{watcher['name']} {'failed' if words.startswith('failed') else 'state'}", ""
            for watcher in asked:
                if watcher["kind"] == "trace" and self.baseline_differs(watcher["name"], glsl):
                    return "caught", f"{watcher['name']} (test)", ""
        return ("equivalent" if mutant.changes_nothing() else "survived"), "", ""

    def compiles(self, watcher, glsl):
        """True if the watcher's kernels compile. A test reports only its failure, so the error text is searched."""
        if watcher["kind"] == "trace":
            return True
        done, words = run([pathlib.Path(tempfile.gettempdir()) / "test_gpu", f"--test-case={look.pattern(watcher['name'])}",
                           "--no-colors"], 6 * look.PATIENCE, stderr=subprocess.STDOUT, cwd=tempfile.gettempdir(),
                          env={**os.environ, "SIMREEL_GLSL": str(glsl), "TMPDIR": tempfile.gettempdir()})
        return done is None or not re.search(r"does not (compile|link)|syntax error", words)


def tests():
    """Returns the names of test_gpu's simulation tests: all tests except those of drawing."""
    done, words = run([pathlib.Path(tempfile.gettempdir()) / "test_gpu", "--list-test-cases", "--no-colors",
                       "--source-file-exclude=*gpu/draw/*"], look.PATIENCE)
    if done != 0:
        sys.exit(f"test_gpu does not list its tests: exit code {done}")
    return [line.strip() for line in words.splitlines() if line.strip() and not line.startswith(("[doctest]", "==="))]
