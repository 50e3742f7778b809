"""Shared helpers of the tests of `simreel test` and `simreel accept`."""
import ctypes
import json
import os
import select
import shutil
import struct
import zlib

from common import PATIENCE, SCENE, SOURCE, Case, png_rows, unfiltered, with_values

OTHER_PROCESSOR = "Testium 3, family 6 model 1 stepping 0"

# A scene that runs quickly, with 9x7 particles and three tested frames.
TESTED = with_values({"test": {"frames": [0, 3, 5], "size": [64, 36], "samples": 1}})

RED = {"objects.flag.material": {"color": [0.9, 0.1, 0.1]}}
# A slightly different green, so that pixels differ by a few units although the state is equal.
HAIR = {"objects.flag.material": {"color": [0.8, 0.705, 0.6]}}


def png(width, height, rows, depth=8, kind=2):
    """Returns a PNG file of raw rows (without filter bytes)."""
    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    palette = chunk(b"PLTE", bytes(range(6))) if kind == 3 else b""
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + palette +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))) + chunk(b"IEND", b""))


class GoldenCase(Case):
    """Base class with a folder `scenes` that contains one scene, `a`, and its baselines."""
    rasterizer = "exact"

    def setUp(self):
        super().setUp()
        self.set_scene({})

    def golden(self, *parts):
        return self.folder.joinpath("scenes/golden", *parts)

    def set_scene(self, values, name="a"):
        self.write(f"scenes/{name}.json", with_values({"render.rasterizer": self.rasterizer, **values}, TESTED))

    def make_baselines(self, *arguments):
        self.once("test", "scenes", "--update", *arguments)

    def run_suite(self, code, *arguments, **options):
        """Runs `simreel test scenes`, checks the exit code if one is given, and returns the report."""
        done = self.run_program("test", "scenes", "--json", "report.json", *arguments, **options)
        out = done.stdout.decode("utf-8", "replace") if done.stdout else ""
        if code is not None:
            self.assertEqual(done.returncode, code, f"{arguments}: {done.err}\n{out}")
        done.out = out
        report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        return report, done

    def one(self, code, *arguments, **options):
        """Runs the suite with its one scene and returns that scene's part of the report."""
        report, done = self.run_suite(code, *arguments, **options)
        self.assertEqual(len(report["scenes"]), 1)
        scene = report["scenes"][0]
        scene["text"], scene["code"] = done.out, done.returncode
        return scene

    def edit_json(self, path, change):
        content = json.loads(path.read_text(encoding="utf-8"))
        change(content)
        path.write_text(json.dumps(content), encoding="utf-8")

    def pretend_other_numerics(self):
        """Changes the baselines as if another driver had made the pictures, so that tolerances apply."""
        def change(baseline):
            for frame in baseline["frames"].values():
                frame["fingerprint"] = "0123456789abcdef"
        self.edit_json(self.golden("a/any/baseline.json"), change)

    def pretend_another_machine(self):
        """Changes the baselines as if a machine with another processor and equal numerics had made the pictures."""
        def change(baseline):
            for frame in baseline["frames"].values():
                frame["machine"]["processor"] = OTHER_PROCESSOR
        self.edit_json(self.golden("a/any/baseline.json"), change)

    def pixel_hash(self, picture):
        """Returns the program's hash of a PNG's pixels: puts the PNG, with the scene's text chunks, into a folder in
        place of a frame and reads the manifest after --skip-existing."""
        shutil.rmtree(self.folder / "found", ignore_errors=True)
        size = "{}x{}".format(*struct.unpack(">II", picture[16:24]))
        render = ("render", "scenes/a.json", "-o", "found/", "--frames", "0", "--size", size)
        self.good(*render)
        own = (self.folder / "found/000000.png").read_bytes()
        texts = own[33:own.index(b"IDAT") - 4]
        (self.folder / "found/manifest.json").unlink()
        self.write("found/000000.png", picture[:33] + texts + picture[33:])
        self.good(*render, "--skip-existing")
        return self.manifest("found")["frames"][0]["pixels"]

    def change_baseline(self, frame, x, y, step):
        """Changes one channel of one pixel of a baseline picture by `step`."""
        path = self.golden(f"a/any/{frame:06}.png")
        width, height, data = png_rows(path.read_bytes())
        rows = [bytearray(row) for row in unfiltered(data, 3 * width, 3)]
        value = rows[y][3 * x]
        rows[y][3 * x] = value + step if value < 128 else value - step
        picture = png(width, height, rows)
        path.write_bytes(picture)
        listed = self.pixel_hash(picture)
        self.edit_json(self.golden("a/any/baseline.json"), lambda b: b["frames"][str(frame)].update(pixels=listed))

    def mutated_glsl(self, name, old, new):
        """Copies the shaders with one place of one file changed, for $SIMREEL_GLSL."""
        folder = self.folder / "glsl"
        if not folder.exists():
            shutil.copytree(SOURCE / "glsl", folder)
        text = (SOURCE / "glsl" / name).read_text(encoding="utf-8")
        self.assertEqual(text.count(old), 1, f"{old!r} stands once in glsl/{name}")
        part = folder / (name + ".part")
        part.write_text(text.replace(old, new), encoding="utf-8")
        part.replace(folder / name)  # The rename is atomic, because the program may be reading the file.
        return {"SIMREEL_GLSL": str(folder)}


class Readings:
    """Counts how often a file was closed after reading, with inotify."""
    READ = 0x10  # inotify's IN_CLOSE_NOWRITE: a file that was open for reading has been closed

    def __init__(self, path):
        libc = ctypes.CDLL(None, use_errno=True)
        self.name, self.descriptor = path.name.encode(), libc.inotify_init1(os.O_CLOEXEC)
        if self.descriptor < 0 or libc.inotify_add_watch(self.descriptor, os.fsencode(path.parent), self.READ) < 0:
            raise OSError(ctypes.get_errno(), "inotify")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.descriptor)

    def wait(self, seconds=PATIENCE):
        """Returns the number of reads since the last call; waits for at least one, and returns 0 only after a
        timeout."""
        if not select.select([self.descriptor], [], [], seconds)[0]:
            return 0
        events, at, count = os.read(self.descriptor, 65536), 0, 0
        while at < len(events):
            (length,) = struct.unpack_from("I", events, at + 12)
            count += events[at + 16:at + 16 + length].rstrip(b"\0") == self.name
            at += 16 + length
        return count


__all__ = ["GoldenCase", "Readings", "HAIR", "OTHER_PROCESSOR", "RED", "SCENE", "TESTED", "png", "png_rows", "with_values"]
