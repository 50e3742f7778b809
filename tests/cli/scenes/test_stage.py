"""Compares pictures of one-line scenes, which get a stage, and of a lens and spot lights with baselines beside them."""
import os

from common import SOURCE, Case, main, png_rows, unfiltered

# These scenes take most of the time. Other scenes and tests/gpu/draw cover the same features. They run only with
# SIMREEL_LONG.
LONG = {"casket", "neon"}


class Stage(Case):
    def test_pictures_of_scenes_of_one_line(self):
        stage = sorted((SOURCE / "tests/cli/scenes/stage").glob("*.json"))
        self.assertLessEqual(LONG, {file.stem for file in stage})
        self.assertGreaterEqual(len(stage), 20)
        chosen = [file for file in stage if file.stem not in LONG or os.environ.get("SIMREEL_LONG") == "1"]
        done = self.good("test", *chosen, "--repeat", "1")
        self.assertIn(f"{len(chosen)} scenes: {len(chosen)} passed", done.stdout.decode())


    def test_features_that_the_driver_lacks_are_reported(self):
        self.write("ball.json", {"version": 1, "camera": {"lens": {"samples": 4}}, "objects": {"ball": {"sphere": {}}}})
        small = ("render", "ball.json", "--frames", "0", "--size", "32x18")
        self.assertIn("camera.lens: the driver's rasterizer draws the whole picture sharp",
                      self.good(*small, "-o", "a/", "--rasterizer", "driver").err)
        self.assertEqual(self.good(*small, "-o", "b/", "-q").err, "")
        said = self.good(*small, "-o", "d/", "--rasterizer", "driver", "-D", "render.quality=standard").err
        self.assertEqual(said.count("render.quality: the driver's rasterizer supports only"), 1)
        self.assertEqual(self.good(*small, "-o", "e/", "-q", "-D", "render.quality=standard").err, "")
        self.bad_scene(["-D camera.lens.blades=2: error: an opening cannot have 2 blades", "3 to 16"], *small, "-o", "c/", "-D", "camera.lens.blades=2")


    def test_light_by_rays(self):
        plain = {"version": 1, "render": {"quality": "high", "raySamples": 2}, "objects": {"ball": {"sphere": {}}}}
        self.write("ball.json", plain)
        laid = {**plain, "objects": {"ball": {"sphere": {}, "material": {"texture": str(SOURCE / "assets/textures/flag.png"), "clearCoat": 1, "alpha": "blend", "opacity": 0.5}}}}
        self.write("laid.json", laid)
        small = ("--frames", "0", "--size", "32x18")
        self.assertEqual(self.good("render", "ball.json", *small, "-o", "a/", "-q").err, "")
        self.assertEqual(self.good("render", "laid.json", *small, "-o", "b/", "-q").err, "")
        self.bad_scene("between 1 and 1024", "render", "ball.json", *small, "-o", "c/", "-D", "render.raySamples=2000")


    def test_glass_is_drawn_in_every_quality_and_its_parameters_need_a_transmission(self):
        glass = {"transmission": 1, "ior": 1.4}
        self.write("glass.json", {"version": 1, "objects": {"ball": {"sphere": {}, "material": glass}}})
        small = ("render", "glass.json", "--frames", "0", "--size", "32x18")
        self.assertEqual(self.good(*small, "-o", "a/", "-q").err, "")
        self.assertEqual(self.good(*small, "-o", "b/", "-q", "-D", "render.quality=high", "-D", "render.raySamples=2").err, "")
        self.write("no_glass.json", {"version": 1, "objects": {"ball": {"sphere": {}, "material": {"ior": 1.4}}}})
        self.bad_scene(["\"ior\" is for a material with a \"transmission\""], "render", "no_glass.json", "-o", "c/")
        self.write("sheet.json", {"version": 1, "objects": {"ball": {"sphere": {}, "material": {**glass, "thinWalled": True, "attenuationColor": [1, 0.5, 0.2]}}}})
        self.bad_scene(["\"attenuationColor\" is for a material with a \"transmission\" that is not \"thinWalled\""], "render", "sheet.json", "-o", "d/")


    def test_glass_of_a_mesh_file_is_recognized(self):
        self.write("bottle.json", {"version": 1, "objects": {"bottle": {"mesh": {"shape": "file", "file": str(SOURCE / "assets/meshes/bottle.glb")}}}})
        small = ("render", "bottle.json", "--frames", "0", "--size", "32x18")
        self.assertEqual(self.good(*small, "-o", "a/", "-q").err, "")
        self.good(*small, "-o", "b/", "-q", "-D", "objects.bottle.material.transmission=0")
        pictures = [(self.folder / name / "000000.png").read_bytes() for name in ("a", "b")]
        self.assertNotEqual(*pictures)


    def test_spot_parameters_need_a_spot_light(self):
        light = {"position": [0, 2, 0], "spot": {"angle": 30}}
        self.write("ball.json", {"version": 1, "lights": {"key": light}, "objects": {"ball": {"sphere": {}}}})
        self.write("where.json", {"version": 1, "lights": {"key": {"type": "spot", "position": [0, 0, 0]}}, "objects": {"ball": {"sphere": {}}}})
        self.bad_scene(["so it has no direction; move \"target\""], "render", "where.json", "-o", "a/", "--frames", "0")
        self.bad_scene(["\"spot\" is for lights of \"type\": \"spot\""], "render", "ball.json", "-o", "a/", "--frames", "0")


    def test_sky_pictures_are_checked(self):
        self.write("ball.json", {"version": 1, "sky": {"picture": "sky.hdr"}, "objects": {"ball": {"sphere": {}}}})
        see = ("render", "ball.json", "--frames", "0", "--size", "32x18")
        self.bad_scene("sky.hdr", *see, "-o", "a/")
        studio = (SOURCE / "assets/textures/studio.hdr").read_bytes()
        self.write("sky.hdr", studio)
        self.assertIn("sky.picture: the driver's rasterizer draws a gradient of the picture's mean light",
                      self.good(*see, "-o", "b/", "--rasterizer", "driver").err)
        self.assertEqual(self.good(*see, "-o", "c/", "-q").err, "")
        self.bad_scene("leave out \"zenith\"", *see, "-o", "d/", "-D", "sky.zenith=[0,0,0]")
        self.write("sky.hdr", studio[:2000])
        self.bad(6, ["sky.hdr is cut off after 2000 bytes"], *see, "-o", "e/")
        self.write("sky.hdr", (SOURCE / "assets/textures/boat.png").read_bytes())
        self.bad(6, ["is neither Radiance HDR nor OpenEXR"], *see, "-o", "f/")
        self.write("sky.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + bytes(16))
        self.bad(6, ["2x2 pixels; an equirectangular picture is twice as wide as high"], *see, "-o", "g/")

    def test_a_bright_sky_picture_lights_the_ground_by_the_cosine_law(self):
        """A cap of 28 degrees around the zenith (sin^2 = 0.2222) gives the same irradiance as uniform light of 0.2222
        times the radiance."""
        def sky(cap, rest):  # In Radiance bytes, 64 stands for 0.5 at exponent 128. Exponent 129 doubles the value.
            return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n" + 64 * 5 * cap + 64 * 27 * rest

        self.write("cap.hdr", sky(bytes((128, 128, 128, 130)), bytes(4)))  # sky whose cap has radiance 2
        self.write("even.hdr", sky(*2 * [bytes((114, 114, 114, 128))]))  # uniform sky of radiance 0.445
        self.write("ground.json", {
            "version": 1, "render": {"quality": "high", "raySamples": 256, "tone": "plain", "samples": 1, "size": [12, 12]}, "sky": {"picture": "even.hdr"},
            "ground": {"height": 0, "color": [0.5, 0.5, 0.5], "roughness": 1}, "camera": {"position": [0, 1, 0.01], "target": [0, 0, 0], "fieldOfView": 10},
            "objects": {"ball": {"sphere": {"position": [30, 0, 0], "radius": 0.1}}}})
        means = []
        for name in ("cap", "even"):
            self.good("render", "ground.json", "-o", f"{name}.png", "--frames", "0", "-q", "-D", f"sky.picture={name}.hdr")
            width, height, rows = png_rows((self.folder / f"{name}.png").read_bytes())
            step = len(rows) // height // width
            lines = unfiltered(rows, step * width, step)
            means.append(sum(sum(line[::step]) for line in lines) / width / height)
        self.assertAlmostEqual(*means, delta=1.5)  # One percent of the light changes the mean by 0.6.


if __name__ == "__main__":
    main()
