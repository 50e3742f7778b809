"""Tests pictures of the exact rasterizer: equal bytes on both memory paths, close to the driver's rasterizer, and
refused settings. Baselines hold the exact bytes on every machine (`simreel test`)."""
import concurrent.futures
import json
import os
import subprocess
import unittest

import exact_pictures
from common import PROGRAM, Case, main

BOTH_PATHS = ["flag", "ripple", "sparks"]

# Values of (width, height, factor). Both rasterizers draw pictures larger by this factor, and the means over factor x
# factor pixels are compared. At the original size, edges alone would exceed the bound, because the sample positions
# differ.
SIZE = (150, 84, 4)
# Scenes with details (blades, crests, darts, folds, grains) that are narrower than the sample spacing even at the larger size.
FINE = (75, 42, 16)
FINE_SCENES = {"cascade", "cave", "cave_map", "flag", "leather", "meadow", "raft", "sparks", "swarm", "waves"}
FLIP = 0.01
# Scenes with textured surfaces, fields and glows. With SIMREEL_LONG, all scenes are tested.
FEW = ["contour", "flag", "sparks"]
LONG = os.environ.get("SIMREEL_LONG") == "1"
# Objects that emit light. The driver's rasterizer leaves emission out.
EMITTING = {"flag": ["near", "middle", "far"], "sparks": ["hills", "farHills"]}
# Later frames of scenes whose first frame shows little.
LATER = dict.fromkeys(("collision", "contour", "raft", "ripple", "snow", "tablecloth", "waves"), 8)


class Pictures(Case):
    @unittest.skipUnless(LONG, "test_storage_path.py has a scene of each simulation")
    def test_memory_paths_draw_the_same_bytes(self):
        frames = dict.fromkeys(BOTH_PATHS, 0)
        texel, storage = (exact_pictures.drawn_all(PROGRAM, frames, "--memory-path", path) for path in ("texel", "storage"))
        self.assertEqual([name for name, entry in texel.items() if "pixels" not in entry], [])
        self.assertEqual(storage, texel)

    def mean_picture(self, scene, frame, rasterizer):
        columns, rows, times = FINE if scene in FINE_SCENES else SIZE
        width, height = times * columns, times * rows
        # The driver's rasterizer supports only drafts.
        changes = ["render.quality=draft", *(f"objects.{name}.material.emission=[0,0,0]" for name in EMITTING.get(scene, []))]
        done = exact_pictures.render(PROGRAM, scene, "-", "--rasterizer", rasterizer, "--frames", frame,
                                     *(word for change in changes for word in ("-D", change)), size=f"{width}x{height}")
        self.assertEqual((done.returncode, len(done.stdout)), (0, 4 * width * height), done.stderr)
        name = f"{scene}.{rasterizer}.png"
        subprocess.run(["convert", "-size", f"{width}x{height}", "-depth", "8", "rgba:-", "-scale", f"{columns}x{rows}!",
                        "-alpha", "off", "-depth", "8", self.folder / name], input=done.stdout, check=True)
        return name

    def flip(self, scene, frame):
        pictures = [self.mean_picture(scene, frame, rasterizer) for rasterizer in ("exact", "driver")]
        compared = json.loads(self.run_program("diff", *pictures, "--json").stdout)
        return compared["metrics"]["flipMean"] if "metrics" in compared else 0

    def test_exact_pictures_look_like_those_of_the_driver(self):
        names = exact_pictures.scenes()
        self.assertLessEqual(set(FEW), set(names))
        frames = {name: LATER.get(name, 0) for name in (names if LONG else FEW)}
        with concurrent.futures.ThreadPoolExecutor(exact_pictures.WORKERS) as pool:
            found = dict(zip(frames, pool.map(self.flip, frames, frames.values())))
        if os.environ.get("SIMREEL_SHOW_FLIP") == "1":
            print(json.dumps(found, indent=1))
        for scene, flip in found.items():
            with self.subTest(scene):
                self.assertLess(flip, FLIP)


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
        self.bad_scene(["3 samples", "1, 2, 4, 8 or 16"], *self.render(*exact, 3))

    def test_names_of_rasterizers(self):
        self.good(*self.render("--rasterizer", "driver"))
        self.bad_scene(['unknown rasterizer "other"', "exact, driver"], *self.render("--rasterizer", "other"))


if __name__ == "__main__":
    main()
