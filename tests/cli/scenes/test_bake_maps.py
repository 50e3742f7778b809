"""Tests `simreel bake --format maps` through the command line, and skins in scenes."""
import struct

from common import Case, main, png_rows, unfiltered, with_values

MAPS = ("albedo", "height", "normal", "occlusion", "roughness")
SIDE = 64
GRAY_SCOTT = {"size": [SIDE, SIDE], "preset": "maze", "presteps": 1500, "steps": 8, "seeds": {"count": 12, "radius": 3},
              "display": {"layer": "none"}}
SKINNED = {
    "version": 1,
    "time": {"fps": 30, "duration": 0.1},
    "render": {"size": [48, 32], "samples": 1},
    "objects": {
        "hide": {"grayScott": GRAY_SCOTT},
        "ball": {"sphere": {"radius": 1}, "material": {"skin": {"field": "hide", "look": "leather"}}},
    },
}


def read_map(data):
    """Returns (width, height, rows of tuples) of an 8-bit RGB or a 16-bit grey PNG."""
    width, height, rows = png_rows(data)
    depth, kind = data[24], data[25]
    if (depth, kind) == (16, 0):
        lines = unfiltered(rows, 2 * width, 2)
        return width, height, [[(v,) for v in struct.unpack(f">{width}H", line)] for line in lines]
    assert (depth, kind) == (8, 2), (depth, kind)
    lines = unfiltered(rows, 3 * width, 3)
    return width, height, [[tuple(line[i:i + 3]) for i in range(0, 3 * width, 3)] for line in lines]


def apart(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


class BakeMaps(Case):
    def setUp(self):
        super().setUp()
        self.write("scene.json", SKINNED)

    def read(self, name):
        return read_map((self.folder / name).read_bytes())

    def test_a_skin_is_baked_to_maps(self):
        self.good("bake", "scene.json", "-o", "out", "--format", "maps")
        self.assertEqual(sorted(self.content("out")), [f"ball_000002_{name}.png" for name in MAPS])
        for name in MAPS:
            data = (self.folder / f"out/ball_000002_{name}.png").read_bytes()
            self.assertEqual(read_map(data)[:2], (SIDE, SIDE))
            self.assertIn(b"simreel:object\0ball", data)
        colours = {c for row in self.read("out/ball_000002_albedo.png")[2] for c in row}
        self.assertIn((149, 108, 63), colours)  # the colour (0.3, 0.15, 0.05) in sRGB
        self.assertIn((89, 63, 39), colours)    # the colour (0.1, 0.05, 0.02) in sRGB
        normals = [n for row in self.read("out/ball_000002_normal.png")[2] for n in row]
        for x, y, z in normals:
            length = sum((c / 127.5 - 1) ** 2 for c in (x, y, z)) ** 0.5
            self.assertAlmostEqual(length, 1, delta=0.02)
            self.assertGreater(z, 127)
        self.assertGreater(max(n[0] for n in normals), 160)
        self.assertEqual({c for row in self.read("out/ball_000002_roughness.png")[2] for c in row}, {(179, 179, 179)})
        heights = {h for row in self.read("out/ball_000002_height.png")[2] for (h,) in row}
        self.assertGreater(len(heights), 600)  # There are more different heights than 8 bits can represent.

    def test_normals_follow_the_heights_with_y_up(self):
        self.good("bake", "scene.json", "-o", "out", "--format", "maps")
        heights = self.read("out/ball_000002_height.png")[2]
        normals = self.read("out/ball_000002_normal.png")[2]
        agree = {0: 0, 1: 0}
        count = {0: 0, 1: 0}
        for y in range(SIDE):
            for x in range(SIDE):
                rise_right = heights[y][(x + 1) % SIDE][0] - heights[y][x - 1][0]
                rise_up = heights[y - 1][x][0] - heights[(y + 1) % SIDE][x][0]
                for axis, rise in ((0, rise_right), (1, rise_up)):
                    if abs(rise) > 3000:  # The slope is steep enough to compare its sign.
                        count[axis] += 1
                        agree[axis] += (normals[y][x][axis] < 127.5) == (rise > 0)
        for axis in (0, 1):
            self.assertGreater(count[axis], 200)
            self.assertEqual(agree[axis], count[axis])

    def test_maps_tile(self):
        """Differences across the tile border, by maximum and 99th percentile, are like those between inner lines; with
        one, several and fewer than one texel per cell."""
        for width, height in ((SIDE, SIDE), (201, 167), (45, 38)):
            self.good("bake", "scene.json", "-o", "out", "--format", "maps", "--overwrite", "--size",
                      f"{width}x{height}")
            for name in MAPS:
                found, rows_found, rows = self.read(f"out/ball_000002_{name}.png")
                self.assertEqual((found, rows_found), (width, height))
                across = [sorted(apart(row[x - 1], row[x]) for row in rows) for x in range(width)]
                down = [sorted(apart(a, b) for a, b in zip(rows[y - 1], rows[y])) for y in range(height)]
                for lines in (across, down):  # The first line is at the border of the tile.
                    for rank in (-1, len(lines[0]) * 99 // 100):
                        # The maximum may occur at the border by chance, so there is a tolerance of 5 %.
                        self.assertLessEqual(lines[0][rank], 1.05 * max(line[rank] for line in lines[1:]) + 1, name)

    def test_a_field_with_a_look(self):
        self.good("bake", "scene.json", "-o", "out", "--format", "maps", "--look", "cracks", "--frames", "0,2")
        names = sorted(MAPS + ("emission",))
        self.assertEqual(sorted(self.content("out")),
                         [f"hide_{frame:06}_{name}.png" for frame in (0, 2) for name in names])

    def test_existing_files_are_kept(self):
        self.write("out/ball_000002_normal.png", "mine")
        self.bad(6, ["out/ball_000002_normal.png", "--overwrite"],
                 "bake", "scene.json", "-o", "out", "--format", "maps")
        self.assertEqual(self.content("out"), {"ball_000002_normal.png": b"mine"})
        self.good("bake", "scene.json", "-o", "out", "--format", "maps", "--overwrite")
        self.assertEqual(len(self.content("out")), 5)

    def test_two_bakes_are_equal(self):
        self.good("bake", "scene.json", "-o", "a", "--format", "maps")
        self.good("bake", "scene.json", "-o", "b", "--format", "maps")
        self.assertEqual(self.content("a"), self.content("b"))

    def test_mistakes(self):
        maps = ("bake", "scene.json", "-o", "out", "--format", "maps")
        self.bad(2, ["bal", "did you mean \"ball\"?"], *maps, "--object", "bal")
        self.bad(2, ["lether", "did you mean \"leather\"?"], *maps, "--look", "lether")
        self.bad(2, ["\"ball\" is no field", "hide"], *maps, "--look", "leather", "--object", "ball")
        self.bad(2, ["at most 8192x8192"], *maps, "--size", "9000x16")
        self.bad(2, ["--format"], "bake", "scene.json", "-o", "out", "--format", "mapz")
        self.bad(2, ["--look", "maps"], "bake", "scene.json", "-o", "out", "--look", "leather")
        self.write("scene.json", with_values({}))
        self.bad(2, ["no material of the scene has a skin"], *maps)
        self.bad(2, ["the scene has no field"], *maps, "--look", "leather")
        self.assertFalse((self.folder / "out").exists())


class SkinsInScenes(Case):
    def check(self, skin, words, extra=None):
        scene = with_values({"objects.ball.material.skin": skin, **(extra or {})}, SKINNED)
        self.write("scene.json", scene)
        self.bad_scene(words, "render", "scene.json", "-o", "out/")

    def test_fields_are_checked(self):
        self.write("scene.json", SKINNED)
        self.good("validate", "scene.json")
        self.check({"field": "hid"}, ["no object is named \"hid\"", "did you mean \"hide\"?"])
        self.check({"field": "ball"}, ["object \"ball\" is a sphere, not a field", "hide"])
        self.check({"look": "leather"}, ["it has no \"field\"", "hide"])
        self.check({"field": 3}, ["field"])
        self.check({"field": "hide", "look": "lether"}, ["did you mean \"leather\"?"])
        self.check({"field": "hide", "repeats": 0}, ["repeats"])
        self.check({"field": "hide", "roughness": 2}, ["roughness"])
        self.write("scene.json", with_values({"objects.flag.material": {"skin": {"field": "flag"}}}))
        self.bad_scene(["object \"flag\" is a cloth, not a field", "the scene has no field"],
                       "render", "scene.json", "-o", "out/")

    def test_an_error_has_its_position(self):
        self.write("scene.json", '{"version": 1, "objects": {\n"hide": {"grayScott": {}},\n'
                                 '"ball": {"sphere": {}, "material": {"skin":\n  {"field": "hude"}}}}}')
        done = self.bad_scene([], "render", "scene.json", "-o", "out/")
        self.assertIn("scene.json:4:13: error: no object is named \"hude\"", done.err)
        self.write("scene.json", SKINNED)
        done = self.bad_scene([], "render", "scene.json", "-o", "out/", "-D", "objects.ball.material.skin.field=hude")
        self.assertIn("hude", done.err)

    def test_a_skin_is_drawn(self):
        self.write("scene.json", SKINNED)
        self.good("render", "scene.json", "-o", "skin.png", "--frames", "0")
        self.good("render", "scene.json", "-o", "other.png", "--frames", "0",
                  "-D", "objects.ball.material.skin.look=cracks")
        self.assertNotEqual((self.folder / "skin.png").read_bytes(), (self.folder / "other.png").read_bytes())


if __name__ == "__main__":
    main()
