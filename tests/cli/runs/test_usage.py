"""Tests exit code 2: errors on the command line and in the scene."""
import json
import os

from common import SCENE, SOURCE, Case, main, with_values


class CommandLine(Case):
    def usage(self, words, *arguments):
        self.bad(2, words, *arguments)
        self.assertFalse((self.folder / "out").exists(), arguments)

    def render(self, words, *arguments, output="out/"):
        self.usage(words, "render", "scene.json", "-o", output, *arguments)

    def test_commands(self):
        self.usage(["--help"])
        self.usage(["no command \"frobnicate\"", "--help"], "frobnicate")
        self.usage(["no command \"rendr\"; did you mean \"render\"?", "Render a scene to pictures or a video", "see `simreel --help`"], "rendr", "scene.json", "-o", "out/")
        self.usage(["scene", "--help"], "render")
        self.usage(["--output", "--help"], "render", "scene.json")
        self.usage(["--frob"], "render", "scene.json", "-o", "out/", "--frob")
        self.usage(["other.json"], "render", "scene.json", "other.json", "-o", "out/")
        self.usage(["extra"], "schema", "extra")
        self.usage(["clth", "did you mean \"cloth\"?"], "list", "clth")

    def test_mistyped_options(self):
        """The message names the mistyped option first, then the command's nearest option, its help, and the command's
        page."""
        for arguments, name, meant, command in (
                (("render", "scene.json", "-o", "out/", "--frame", "3"), "--frame", "--frames", "render"),
                (("render", "scene.json", "-o", "out/", "--frame=3"), "--frame", "--frames", "render"),
                (("render", "scene.json", "--outpt", "out/"), "--outpt", "--output", "render"), (("render", "scene.json", "--out", "out/"), "--out", "--output", "render"),
                (("render", "--sise=3x3"), "--sise", "--size", "render"), (("render", "scene.json", "-o", "out/", "--verbos"), "--verbos", "--verbose", "render"),
                (("test", ".", "--filtr", "x"), "--filtr", "--filter", "test"),
                (("report", "merge", "a", "-o", "b", "--junt", "c"), "--junt", "--junit", "report merge")):
            with self.subTest(name):
                done = self.bad(2, [f"simreel: error: no flag {name}; did you mean {meant}?\n  ", f"see `simreel {command} --help`"], *arguments)
                self.assertRegex(done.err.splitlines()[1], rf"^  (-\w, )?{meant}( |$)")
        self.usage(["`simreel test` has no flag --sise; --size is a flag of render, "], "test", "--sise", "4x4")
        self.usage(["`simreel render` has no flag --frobnicate; see `simreel render --help`"], "render", "scene.json", "-o", "out/", "--frobnicate")
        self.usage(["`simreel render` has no flag -z; see"], "render", "scene.json", "-o", "out/", "-z")
        self.usage(['no command "mrge"; did you mean "merge"?', "see `simreel report --help`"], "report", "mrge")

    def test_missing_arguments_are_named(self):
        self.usage(["`simreel render` needs --output\n  -o, --output", "see `simreel render --help`"], "render", "scene.json")
        self.usage(["`simreel diff` needs B\n  B ", "usage: simreel diff A B"], "diff", "a.png")
        self.usage(["--frames needs a value\n  --frames"], "render", "scene.json", "-o", "out/", "--frames")
        self.usage(["--turn takes a number, not fast\n  --turn"], "render", "scene.json", "-o", "out/", "--turn", "fast")
        self.usage(["`simreel report` needs a command: merge"], "report")
        self.usage(["simreel needs a command, for example: simreel render "])
        self.usage(["`simreel render` takes no other.json", "see `simreel render --help`"], "render", "scene.json", "other.json", "-o", "out/")
        self.usage(["scene.json is no command; to render that scene: simreel render scene.json"], "scene.json")

    def test_outputs_are_checked_before_a_device_is_opened(self):
        """Existing or unwritable outputs are reported before anything is simulated to place a camera."""
        nothing = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nothing"}
        for output in ("scene.json/out/", "/proc/self/out/", "/proc/nowhere/a.mp4", "/proc/self/a_####.png"):
            self.bad(6, ["cannot create"], "render", "scene.json", "-o", output, env=nothing)
        self.write("a.mp4", "here")
        self.write("there/000003.png", "here")
        for output in ("a.mp4", "there/"):
            self.bad(6, ["exist", "--overwrite"], "render", "scene.json", "-o", output, env=nothing)
        self.bad(4, ["install a driver"], "render", "scene.json", "-o", "new/deep/", env=nothing)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.mp4", "scene.json", "there"])

    def test_scene_files(self):
        self.usage(["none.json", "No such file"], "render", "none.json", "-o", "out/")
        self.usage(["is a folder"], "render", ".", "-o", "out/")
        self.usage(["is a folder"], "validate", ".")
        done = self.bad(2, ["none.json", "1 of 2 scenes"], "validate", "scene.json", "none.json")
        self.assertEqual(done.stdout, b"scene.json: ok\n")

    def override(self, message, caret, argument, *arguments):
        """Expects one error in `-D argument`, with the caret line below it."""
        done = self.bad_scene([], "render", "scene.json", "-o", "out/", *(arguments or ("-D", argument)))
        self.assertEqual(done.err.splitlines(), [f"-D {argument}: error: {message}", "  " + argument, "  " + caret])
        self.assertFalse((self.folder / "out").exists(), argument)

    def test_overrides(self):
        self.render(["error: -D foo: expected path=value, for example -D time.fps=30\n"], "-D", "foo")
        self.render(["error: -D =3: expected path=value, for example -D time.fps=30\n"], "-D", "=3")
        self.override('unknown key "fsp"; did you mean "fps"?', "     ^~~", "time.fsp=3")
        self.override("expected a number, found a string", "         ^~~", "time.fps=abc")
        self.override("expected a number, found a string", "         ^~~", "time.fps=NaN")
        self.override("expected a number, found a string", "         ^", "time.fps=")
        self.override("a name is missing in this path", "     ^", "time..fps=3")
        self.override('"time.fps" is a number, which holds nothing named "x"', "         ^", "time.fps.x=3")
        self.override("expected a whole number, found 1.5", "               ^~~", "render.samples=1.5")
        self.override('expected an object, such as {"size": [640, 360]}, found a number', "       ^", "render=3")
        self.override("no item 2; the list has 2, counted from 0", "            ^", "render.size.2=3")
        self.override("expected ',' or ']'; is a comma missing?", "               ^", "render.size=[3 4]")

    def test_sizes(self):
        for size in ("3", "3x", "x3", "0x4", "-1x4", "3x4x5", "99999999999x2", "3 x 4", "3X4", ""):
            self.render(["--size takes WxH", f"\"{size}\""], f"--size={size}" if size else "--size", *([] if size else [""]))
        self.override('"size" must be between 1 and 16384 pixels, found 20000', "             ^~~~~", "render.size=[20000,3]",
                      "--size", "20000x3")

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

    def test_names_of_files_that_are_something_else(self):
        """A folder where a video or picture is asked for, links, and pipes that no program reads are errors before
        anything is simulated."""
        for name, kind in (("x.mp4", "video"), ("x.png", "picture")):
            (self.folder / name).mkdir()
            self.usage([f"--output {name}: this is a folder, not a {kind}", "add a /"], "render", "scene.json", "-o", name, "--frames", "0")
        for name in ("link.mp4", "link.png"):
            (self.folder / name).symlink_to("nowhere")
            self.bad(6, [f"{name} exists", "--overwrite"], "render", "scene.json", "-o", name, "--frames", "0")
        os.mkfifo(self.folder / "pipe.mp4")
        self.usage(["pipe.mp4: this is a pipe or a device", "-o -"], "render", "scene.json", "-o", "pipe.mp4", "--overwrite")
        os.mkfifo(self.folder / "pipe.png")
        self.bad(6, ["cannot write pipe.png: it is a pipe or a socket that no program reads"], "render", "scene.json", "-o", "pipe.png",
                 "--frames", "0", "--overwrite", "--no-manifest")

    def test_options_without_effect_are_refused(self):
        """Each takes milliseconds, because nothing is simulated."""
        for words, arguments in (
                ("--jobs has no effect without --pieces", ("render", "scene.json", "-o", "out/", "-j", "4")),
                ("--jobs and --slurm exclude each other", ("render", "scene.json", "-o", "out/", "-j", "4", "--pieces", "2", "--slurm")),
                ("--slurm has no effect without --pieces", ("render", "scene.json", "-o", "out/", "--slurm")),
                ("--scratch has no effect without --pieces", ("render", "scene.json", "-o", "out/", "--scratch", "/tmp")),
                ("--sbatch has no effect without --slurm", ("render", "scene.json", "-o", "out/", "--pieces", "2", "--sbatch=--x")),
                ("--sbatch has no effect without --slurm", ("sweep", "scene.json", "--vary", "seed=1,2", "-o", "out/", "--sbatch=--x")),
                ("--stream-format has no effect with --output out/", ("render", "scene.json", "-o", "out/", "--stream-format", "y4m")),
                ("--bits 16 has no effect with --pieces", ("render", "scene.json", "-o", "out/", "--pieces", "2", "--bits", "16")),
                ("exclude each other", ("render", "scene.json", "-o", "out/", "--pieces", "2", "--debug")),
                ("--fields has no effect with --frames none", ("render", "scene.json", "-o", "out/", "--frames", "none",
                                                               "--checkpoint-at", "2", "--fields", "npy")),
                ("exclude each other", ("sweep", "scene.json", "--vary", "seed=1,2", "-o", "out/", "--plan-only", "-j", "2")),
                ("--overwrite belongs to `simreel sweep SCENE`", ("sweep", "status", "out", "--overwrite")),
                ("exclude each other", ("explain", "scene.json", "--quick", "--device", "0")),
                ("exclude each other", ("list", "cloth", "--reference", "out")),
                ("exclude each other", ("kernels", "a.compute", "--check", "scene.json", "--glsl")),
                ("--device has no effect without --check", ("kernels", "a.compute", "--device", "0")),
                ("--repeat and --expected exclude each other", ("test", "--expected", "out", "--actual", "b", "--repeat", "3")),
                ("--jobs has no effect with --actual", ("test", "--expected", "out", "--actual", "b", "--jobs", "3")),
                ("--reason has no effect with --update=prune", ("test", "scene.json", "--update=prune", "--reason", "x")),
                ("--markdown-pictures has no effect without --markdown", ("test", "scene.json", "--markdown-pictures", "none"))):
            with self.subTest(arguments=arguments):
                self.usage(words, *arguments)

    def test_an_option_given_twice_and_help_as_a_command(self):
        self.render(["--size is given more than once"], "--size", "8x8", "--size", "4x4")
        self.usage(['scene.json has no value "camera.lens.nothing"'], "explain", "scene.json", "camera.lens.nothing", "--quick")
        self.assertEqual(self.good("help", "render").stdout, self.good("render", "--help").stdout)
        self.assertIn(b"Usage: simreel", self.good("help").stdout)

    def test_values_of_options(self):
        self.render(["--overwrite", "--resume", "exclude"], "--overwrite", "--resume")
        self.render(["--skip-existing", "exclude"], "--skip-existing", "--resume")
        self.render(["--progress", "loud", "ndjson"], "--progress", "loud")
        self.render(["jpg", "y4m"], "--stream-format", "jpg")
        self.render(["jpg", "y4m"], "--stream-format", "jpg", output="-")
        self.render(["--seed", "abc"], "--seed", "abc")
        self.override('"seed" must be at least 0, found -1', "     ^~", "seed=-1", "--seed", "-1")
        self.render(["--seed"], "--seed", "99999999999")
        for fps in ("nan", "inf"):
            self.override("expected a number, found a string", "         ^~~", f"time.fps={fps}", "--fps", fps)
        for fps in ("0", "1e-30"):
            self.override(f'"fps" must be between 0.001 and 100000 frames/s, found {fps}',
                          " " * 9 + "^".ljust(len(fps), "~"), f"time.fps={fps}", "--fps", fps)
        self.override('"samples" must be between 1 and 16, found 99', "               ^~", "render.samples=99",
                      "--samples", "99")
        self.render(["--samples", "x"], "--samples", "x")

    def test_a_stream_cannot_be_resumed(self):
        for flag in ("--resume", "--skip-existing"):
            self.usage(["--output -", flag], "render", "scene.json", "-o", "-", flag)

    def test_a_video_cannot_be_resumed(self):
        self.bad(2, ["--resume", "a.mp4", "folder"], "render", "scene.json", "-o", "a.mp4", "--resume")


class SceneMistakes(Case):
    def test_unknown_names_are_reported_with_all_other_errors(self):
        self.write("bad.json", """{"version": 1, "objects": {
            "flag": {"cloth": {"spacing": -1, "air": {"fluid": "smoke"}, "walls": "cave"}}, "ball": {"sphere": {"radius": -1}}},
            "camera": {"track": "bal"}, "lights": {"lamp": {"follow": {"object": "cve"}}}, "test": {"frames": [9999]}}""")
        for command in (("validate", "bad.json"), ("render", "bad.json", "-o", "out/")):
            done = self.run_program(*command)
            self.assertEqual(done.returncode, 2)
            for words in ('"spacing" must be', '"radius" must be', "frame 9999 is beyond", 'no object is named "bal"; did you mean "ball"?',
                          'no object is named "cve"', "smoke", "cave"):
                self.assertIn(words, done.err)
            self.assertEqual(done.err.count("error: "), 7 + (command[0] == "validate"), done.err)
        # An object with an unreadable value or an unknown kind counts as existing, so references to it cause no further
        # error.
        self.write("bad.json", '{"version": 1, "objects": {"flag": {"clth": {}}}, "camera": {"track": "flag"}}')
        self.assertEqual(self.run_program("validate", "bad.json").err.count("error: "), 2)

    def mistake(self, words, text):
        """Expects the same report from validate and from render."""
        self.write("bad.json", text)
        checked = self.bad(2, words, "validate", "bad.json")
        rendered = self.bad_scene(words, "render", "bad.json", "-o", "out/")
        self.assertFalse((self.folder / "out").exists())
        self.assertEqual(rendered.err + "simreel: error: 1 of 1 scene cannot be used\n", checked.err)
        return rendered.err

    def only(self, head, caret, text):
        """Expects one error: its first line after "bad.json:", and the caret line below it."""
        lines = self.mistake([], text).splitlines()
        self.assertEqual([lines[0], *lines[2:]], ["bad.json:" + head, caret])

    def test_a_parameter_without_effect_causes_a_warning(self):
        self.write("idle.json", '{"version": 1, "render": {"size": [16, 9], "raySamples": 8},\n "objects": {"ball": {"sphere": {}}}}')
        warning = ('idle.json:1:44: warning: "raySamples" is for "quality": "high"; here it does nothing\n'
                   '  {"version": 1, "render": {"size": [16, 9], "raySamples": 8},\n'
                   + " " * 45 + "^~~~~~~~~~~~\n")
        checked = self.good("validate", "idle.json")
        self.assertEqual((checked.err, checked.stdout), (warning, b"idle.json: ok\n"))
        render = ("render", "idle.json", "--frames", "0-1", "--overwrite", "-o", "out/")
        self.assertEqual(self.good(*render).err.count(warning), 1)
        self.assertEqual(self.good(*render, "-q").err, "")
        said = [json.loads(line) for line in self.good(*render, "--progress", "ndjson").err.splitlines()]
        self.assertIn({"event": "message", "level": "warning", "text": warning[:-1]}, said)
        self.assertEqual(self.good("validate", "idle.json", "-D", "render.quality=high").err, "")
        self.write("idle.json", '{"version": 1, "render": {"quality": "high", "raySamples": 8}, "objects": {"ball": {"sphere": {}}}}')
        self.assertEqual(self.good("validate", "idle.json", "-D", "render.quality=draft").err, "")

    def test_syntax(self):
        self.mistake(['bad.json:2:12: error: unknown word "x"; strings and keys need double quotes\n'
                      '    "title": x}\n'
                      '             ^\n'], '{"version": 1,\n  "title": x}')
        self.only("1:14: error: the text ends, but the '{' of line 1 is still open", " " * 15 + "^", '{"version": 1')
        self.only("1:1: error: the text is empty; a scene begins with {", "  ^", "")
        self.only("1:32: error: NaN is not a number in JSON; give a finite number", " " * 33 + "^~~",
                  '{"version": 1, "time": {"fps": NaN}}')
        self.only('1:32: error: "1e999" is beyond the largest number there is, 1.8e308', " " * 33 + "^~~~~",
                  '{"version": 1, "time": {"fps": 1e999}}')
        self.only("1:65: error: nested deeper than 64 levels", " " * 65 + "^", "[" * 100000)
        self.only("1:321: error: nested deeper than 64 levels", " " * 65 + "^", '{"a":' * 100000)
        self.only('1:27: error: key "seed" is given twice in this object', " " * 28 + "^~~~~~",
                  '{"version": 1, "seed": 1, "seed": 2}')
        self.only("1:1: error: expected a scene in { }, found a list", "  ^~", "[]")
        self.only('1:1: error: the scene has no version; add "version": 2', "  ^", "{}")
        self.only("1:13: error: unknown version 3; this program reads versions 1 to 2", " " * 14 + "^", '{"version": 3}')

    def test_binary(self):
        err = self.mistake(["bad.json:3:1: error: zero byte; is this a text file?"],
                           b"\x89PNG\r\n\x1a\n\0\0\x1b[31m" + bytes(range(256)))
        self.assertNotIn("\x1b", err)
        self.only("1:26: error: not valid UTF-8; save the text as UTF-8", " " * 27 + "^",
                  b'{"version": 1, "title": "\xff\xfe"}')
        self.write("bad.json", b" " * (5 << 20))
        for command in (["validate", "bad.json"], ["render", "bad.json", "-o", "out/"]):
            self.bad(2, ["bad.json is larger than the limit of 4194304 bytes"], *command)

    def test_all_errors_are_reported_at_once(self):
        err = self.mistake([
            "bad.json:3:2: error: unknown key \"titel\"; did you mean \"title\"?",
            "bad.json:4:18: error: expected a number, found a string",
            "bad.json:6:9: error: unknown kind of object \"clothh\"; did you mean \"cloth\"?",
            "bad.json:7:28: error: \"size\" must be between 2 and 16384 particles, found 1",
            "bad.json:7:35: error: unknown key \"stifness\"; did you mean \"stiffness\"?",
            "bad.json:8:22: error: object \"c\" is a \"cloth\" already; an object has one kind",
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
        def refused(texture, message):
            err = self.mistake([f'error: "{texture}" {message}' if message else f'error: no file "{texture}" in '],
                               scene(texture)).splitlines()
            self.assertEqual(err[1].index(f'"{texture}"'), err[2].index("^"))
            self.assertIn("^" + "~" * (len(texture) + 1), err[2])
            return err[0]
        self.assertIn(f"{self.folder} and {SOURCE / 'assets'}", refused("none.png", None))
        os.symlink("/etc/passwd", self.folder / "link.png")
        for outside in ("../../etc/passwd", "/etc/passwd", "link.png"):
            refused(outside, f"lies outside the folders a scene may read: {self.folder} and ")
        refused(".", "is not a file")

    def test_invalid_values_are_reported_at_their_position(self):
        def at(line, column, message, values):
            self.mistake([f"bad.json:{line}:{column}: error: {message}\n"], json.dumps(with_values(values), indent=1))
        at(21, 13, '"position" and "target" are the same point, so the camera has no direction; move one of them',
           {"camera": {"position": [1, 1, 1], "target": [1, 1, 1]}})
        at(13, 15, "(start + duration) * fps is 1e+11 frames; the limit is 10 million",
           {"time": {"fps": 1e5, "duration": 1e6}})
        at(52, 15, "row 7 is outside the cloth: it has 7 (0 to 6, or -1 for the last)",
           {"objects.flag.cloth.pins": [{"rows": [7]}]})
        at(34, 6, '"size" must be between 2 and 16384 particles, found 16385', {"objects.flag.cloth.size": [16385, 3]})

    def test_too_many_colliders(self):
        scene = with_values({})
        scene["objects"] = dict(SCENE["objects"], **{f"s{i}": {"sphere": {}} for i in range(33)})
        self.write("many.json", scene)
        self.bad(2, ["32", "33", "\"collides\": false"], "render", "many.json", "-o", "out/")
        self.assertEqual(list(self.folder.glob("out/*")), [])


if __name__ == "__main__":
    main()
