"""Tests pictures without a background, and linear light as OpenEXR, through the command line."""
import json

from common import SOURCE, Case, main, png_rows, unfiltered
from exr_file import bits, read_exr

SCENE = {"version": 1, "stage": False, "render": {"size": [97, 55]},
         "sky": {"zenith": [0.1, 0.2, 0.4]}, "objects": {"ball": {"sphere": {"radius": 0.4}}, "ring": {"mesh": {"shape": "torus", "rotation": [50, 20, 0]}}}}


def pixels(png):
    """Returns the pixels of an 8-bit PNG, and its number of channels."""
    channels = {2: 3, 6: 4}[png[25]]
    width, _, rows = png_rows(png)
    data = b"".join(unfiltered(rows, width * channels, channels))
    return [list(data[i:i + channels]) for i in range(0, len(data), channels)], channels


class Film(Case):
    def picture(self, name, *arguments):
        self.good("render", "scene.json", "--frames", "0", "-o", name, "-q", *arguments)
        return pixels((self.folder / name).read_bytes())

    def test_a_transparent_background_has_alpha(self):
        self.write("scene.json", SCENE)
        plain, three = self.picture("plain.png")
        cut, four = self.picture("cut.png", "-D", "render.transparent=true")
        self.assertEqual((three, four), (3, 4))
        counts = {"whole": 0, "part": 0, "none": 0}
        for before, after in zip(plain, cut):
            alpha = after[3]
            counts["whole" if alpha == 255 else "part" if alpha > 0 else "none"] += 1
            if alpha == 255:
                self.assertEqual(after[:3], before)  # Pixels that an object covers fully must be unchanged.
            if alpha == 0:
                self.assertEqual(after, [0, 0, 0, 0])
        self.assertGreater(min(counts.values()), 100)
        # With four samples per pixel, alpha is a multiple of a quarter.
        self.assertLessEqual({pixel[3] for pixel in cut}, {0, 64, 128, 191, 255})

    def apart_over_black(self, *arguments):
        """Returns how far each byte of a galaxy without a sky, shown over black, is from the galaxy with its sky."""
        galaxy = (str(SOURCE / "assets/scenes/galaxy.json"), "--frames", "0", "--size", "97x55", "-q", "--overwrite", *arguments)
        self.good("render", *galaxy, "-o", "plain.png")
        self.good("render", *galaxy, "-o", "cut.png", "-D", "render.transparent=true")
        plain, _ = pixels((self.folder / "plain.png").read_bytes())
        cut, _ = pixels((self.folder / "cut.png").read_bytes())
        self.assertGreater(len({pixel[3] for pixel in cut}), 50)
        return [abs(before[i] - after[i] * after[3] / 255) for before, after in zip(plain, cut) for i in range(3)]

    def test_glows_look_the_same_over_black(self):
        # The pictures are equal except for rounding and the sky, which is nearly black.
        apart = self.apart_over_black("-D", "objects.core=null")
        self.assertLessEqual(max(apart), 6)
        self.assertLess(sum(apart) / len(apart), 1.5)

    def test_glows_before_a_blended_surface_keep_their_light(self):
        # Surfaces are composited by their alpha in encoded values, so the pictures differ where the core is thin.
        apart = self.apart_over_black()
        self.assertLessEqual(max(apart), 80)
        self.assertLess(sum(apart) / len(apart), 4)

    def test_formats_without_alpha_are_refused(self):
        self.write("scene.json", SCENE)
        see = ("render", "scene.json", "--frames", "0", "-D", "render.transparent=true")
        self.bad(2, "a video has no alpha channel for render.transparent", *see, "-o", "a.mp4")
        self.bad(2, "y4m has no alpha channel", *see, "-o", "-", "--stream-format", "y4m")
        self.bad_scene("a transparent background needs \"rasterizer\": \"exact\"", *see, "-o", "a.png", "--rasterizer", "driver")

    def test_sixteen_bits(self):
        for transparent in ("false", "true"):
            with self.subTest(transparent):
                self.write("scene.json", SCENE)
                see = ("render", "scene.json", "--frames", "0", "-q", "--overwrite", "-D", f"render.transparent={transparent}")
                self.good(*see, "-o", "deep.png", "--bits", "16")
                self.good(*see, "-o", "plain.png")
                deep, plain = ((self.folder / name).read_bytes() for name in ("deep.png", "plain.png"))
                self.assertEqual((deep[24], deep[25]), (16, 6 if transparent == "true" else 2))
                width, _, rows = png_rows(deep)
                channels = 4 if transparent == "true" else 3
                data = b"".join(unfiltered(rows, width * 2 * channels, 2 * channels))
                numbers = [256 * data[i] + data[i + 1] for i in range(0, len(data), 2)]
                shown = [value for pixel in pixels(plain)[0] for value in pixel]
                # The pictures are equal except for the dither, which is at most half a step.
                self.assertLessEqual(max(abs(a / 257 - b) for a, b in zip(numbers, shown)), 1.01)
                self.assertGreater(len(set(numbers)), 4 * len(set(shown)))
        # Without a tone curve, 16-bit values are the light of the OpenEXR file, encoded by the sRGB curve (IEC
        # 61966-2-1) and rounded. With several samples, edges of highlights differ (edge_light.glsl).
        dark = ("--samples", "1", "-D", "sky.ground=[0.002,0.01,0.003]", "-D", "render.tone=plain", "-D", "render.transparent=false")
        self.good(*see[:6], *dark, "-o", "deep.png", "--bits", "16")
        self.good(*see[:6], *dark, "-o", "light.exr", "--bits", "32")
        width, _, rows = png_rows((self.folder / "deep.png").read_bytes())
        data = b"".join(unfiltered(rows, width * 6, 6))
        numbers = [256 * data[i] + data[i + 1] for i in range(0, len(data), 2)]
        _, _, channels, _ = read_exr((self.folder / "light.exr").read_bytes())
        light = [min(value, 1) for pixel in zip(channels["R"], channels["G"], channels["B"]) for value in pixel]
        encoded = [65535 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055) for x in light]
        self.assertLess(max(abs(a - b) for a, b in zip(numbers, encoded)), 0.6)
        self.bad(2, "PNG pictures have 8 or 16 bits", *see, "-o", "a.png", "--bits", "32")
        self.bad(2, "OpenEXR pictures have 16 or 32 bits", *see, "-o", "a.exr", "--bits", "8")
        self.bad(2, "videos and streams have 8 bits", *see[:5], "-o", "a.mp4", "--bits", "16")
        self.write("chart.json", {"version": 1, "objects": {"cells": {"life": {"size": [32, 18]}}, "curve": {"chart": {"curves": [{"of": "cells.population"}]}}}})
        self.bad(2, "a chart is drawn over the picture", "render", "chart.json", "-o", "map.png", "--frames", "0", "--bits", "16")

    def test_exr_files_hold_light_and_layers(self):
        self.write("scene.json", SCENE)
        see = ("render", "scene.json", "-q", "--layers", "depth,object,position,normal,albedo")
        self.good(*see, "--frames", "0,3", "-o", "a/####.exr")
        self.good(*see, "--frames", "0", "-o", "b.exr")
        first = (self.folder / "a/0000.exr").read_bytes()
        self.assertEqual(first, (self.folder / "b.exr").read_bytes())
        for channel in (b"CryptoObject00.R", b"N.X", b"P.X", b"Z\0", b"albedo.B", b"MurmurHash3_32", b"ball", b"simreel:scene"):
            self.assertIn(channel, first[:4096])
        frames = json.loads((self.folder / "a/manifest.json").read_text())["frames"]
        self.assertEqual([frame["file"] for frame in frames], ["0000.exr", "0003.exr"])
        self.good("render", "scene.json", "--layers", "depth,object,position,normal,albedo", "--frames", "0,3", "-o", "a/####.exr", "--resume")
        self.assertEqual(first, (self.folder / "a/0000.exr").read_bytes())
        # Tone curve and exposure do not affect OpenEXR.
        self.good(*see, "--frames", "0", "-o", "c.exr", "-D", "render.tone=plain", "-D", "render.exposure=3")
        self.good("diff", "b.exr", "c.exr")
        self.assertEqual(self.run_program("diff", "b.exr", "b.exr", "-q").returncode, 0)
        self.good(*see, "--frames", "0", "-o", "d.exr", "-D", "sky.zenith=[0.2,0.2,0.4]")
        self.assertEqual(self.run_program("diff", "b.exr", "d.exr", "-q").returncode, 1)

    def test_coverage_of_objects_has_the_motion_blur_of_the_light(self):
        turning = {"radius": 0.3, "position": {"keys": [[0, [-1, 0, 0]], [1, [1, 0, 0]]]}}
        self.write("scene.json", {"version": 1, "stage": False, "render": {"size": [48, 27], "samples": 2, "transparent": True}, "time": {"fps": 8, "duration": 1},
                                  "camera": {"position": [0, 0, 3], "target": [0, 0, 0]}, "sky": {"zenith": [1, 1, 1]}, "ground": {"visible": False},
                                  "objects": {"moved": {"sphere": turning}, "near": {"sphere": {"radius": 0.15, "position": [0, 0.2, 1.5]}}}})
        lens, shutter = ("-D", "camera.lens={\"fNumber\": 0.1, \"samples\": 12}"), ("-D", "camera.shutter={\"angle\": 360, \"samples\": 6}")
        partly = []
        for blur in ((), shutter, lens, (*lens, *shutter)):
            self.good("render", "scene.json", "--frames", "4", "-q", "-o", "a.exr", "--overwrite", "--bits", "32", "--layers", "object", *blur)
            _, _, channels, header = read_exr((self.folder / "a.exr").read_bytes())
            manifest = json.loads(next(body for name, (_, body) in header.items() if name.endswith("/manifest")))
            self.assertEqual(set(manifest), {"moved", "near"})
            known = {int(number, 16): name for name, number in manifest.items()}
            ranks = [(channels[f"CryptoObject{i // 2:02}.{'RB'[i % 2]}"], channels[f"CryptoObject{i // 2:02}.{'GA'[i % 2]}"])
                     for i in range(2 * sum(name.endswith(".R") and "Crypto" in name for name in channels))]
            seen = set()
            for pixel, alpha in enumerate(channels["A"]):
                shares = [(known[bits(ids[pixel])], covers[pixel]) for ids, covers in ranks if covers[pixel] > 0]
                self.assertAlmostEqual(sum(share for _, share in shares), alpha, delta=1e-6)
                self.assertEqual(shares, sorted(shares, key=lambda one: -one[1]))
                self.assertEqual(len({name for name, _ in shares}), len(shares))
                seen.update(name for name, _ in shares)
            self.assertEqual(seen, set(manifest))
            partly.append(sum(0 < alpha < 1 for alpha in channels["A"]))
        self.assertGreater(min(partly[1:]), 1.5 * partly[0])

    def test_layers_without_light_are_refused(self):
        self.write("scene.json", SCENE)
        see = ("render", "scene.json", "--frames", "0")
        self.bad(2, "--layers: only OpenEXR pictures have layers", *see, "-o", "a.png", "--layers", "depth")
        self.bad(2, "depht", *see, "-o", "a.exr", "--layers", "depht")
        self.bad(2, 'OpenEXR pictures need "rasterizer": "exact"', *see, "-o", "a.exr", "--rasterizer", "driver")
        self.bad(2, "--pieces makes PNG pictures or a video", "render", "scene.json", "-o", "a/####.exr", "--pieces", "2")
        said = "OpenEXR pictures contain only the light of the scene; missing there, because drawn over the picture: text"
        self.write("worded.json", {**SCENE, "objects": {**SCENE["objects"], "word": {"text": {"text": "A", "screen": {}}}}})
        self.assertEqual(self.good("render", "worded.json", "--frames", "0-2", "-o", "b/####.exr").err.count(said), 1)
        self.assertNotIn(said, self.good("render", "scene.json", "--frames", "0", "-o", "c.exr").err)
        # Renders a field that covers the whole picture.
        self.write("field.json", {"version": 1, "render": {"size": [16, 9]}, "objects": {"cells": {"life": {"size": [32, 18]}}}})
        self.good("render", "field.json", "--frames", "0", "-o", "d.exr")
        width, height, channels, _ = read_exr((self.folder / "d.exr").read_bytes())
        self.assertEqual((width, height, len(channels["G"])), (16, 9, 144))


if __name__ == "__main__":
    main()
