"""Checks that the shipped scenes detect errors in the shipped simulations: with one constant of a simulation changed by
1 %, `simreel test` must fail for every scene that contains that simulation. For a simulation without an entry here, the
first decimal number in its code is changed by 1 %."""
import json
import os
import pathlib
import re
import shutil

from common import SOURCE, main
from golden_common import GoldenCase

# Mutation for each kind of object: (file, text that occurs once in the file, the text with one constant changed by 1
# %).
MUTATIONS = {
    "cloth": ("cloth/model.glsl", "precise vec3 v = (velocity + acceleration * stepData.dt) * stepData.kept;",
              "precise vec3 v = (velocity + acceleration * (stepData.dt * 1.01f)) * stepData.kept;"),
    "particles": ("particles/model.glsl", "v * pace.drift;",
                  "v * (pace.drift * 1.01f);"),
    "mesh": ("mesh/displace.comp", "vec4(displaced(LOAD_INPUT(restPositions, i).xyz), 1)",
             "vec4(displaced(LOAD_INPUT(restPositions, i).xyz * 1.01), 1)"),
    "body": ("body/model.glsl", "precise vec4 between = begin * moment.before + end * moment.now;",
             "precise vec4 between = begin * moment.before + end * (moment.now * 1.01f);"),
    "fluid": ("fluid/advection.glsl", "precise vec2 start = p - velocity * stepData.dt;",
              "precise vec2 start = p - velocity * (stepData.dt * 1.01f);"),
    "grayScott": ("gray_scott/model.glsl", "rates.feed * (1.0f - u)", "rates.feed * (1.01f - u)"),
    "reaction": ("reaction/grid.glsl", "precise vec4 rest = raised - grain;", "precise vec4 rest = (raised - grain) * 1.01;"),
    # Life has only integer counts, so a carry of the adder is changed instead.
    "life": ("life/model.glsl", "WORD carry = highs.low & lows.high;", "WORD carry = highs.low & ~lows.high;"),
    "epidemic": ("spread/epidemic/step.comp", "uvec4 threshold = mix(infection,",
                 "uvec4 threshold = mix(infection / 100u * 101u,"),
    # For users' kernels, the drawn numbers are changed by 1 %.
    "kernels": ("kernels/run/gather.comp", "result[c] = numberAt(element + places[c], number);",
                "result[c] = numberAt(element + places[c], number) * 1.01;"),
    "image": ("kernels/run/gather.comp", "result[c] = numberAt(element + places[c], number);",
              "result[c] = numberAt(element + places[c], number) * 1.01;"),
    # For caves, one of the nine cells is ignored.
    "cave": ("cave/model.glsl", "return three | (exactlyTwo & ones.one);", "return three | (exactlyTwo & above.one);"),
    "contour": ("contour/classify.comp", "value >= levels[i] ?", "value >= levels[i] * 1.01 ?"),
    "wildfire": ("spread/wildfire/step.comp", "uint weight = fuelWeight(byteOf(fuel, k));",
                 "uint weight = fuelWeight(byteOf(fuel, k)) * 99u / 100u;"),
}
# Scenes that run other shaders than usual for their kind.
OTHERS = {"wireworld": ("life", ("automata/step.comp", "node = child(node, cellOf(here, j + 1));", "node = child(node, cellOf(here, j));"))}
SCENERY = {"sphere", "capsule", "plane", "box", "cylinder", "cone", "torus", "disc", "text", "chart", "colorBar", "isolines", "scaleBar", "flow", "arrows", "streamlines"}  # kinds of objects that are not simulated
FRAMES = 3  # number of the frame that is compared, after frame 0
# Rock changes late in cave_map, electrons are far apart in wireworld, and few people are infected early in epidemic.
LATER_FRAMES = {"cave_map": 24, "epidemic": 30, "wireworld": 24}
# Scenes with particles, with cells and with a grid of numbers. Some have a mutation in the list above, and some a
# derived one. With SIMREEL_LONG, all scenes and kinds are tested.
QUICK_SCENES = {"contour", "epidemic", "flag", "rain", "sparks"}
ALL_SCENES = os.environ.get("SIMREEL_LONG") == "1"
# Scenes whose first frame takes seconds without a GPU. Other scenes cover the same kinds.
LONG_SCENES = set((SOURCE / "tests/long_scenes.txt").read_text(encoding="utf-8").split())


def derived_mutation(kind):
    """Returns a mutation of the first decimal number in the code of the kind's shader folder, model.glsl first; None if
    there is no number."""
    folder = SOURCE / "glsl" / re.sub(r"[A-Z]", lambda m: "_" + m[0].lower(), kind)
    files = [*folder.glob("*.glsl"), *folder.glob("*.comp")]
    for file in sorted(files, key=lambda f: (f.name != "model.glsl", f.name)):
        text = file.read_text(encoding="utf-8")
        for line in text.splitlines():
            number = re.search(r"(?<![\w.])\d+\.\d+", line.split("//")[0])
            if number and float(number[0]) and text.count(line) == 1:
                new = line[:number.start()] + repr(float(number[0]) * 1.01) + line[number.end():]
                return str(file.relative_to(SOURCE / "glsl")), line, new
    return None


class Mutation(GoldenCase):
    def shipped(self):
        return sorted(f for f in (SOURCE / "assets/scenes").glob("*.json") if f.stem not in LONG_SCENES)

    def scenes(self):
        return [f for f in self.shipped() if ALL_SCENES or f.stem in QUICK_SCENES]

    def read(self, file):
        # Removes comments but keeps strings.
        text = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda m: m.group(1) or "", file.read_text(encoding="utf-8"))
        return json.loads(text)

    def shortened(self, file):
        """Shortens a scene to its first frames, without pre-roll. Pictures are tiny, because a change of 1 % shows in
        the state. A full run of the scene starts with the same steps, so its baselines detect the change too."""
        scene = self.read(file)
        scene["time"]["start"] = 0
        scene["test"] = {"frames": [0, LATER_FRAMES.get(file.stem, FRAMES)], "size": [16, 9]}
        del scene["checks"]
        return scene

    def has_kind(self, file, kind):
        things = [thing[kind] for thing in self.read(file)["objects"].values() if kind in thing]
        # A mesh without deformation is not simulated.
        return any(kind != "mesh" or "deform" in thing for thing in things)

    def mutations(self):
        simulations = self.good("list").stdout.decode().split("\n\n")[0]
        kinds = set(re.findall(r"^  (\w+)", simulations, re.M)) - SCENERY
        self.assertLessEqual(set(MUTATIONS), kinds)
        return {kind: MUTATIONS.get(kind) or derived_mutation(kind) for kind in sorted(kinds)}

    def test_every_simulation_has_a_mutation_and_a_scene(self):
        mutations = self.mutations()
        without = [kind for kind, mutation in mutations.items() if mutation is None]
        self.assertEqual(without, [], "no number was found in their shaders: list a mutation above")
        for name, old, _ in [*mutations.values(), *(mutation for _, mutation in OTHERS.values())]:
            self.assertEqual((SOURCE / "glsl" / name).read_text(encoding="utf-8").count(old), 1, f"{old!r} stands once in glsl/{name}")
        alone = [kind for kind in mutations if not any(self.has_kind(f, kind) for f in self.shipped())]
        self.assertEqual(alone, [], "no shipped scene has them")

    def test_one_percent_fails_every_scene(self):
        seen = set()
        scenes = pathlib.Path(self.folder / "shipped")
        scenes.mkdir()
        for file in self.scenes():
            (scenes / file.name).write_text(json.dumps(self.shortened(file)), encoding="utf-8")
        assets = {"SIMREEL_ASSETS": str(SOURCE / "assets")}
        self.good("test", "shipped", "--update", "--repeat", "1", env=assets)
        runs = [(kind, mutation, [f.stem for f in self.scenes() if self.has_kind(f, kind) and f.stem not in OTHERS])
                for kind, mutation in self.mutations().items()]
        runs += [(kind, mutation, [scene]) for scene, (kind, mutation) in OTHERS.items() if ALL_SCENES or scene in QUICK_SCENES]
        for _, (name, old, new), names in runs:
            if not names:
                continue
            env = {**self.mutated_glsl(name, old, new), **assets}
            filters = [word for scene in names for word in ("--filter", scene)]
            done = self.run_program("test", "shipped", "--repeat", "1", "--json", "report.json", *filters, env=env)
            self.assertEqual(done.returncode, 1, f"{names} do not notice {new}: {done.err}")
            report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
            for scene in report["scenes"]:
                self.assertEqual(scene["status"], "fail")
                self.assertIsNotNone(scene["divergence"], f"{scene['name']} does not notice {new}: {scene['messages']}")
            seen.update(names)
        self.assertEqual(seen, {f.stem for f in self.scenes()})


if __name__ == "__main__":
    main()
