"""Tests where scenes and the files that they name are found, and which parts of the command line are stored with the
pictures."""
import json
import os
import shutil
import struct
import subprocess
import unittest
import zlib

from common import PATIENCE, PROGRAM, SOURCE, Case, main, with_values
from exr_file import write_exr


def png_texts(data):
    """Returns keyword -> text of a PNG's tEXt chunks."""
    texts, at = {}, 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"tEXt":
            keyword, text = data[at + 8:at + 8 + length].split(b"\0", 1)
            texts[keyword.decode()] = text.decode("latin-1")
        at += 12 + length
    return texts


def png(width, height, rgba):
    """Returns a PNG of one colour."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = (b"\0" + bytes(rgba) * width) * height
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Overrides(Case):
    def test_overrides_are_stored_with_the_pictures(self):
        self.good("render", "scene.json", "-o", "plain/", "--frames", "0")
        self.good("render", "scene.json", "-o", "changed/", "--frames", "0", "-D", "objects.flag.cloth.wind=[1, 0, 0]",
                  "--seed", "7", "--size", "32x18", "--fps", "25", "--samples", "1")
        self.assertEqual(json.loads((self.folder / "plain/manifest.json").read_text())["overrides"], [])
        kept = json.loads((self.folder / "changed/manifest.json").read_text())["overrides"]
        self.assertEqual(kept, ["objects.flag.cloth.wind=[1, 0, 0]", "seed=7", "render.size=[32,18]", "time.fps=25",
                                "render.samples=1"])
        self.assertNotIn("simreel:overrides", png_texts((self.folder / "plain/000000.png").read_bytes()))
        text = png_texts((self.folder / "changed/000000.png").read_bytes())["simreel:overrides"]
        self.assertEqual(text, "-D 'objects.flag.cloth.wind=[1, 0, 0]' -D seed=7 -D 'render.size=[32,18]' "
                               "-D time.fps=25 -D render.samples=1")
        # The stored arguments must render the same picture.
        subprocess.run(f"{PROGRAM} render scene.json -o again/ --frames 0 {text}", shell=True, cwd=self.folder, check=True)
        self.assertEqual((self.folder / "again/000000.png").read_bytes(), (self.folder / "changed/000000.png").read_bytes())

    def test_resume_names_the_changed_override(self):
        self.good("render", "scene.json", "-o", "out/", "--frames", "0")
        self.bad(2, ["cannot resume: what is changed in the scene is -D seed=7 in this run and nothing in the earlier one"],
                 "render", "scene.json", "-o", "out/", "--seed", "7", "--resume")

    def test_baked_points_store_overrides(self):
        self.good("bake", "scene.json", "-o", "out/", "--frames", "0", "--seed", "7")
        head = (self.folder / "out/flag_000000.ply").read_bytes().split(b"end_header")[0].decode()
        self.assertIn("comment overrides -D seed=7\n", head)


class Folders(Case):
    def setUp(self):
        super().setUp()
        self.write("there/board.png", png(4, 4, (200, 100, 50, 255)))
        self.write("project/scene.json", with_values({"objects.flag.material": {"texture": "board.png"}}))

    def test_assets_are_read_from_given_folders(self):
        refused = self.bad_scene(['error: no file "board.png" in '], "render", "project/scene.json", "-o", "out/")
        for command in (["render", "project/scene.json", "-o", "out/", "--frames", "0"], ["validate", "project/scene.json"],
                        ["trace", "project/scene.json", "--frames", "0"], ["bisect", "project/scene.json", "--frames", "1"],
                        ["bake", "project/scene.json", "-o", "baked/", "--frames", "0"],
                        ["bench", "project/scene.json", "--frames", "1", "--warm-up", "0"]):
            self.bad_scene([], *command) if command[0] != "validate" else self.bad(2, [], *command)
            self.good(*command, "--assets", "project", "--assets", "there")
        tested = self.run_program("test", "project", "--assets", "there")
        # Exit code 3 means that the scene has no baseline. It did run.
        self.assertEqual(tested.returncode, 3, tested.err)
        self.write("project/scene.json", with_values({"objects.flag.material": {"texture": "../there/board.png"}}))
        self.bad_scene(["lies outside the folders a scene may read", "--assets DIR lets it read another"], "render",
                       "project/scene.json", "-o", "out/")
        self.good("render", "project/scene.json", "-o", "other/", "--frames", "0", "--assets", "there")
        self.bad(2, ["--assets nowhere", "no such folder"], "validate", "project/scene.json", "--assets", "nowhere")

    def test_a_program_elsewhere_finds_the_shipped_assets(self):
        environment = {k: v for k, v in os.environ.items() if k != "SIMREEL_ASSETS"}
        shutil.copy(PROGRAM, self.folder / "elsewhere")
        done = subprocess.run([self.folder / "elsewhere", "validate", SOURCE / "assets/scenes/flag.json"], cwd=self.folder,
                              env=environment, capture_output=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, b""))


def gradient(width, height):
    """Returns a grey PNG, dark on its left."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes(255 * x // width for x in range(width)) for _ in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class ValidateAndRender(Case):
    """validate refuses what render refuses, with the same message and exit code."""

    def setUp(self):
        super().setUp()
        good = gradient(8, 8)
        files = {
            "good.png": good, "cut.png": good[:40], "text.png": b"hello", "black.png": png(4, 4, (0, 0, 0, 255)),
            "clear.png": png(4, 4, (200, 100, 50, 128)), "one.png": png(4, 4, (9, 9, 9, 254)),
            "m.stl": "solid x\nendsolid x\n", "m.fbx": "x", "empty.obj": "", "nan.obj": "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "good.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "cut.glb": b"glTF\2\0\0\0", "x.gltf": "{",
            "no.csv": "a,b\n1,2\n", "bad.csv": "x,y,z\n1,2,three\n", "good.csv": "x,y,z\n1,2,3\n",
            "bad.ply": "ply\nformat ascii 1.0\n", "bad.rle": "x = 3, y = 3\nqqq!", "wide.rle": "x = 99, y = 1\n99o!",
            "high.rle": "x = 3, y = 1, rule = B36/S23\n3o!", "life.rle": "x = 3, y = 1, rule = B3/S23\n3o!",
        }
        for name, content in files.items():
            self.write(name, content)

    def scene(self, objects):
        return {"version": 1, "render": {"size": [32, 18], "samples": 1}, "time": {"fps": 30, "duration": 0.1},
                "objects": objects}

    def both(self, objects, code, words):
        self.write("s.json", self.scene(objects))
        rendered = self.run_program("render", "s.json", "-o", "out/", "--frames", "0", "--overwrite")
        checked = self.run_program("validate", "s.json")
        self.assertEqual((rendered.returncode, checked.returncode), (code, code), (objects, rendered.err, checked.err))
        for done in (rendered, checked):
            self.assertIn(words, done.err)
        if code != 0:
            self.assertEqual(checked.err, rendered.err.replace("simreel: error: ", "s.json: error: ") +
                             "simreel: error: 1 of 1 scene cannot be used\n")
        return checked

    def test_pictures(self):
        stroke = [{"from": [8, 8, 0], "radius": 3}]
        for name, code, words in (("good", 0, ""), ("cut", 6, "not a picture"), ("text", 6, "not a picture"),
                                  ("clear", 2, "transparent in 16 of 16 pixels"), ("one", 2, "flatten it onto a colour")):
            picture = name + ".png"
            self.both({"a": {"sphere": {}, "material": {"texture": picture}}}, code, words)
            for member in ("image", "feedImage", "killImage"):
                self.both({"a": {"grayScott": {"size": [16, 16], member: picture}}}, code, words)
            self.both({"a": {"epidemic": {"size": [16, 16], "infected": 0.2, "population": picture}}}, code, words)
            for member in ("fuel", "obstacles", "moistureMap", "terrain"):
                self.both({"a": {"wildfire": {"size": [16, 16], "strokes": stroke, member: picture}}}, code, words)
        self.both({"a": {"epidemic": {"size": [16, 16], "infected": 0.2, "population": "black.png"}}}, 2, "dark all over")
        self.both({"a": {"wildfire": {"size": [16, 16], "strokes": stroke, "fuel": "black.png"}}}, 2, "can burn")

    def test_meshes(self):
        for name, code in (("good.obj", 0), ("m.fbx", 2), ("m.stl", 6), ("empty.obj", 6), ("nan.obj", 6), ("cut.glb", 6), ("x.gltf", 6)):
            self.both({"a": {"mesh": {"shape": "file", "file": name}}}, code, "" if code == 0 else name)
        fine = {"size": [10000, 0, 10000], "deform": [{"waves": [{"length": 1e-3}]}]}
        self.both({"a": {"mesh": fine}}, 2, "too short for a mesh")

    def test_particles(self):
        for name, code in (("good.csv", 0), ("no.csv", 6), ("bad.csv", 6), ("bad.ply", 6)):
            self.both({"a": {"particles": {"groups": [{"shape": "file", "file": name}]}}}, code, "" if code == 0 else name)
        self.write("s.json", self.scene({"a": {"particles": {"groups": [{"count": 16777216}] * 5}}}))
        for command in (["render", "s.json", "-o", "new/"], ["validate", "s.json"]):
            self.bad(2, ["83886080 particles", "that fit here"], *command)

    def test_automata(self):
        def life(*names, **more):
            return {"a": {"life": dict(size=[32, 32], patterns=[{"file": name, "at": [0, 0]} for name in names], **more)}}
        self.both(life("life.rle"), 0, "")
        self.both(life("bad.rle"), 2, "bad.rle")
        self.both(life("wide.rle"), 2, "99 x 1 cells")
        self.both(life("life.rle", "high.rle"), 2, "say in the scene which \"rule\" is meant")
        self.both({"a": {"life": {"size": [32, 32], "border": "dead", "patterns": [{"file": "life.rle", "at": [31, 0]}]}}}, 2,
                  "outside the grid")

    def test_limits_over_several_objects_are_checked(self):
        balls = {f"s{i}": {"sphere": {}} for i in range(33)}
        self.both(dict(balls, flag={"cloth": {}}), 2, "at most 32 shapes")

    def test_every_object_and_every_scene_is_reported(self):
        self.write("s.json", self.scene({"a": {"sphere": {}, "material": {"texture": "cut.png"}},
                                         "b": {"mesh": {"shape": "file", "file": "m.fbx"}}}))
        checked = self.run_program("validate", "s.json", "scene.json", "none.json")
        self.assertEqual(checked.returncode, 2)
        self.assertEqual(checked.stdout, b"scene.json: ok\n")
        lines = checked.err.splitlines()
        self.assertEqual(len(lines), 4, lines)
        for line, start in zip(lines, ("s.json: error: ", "s.json: error: ", "none.json: error: ", "simreel: error: 2 of 3 ")):
            self.assertTrue(line.startswith(start), line)

    def test_limits_of_the_device_are_checked_with_a_device(self):
        for large, kind in (({"size": [65536, 65536]}, "life"), ({"size": [16384, 16384], "infected": 0.2}, "epidemic"),
                            ({"size": [16384, 16384], "strokes": [{"from": [8, 8, 0], "radius": 3}]}, "wildfire"),
                            ({"groups": [{"count": 9000000}]}, "particles"), ({"size": [65536, 65536]}, "life")):
            self.write("s.json", self.scene({"a": {kind: large}}))
            self.assertIn(f'warning: s.json: {kind} "a" needs', self.good("validate", "s.json").err)
        self.bad(4, ["s.json: error: life \"a\" of 65536 x 65536 cells needs"], "validate", "s.json", "--device")
        done = self.good("validate", "--device", "scene.json", SOURCE / "assets/scenes/ripple.json")
        self.assertEqual(len(done.stdout.splitlines()), 2)
        self.good("validate", "--device=0", "scene.json")
        self.bad(4, ["no such device"], "validate", "--device=no such device", "scene.json")


class Skies(Case):
    def sky(self, channels="RGB", first=0.5, **attributes):
        values = {name: (2, [first] + [0.5] * 7) for name in channels}
        self.write("sky.exr", write_exr((4, 2, values, attributes)))
        self.write("s.json", {"version": 1, "sky": {"picture": "sky.exr"}, "objects": {"a": {"sphere": {}}}})

    def test_valid_sky_pictures_are_accepted(self):
        for attributes in ({}, {"envmap": ("envmap", b"\0")},
                           {"chromaticities": ("chromaticities", struct.pack("<8f", .64, .33, .3, .6, .15, .06, .3127, .329))}):
            self.sky(**attributes)
            self.assertEqual(self.good("validate", "s.json").err, "")
        self.sky(first=-1e-5)
        self.assertIn("sky.exr has 3 values a little below 0, which count as 0\n", self.good("validate", "s.json").err)

    def test_invalid_sky_pictures_are_refused(self):
        aces = struct.pack("<8f", .7347, .2653, 0, 1, .0001, -.077, .32168, .33767)
        for words, options in (("it is a cube map; convert it", {"envmap": ("envmap", b"\1")}),
                               ("has primaries of its own (red 0.735 0.265, green 0.000 1.000); convert it",
                                {"chromaticities": ("chromaticities", aces)}),
                               ("has no channel B", {"channels": "RG"}), ("has no channel R", {"channels": "BG"}),
                               ("has the value -0.01 at column 0, row 0", {"first": -0.01})):
            self.sky(**options)
            self.bad(6, words, "validate", "s.json")


class Warnings(Case):
    def warned(self, *arguments):
        return [line for line in self.good(*arguments).err.splitlines() if "warning" in line]

    def test_frames_beyond_the_end(self):
        words = ["simreel: warning: frame 9 is beyond the scene's last frame, 5 (0.2 s); the simulation continues past the end"]
        for command in (["render", "scene.json", "-o", "out/"], ["bake", "scene.json", "-o", "baked/"]):
            self.assertEqual(self.warned(*command, "--frames", "4-5"), [])
            self.assertEqual(self.warned(*command, "--frames", "5,9", "--overwrite"), words)
        self.assertEqual(self.warned("trace", "scene.json", "--frames", "5-9"), words)
        self.assertEqual(self.warned("bisect", "scene.json", "--frames", "10"), words)
        self.assertEqual(len(list((self.folder / "out").glob("*.png"))), 3)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_sizes_that_an_encoder_changes(self):
        for name, size, words in (("a.mp4", "33x19", "33x19 becomes 34x20"), ("b.webm", "32x19", "32x19 becomes 32x20"),
                                  ("c.mp4", "32x18", None), ("d.gif", "33x19", None)):
            warnings = self.warned("render", "scene.json", "-o", name, "--size", size, "--frames", "0-1")
            self.assertEqual(len(warnings), 0 if words is None else 1)
            if words is not None:
                self.assertIn(words, warnings[0])
            if shutil.which("ffprobe"):
                shown = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0:s=x",
                                        self.folder / name], capture_output=True, check=True, text=True).stdout.strip()
                self.assertEqual(shown, size if words is None else words.split()[-1])

    def test_a_float_wider_than_its_basin(self):
        def pool(**sides):
            box = {"shape": "box", "size": [4, 0.4, 1], "position": [0, 0.6, 0]}
            self.write("pool.json", {"version": 1, "objects": {"pool": {
                "water": {"size": [30, 30], "cell": 0.1, "terrain": {"bed": -3}, "floats": [box], **sides}}}})
            return self.warned("validate", "pool.json")
        self.assertEqual(pool(), ['simreel: warning: water "pool.floats.0": the float is 4 by 1 m, wider than the basin of 3 by 3 m; '
                                  "make it smaller or the basin larger"])
        self.assertEqual(pool(cell=0.2), [])

    def test_unknown_columns_are_reported(self):
        self.write("s.json", {"version": 1, "objects": {"a": {"particles": {"groups": [{"shape": "file", "file": "p.csv"}]}}}})
        for table, columns in (("x,y,z,radius,vX,\"note, long\"\n1,2,3,4,5,a\n", 'columns "radius", "note, long"'),
                               ("x,y,z,foo\n1,2,3,4\n", 'column "foo"'), ("x,y,z,mass\n1,2,3,4\n", None)):
            self.write("p.csv", table)
            warnings = self.warned("validate", "s.json")
            self.assertEqual(len(warnings), 1 if columns else 0, warnings)
            if columns:
                self.assertIn(f"p.csv: not used: {columns}; particles have x, y, z, vx, vy, vz, mass", warnings[0])

    def test_default_pins_are_reported(self):
        self.write("s.json", {"version": 1, "objects": {"sheet": {"cloth": {"size": [9, 9]}}}})
        render = ("render", "s.json", "--size", "32x18", "--frames", "0", "-o")
        line = 'cloth "sheet": its last row is pinned (default); "pins": [] lets it fall'
        self.assertEqual(self.good(*render, "a/").err.splitlines().count(line), 1)
        self.assertEqual(self.good(*render, "b/", "-q").err, "")
        self.assertNotIn("pinned", self.good(*render, "c/", "-D", "objects.sheet.cloth.pins=[]").err)

    def test_old_parameter_names_are_reported(self):
        self.write("old.json", """{"version": 1,
"test": {"tolerance": {"max_diff_ratio": 0.1}}, "checks": [{"what": "population", "least": 0}],
"objects": {"cells": {"life": {"size": [32, 32], "strokes": [{"at": 0, "share": 0.5}]}}}}""")
        words = ['old.json:2:24: "max_diff_ratio" is called "maxDiffRatio" now',
                 'old.json:2:83: "least" is called "min" now', 'old.json:3:72: "share" is called "fraction" now']
        warnings = self.warned("validate", "old.json")
        self.assertEqual(sorted(warnings), sorted("simreel: warning: " + line for line in words))


class StandardInput(Case):
    def feed(self, text, *arguments, code=0):
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, input=text, capture_output=True, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_a_scene_comes_from_standard_input(self):
        text = (self.folder / "scene.json").read_bytes()
        self.good("render", "scene.json", "-o", "a/")
        self.feed(text, "render", "-", "-o", "b/")
        self.assertEqual((self.folder / "a/000005.png").read_bytes(), (self.folder / "b/000005.png").read_bytes())
        self.assertEqual((self.folder / "a/manifest.json").read_bytes(), (self.folder / "b/manifest.json").read_bytes())
        self.assertEqual(self.feed(text, "validate", "-").stdout, b"-: ok\n")
        self.feed(text, "bench", "-", "--frames", "1", "--warm-up", "0", "--vary", "seed=1,2")
        self.assertIn(b"standard input can be read only once", self.feed(text, "bisect", "-", code=2).stderr)

    def test_its_files_are_read_from_the_current_folder(self):
        self.write("here.png", png(4, 4, (200, 100, 50, 255)))
        scene = json.dumps(with_values({"objects.flag.material": {"texture": "here.png"}})).encode()
        self.feed(scene, "render", "-", "-o", "out/", "--frames", "0")

    def test_mistakes(self):
        self.assertIn(b"<stdin>:1:16: error: unknown key \"sed\"; did you mean \"seed\"?\n",
                      self.feed(b'{"version": 1, "sed": 2}', "render", "-", "-o", "out/", code=2).stderr)
        self.assertIn(b"the text is empty", self.feed(b"", "validate", "-", code=2).stderr)
        self.assertIn(b"scene on standard input is larger than the limit of 4194304 bytes",
                      self.feed(b" " * (5 << 20), "render", "-", "-o", "out/", code=2).stderr)


if __name__ == "__main__":
    main()
