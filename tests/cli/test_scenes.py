"""Where scenes and what they name come from, and what of the command line is kept with the pictures."""
import json
import os
import shutil
import struct
import subprocess
import zlib

from common import PROGRAM, SOURCE, Case, main, with_values


def png_texts(data):
    """Keyword -> text of a PNG's tEXt chunks."""
    texts, at = {}, 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"tEXt":
            keyword, text = data[at + 8:at + 8 + length].split(b"\0", 1)
            texts[keyword.decode()] = text.decode("latin-1")
        at += 12 + length
    return texts


def png(width, height, rgba):
    """A PNG of one colour."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = (b"\0" + bytes(rgba) * width) * height
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Overrides(Case):
    def test_they_are_kept_with_the_pictures(self):
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
        # What stands there makes the same picture again.
        subprocess.run(f"{PROGRAM} render scene.json -o again/ --frames 0 {text}", shell=True, cwd=self.folder, check=True)
        self.assertEqual((self.folder / "again/000000.png").read_bytes(), (self.folder / "changed/000000.png").read_bytes())

    def test_a_resumed_run_names_the_difference(self):
        self.good("render", "scene.json", "-o", "out/", "--frames", "0")
        self.bad(2, ["cannot resume: what is changed in the scene is -D seed=7 in this run and nothing in the earlier one"],
                 "render", "scene.json", "-o", "out/", "--seed", "7", "--resume")

    def test_baked_points_name_them(self):
        self.good("bake", "scene.json", "-o", "out/", "--frames", "0", "--seed", "7")
        head = (self.folder / "out/flag_000000.ply").read_bytes().split(b"end_header")[0].decode()
        self.assertIn("comment overrides -D seed=7\n", head)


class Folders(Case):
    def setUp(self):
        super().setUp()
        self.write("there/board.png", png(4, 4, (200, 100, 50, 255)))
        self.write("project/scene.json", with_values({"objects.flag.material": {"texture": "board.png"}}))

    def test_assets_may_lie_in_folders_that_are_given(self):
        refused = self.bad_scene(['error: no file "board.png" in '], "render", "project/scene.json", "-o", "out/")
        for command in (["render", "project/scene.json", "-o", "out/", "--frames", "0"], ["validate", "project/scene.json"],
                        ["trace", "project/scene.json", "--frames", "0"], ["bisect", "project/scene.json", "--frames", "1"],
                        ["bake", "project/scene.json", "-o", "baked/", "--frames", "0"],
                        ["bench", "project/scene.json", "--frames", "1", "--warm-up", "0"]):
            self.bad_scene([], *command) if command[0] != "validate" else self.bad(2, [], *command)
            self.good(*command, "--assets", "project", "--assets", "there")
        tested = self.run_program("test", "project", "--assets", "there")
        self.assertEqual(tested.returncode, 3, tested.err)  # no baseline, but it ran
        self.write("project/scene.json", with_values({"objects.flag.material": {"texture": "../there/board.png"}}))
        self.bad_scene(["lies outside the folders a scene may read", "--assets DIR lets it read another"], "render",
                       "project/scene.json", "-o", "out/")
        self.good("render", "project/scene.json", "-o", "other/", "--frames", "0", "--assets", "there")
        self.bad(2, ["--assets nowhere", "no such folder"], "validate", "project/scene.json", "--assets", "nowhere")

    def test_a_program_built_elsewhere_finds_the_shipped_ones(self):
        environment = {k: v for k, v in os.environ.items() if k != "SIMREEL_ASSETS"}
        shutil.copy(PROGRAM, self.folder / "elsewhere")
        done = subprocess.run([self.folder / "elsewhere", "validate", SOURCE / "assets/scenes/flag.json"], cwd=self.folder,
                              env=environment, capture_output=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, b""))


class StandardInput(Case):
    def feed(self, text, *arguments, code=0):
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, input=text, capture_output=True, timeout=60, check=False)
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
        self.assertIn(b"standard input comes once", self.feed(text, "bisect", "-", code=2).stderr)

    def test_what_it_names_lies_in_the_current_folder(self):
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
