"""Checks text and colours of lines over the picture, and warnings of keys that do nothing."""
import json

from common import Case, main, png_rows

LIFE = {"life": {"size": [32, 18]}}


class OverPicture(Case):
    def scene(self, objects, **more):
        self.write("a.json", {"version": 2, "render": {"size": [192, 108], "samples": 1},
                              "time": {"fps": 10, "duration": 0.3}, "objects": objects, **more})

    def picture(self, name, *options):
        self.good("render", "a.json", "-o", f"{name}.png", "--frames", "last", "--no-manifest", "-q", *options)
        return png_rows((self.folder / f"{name}.png").read_bytes())

    def test_text_over_a_field_that_hides_a_bright_stage_is_white(self):
        self.scene({"l": LIFE, "b": {"sphere": {}}, "t": {"text": {"text": "A", "screen": {"height": 0.3}}}})
        self.assertEqual(self.picture("a"), self.picture("b", "-D", "objects.t.text.screen.color=[1,1,1]"))

    def test_an_orbit_that_stands_still_leaves_room_for_a_colour_bar(self):
        balls = {"groups": [{"shape": "cube"}], "method": "none", "look": {"colorBy": "mass"}}

        def camera(bar, **orbit):
            self.scene({"p": {"particles": balls}, "b": {"colorBar": {"of": "p", **bar}}},
                       camera={"orbit": {"turn": 0, "elevation": 0, **orbit}})
            values = json.loads(self.good("explain", "a.json", "--format", "json").stdout)
            value = {one["path"]: one["value"] for one in values}
            return value["camera.target"][0], value["camera.orbit.distance"]

        placed, free = camera({"corner": [0.9, 0.2, 0]}), camera({})
        self.assertGreater(free[0], placed[0] + 0.1)
        self.assertGreaterEqual(free[1], placed[1])
        turning = {"turn": {"keys": [[0, 0], [1, 90]]}}
        self.assertEqual(camera({"corner": [0.9, 0.2, 0]}, **turning), camera({}, **turning))

    def test_the_colours_of_streamlines_end_at_the_greatest_speed_of_the_flow(self):
        rows = [f"{x * 0.25},{y * 0.25},{1 + (x == 3)},0" for y in range(4) for x in range(4)]
        self.write("flow.csv", "x,y,u,v\n" + "\n".join(rows) + "\n")
        self.scene({"f": {"flow": {"file": "flow.csv"}}, "s": {"streamlines": {"of": "f", "separation": 0.1}}})
        self.assertEqual(self.picture("a"), self.picture("b", "-D", "objects.s.streamlines.high=2"))

    def test_a_scale_bar_stands_beside_a_chart(self):
        bar = {"scaleBar": {"of": "l"}}
        chart = {"chart": {"curves": [{"of": "l.population"}], "x": 0, "width": 0.5}}
        self.scene({"l": LIFE, "c": chart, "s": bar})
        self.assertEqual(self.picture("a"), self.picture("b", "-D", "objects.s.scaleBar.corner=[0.53,0.93,0]"))
        self.scene({"l": LIFE, "s": bar})
        self.assertEqual(self.picture("c"), self.picture("d", "-D", "objects.s.scaleBar.corner=[0.05,0.93,0]"))

    def test_a_wind_that_is_much_stronger_than_gravity_is_reported(self):
        cloth = {"size": [5, 5], "fabric": "silk", "pins": [{"rows": [0]}], "substeps": 200}
        self.scene({"c": {"cloth": {**cloth, "wind": [3, 0, 2]}}})
        done = self.good("render", "a.json", "-o", "a.png", "--frames", "0", "--no-manifest")
        self.assertIn('"wind" is a force on each particle in N', done.err)
        self.assertIn('give "air": {"velocity": [x, y, z]}', done.err)
        self.scene({"c": {"cloth": {**cloth, "wind": [0.01, 0, 0]}}})
        done = self.good("render", "a.json", "-o", "b.png", "--frames", "0", "--no-manifest")
        self.assertNotIn("force on each particle", done.err)

    def test_light_of_a_scene_that_is_one_field_is_reported(self):
        for key, value in (("stage", "paper"), ("sun", {"intensity": 2}), ("ground", {})):
            self.scene({"l": LIFE}, **{key: value})
            self.assertIn(f'here "{key}" does nothing', self.good("validate", "a.json").err)
        for objects, more in (({"l": LIFE, "b": {"sphere": {}}}, {"panels": {"p": {}}, "sun": {}}),
                              ({"l": LIFE}, {"stage": False}), ({"l": LIFE}, {})):
            self.scene(objects, **more)
            self.assertEqual(self.good("validate", "a.json").err, "")

    def test_a_bar_of_water_that_nothing_is_coloured_by_is_reported(self):
        pond = {"water": {"size": [16, 16], "terrain": {"bed": -0.5}}}
        self.scene({"p": pond, "b": {"colorBar": {"of": "p.speed"}}})
        self.assertIn('explains the colours of "p.speed", which nothing shows', self.good("validate", "a.json").err)
        self.scene({"p": {"water": {**pond["water"], "display": {"layer": "over"}}}, "b": {"colorBar": {"of": "p"}}})
        self.assertEqual(self.good("validate", "a.json").err, "")


if __name__ == "__main__":
    main()
