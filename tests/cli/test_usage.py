"""Exit code 2: mistakes on the command line and in the scene."""
import json
import os

from common import SCENE, Case, main, with_values


class CommandLine(Case):
    def usage(self, words, *arguments):
        self.bad(2, words, *arguments)
        self.assertFalse((self.folder / "out").exists(), arguments)

    def render(self, words, *arguments, output="out/"):
        self.usage(words, "render", "scene.json", "-o", output, *arguments)

    def test_commands(self):
        self.usage(["--help"])
        self.usage(["unknown command \"frobnicate\"", "--help"], "frobnicate")
        self.usage(["unknown command \"rendr\"", "did you mean \"render\"?"], "rendr", "scene.json", "-o", "out/")
        self.usage(["scene", "--help"], "render")
        self.usage(["--output", "--help"], "render", "scene.json")
        self.usage(["--frob"], "render", "scene.json", "-o", "out/", "--frob")
        self.usage(["other.json"], "render", "scene.json", "other.json", "-o", "out/")
        self.usage(["extra"], "schema", "extra")
        self.usage(["clth", "did you mean \"cloth\"?"], "list", "clth")

    def test_scene_files(self):
        self.usage(["none.json", "No such file"], "render", "none.json", "-o", "out/")
        self.usage(["is a folder"], "render", ".", "-o", "out/")
        self.usage(["is a folder"], "validate", ".")
        done = self.bad(2, ["none.json", "1 of 2 scenes"], "validate", "scene.json", "none.json")
        self.assertEqual(done.stdout, b"scene.json: ok\n")

    def test_overrides(self):
        self.render(["-D takes path=value", "\"foo\""], "-D", "foo")
        self.render(["-D takes path=value"], "-D", "=3")
        self.render(["time.fsp=3", "did you mean \"fps\"?"], "-D", "time.fsp=3")
        self.render(["expected a number, found a string"], "-D", "time.fps=abc")
        self.render(["time..fps", "empty part"], "-D", "time..fps=3")
        self.render(["there is no \"x\""], "-D", "time.fps.x=3")
        self.render(["whole number", "1.5"], "-D", "render.samples=1.5")
        self.render(["expected a number"], "-D", "time.fps=NaN")
        self.render(["expected"], "-D", "render=3")

    def test_sizes(self):
        for size in ("3", "3x", "x3", "0x4", "-1x4", "3x4x5", "99999999999x2", "3 x 4", "3X4", ""):
            self.render(["--size takes WxH", f"\"{size}\""], f"--size={size}" if size else "--size", *([] if size else [""]))
        self.render(["20000", "16384"], "--size", "20000x3")

    def test_frames(self):
        for frames, word in (("5-2", "backwards"), ("abc", "a frame number is expected"), ("-3", "is expected"),
                             ("99999999999", "above"), ("0-100000000", "above"), ("1-5x0", "at least 1"),
                             ("1,,2", "character 3"), ("3-", "last frame"), ("1 2", "unexpected"), ("1.5", "unexpected"),
                             ("", "is expected"), ("1-5x", "step")):
            self.render(["--frames", word, "for example"], *(["--frames", frames]))

    def test_outputs(self):
        for output, word in (("", "empty"), ("out.jpg", ".jpg"), ("a%s.png", "%04d"), ("a_##_##.png", "once"),
                             ("a_####.jpg", ".png"), ("d##/a.png", "folder"), ("x.png", "x_####.png"),
                             ("a%.png", "%04d"), ("a" + "#" * 21 + ".png", "20")):
            self.usage(["--output", word], "render", "scene.json", "-o", output)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["scene.json"])

    def test_values_of_options(self):
        self.render(["--overwrite", "--resume", "exclude"], "--overwrite", "--resume")
        self.render(["--skip-existing", "exclude"], "--skip-existing", "--resume")
        self.render(["--progress", "loud", "ndjson"], "--progress", "loud")
        self.render(["jpg", "y4m"], "--stream-format", "jpg")
        self.render(["jpg", "y4m"], "--stream-format", "jpg", output="-")
        self.render(["--seed", "abc"], "--seed", "abc")
        self.render(["seed", "-1"], "--seed", "-1")
        self.render(["--seed"], "--seed", "99999999999")
        self.render(["fps", "number"], "--fps", "nan")
        self.render(["fps", "number"], "--fps", "inf")
        self.render(["0.001"], "--fps", "0")
        self.render(["99", "16"], "--samples", "99")
        self.render(["--samples", "x"], "--samples", "x")

    def test_a_stream_keeps_nothing(self):
        for flag in ("--resume", "--skip-existing"):
            self.usage(["--output -", flag], "render", "scene.json", "-o", "-", flag)

    def test_a_video_cannot_be_resumed(self):
        self.bad(2, ["--resume", "a.mp4", "folder"], "render", "scene.json", "-o", "a.mp4", "--resume")


class SceneMistakes(Case):
    def mistake(self, words, text):
        """The same report from validate and from render."""
        self.write("bad.json", text)
        checked = self.bad(2, words, "validate", "bad.json")
        rendered = self.bad(2, words, "render", "bad.json", "-o", "out/")
        self.assertFalse((self.folder / "out").exists())
        self.assertEqual(rendered.err.replace("simreel: error: ", "", 1).splitlines(),
                         checked.err.splitlines()[:-1])
        return rendered.err

    def test_syntax(self):
        self.mistake(["bad.json:2:3: error: not valid JSON", "\n    \"title\": x}\n    ^~~~~~~~~~\n"], '{"version": 1,\n  "title": x}')
        self.mistake(["bad.json:", "error:", "^"], '{"version": 1')
        self.mistake(["bad.json:1:1: error: the file is empty"], "")
        self.mistake(["bad.json:", "not valid JSON"], '{"version": 1, "time": {"fps": NaN}}')
        self.mistake(["bad.json:1:32: error: this number is too large"], '{"version": 1, "time": {"fps": 1e999}}')
        self.mistake(["bad.json:1:65: error: nested deeper than 64"], "[" * 100000)
        self.mistake(["bad.json:1:", "nested deeper"], '{"a":' * 100000)
        self.mistake(["the key \"seed\" is given twice"], '{"version": 1, "seed": 1, "seed": 2}')
        self.mistake(["bad.json:1:1: error: a scene is an object"], "[]")
        self.mistake(["\"version\": 1"], "{}")
        self.mistake(["version 1"], '{"version": 2}')

    def test_binary(self):
        err = self.mistake(["bad.json:1:1: error: not valid JSON"], b"\x89PNG\r\n\x1a\n\0\0\x1b[31m" + bytes(range(256)))
        self.assertNotIn("\x1b", err)
        self.mistake(["bad.json:1:", "error:"], b'{"version": 1, "title": "\xff\xfe"}')
        self.mistake(["larger than the limit"], b" " * (5 << 20))

    def test_every_mistake_at_once(self):
        err = self.mistake([
            "bad.json:3:2: error: unknown key \"titel\"; did you mean \"title\"?",
            "bad.json:4:18: error: expected a number, found a string",
            "bad.json:6:9: error: unknown kind of object \"clothh\"; did you mean \"cloth\"?",
            "bad.json:7:28: error: 1 is outside the range 2 to 16384",
            "bad.json:7:35: error: unknown key \"stifness\"; did you mean \"stiffness\"?",
            "already",
        ], """{
 "version": 1,
 "titel": "x",
 "time": {"fps": "a"},
 "objects": {
  "a": {"clothh": {}},
  "b": {"cloth": {"size": [1, 2], "stifness": 3}},
  "c": {"cloth": {}, "sphere": {}}}}
""")
        lines = err.splitlines()
        self.assertEqual(len(lines), 18)
        at = next(i for i, line in enumerate(lines) if "titel" in line)
        self.assertEqual(lines[at + 1:at + 3], ["   \"titel\": \"x\",", "   ^~~~~~~"])

    def test_textures(self):
        def scene(texture):
            return json.dumps(with_values({"objects.flag.material": {"texture": texture}}))
        self.mistake(["none.png", "no file"], scene("none.png"))
        for outside in ("../../etc/passwd", "/etc/passwd"):
            self.mistake([outside, "leaves the scene's folder"], scene(outside))
        os.symlink("/etc/passwd", self.folder / "link.png")
        self.mistake(["link.png", "leaves the scene's folder"], scene("link.png"))
        self.mistake(["no file"], scene("."))

    def test_values(self):
        self.mistake(["same point"], json.dumps(with_values({"camera": {"position": [1, 1, 1], "target": [1, 1, 1]}})))
        self.mistake(["10 million"], json.dumps(with_values({"time": {"fps": 1e5, "duration": 1e6}})))
        self.mistake(["row 7 is outside"], json.dumps(with_values({"objects.flag.cloth.pins": [{"rows": [7]}]})))
        self.mistake(["16384"], json.dumps(with_values({"objects.flag.cloth.size": [16385, 3]})))

    def test_too_many_colliders(self):
        scene = with_values({})
        scene["objects"] = dict(SCENE["objects"], **{f"s{i}": {"sphere": {}} for i in range(13)})
        self.write("many.json", scene)
        self.bad(2, ["12", "13", "\"collides\": false"], "render", "many.json", "-o", "out/")
        self.assertEqual(list(self.folder.glob("out/*")), [])


if __name__ == "__main__":
    main()
