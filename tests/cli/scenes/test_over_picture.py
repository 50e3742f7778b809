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

    def test_isolines_are_light_over_dark_colours_and_dark_over_light_ones(self):
        hill = {"reaction": {"size": [64, 36], "steps": 0, "boundary": "no-flux", "species": {"h": {"start": "x"}},
                             "display": {"low": 0, "high": 64, "stops": [{"color": "black"}, {"color": "white"}]}}}
        for value, ink in ((4, 0.75), (50, 0.01)):
            self.scene({"h": hill, "i": {"isolines": {"of": "h", "at": [value]}}})
            own = self.picture(f"own{value}")
            self.assertEqual(own, self.picture(f"same{value}", "-D", f"objects.i.isolines.color=[{ink},{ink},{ink}]"))
        self.assertNotEqual(own, self.picture("light", "-D", "objects.i.isolines.color=[0.75,0.75,0.75]"))

    def test_a_chart_alone_in_a_panel_fills_it(self):
        chart = {"chart": {"curves": [{"of": "l.population"}]}}
        panels = {"a": {"objects": ["l"], "caption": ""}, "b": {"objects": ["c"], "caption": ""}}
        self.scene({"l": LIFE, "c": chart}, panels=panels)
        both, other = self.picture("a"), ("-D", "objects.c.chart.high=1000000")
        self.assertNotEqual(both, self.picture("b", *other))
        # The chart fills the panel.
        self.assertEqual(both, self.picture("c", "-D", "objects.c.chart.x=0.4", "-D", "objects.c.chart.width=0.5"))
        self.scene({"l": LIFE, "c": chart}, panels={"a": panels["a"]})
        self.assertEqual(self.picture("d"), self.picture("e", *other))

    def test_a_bar_of_the_speed_of_water_names_its_unit(self):
        pond = {"water": {"size": [16, 16], "display": {"layer": "over"}}}
        self.scene({"p": pond, "b": {"colorBar": {"of": "p.speed"}}})
        self.assertEqual(self.picture("a"), self.picture("b", "-D", "objects.b.colorBar.title=speed (m/s)"))

    def test_particles_that_fall_through_the_ground_are_reported(self):
        def said(particles, ground, **more):
            self.scene({"p": {"particles": {"method": "none", "acceleration": [0, -9.81, 0], **particles}}}, ground=ground, **more)
            return self.good("validate", "a.json", "-D", "time.duration=2").err

        cloud = {"groups": [{"position": [0, 2, 0]}]}
        self.assertIn('"p" falls through the ground, which hides it; give it "collides": true', said(cloud, {"height": 0}))
        for particles, ground in (({**cloud, "collides": True}, {"height": 0}), (cloud, {"height": -50}),
                                  (cloud, {"height": 0, "visible": False}), ({**cloud, "damping": 100}, {"height": 0}),
                                  ({"emitters": [{}]}, {"height": 0})):
            self.assertEqual(said(particles, ground), "")


if __name__ == "__main__":
    main()
