"""Tests shipped scenes on the storage path, the memory path of GPUs: the state must equal the baselines, and exact
pictures must be equal in every byte. Tests one scene of each kind of simulation, at its second tested frame: both paths
share their arithmetic, and the test of the texel path runs to the last frame; only the kernels' memory accesses differ.
tools/drivers tests all scenes."""
import json
import re
import shutil

from common import SOURCE, Case, main

LONG = set((SOURCE / "tests/long_scenes.txt").read_text(encoding="utf-8").split())
# Scenes that are tested first. They are cheap scenes, and two scenes of standard quality that cover ambient occlusion
# on this path. Further scenes follow in order of their names.
FIRST = ["cape", "cascade", "cave_map", "crystal", "ripple", "street"]


class StoragePath(Case):
    def test_states_and_pictures_equal_the_baselines(self):
        (self.folder / "shipped").mkdir()
        shutil.copytree(SOURCE / "assets/scenes/golden", self.folder / "shipped/golden")
        names = sorted((f.stem for f in (SOURCE / "assets/scenes").glob("*.json") if f.stem not in LONG),
                       key=lambda name: (name not in FIRST, name))
        listed = self.good("list").stdout.decode().split("\n\n")[0]
        kinds = set(re.findall(r"^  (\w+)", listed, re.M)) - {"sphere", "capsule", "plane", "box", "cylinder", "cone", "torus", "disc", "text", "chart", "colorBar", "isolines", "scaleBar", "flow", "arrows", "streamlines"}
        chosen, qualities = [], set()
        for name in names:
            text = (SOURCE / f"assets/scenes/{name}.json").read_text(encoding="utf-8")
            # Removes comments but keeps strings.
            scene = json.loads(re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda m: m.group(1) or "", text))
            new = kinds & {kind for thing in scene["objects"].values() for kind in thing}
            if not new:
                continue
            kinds -= new
            chosen.append(name)
            qualities.add(scene["render"].get("quality"))
            scene["test"]["frames"] = scene["test"]["frames"][1:2]
            self.write(f"shipped/{name}.json", scene)
        self.assertEqual(kinds, set(), "no scene that is not long has these")
        self.assertIn("standard", qualities)
        done = self.run_program("test", "shipped", "--memory-path", "storage", "--repeat", "1", "--json", "report.json",
                                env={"SIMREEL_ASSETS": str(SOURCE / "assets")})
        report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["name"] for s in report["scenes"] if s["status"] != "pass"], [], done.stdout.decode())
        self.assertEqual(done.returncode, 0, done.err)
        self.assertEqual(sorted(s["name"] for s in report["scenes"]), sorted(chosen))


if __name__ == "__main__":
    main()
