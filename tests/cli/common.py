"""Shared helpers of the command-line tests: tiny scenes, a runner, and checks of messages and folders."""
import copy
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

PROGRAM = os.environ.get("SIMREEL", "simreel")
SOURCE = pathlib.Path(__file__).resolve().parents[2]

CLOTH = {"size": [9, 7], "spacing": 0.1, "position": [0, 1, 0], "rotation": [90, 0, 0], "jitter": 0.01, "substeps": 4,
         "pins": [{"rows": [-1]}]}
SCENE = {
    "version": 1, "stage": False,
    "render": {"size": [64, 36], "samples": 1},
    "time": {"fps": 30, "duration": 0.2},
    "camera": {"position": [0, 1, 3], "target": [0, 1, 0]},
    "sun": {"shadowSize": 64},
    "objects": {"flag": {"cloth": CLOTH}},
}
FRAMES = 6

# Time (s) after which a test considers a program to hang. No test depends on the speed of the machine, because no
# shorter limit is used. If a program ends before a test's signal arrives, the test starts the program again.
PATIENCE = 1200

# A stable simulation whose frames take long enough that a signal can arrive in the middle of one.
SLOW = {"render.size": [320, 240], "time.fps": 30, "time.duration": 2, "objects.flag.cloth.size": [64, 48],
        "objects.flag.cloth.spacing": 0.02, "objects.flag.cloth.substeps": 64}

# Texts that must never appear in the output, regardless of the failure.
CRASH = ("terminate called", "Aborted", "Segmentation", "Assertion", "core dumped", "AddressSanitizer",
         "runtime error:", "internal error at", "std::")


def with_values(values, scene=None):
    """Returns a copy of the scene with values set at dotted paths."""
    result = copy.deepcopy(SCENE if scene is None else scene)
    for path, value in values.items():
        steps = path.split(".")
        node = result
        for step in steps[:-1]:
            node = node.setdefault(step, {})
        node[steps[-1]] = value
    return result


def without_hash(manifest):
    """Returns a manifest's text in format version 3, which has no hash of itself at the end; other text is returned
    unchanged."""
    return re.sub(r',\n  "hash": "[0-9a-f]{32}"\n}\n$', "\n}\n", manifest).replace('"version": 4', '"version": 3', 1)


def png_rows(data):
    """Returns (width, height, raw filtered rows) of a PNG and checks all its chunks. Raises ValueError if the file is
    incomplete."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("no PNG signature")
    at, pixels, size, ended = 8, b"", None, False
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        (check,) = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        if zlib.crc32(kind + body) != check:
            raise ValueError(f"bad checksum of {kind}")
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        elif kind == b"IDAT":
            pixels += body
        ended = kind == b"IEND"
        at += 12 + length
    if not ended:
        raise ValueError("no end")
    return size[0], size[1], zlib.decompress(pixels)


def unfiltered(rows, stride, step):
    """Returns the bytes of a PNG's rows with the filters undone (specification 9.2); `step` is bytes per pixel."""
    result, above = [], bytes(stride)
    for start in range(0, len(rows), stride + 1):
        kind, line = rows[start], bytearray(rows[start + 1:start + 1 + stride])
        for i in range(stride):
            left = line[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            if kind == 4:
                guess = left + above[i] - corner
                nearest = min((abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]),
                              (abs(guess - corner), 2, corner))[2]
            else:
                nearest = (0, left, above[i], (left + above[i]) // 2)[kind]
            line[i] = (line[i] + nearest) & 255
        above = bytes(line)
        result.append(above)
    return result


class Case(unittest.TestCase):
    """Base class: each test runs in its own temporary folder, which contains scene.json."""
    written = {}  # files that the runs of once() wrote, by the arguments and the files before the run

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="simreel-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.write("scene.json", SCENE)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content, indent=1), encoding="utf-8")
        return path

    def run_program(self, *arguments, env=None, stdout=subprocess.PIPE, timeout=PATIENCE, **options):
        environment = dict(os.environ, **(env or {}))
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=stdout,
                              stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, timeout=timeout, check=False,
                              **options)
        done.err = done.stderr.decode("utf-8", "replace")
        for word in CRASH:
            self.assertNotIn(word, done.err)
        self.assertGreaterEqual(done.returncode, 0, f"ended by a signal: {done.err}")
        return done

    def good(self, *arguments, **options):
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.err)
        return done

    def once(self, *arguments):
        """Like good(), for a run that several tests begin with: later calls with the same arguments in a folder with the
        same files do not run the program, but write the files that the first call wrote."""
        before = Case.tree(self, ".")
        key = (arguments, tuple(before.items()))
        if key not in self.written:
            self.good(*arguments)
            self.written[key] = self.folder, {name: content for name, content in Case.tree(self, ".").items() if before.get(name) != content}
        folder, files = self.written[key]
        for name, content in files.items():  # run.json names the folder.
            self.write(name, content.replace(str(folder).encode(), str(self.folder).encode()))

    def bad(self, code, words, *arguments, **options):
        """Runs the program; expects the exit code and a single error that contains every word: a sentence after
        "simreel: error: "."""
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.err}")
        starts = [line for line in done.err.splitlines() if line.startswith("simreel: error: ")]
        self.assertEqual(len(starts), 1, f"one error line is expected: {done.err}")
        self.assert_words(words, done)
        return done

    def bad_scene(self, words, *arguments, **options):
        """Runs the program; expects exit code 2 and a report: three lines per error, and no other output."""
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, 2, f"{arguments}: {done.err}")
        self.assertEqual(done.stdout, b"")
        lines = done.err.removesuffix("\n").split("\n")
        self.assertEqual(len(lines) % 3, 0, done.err)
        for head, line, caret in zip(lines[::3], lines[1::3], lines[2::3]):
            self.assertRegex(head, r"^([^:]+:\d+:\d+|-D .+?): error: ")
            self.assertEqual(head.count("error: "), 1, head)
            self.assertRegex(line, "^  ")
            self.assertRegex(caret, r"^  +\^~*$")
        self.assert_words(words, done)
        return done

    def assert_words(self, words, done):
        for word in [words] if isinstance(words, str) else words:
            self.assertIn(word, done.err)

    def tree(self, folder):
        """Returns the bytes of every file below a folder, by path."""
        root = self.folder / folder
        return {str(p.relative_to(root)): p.read_bytes() for p in sorted(root.rglob("*")) if p.is_file()}

    def manifest(self, folder):
        return json.loads((self.folder / folder / "manifest.json").read_text(encoding="utf-8"))

    def content(self, folder):
        """Returns the bytes of every file of a folder by name, except run.json, which contains machines and times."""
        return {p.name: p.read_bytes() for p in (self.folder / folder).iterdir() if p.name != "run.json"}

    def runs(self, folder):
        """Returns the runs listed in a folder's run.json."""
        return json.loads((self.folder / folder / "run.json").read_text(encoding="utf-8"))["runs"]

    def assert_manifest_is_whole(self, folder):
        """Checks that every frame in the manifest exists and decodes; returns the frame numbers."""
        manifest = self.manifest(folder)
        for frame in manifest["frames"]:
            width, height, _ = png_rows((self.folder / folder / frame["file"]).read_bytes())
            self.assertEqual((width, height), (manifest["width"], manifest["height"]))
        return [frame["frame"] for frame in manifest["frames"]]

    def start(self, *arguments, **options):
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, **options)
        self.addCleanup(process.stderr.close)
        return process

    def wait_until(self, good, *processes):
        """Waits until good() is true or one of the processes has ended, and returns the result of good()."""
        end = time.monotonic() + PATIENCE
        while not (found := good()):
            if any(process.poll() is not None for process in processes):
                return good()
            self.assertLess(time.monotonic(), end, "it never came")
            time.sleep(0.002)
        return found

    def signal_when(self, good, folder, number, *arguments, **options):
        """Runs the program in the background, sends the signal once good() is true, and returns exit code and messages.
        If the run ends before the signal, restores the folder and starts again."""
        place = self.folder / folder
        kept = self.folder / "kept before the signal"
        if place.exists():
            shutil.copytree(place, kept, symlinks=True)
        for _ in range(20):
            process = self.start(*arguments, **options)
            self.wait_until(good, process)
            process.send_signal(number)
            messages = process.communicate(timeout=PATIENCE)[1].decode("utf-8", "replace")
            if process.returncode != 0:
                break
            shutil.rmtree(place, True)
            if kept.exists():
                shutil.copytree(kept, place, symlinks=True)
        shutil.rmtree(kept, True)
        if number != signal.SIGKILL:
            for word in CRASH:
                self.assertNotIn(word, messages)
        return process.returncode, messages

    def signal_after(self, count, folder, number, *arguments):
        """Calls signal_when() with the condition that `count` frames exist."""
        return self.signal_when(lambda: len(list((self.folder / folder).glob("*.png"))) >= count, folder, number, *arguments)

def main():
    unittest.main(verbosity=2)
