"""Text from files, names or arguments cannot send control sequences to the terminal; every failure prints its line."""
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile
import unittest

from common import PATIENCE, PROGRAM, SOURCE, Case, main, with_values

ESC = "\x1b]0;owned\x07"
C1 = "\x9b31m"
BIDI = "\u202e"
HOSTILE = f"a{ESC}{C1}{BIDI}\n::error::b\r\x7f"
# Escape sequences, C0 except newline and tab, DEL, C1 and direction marks, all unescaped.
RAW = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")


class Terminal(Case):
    def clean(self, code, *arguments, most=None, **options):
        """Runs the program, checks the exit code, and searches the output for control characters; `most` is the maximum
        number of message lines."""
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, code, (arguments, done.err))
        # Decoding also checks that the output is valid UTF-8.
        for text in (done.stdout.decode("utf-8"), done.stderr.decode("utf-8")):
            self.assertIsNone(RAW.search(text), text)
        if most is not None:
            self.assertLessEqual(len(done.err.splitlines()), most, done.err)
        return done

    def test_hostile_arguments_are_escaped(self):
        self.clean(2, HOSTILE, most=1)
        self.clean(2, "render", HOSTILE, "-o", "out/", most=1)
        self.clean(2, "list", HOSTILE, most=1)
        self.clean(2, "render", "scene.json", "-o", HOSTILE + ".xyz", most=1)
        self.clean(2, "render", "scene.json", "-o", "out/", "-D", HOSTILE, most=1)
        self.clean(2, "render", "scene.json", "-o", "out/", "-D", f"ti\x1btle.x={HOSTILE}")
        self.clean(2, "render", "scene.json", "-o", "out/", "--frames", HOSTILE, most=1)
        self.clean(2, "render", "scene.json", "-o", "out/", "--" + HOSTILE, most=1)
        self.clean(2, "validate", "scene.json", "--assets", HOSTILE, most=1)
        self.clean(4, "render", "scene.json", "-o", "out/", "--device", HOSTILE, most=1)
        self.clean(0, "bench", "scene.json", "--vary", f"title={HOSTILE},b", "--frames", "1", "--warm-up", "0")
        self.clean(0, "bisect", "scene.json", "--frames", "1", "--against", f"true '{ESC}';{PROGRAM}")
        self.clean(6, "bisect", "scene.json", "--frames", "1", "--against", f"printf 'x{ESC}'>&2;false")
        done = self.clean(0, "trace", "scene.json", "-D", f"title={HOSTILE}", "--frames", "0")
        for line in done.stdout.splitlines():
            json.loads(line)

    def test_hostile_file_names_are_escaped(self):
        self.write(f"{HOSTILE}.json".replace("/", ""), (self.folder / "scene.json").read_bytes())
        name = f"{HOSTILE}.json"
        self.assertEqual(len(self.clean(0, "validate", name).stdout.splitlines()), 1)
        self.clean(0, "render", name, "-o", f"{HOSTILE}-out/", "--frames", "0,90", most=2)
        self.clean(6, "render", name, "-o", f"{HOSTILE}-out/", "--frames", "0", most=1)
        self.clean(0, "bake", name, "-o", HOSTILE, "--frames", "0", most=1)
        self.clean(0, "diff", f"{HOSTILE}-out", f"{HOSTILE}-out")
        self.clean(0, "diff", f"{HOSTILE}-out/000000.png", f"{HOSTILE}-out/000000.png", "--json")
        shutil.copytree(self.folder / f"{HOSTILE}-out", self.folder / "b")
        (self.folder / "b/000090.png").rename(self.folder / f"b/{HOSTILE}.png")
        (self.folder / f"b/{HOSTILE}-2.png").write_bytes(b"x")
        (self.folder / f"{HOSTILE}-out/{HOSTILE}-2.png").write_bytes(b"x")
        self.clean(6, "diff", f"{HOSTILE}-out", "b")
        self.clean(6, "diff", f"{HOSTILE}-out", "b", "--json")
        self.clean(2, "accept", f"{HOSTILE}-out", most=1)
        self.clean(6, "render", name, "-o", "v.mp4", most=2, env={"PATH": str(self.fake_ffmpeg())})

    def fake_ffmpeg(self):
        program = self.write("bin/ffmpeg", f"#!/bin/sh\nprintf '{ESC}broken\\r{ESC}\\n' >&2\nexit 3\n")
        program.chmod(0o755)
        return program.parent

    def test_hostile_file_contents_are_escaped(self):
        def broken(text):
            self.write("bad.json", text)
            self.clean(2, "validate", "bad.json")
            self.clean(2, "render", "bad.json", "-o", "out/")
        broken(b'{"version": 1, "' + HOSTILE.encode() + b'": 2}')
        broken(json.dumps(with_values({HOSTILE: 1})))
        broken(json.dumps(with_values({"objects.flag": {HOSTILE: {}}})))
        broken(json.dumps(with_values({"objects." + HOSTILE.replace(".", ""): {"cloth": {}}})))
        broken(json.dumps(with_values({"numerics": HOSTILE})))
        broken(json.dumps(with_values({"objects.flag.material": {"texture": HOSTILE}})))
        broken(json.dumps(with_values({"checks": [{"what": HOSTILE, "object": HOSTILE, "of": HOSTILE}]})))
        broken(json.dumps({"version": 1, "objects": {"c": {"life": {"rule": HOSTILE}}}}))
        for name, content, thing in (("m.obj", f"v 1 {HOSTILE}", {"mesh": {"shape": "file", "file": "m.obj"}}),
                                     ("m.gltf", f'{{"{ESC}', {"mesh": {"shape": "file", "file": "m.gltf"}}),
                                     ("p.csv", f"x,y,z\n1,{HOSTILE},2\n", {"particles": {"groups": [
                                         {"shape": "file", "file": "p.csv"}]}}),
                                     ("p.ply", f"ply\nformat {HOSTILE} 1.0\n", {"particles": {"groups": [
                                         {"shape": "file", "file": "p.ply"}]}}),
                                     ("c.rle", f"x = 3, y = {ESC}\n{ESC}!", {"life": {"patterns": [{"file": "c.rle"}]}})):
            self.write(name, content)
            self.write("uses.json", {"version": 1, "render": {"size": [16, 9], "samples": 1}, "objects": {"o": thing}})
            done = self.run_program("render", "uses.json", "-o", "out/", "--frames", "0")
            self.assertIn(done.returncode, (2, 6), (name, done.err))
            self.clean(done.returncode, "render", "uses.json", "-o", "out/", "--frames", "0", most=1)

    def test_hostile_text_in_reports_is_escaped(self):
        """Covers names, reasons and sources of tested scenes."""
        hostile = with_values({"test": {"frames": [0], "size": [16, 9], "samples": 1, "xfail": HOSTILE}})
        self.write(f"scenes/{HOSTILE}.json", hostile)
        self.write("scenes/::error title=x::y.json", with_values({"test": {"frames": [0], "size": [16, 9]}}))
        self.write("scenes/broken.json", '{"version": 1,\n::error::from a scene, ##[error]too\n}')
        self.assertEqual(len(self.clean(0, "test", "scenes", "--list").stdout.splitlines()), 3)
        for arguments in ([], ["--github"], ["--report", HOSTILE]):
            done = self.clean(2, "test", "scenes", *arguments) if not arguments else self.run_program("test", "scenes", *arguments)
            text = (done.stdout + done.stderr).decode()
            self.assertIsNone(RAW.search(text), text)
            if arguments == ["--github"]:
                self.assertNotIn("##[", text)
                commands = [line for line in text.splitlines() if line.lstrip().startswith("::")]
                self.assertEqual(len(commands), len([s for s in commands if s.startswith("::error file=scenes/")]), commands)
                self.assertGreaterEqual(len(commands), 2)


class SetUp(unittest.TestCase):
    def test_a_failure_while_the_command_line_is_set_up_is_one_line(self):
        """The arguments have 2 MB, and memory is barely enough to start the program without them."""
        def run(megabytes, arguments):
            limit = int(megabytes * (1 << 20))
            return subprocess.run([PROGRAM, "list", *arguments], capture_output=True, check=False, timeout=PATIENCE,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        least, enough = 16.0, 2048.0
        while enough - least > 0.5:
            middle = (least + enough) / 2
            if run(middle, ["cloth"]).returncode == 0:
                enough = middle
            else:
                least = middle
        long = ["x" * 100_000] * 18
        done = run(enough + 2.5, long)  # The long arguments need more memory, because they are on the stack.
        self.assertEqual((done.returncode, done.stderr), (4, b"simreel: error: not enough memory\n"))
        self.assertEqual(run(enough + 200, long).returncode, 2)


class Layers(unittest.TestCase):
    def test_check_layers_reads_includes_in_every_folder(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "tools").mkdir()
            shutil.copy(SOURCE / "tools/check-layers", folder / "tools")
            shutil.copy(SOURCE / "CMakeLists.txt", folder)
            for room in ("sim/core", "sim/cloth/deep"):
                (folder / "src" / room).mkdir(parents=True)
            step, core = folder / "src/sim/cloth/deep/step.cpp", folder / "src/sim/core/list.hpp"

            def check(step_includes, core_includes):
                step.write_text(f'#include "{step_includes}"\n', encoding="utf-8")
                core.write_text(f'#include "{core_includes}"\n', encoding="utf-8")
                done = subprocess.run([folder / "tools/check-layers"], capture_output=True, check=False, env=os.environ)
                return done.returncode, done.stderr.decode()

            self.assertEqual(check("gl/buffer.hpp", "scene/scene.hpp"), (0, ""))
            self.assertEqual(check("sim/core/list.hpp", "gl/buffer.hpp"), (0, ""))
            code, message = check("draw/camera.hpp", "gl/buffer.hpp")
            self.assertEqual(code, 1)
            self.assertIn("src/sim/cloth/deep/step.cpp:1: sim does not link draw", message)
            code, message = check("sim/core/list.hpp", "sim/cloth/deep/step.hpp")
            self.assertEqual(code, 1)
            self.assertIn("src/sim/core/list.hpp:1: sim/core includes from sim/cloth/deep", message)

    def test_check_layers_finds_unknown_folders_and_cycles(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "tools").mkdir()
            shutil.copy(SOURCE / "tools/check-layers", folder / "tools")
            shutil.copy(SOURCE / "CMakeLists.txt", folder)

            def check(**files):
                for file, text in {"sim/cloth/cloth.cpp": "class Cloth : public Simulation {\n};\n", **files}.items():
                    (folder / "src" / file).parent.mkdir(parents=True, exist_ok=True)
                    (folder / "src" / file).write_text(text, encoding="utf-8")
                done = subprocess.run([folder / "tools/check-layers"], capture_output=True, check=False, env=os.environ)
                for file in files:
                    (folder / "src" / file).unlink()
                return done.returncode, done.stderr.decode()

            includes = '#include "{}"\n'.format
            for layer, wanted in (("draw", 1), ("frame", 1), ("serve", 0), ("sim/water", 1), ("sim/garment", 0), ("sim/world", 0)):
                with self.subTest(layer=layer):
                    code, message = check(**{f"{layer}/a.cpp": includes("sim/cloth/cloth.hpp")})
                    self.assertEqual(code, wanted, message)
                    self.assertEqual("includes from the simulation sim/cloth" in message, wanted == 1)
            code, message = check(**{"scene/a.cpp": includes("scene/b.hpp"), "scene/b.hpp": includes("scene/a.hpp")})
            self.assertEqual(code, 1)
            self.assertIn("src/scene/b.hpp:1: b includes from a", message)


if __name__ == "__main__":
    main()
