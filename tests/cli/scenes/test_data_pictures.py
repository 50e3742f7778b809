"""Checks pictures of data against numbers: automatic ranges of colours, isolines and scale bars."""
import json
import math
import re
import struct

from common import Case, main, png_rows

SHORT = ("render", "a.json", "-o", "b/", "--frames", "0")
DISH = {"preset": "schnakenberg", "size": [20, 10]}


def numbers(data):
    """Returns the values of an NPY file of floats, and its number of columns."""
    length, = struct.unpack("<H", data[8:10])
    columns = int(re.search(rb"\((\d+), (\d+)\)", data[10:10 + length])[2])
    body = data[10 + length:]
    return struct.unpack(f"<{len(body) // 4}f", body), columns


class DataPictures(Case):
    def scene(self, objects, size=(200, 100), seconds=0.1, **more):
        self.write("a.json", {"version": 2, "stage": False, "render": {"size": list(size), "samples": 1},
                              "time": {"fps": 30, "duration": seconds}, "objects": objects, **more})

    def ends(self, text):
        """Returns the measured ends that a message says, by the last part of their paths."""
        return {path.split(".")[-1]: float(value) for path, value in re.findall(r"-D '?([\w.]+)=([-\d.e+]+)", text)}

    def test_an_automatic_range_is_that_of_the_baked_values(self):
        self.scene({"dish": {"reaction": {**DISH, "display": {"low": "auto", "high": "auto"}}}})
        said = self.good("render", "a.json", "-o", "auto/").err
        self.good("bake", "a.json", "-o", "baked", "--fields", "dish", "-q")
        values = [value for data in self.content("baked").values() for value in numbers(data)[0]]
        self.assertEqual(len(values), 3 * 200)
        ends = self.ends(said)
        for end, value in (("low", min(values)), ("high", max(values))):
            self.assertEqual(struct.pack("<f", ends[end]), struct.pack("<f", value))
        # Fixing the ends to the printed values gives the same pictures, and so does rendering a single frame.
        pinned = re.search(r"to keep them: (.*)", said)[1].replace("'", "").split()
        self.good("render", "a.json", "-o", "pinned/", "-q", *pinned)
        self.good("render", "a.json", "-o", "one/", "--frames", "1", "-q")
        auto = self.content("auto")
        for frame in range(3):
            name = f"{frame:06}.png"
            self.assertEqual(png_rows(self.content("pinned")[name]), png_rows(auto[name]))
        self.assertEqual(self.content("one")["000001.png"], auto["000001.png"])

    def test_one_end_of_a_range_may_be_given(self):
        self.scene({"dish": {"reaction": {**DISH, "display": {"low": -1, "high": "auto", "map": "grey"}}},
                    "bar": {"colorBar": {"of": "dish"}}})
        self.assertEqual(list(self.ends(self.good("render", "a.json", "-o", "b/", "--frames", "0").err)), ["high"])

    def test_the_colours_of_particles_span_their_speeds(self):
        groups = [{"shape": "ball", "count": 50, "radius": 1, "velocity": [1, 2, 2], "speed": 0.5}]
        self.scene({"dust": {"particles": {"groups": groups, "acceleration": [0, -9, 0], "look": {"colorBy": "speed"}}}},
                   camera={"position": [0, 0, 5], "target": [0, 0, 0]})
        self.assertEqual(self.ends(self.good("render", "a.json", "-o", "b/", "--frames", "0", "-D", "version=1").err), {})
        ends = self.ends(self.good("render", "a.json", "-o", "b/", "--frames", "0", "--overwrite").err)
        self.good("bake", "a.json", "-o", "baked", "--format", "npy", "-q")
        speeds = []
        for data in self.content("baked").values():
            values, columns = numbers(data)
            speeds += [math.hypot(*values[i + 4:i + 7]) for i in range(0, len(values), columns)]
        self.assertAlmostEqual(ends["colorFrom"], min(speeds), 5)
        self.assertAlmostEqual(ends["colorTo"], max(speeds), 5)

    def test_the_strain_and_speed_of_cloth_are_those_of_a_closed_form(self):
        # The cloth is scaled by 1.1 along both axes, so every link has the strain 0.1. It is moved by (1, 2, -2) m in a
        # second, which is a speed of 3 m/s.
        auto = {"colorFrom": "auto", "colorTo": "auto"}
        plane = {"mesh": {"shape": "plane", "size": [1, 0, 1], "resolution": [5, 5]}}
        whole = {"min": [-1, -1, -1], "max": [1, 1, 1]}
        stretch = {"keys": [[0, [1, 1, 1]], [0.05, [1.1, 1, 1.1]]]}
        moved = {"keys": [[0, [0, 0, 0]], [1, [1, 2, -2]]]}
        for mesh in (False, True):
            held = {"box": whole} if mesh else {"rows": [0, 1, 2, 3, 4]}
            shape = {"gravity": [0, 0, 0], "wind": [0, 0, 0], **(plane if mesh else {"size": [5, 5], "spacing": 0.25})}
            for quantity, pin, expected in (("strain", {"scale": stretch}, 0.1), ("speed", {"move": moved}, 3)):
                self.scene({"sheet": {"cloth": {**shape, "pins": [{**held, **pin}], "colorBy": quantity, **auto}}})
                ends = self.ends(self.good("render", "a.json", "-o", f"{quantity}{mesh}/", "--frames", "0", "--size", "32x18").err)
                self.assertAlmostEqual(ends["colorFrom"], 0, 5)
                self.assertAlmostEqual(ends["colorTo"], expected, 3)
            # Without pins the cloth falls freely, so v = g t. There are two steps in each of three frames.
            for fabric in ({}, {"fabric": {"material": "cotton", "stretchDamping": 0}, "substeps": 4}):
                self.scene({"sheet": {"cloth": {**shape, **fabric, "gravity": [0, -10, 0], "damping": 0, "pins": [], "colorBy": "speed", **auto}}})
                ends = self.ends(self.good("render", "a.json", "-o", "fall/", "--frames", "0", "--size", "32x18", "--overwrite").err)
                self.assertAlmostEqual(ends["colorTo"], 10 * 2 / 30, 3)

    def test_cloth_has_the_colours_of_its_bar(self):
        stretch = {"keys": [[0, [1, 1, 1]], [0.05, [1.1, 1, 1.1]]]}
        stops = [{"color": [0, 0, 1]}, {"color": [0.2, 0.6, 0]}, {"color": [1, 0, 0]}]
        look = {"colorBy": "strain", "colorFrom": 0, "colorTo": 0.2, "colorStops": stops}
        view = {"camera": {"position": [0, 2, 0.01], "target": [0, 0, 0]}}
        for shape, held in (({"size": [5, 5], "spacing": 0.25, "fabric": "silk"}, {"rows": [0, 1, 2, 3, 4]}),
                            ({"mesh": {"shape": "plane", "size": [1, 0, 1], "resolution": [5, 5]}}, {"box": {"min": [-1, -1, -1], "max": [1, 1, 1]}})):
            pictures = []
            for colors, material in ((look, {}), ({}, {"material": {"color": [0.2, 0.6, 0]}})):
                self.scene({"sheet": {"cloth": {**shape, "gravity": [0, 0, 0], "pins": [{**held, "scale": stretch}], **colors}, **material}}, (60, 60), **view)
                pictures.append(self.good("render", "a.json", "-o", "-", "--frames", "last", "-q").stdout)
            self.assertGreater(max(pictures[0][1::4]), 100)
            self.assertLess(max(abs(a - b) for a, b in zip(*pictures)), 2)
            self.scene({"sheet": {"cloth": {**shape, **look}}, "bar": {"colorBar": {"of": "sheet"}}})
            self.good("validate", "a.json")

    def test_colours_of_cloth_leave_its_states_alone(self):
        for colors in ({}, {"colorBy": "speed"}):
            self.scene({"sheet": {"cloth": {"size": [6, 6], **colors}}})
            self.good("bake", "a.json", "-o", f"out{len(colors)}", "--format", "npy", "-q")
        self.assertEqual(self.content("out0"), self.content("out1"))

    def test_mistakes_of_coloured_cloth(self):
        self.scene({"sheet": {"cloth": {"size": [5, 5]}}, "bar": {"colorBar": {"of": "sheet"}}})
        self.bad_scene('without "colorBy"', *SHORT)
        self.scene({"sheet": {"cloth": {"size": [5, 5], "colorBy": "strain", "colorFrom": 1, "colorTo": 1}}})
        self.bad_scene("colorFrom and colorTo must differ", *SHORT)
        self.scene({"sheet": {"cloth": {"size": [5, 5], "colorBy": "strain"}, "material": {"color": "red"}}})
        self.assertIn('has the colours of its "colorBy"; here "color" of the material does nothing', self.good(*SHORT, "--size", "32x18").err)

    def test_the_jobs_of_a_sweep_share_one_range(self):
        self.scene({"dish": {"reaction": {"size": [20, 10], "parameters": {"a": 1}, "steps": 0,
                                          "species": {"u": {"start": "a*x"}}, "display": {"low": "auto", "high": "auto"}}}})
        self.good("sweep", "a.json", "--vary", "objects.dish.reaction.parameters.a=1,2,-1", "-o", "jobs/", "--frames", "0")
        plan = json.loads((self.folder / "jobs/plan.json").read_text())
        given = " ".join(f"-D {one}" for one in plan["overrides"])
        self.assertEqual(self.ends(given), {"low": -19.5, "high": 39})

    def test_mistakes_of_ranges(self):
        self.scene({"dish": {"reaction": {**DISH, "display": {"low": "auto ", "high": 3}}}})
        self.bad_scene('expected a number or "auto"', *SHORT)
        self.scene({"town": {"epidemic": {"size": [8, 8], "infected": 0.1, "display": {"low": "auto"}}}})
        self.bad_scene('its colours are in "colors"', *SHORT)

    def field(self, start, lines, size=(320, 180), cells=(80, 45), **display):
        """A field of a known function without colours, under black lines."""
        self.scene({"hill": {"reaction": {"size": list(cells), "steps": 0, "boundary": "no-flux", "species": {"h": {"start": start}},
                                          "display": {"low": 0, "high": 50, "stops": [{"color": "white"}, {"color": "white"}], **display}}},
                    "lines": {"isolines": {"of": "hill", "color": "black", "opacity": 1, "labels": False, **lines}}}, size)
        pixels = self.good("render", "a.json", "-o", "-", "--frames", "0", "-q").stdout
        return [[255 - pixels[4 * (size[0] * y + x)] for x in range(size[0])] for y in range(size[1])]

    def test_a_field_of_version_2_is_in_the_picture_as_a_whole(self):
        # This test takes 0.3 s.
        for version, fit in ((1, "cover"), (2, "contain")):
            self.write("a.json", {"version": version, "render": {"size": [64, 16]}, "objects": {"f": {"lenia": {"size": [32, 32]}}}})
            said = self.good("explain", "a.json").stdout.decode()
            self.assertIn(fit, next(line for line in said.splitlines() if line.startswith("objects.f.lenia.display.fit")))

    def test_a_chart_outside_of_the_picture_is_refused(self):
        # This test takes 0.1 s.
        for key, value in (("x", 1.2), ("x", -0.6), ("y", 1)):
            self.write("a.json", {"version": 2, "objects": {"s": {"cloth": {}}, "c": {"chart": {"curves": [{"of": "s.speed"}], "width": 0.5, "height": 0.3, key: value}}}})
            self.bad(2, "the chart lies outside of the picture", "validate", "a.json")

    def test_an_isoline_lies_where_the_closed_form_has_it(self):
        # The lines are circles with radii of 10 and 17.5 cells around the corner of cell (40, 22), which is pixel (160,
        # 88).
        dark = self.field("sqrt((x - 40)^2 + (y - 22)^2)", {"at": [10, 17.5], "width": 2 / 180})
        for y in (90, 110, 60):
            for radius in (40, 70):
                for side in (-1, 1):
                    x = 160 + side * math.sqrt(radius ** 2 - (y + 0.5 - 88) ** 2)
                    near = range(int(x) - 5, int(x) + 7)
                    weight = sum(dark[y][i] for i in near)
                    self.assertGreater(weight, 255)
                    middle = sum(dark[y][i] * (i + 0.5) for i in near) / weight
                    self.assertLess(abs(middle - x), 0.25, (y, radius, side))
        # The area of a line is its length times its width, which is 2 pixels here.
        area = sum(map(sum, dark)) / 255
        self.assertAlmostEqual(area, 2 * 2 * math.pi * (40 + 70), delta=0.01 * area)

    def test_isolines_of_reduced_fields_and_of_a_part_of_a_field(self):
        # A pixel covers 4 cells. The corner of cell 160 is at pixel 40.
        dark = self.field("x", {"at": [160, 960], "width": 1 / 45}, (80, 45), (320, 180))
        self.assertAlmostEqual(sum(d * (i + 0.5) for i, d in enumerate(dark[20])) / sum(dark[20]), 40, delta=0.1)
        # Cells 20 to 60 fill the right half of the picture.
        place = {"corner": [0.5, 0, 0], "extent": [0.5, 1, 0], "fit": "cover"}
        dark = self.field("x", {"at": [15, 21, 65], "width": 1 / 180}, **place)
        bare = self.field("x", {"at": [1000]}, **place)
        self.assertEqual([row[:160] for row in dark], [row[:160] for row in bare])
        self.assertAlmostEqual(sum(dark[90][160:]), 255, delta=2)

    def test_numbers_interrupt_their_lines(self):
        bare = self.field("y", {"every": 10})
        numbered = self.field("y", {"every": 10, "labels": True, "height": 0.05})
        # Line 10 is at pixel 40. Without a number it is continuous; with a number it has a gap as wide as the number.
        self.assertGreater(min(bare[39]), 30)
        gap = [x for x, shade in enumerate(numbered[39]) if shade < 30]
        self.assertGreater(len(gap), 4)
        self.assertGreater(sum(map(sum, numbered[:60])), sum(map(sum, bare[:60])))

    def test_mistakes_of_isolines(self):
        hill = {"hill": {"reaction": {**DISH}}}
        for lines, words in [({}, 'Give "of"'), ({"of": "hil"}, 'did you mean "hill"?'),
                             ({"of": "hill", "every": 1, "at": [2]}, '"every" gives the values already'),
                             ({"of": "hill", "at": ["a"]}, "expected numbers")]:
            self.scene({**hill, "lines": {"isolines": lines}})
            self.bad_scene(words, *SHORT)
        self.scene({**hill, "lines": {"isolines": {"of": "hill", "every": 1e-4}}})
        self.bad(2, 'raise "every"', *SHORT)
        self.scene({"hill": {"reaction": {**DISH, "display": {"layer": "none"}}}, "lines": {"isolines": {"of": "hill.u"}}})
        self.bad_scene("shows no field over the picture", *SHORT)

    def bar(self, bar, more=None, size=(400, 200), **scene):
        """Returns the first column of a bar, and the column after its last one."""
        self.scene({**(more or {}), "bar": {"scaleBar": {"corner": [0.05, 0.9, 0], "height": 0.1, "backdrop": 0, "color": [1, 0, 0], **bar}}}, size, **scene)
        pixels = self.good("render", "a.json", "-o", "-", "--frames", "0", "-q").stdout
        row = [pixels[4 * (size[0] * 178 + x):][:2] for x in range(size[0])]
        red = [x for x, (r, g) in enumerate(row) if r > 200 and g < 60]
        return red[0], red[-1] + 1

    def test_a_scale_bar_is_as_long_as_its_number_says(self):
        flat = {"projection": "orthographic", "height": 4, "position": [0, 0, 5], "target": [0, 0, 0]}
        # The picture shows 4 m in 200 pixels. The bar may cover at most 0.25 of 400 pixels, which is 2 m.
        self.assertEqual(self.bar({}, camera=flat), (20, 120))
        self.assertEqual(self.bar({"length": 3}, camera=flat), (20, 170))
        # The visible height of 2 * 5 m * tan(20 degrees) has 200 pixels.
        deep = {"fieldOfView": 40, "position": [0, 0, 5], "target": [0, 0, 0]}
        first, last = self.bar({"length": 1}, camera=deep)
        self.assertAlmostEqual(last - first, 200 / (10 * math.tan(math.radians(20))), delta=1)
        # In this field, a cell has 5 pixels, and 20 cells have 100 pixels.
        dish = {"dish": {"reaction": {"size": [80, 40], "steps": 0, "species": {"u": {"start": "0"}}, "display": {"stops": [{"color": "black"}, {"color": "black"}]}}}}
        self.assertEqual(self.bar({"of": "dish"}, dish), (20, 120))
        self.assertEqual(self.bar({"of": "dish", "cell": 0.05, "length": 1.5}, dish), (20, 170))

    def test_mistakes_of_scale_bars(self):
        self.scene({"bar": {"scaleBar": {"unit": "km"}}})
        self.bad_scene('needs "of"', *SHORT)
        self.scene({"ball": {"sphere": {}}, "bar": {"scaleBar": {}}}, camera={"track": {"object": "ball"}})
        self.bad(2, "take an orthographic camera", *SHORT)


if __name__ == "__main__":
    main()
