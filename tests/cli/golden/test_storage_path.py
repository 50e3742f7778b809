"""The shipped scenes on the storage path, the way GPUs read memory: the same state as in their baselines, and exact
pictures equal in every byte. At their second tested frame: arithmetic is the texel path's, whose test goes to the last
one; what differs is how each kernel reads and writes. The long ones and the other frames: tools/drivers."""
import json
import re
import shutil

from common import SOURCE, Case, main

LONG = set((SOURCE / "tests/long_scenes.txt").read_text(encoding="utf-8").split())


class StoragePath(Case):
    def test_state_and_pictures_are_those_of_the_baselines(self):
        (self.folder / "shipped").mkdir()
        shutil.copytree(SOURCE / "assets/scenes/golden", self.folder / "shipped/golden")
        names = sorted(f.stem for f in (SOURCE / "assets/scenes").glob("*.json") if f.stem not in LONG)
        for name in names:
            text = (SOURCE / f"assets/scenes/{name}.json").read_text(encoding="utf-8")
            # A string is kept, a comment goes.
            scene = json.loads(re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda m: m.group(1) or "", text))
            scene["test"]["frames"] = scene["test"]["frames"][1:2]
            self.write(f"shipped/{name}.json", scene)
        done = self.run_program("test", "shipped", "--memory-path", "storage", "--repeat", "1", "--json", "report.json",
                                env={"SIMREEL_ASSETS": str(SOURCE / "assets")}, timeout=800)
        report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        self.assertEqual([s["name"] for s in report["scenes"] if s["status"] != "pass"], [], done.stdout.decode())
        self.assertEqual(done.returncode, 0, done.err)
        self.assertEqual(sorted(s["name"] for s in report["scenes"]), names)


if __name__ == "__main__":
    main()
