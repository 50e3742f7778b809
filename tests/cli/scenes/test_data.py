"""Checks pictures and tables of data: colour bars, tables of quantities, and what version 2 of scenes changes."""
import csv
import json
import struct

from common import Case, main

FIELD = {"version": 2, "render": {"size": [200, 100], "samples": 1}, "time": {"fps": 30, "duration": 0.1},
         "objects": {"dish": {"reaction": {"preset": "schnakenberg", "size": [20, 10], "display": {"low": 1, "high": 5}}},
                     "bar": {"colorBar": {"of": "dish", "corner": [0.5, 0.2, 0], "extent": [0.1, 0.6, 0], "height": 0.08}}}}


SHORT = ("render", "a.json", "-o", "x.png", "--frames", "0")


class Data(Case):
    def test_a_colour_bar_runs_through_the_colours_of_its_field(self):
        self.write("a.json", {**FIELD, "objects": {**FIELD["objects"], "dish": {"reaction": {**FIELD["objects"]["dish"]["reaction"], "display": {"low": 1, "high": 5, "map": "grey"}}}}})
        pixels = self.good("render", "a.json", "--frames", "0", "-o", "-", "-q").stdout

        def grey(x, y):
            return pixels[4 * (200 * y + x)]
        # The bar covers x from 100 to 120 and y from 20 to 80. It is white at the top and black at the bottom.
        shades = [grey(110, y) for y in range(21, 80)]
        self.assertEqual(shades, sorted(shades, reverse=True))
        self.assertGreater(shades[0], 245)
        self.assertLess(shades[-1], 30)
        # Ticks are to the right of the bar at the values 1 to 5. Between them, the panel is visible.
        self.assertGreater(max(grey(121, 49), grey(121, 50)), 110)
        self.assertLess(grey(121, 57), 80)

    def test_fields_and_bake_leave_out_colour_bars(self):
        self.write("a.json", FIELD)
        self.good("render", "a.json", "--frames", "0", "-o", "out/", "--fields", "npy", "-q")
        self.assertEqual(sorted(file.name for file in (self.folder / "out").glob("*.npy")), ["000000.dish.npy", "000000.dish.u.npy", "000000.dish.v.npy"])
        self.good("bake", "a.json", "--frames", "0", "-o", "baked", "--format", "npy", "-q")
        self.assertEqual(sorted(file.name for file in (self.folder / "baked").iterdir()), ["dish.u_000000.npy", "dish.v_000000.npy", "dish_000000.npy"])

    def test_a_colour_bar_lies_over_its_field_wherever_the_scene_lists_it(self):
        pictures = []
        for names in (("dish", "bar"), ("bar", "dish")):
            self.write("a.json", {**FIELD, "objects": {name: FIELD["objects"][name] for name in names}})
            pictures.append(self.good("render", "a.json", "--frames", "0", "-o", "-", "-q").stdout)
        self.assertEqual(*pictures)

    def test_a_colour_bar_names_the_classes_of_an_epidemic(self):
        pictures = []
        for labels in ({}, {"labels": ["empty", "susceptible", "infected", "recovered"]},
                       {"labels": [{"text": text, "value": value} for text, value in
                                   (("empty", 0), ("susceptible", 64), ("infected", 128), ("recovered", 255))]}):
            self.write("a.json", {**FIELD, "objects": {"town": {"epidemic": {"size": [20, 10], "infected": 0.1}},
                                                       "bar": {"colorBar": {"of": "town", **labels}}}})
            pictures.append(self.good("render", "a.json", "--frames", "0", "-o", "-", "-q").stdout)
        self.assertEqual(len(set(pictures)), 1)

    def test_colours_that_no_scale_explains_have_no_bar(self):
        for show, code in (("dye", 2), ("speed", 0)):
            self.write("a.json", {**FIELD, "objects": {"f": {"fluid": {"size": [32, 18], "show": show}}, "bar": {"colorBar": {"of": "f"}}}})
            done = self.run_program("render", "a.json", "--frames", "0", "-o", "f.png")
            self.assertEqual(done.returncode, code, done.err)
            self.assertEqual("in colours of its own, which a bar cannot explain" in done.err, code == 2)

    def test_an_override_of_null_removes_a_value(self):
        self.write("a.json", FIELD)
        plain = self.good("render", "a.json", "--frames", "0", "-o", "-", "-q", "-D", "objects.bar=null").stdout
        self.write("a.json", {**FIELD, "objects": {"dish": FIELD["objects"]["dish"]}})
        self.assertEqual(self.good("render", "a.json", "--frames", "0", "-o", "-", "-q").stdout, plain)

    def test_mistakes_of_colour_bars(self):
        def bar(value, **more):
            self.write("a.json", {**FIELD, "objects": {**FIELD["objects"], "bar": {"colorBar": value}, **more}})
        bar({"of": "dsh"})
        self.bad_scene('did you mean "dish"?', *SHORT)
        bar({"of": "ball"}, ball={"sphere": {}})
        self.bad_scene('object "ball" is a sphere, which is not drawn in colours of a scale', *SHORT)
        bar({"of": "dust"}, dust={"particles": {"groups": [{}]}})
        self.bad_scene('whose "look" has no "colorBy"', *SHORT)
        bar({})
        self.bad_scene('Give "of"', *SHORT)
        bar({"of": "dish", "title": "\u4e2d"})
        self.bad(2, "colorBar \"bar\": the font has no", *SHORT)
        bar({"of": "dish", "extent": [0, 0.5, 0]})
        self.bad_scene("needs a width and a height above 0", *SHORT)
        bar({"of": "dish", "labels": ["low", {"text": "high", "value": 9}]})
        self.bad(2, "the colours of \"dish\" go from 1 to 5", *SHORT)
        bar({"of": "cells", "labels": [{"text": "x", "value": 2000}]}, cells={"epidemic": {"size": [8, 8], "infected": 0.1}})
        self.bad(2, 'the label "x" has the value 2000', *SHORT)

    def test_a_table_of_quantities_has_a_row_for_each_frame(self):
        self.write("a.json", {"version": 2, "time": {"fps": 20, "duration": 0.2}, "objects": {
            "sheet": {"cloth": {"size": [5, 5], "gravity": [0, -10, 0], "wind": [0, 0, 0], "damping": 0, "substeps": 1}},
            "ball": {"sphere": {"position": [9, 0, 0]}}}})
        self.good("bake", "a.json", "-o", "out", "--format", "csv", "-q")
        self.assertEqual([file.name for file in (self.folder / "out").iterdir()], ["sheet.csv"])
        rows = list(csv.DictReader((self.folder / "out/sheet.csv").read_text().splitlines()))
        self.assertEqual([row["frame"] for row in rows], ["0", "1", "2", "3"])
        self.assertEqual(list(rows[0])[:3], ["frame", "time", "population"])
        # For free fall with semi-implicit Euler, v = g t, so E = m (g t)^2 / 2 with m = 25 kg.
        for row in rows:
            self.assertAlmostEqual(float(row["kineticEnergy"]), 0.5 * 25 * (10 * float(row["time"])) ** 2, 3)
        self.bad(6, "exists; use --overwrite", "bake", "a.json", "-o", "out", "--format", "csv")
        self.bad(2, '"ball" is no object that measures a quantity; there is sheet', "bake", "a.json", "-o", "b", "--format", "csv", "--object", "ball")

    def test_no_manifest_leaves_the_picture_alone(self):
        self.write("a.json", {"version": 2, "render": {"size": [32, 18]}, "objects": {"ball": {"sphere": {"position": [9, 0, 0]}}}})
        self.good("render", "a.json", "-o", "out/a.png", "--frames", "0", "--no-manifest", "-q")
        self.assertEqual([file.name for file in (self.folder / "out").iterdir()], ["a.png"])
        self.bad(2, "--no-manifest: --resume needs the manifest", "render", "a.json", "-o", "out/", "--no-manifest", "--resume")
        self.good("render", "a.json", "-o", "out/a.png", "--frames", "0", "--overwrite", "-q")
        self.bad(6, "lists earlier frames", "render", "a.json", "-o", "out/a.png", "--frames", "0", "--overwrite", "--no-manifest")

    def test_a_small_ball_does_not_fall_between_the_particles_of_a_sheet(self):
        # In version 1, the ball does fall between the particles. This test takes 3 s.
        scene = {"stage": False, "time": {"fps": 60, "duration": 1}, "objects": {"s": {"cloth": {"size": [16, 16], "position": [0, 1, 0], "pins": []}}, "b": {"sphere": {"radius": 0.08, "position": [0.013, 0.6, 0.021]}}}}
        for version, holds in ((2, True), (1, False)):
            self.write("a.json", {"version": version, **scene})
            self.good("bake", "a.json", "--object", "s", "--format", "ply", "--frames", "50", "-o", "b", "--overwrite")
            head, rows = (self.folder / "b/s_000050.ply").read_bytes().split(b"end_header\n", 1)
            width = head.split(b"element face")[0].count(b"property float")
            self.assertEqual(max(struct.unpack_from("<f", rows, 4 * (width * i + 1))[0] for i in range(256)) > 0.6, holds)

    def test_sheets_fall_in_version_2_and_hang_in_version_1(self):
        sheet = {"objects": {"sheet": {"cloth": {"size": [5, 5]}}}}
        self.write("one.json", {"version": 1, **sheet})
        self.write("two.json", {"version": 2, **sheet})
        self.assertIn("its last row is pinned", self.good("render", "one.json", "-o", "a/", "--frames", "0", "--size", "32x18").err)
        self.assertNotIn("pinned", self.good("render", "two.json", "-o", "b/", "--frames", "0", "--size", "32x18").err)

    def test_explain_knows_the_pins_of_a_sheet_of_version_1(self):
        # This test takes 0.2 s.
        for version, pinned in ((1, True), (2, False)):
            self.write("a.json", {"version": version, "objects": {"sheet": {"cloth": {"size": [5, 5]}}}})
            self.assertEqual("objects.sheet.cloth.pins.0.rows" in self.good("explain", "a.json").stdout.decode(), pinned)

    def test_the_margin_of_a_sheet_follows_its_spacing_in_version_2(self):
        for version, margin in ((1, 0.01), (2, 0.07)):
            self.write("a.json", {"version": version, "objects": {"sheet": {"cloth": {"size": [5, 5], "spacing": 0.2}}}})
            said = self.good("explain", "a.json").stdout.decode()
            line = next(line for line in said.splitlines() if line.startswith("objects.sheet.cloth.margin"))
            self.assertAlmostEqual(float(line.split()[1]), margin, 6)

    def test_a_camera_with_a_target_alone_keeps_its_distance(self):
        ball = {"objects": {"ball": {"sphere": {"radius": 40}}}, "camera": {"target": [0, 5, 0]}}
        self.write("a.json", {"version": 2, **ball})
        said = self.good("explain", "a.json").stdout.decode()
        place = json.loads(next(line for line in said.splitlines() if line.startswith("camera.position")).split()[1])
        self.assertGreater(max(abs(number) for number in place), 80)

    def test_a_ground_lies_under_a_fountain(self):
        self.write("a.json", {"version": 2, "ground": True, "objects": {"water": {"particles": {
            "emitters": [{"position": [0, 1, 0]}], "acceleration": [0, -9.8, 0], "collides": True}}}})
        said = self.good("explain", "a.json").stdout.decode()
        height = float(next(line for line in said.splitlines() if line.startswith("ground.height")).split()[1])
        self.assertLess(abs(height - 1), 0.1)

    def test_a_plane_alone_has_a_stage(self):
        self.write("a.json", {"version": 2, "objects": {"floor": {"plane": {}}}})
        self.assertIn("stage", self.good("explain", "a.json").stdout.decode())

    def test_messages_about_groups_show_an_example(self):
        ball = {"ball": {"sphere": {}}}
        for more, expected in [({"lights": [{}]}, 'expected lamps by name, such as {"lamp": {"position": [0, 3, 2]}}, found a list'),
                               ({"ground": 3}, "expected true, false or an object"),
                               ({"objects": {"ball": {"sphere": {}, "material": "gold"}}}, 'such as {"color": "gold", "metallic": 1}'),
                               ({"objects": [ball]}, "expected objects by name"),
                               ({"objects": {"ball": "sphere"}}, 'such as {"sphere": {}}')]:
            self.write("a.json", {"version": 2, "objects": ball, **more})
            self.bad_scene(expected, *SHORT)
        self.write("a.json", {"version": 2})
        self.assertIn("the scene has no objects", self.good("render", "a.json", "-o", "b/", "--frames", "0", "--size", "32x18").err)
        self.write("a.json", {"version": 2, "stage": "paper", "objects": {"dust": {"particles": {"groups": [{}], "look": {"additive": True}}}}})
        self.assertIn('take "stage": "night"', self.good("validate", "a.json").err)


if __name__ == "__main__":
    main()
