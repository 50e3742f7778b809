"""Tests the passes of exact pictures: `simreel trace --passes`, `bisect --passes`, and the messages of `simreel test`
about a differing picture. A copy of the shaders with one constant changed stands in for another build."""
import array
import json
import os
import pathlib
import re
import shlex
import shutil

from common import PROGRAM, main, with_values
from golden_common import TESTED, GoldenCase

PASSES = ["visibility", "shadow", "light", "glow", "bloom", "picture"]
WIDTH, HEIGHT, SAMPLES = 67, 41, 4
SCENE = with_values({
    "render": {"size": [WIDTH, HEIGHT], "samples": SAMPLES, "rasterizer": "exact", "bloom": {"strength": 0.3}},
    "ground": {"height": 0},
    "camera": {"position": [0, 1, 3], "target": [0, 0.7, 0]},
    "lights": {"lamp": {"position": [0.9, 1.2, 0.7], "intensity": 3, "shadowSize": 64}},
    "objects.ball": {"sphere": {"position": [0.8, 0.3, 0.2], "radius": 0.3}},
    "objects.sparks": {"particles": {
        "groups": [{"count": 40, "radius": 0.4, "position": [-0.5, 0.6, 0.8]}], "method": "none",
        "look": {"size": 0.05, "additive": True, "brightness": 2}}},
    "test": {"frames": [0, 2], "size": [WIDTH, HEIGHT], "samples": SAMPLES},
}, TESTED)

# Change for each pass: (file, text that occurs once in the file, the text with a different constant).
CHANGES = {
    "visibility": ("draw/exact/triangles/triangle.glsl", "v.x * perDepth * 256.0f + 0.5f", "v.x * perDepth * 256.0f + 9.5f"),
    "shadow": ("draw/exact/triangles/vertices.comp", "precise float near = 1.0f - place.z;",
               "precise float near = 1.2f - place.z;"),
    "light": ("draw/exact/shadows/sun_map.glsl", "lightTexel() * (0.5f + 0.5f", "lightTexel() * (0.1f + 0.1f"),
    "glow": ("draw/exact/instances/glow_add.glsl", "precise vec3 all_ = light * part;", "precise vec3 all_ = light * (part * 1.01f);"),
    "bloom": ("draw/exact/screen/bloom_up.comp", "(fraction.y * 0.0625f)", "(fraction.y * 0.0626f)"),
    "picture": ("draw/screen/film.glsl", "bright = 1.3f * light", "bright = 1.31f * light"),
}
PROGRAM_WORD = shlex.quote(str(pathlib.Path(PROGRAM).resolve()) if os.sep in PROGRAM else PROGRAM)


def read_passes(data):
    """Returns the header, and the 32-bit words of each part of a pass, item by item."""
    head, _, body = data.partition(b"\n")
    header = json.loads(head)
    items = {}
    for one in header["arrays"]:
        size = one["width"] * one["height"] * one["each"] * 4
        words = array.array("I", body[:size])
        body = body[size:]
        items[one["pass"], one["part"]] = [tuple(words[i:i + one["each"]]) for i in range(0, len(words), one["each"])]
    assert not body
    return header, items


class PassCase(GoldenCase):
    def setUp(self):
        super().setUp()
        self.write("scene.json", SCENE)

    def changed(self, change):
        """Returns the environment and the command of another build."""
        env = self.mutated_glsl(*change)
        return env, f"env SIMREEL_GLSL={shlex.quote(env['SIMREEL_GLSL'])} {PROGRAM_WORD}"

    def lines(self, *arguments, **options):
        out = self.good("trace", "scene.json", "--passes", *arguments, **options).stdout
        return [json.loads(line) for line in out.splitlines()][1:]

    def dump(self, frame, **options):
        return read_passes(self.good("trace", "scene.json", f"--dump={frame}:passes", "-o", "-", **options).stdout)

    def bisect(self, code, *arguments):
        done = self.run_program("bisect", "scene.json", "--passes", "--json", "--frames=3", *arguments)
        self.assertEqual(done.returncode, code, done.err)
        return json.loads(done.stdout)


class Trace(PassCase):
    def test_trace_lines_have_a_hash_for_each_pass(self):
        lines = self.lines("--frames=0-2")
        for line in lines:
            self.assertEqual(list(line["passes"]), PASSES)
            for text in line["passes"].values():
                self.assertRegex(text, r"\A[0-9a-f]{16}\Z")
        for name in ("visibility", "light", "picture"):  # These passes differ between frames, because the cloth falls.
            self.assertEqual(len({line["passes"][name] for line in lines}), 3, name)
        for path in ("storage", "texel"):
            self.assertEqual(self.lines("--frames=0-2", "--memory-path", path), lines)
        plain = json.loads(self.good("trace", "scene.json", "--frames=2").stdout.splitlines()[1])
        self.assertNotIn("passes", plain)
        self.assertEqual(plain["arrays"], lines[2]["arrays"])

    def test_a_picture_has_the_passes_that_it_needs(self):
        self.write("scene.json", with_values({"render.bloom": {"strength": 0}, "sun.shadow": False,
                                              "lights": {}}, SCENE))
        self.assertEqual(list(self.lines("--frames=1")[0]["passes"]), ["visibility", "light", "glow", "picture"])
        self.write("scene.json", with_values({"time.start": 0.1}, SCENE))
        self.assertEqual([("passes" in line) for line in self.lines("--frames=-1-1")], [False, True, True])

    def test_dumps(self):
        header, items = self.dump(2)
        self.assertEqual(header["frame"], 2)
        self.assertEqual(sorted({name for name, _ in items}, key=PASSES.index), PASSES)
        self.assertEqual({thing["object"]: thing["kind"] for thing in header["things"]},
                         {"flag": "triangle", "ball": "triangle"})
        self.assertEqual(len(items["visibility", "keys"]), WIDTH * HEIGHT)
        picture = self.good("render", "scene.json", "-o", "-", "--frames=2", "--no-counts", "-q").stdout
        shown = b"".join(bytes(word[0].to_bytes(4, "little")) for word in items["picture", "finished"])
        self.assertEqual(shown, picture)

    def test_usage(self):
        self.bad(2, ["--rasterizer exact"], "trace", "scene.json", "--passes", "--rasterizer", "driver", "--frames=0")
        self.bad(2, ["--rasterizer exact"], "trace", "scene.json", "--dump=0:passes", "-o", "x", "--rasterizer", "driver")
        self.bad(2, ["whole frames"], "trace", "scene.json", "--passes", "--steps-of=1")
        self.bad(2, ["starts at frame 0"], "trace", "scene.json", "--dump=-1:passes", "-o", "x")


class Bisect(PassCase):
    def test_equal_sides_have_no_difference(self):
        self.assertFalse(self.bisect(0)["different"])
        done = self.good("bisect", "scene.json", "--passes", "--frames=2", "--against-memory-path", "storage")
        self.assertIn(b"The same state and the same passes, bit for bit, over 2 frames (0 to 1).", done.stdout)
        self.write("still.json", with_values({"objects": {"ball": {"sphere": {}}}}, SCENE))
        self.good("bisect", "still.json", "--passes", "--frames=1")

    def preferred(self, pixels, drawn):
        """Returns the first pixel that shows only one object, or else the first pixel."""
        header, items = drawn
        firsts = [one["first"] for one in header["things"]]

        def thing(number):
            return number if number >= 0xfffffffe else max(first for first in firsts if first <= number)
        alone = [i for i in pixels if len({thing(number) for number in items["visibility", "numbers"][i]}) == 1]
        return (alone or pixels)[0]

    def check(self, found, here, there):
        """Checks that the reported difference is the first one in dumps of both sides."""
        (header, ours), (_, theirs) = here, there
        for part, items in ours.items():
            if PASSES.index(part[0]) < PASSES.index(found["pass"]):
                self.assertEqual(items, theirs[part], part)
        part = (found["pass"], found["part"])
        if found["pass"] == "visibility":
            sides = [[pair for k, n in zip(side["visibility", "keys"], side["visibility", "numbers"]) for pair in zip(k, n)]
                     for side in (ours, theirs)]
        else:
            sides = [ours[part], theirs[part]]
        differing = [i for i, (a, b) in enumerate(zip(*sides)) if a != b]
        self.assertEqual((found["differing"], found["of"]), (len(differing), len(sides[0])))
        first = differing[0]
        if found["pass"] in ("light", "glow", "picture"):
            first = self.preferred(differing, here)
        for name, side in zip(("here", "there"), sides):
            words = side[first][:1] if found["pass"] == "visibility" else side[first]
            self.assertEqual(found[name]["bits"], [f"0x{word:08x}" for word in words])
        if found["pass"] == "visibility":
            place, found_sample = divmod(first, SAMPLES)
            self.assertEqual(found["sample"], found_sample)
        elif found["pass"] == "shadow":
            place = self.preferred([i for i, (a, b) in enumerate(zip(ours["light", ""], theirs["light", ""])) if a != b], here)
        elif found["pass"] == "bloom":
            x, y = first % ((WIDTH + 1) // 2), first // ((WIDTH + 1) // 2)
            place = 2 * y * WIDTH + 2 * x
        else:
            place = first
        self.assertEqual(found["pixel"], [place % WIDTH, place // WIDTH])
        samples = ours["visibility", "numbers"][place]
        number = samples[found["sample"]] if found["pass"] == "visibility" else min(samples)
        thing = [one for one in header["things"] if one["first"] <= number]
        if found["pass"] == "visibility" or len(set(samples)) == 1:
            expected = {0xffffffff: ("", "sky"), 0xfffffffe: ("", "ground")}.get(
                number) or (thing[-1]["object"], f"triangle {number - thing[-1]['first']}")
            self.assertEqual((found["here"]["object"], found["here"]["primitive"]), expected)

    def test_a_change_of_each_pass_is_found(self):
        here = self.dump(0)
        for name, change in CHANGES.items():
            with self.subTest(name):
                shutil.rmtree(self.folder / "glsl", ignore_errors=True)
                env, against = self.changed(change)
                found = self.bisect(1, "--against", against)["difference"]
                self.assertEqual((found["frame"], found["pass"]), (0, name))
                self.check(found, here, self.dump(0, env=env))
                done = self.run_program("bisect", "scene.json", "--passes", "--frames=1", "--against", against)
                self.assertEqual(done.returncode, 1)
                text = done.stdout.decode()
                self.assertIn(f"First difference: frame 0, pass {name}", text)
                x, y = found["pixel"]
                self.assertIn(f"pixel ({x}, {y})", text)
                self.assertIn(found["here"]["primitive"], text)

    def test_a_state_difference_is_reported_before_passes(self):
        _, against = self.changed(("cloth/model.glsl", "force * here.w + vec3(stepData.gravity);",
                                   "force * here.w + vec3(stepData.gravity) * 1.01f;"))
        found = self.bisect(1, "--against", against)["difference"]
        self.assertEqual((found["frame"], found["step"], found["object"]), (1, 1, "flag"))

    def test_a_changed_material_is_located_on_its_object(self):
        self.write("other simreel", f'#!/bin/sh\nexec {PROGRAM_WORD} "$@" -D objects.ball.material.roughness=0.31\n').chmod(0o755)
        found = self.bisect(1, "--against", shlex.quote(str(self.folder / "other simreel")))["difference"]
        self.assertEqual((found["pass"], found["here"]["object"]), ("light", "ball"))

    def test_failures(self):
        script = self.write("other simreel", f'#!/bin/sh\nexec {PROGRAM_WORD} "$@" --size 68x41\n')
        script.chmod(0o755)
        self.bad(2, ["different sizes", "67x41", "68x41"], "bisect", "scene.json", "--passes", "--frames=1", "--against",
                 shlex.quote(str(script)))
        self.write("other simreel", f'#!/bin/sh\ncase "$*" in *--dump*) {PROGRAM_WORD} "$@" | head -c 999;; *) '
                                    f'{PROGRAM_WORD} "$@" --samples 1;; esac\n')
        self.bad(6, ["prints no trace"], "bisect", "scene.json", "--passes", "--frames=1", "--against", shlex.quote(str(script)))
        self.write("other simreel", f'#!/bin/sh\ncase "$*" in *--dump*) exec {PROGRAM_WORD} "$@";; *) '
                                    f'exec {PROGRAM_WORD} "$@" --samples 1;; esac\n')
        done = self.run_program("bisect", "scene.json", "--passes", "--frames=1", "--against", shlex.quote(str(script)))
        self.assertEqual(done.returncode, 1, done.err)
        self.assertIn("does not repeat itself", done.stdout.decode())


class Test(PassCase):
    def setUp(self):
        super().setUp()
        self.write("scenes/a.json", SCENE)
        self.make_baselines()

    def baseline(self):
        return json.loads(self.golden("a/any/baseline.json").read_text(encoding="utf-8"))

    def test_baselines_list_passes(self):
        for number, frame in self.baseline()["frames"].items():
            self.assertEqual(sorted(frame["passes"]), sorted(PASSES))
            self.assertEqual(self.lines(f"--frames={number}", "--fps=30")[0]["passes"], frame["passes"])
        for frame in self.one(0)["frames"]:
            self.assertIsNone(frame["pass"])

    def test_a_change_of_each_pass_is_reported(self):
        for name, change in CHANGES.items():
            with self.subTest(name):
                shutil.rmtree(self.folder / "glsl", ignore_errors=True)
                env, _ = self.changed(change)
                scene = self.one(1, env=env)
                for frame in scene["frames"]:
                    place = frame["pass"]
                    self.assertEqual(place["pass"], name)
                    self.assertIn(place["message"], scene["messages"])
                    self.assertIn(f"the first pass that differs is {name}", scene["text"])
                    self.assertRegex(place["message"], re.escape(f"({place['x']}, {place['y']}), {place['shows']}: ") +
                                     r"\d+ \d+ \d+, in the baseline \d+ \d+ \d+\Z")
                    self.assertRegex(place["shows"], r"\A(the (sky|ground)|triangle \d+ of (flag|ball))\Z")

    def test_a_baseline_without_passes(self):
        def drop(baseline):
            for frame in baseline["frames"].values():
                del frame["passes"]
        self.edit_json(self.golden("a/any/baseline.json"), drop)
        self.one(0)
        env, _ = self.changed(CHANGES["light"])
        place = self.one(1, env=env)["frames"][0]["pass"]
        self.assertEqual(place["pass"], "")
        self.assertIn("the baseline does not record which pass differs", place["message"])

    def test_updating_changes_only_the_hashes(self):
        """Covers a pass whose hash changed while the picture is unchanged."""
        before, files = self.baseline(), self.tree("scenes/golden")
        self.edit_json(self.golden("a/any/baseline.json"), lambda b: b["frames"]["2"]["passes"].update(light="0" * 16))
        self.assertIn("wrote hashes of passes", self.one(0, "--update")["notes"][0])
        self.assertEqual(self.baseline(), before)
        self.assertEqual(self.tree("scenes/golden"), files)
        self.assertEqual(self.one(0, "--update")["notes"], [])

    def test_accepting_stores_the_drawn_passes(self):
        before = self.baseline()["frames"]["2"]["passes"]
        self.set_scene({}, "a")
        self.write("scenes/a.json", with_values({"objects.ball.material": {"color": [0.9, 0.1, 0.1]}}, SCENE))
        self.one(1)
        self.good("accept", "report.json")
        after = self.baseline()["frames"]["2"]["passes"]
        self.assertEqual([name for name in PASSES if before[name] != after[name]], ["light", "glow", "bloom", "picture"])
        self.one(0)


if __name__ == "__main__":
    main()
