"""Pictures of the exact rasterizer: the listed bytes for every shipped scene, on both memory paths, near the driver's; what it refuses."""
import json
import os
import unittest

import exact_pictures
from common import PROGRAM, Case, main

BOTH_PATHS = ["flag", "ripple", "sparks"]


class Pictures(Case):
    def test_every_scene_has_the_listed_bytes(self):
        names = exact_pictures.scenes()
        if os.environ.get("SIMREEL_RENEW_EXACT") == "1":
            entries = exact_pictures.drawn_all(PROGRAM, names)
            self.assertEqual([name for name in names if "failed" in entries[name]], [])
            exact_pictures.LIST.write_text(json.dumps(entries, indent=1) + "\n", encoding="utf-8")
            return
        gone = set(exact_pictures.listed()) - set(names)
        wrong = {**exact_pictures.differences(PROGRAM, names), **dict.fromkeys(gone, "is no scene any more")}
        self.assertEqual(wrong, {}, "exact pictures are the same on every machine; if this change means them to differ, "
                                    f"look at them and renew the list: {exact_pictures.RENEWAL}")

    def test_memory_paths_draw_the_same_bytes(self):
        for path in ("texel", "storage"):
            with self.subTest(path):
                self.assertEqual(exact_pictures.differences(PROGRAM, BOTH_PATHS, "--memory-path", path), {})


class Usage(Case):
    def render(self, *arguments):
        return ("render", "scene.json", "-o", "out/", "--frames", "0", "--overwrite", *arguments)

    def test_numbers_of_samples(self):
        exact = ("--rasterizer", "exact", "--samples")
        seen = set()
        for samples in (1, 2, 4, 8, 16):
            self.good(*self.render(*exact, samples))
            seen.add(exact_pictures.pixels_hash(self.folder / "out/000000.png"))
        self.assertEqual(len(seen), 5, "each number has edges of its own")
        done = self.bad(2, ["3 samples", "1, 2, 4, 8 and 16"], *self.render(*exact, 3))
        self.assertEqual(len(done.err.splitlines()), 1, done.err)

    def test_names_of_rasterizers(self):
        self.good(*self.render("--rasterizer", "driver"))
        self.bad_scene(['unknown rasterizer "other"', "driver, exact"], *self.render("--rasterizer", "other"))


if __name__ == "__main__":
    main()
