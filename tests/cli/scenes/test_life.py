"""Tests automata through the command line: RLE input and output, compared with Golly's bgolly (Debian package
golly)."""
import shutil
import subprocess
import unittest

import golly
from common import PATIENCE, SOURCE, Case, main


def read_rle(text):
    """Returns (width, height, rule, set of living cells) of a two-state RLE file."""
    *said, cells = golly.read_rle(text)
    return *said, set(cells)


def scene(size, generations, **life):
    """Frame 0 is the start and frame 10 is `generations` later."""
    return {"version": 1, "seed": 4, "render": {"size": [64, 36], "samples": 1},
            "time": {"fps": 10, "duration": 1.1},
            "objects": {"cells": {"life": {"size": size, "stepsPerSecond": generations, **life}}}}


def with_object(**life):
    """Returns a scene without a size of the grid."""
    values = scene([1, 1], 10)
    values["objects"]["cells"]["life"] = life
    return values


@unittest.skipUnless(golly.GOLLY, "bgolly is not installed (Debian package golly; tools/setup installs it)")
class Golly(Case):
    def run_golly(self, file, generations):
        subprocess.run([golly.GOLLY, "-q", "-q", "-h", "-m", str(generations), "-i", "1", "-o", "golly.mc", file],
                       cwd=self.folder, stdout=subprocess.DEVNULL, check=True, timeout=PATIENCE)
        return set(golly.read_macrocell((self.folder / "golly.mc").read_text(encoding="ascii")))

    def compare(self, size, rule, generations):
        self.write("s.json", scene(size, generations, rule=rule, fill=0.3))
        self.good("bake", "s.json", "-o", "out", "--frames", "0,10", "--format", "rle", "--overwrite")
        texts = [(self.folder / f"out/cells_{frame:06}.rle").read_text(encoding="ascii") for frame in (0, 10)]
        start, end = (read_rle(text) for text in texts)
        self.assertEqual(start[:3], (*size, f"{rule}:T{size[0]},{size[1]}"))
        self.assertLessEqual(max(map(len, texts[1].splitlines())), 70)
        # The first generation gives the offset of Golly's grid. Later generations use the same offset.
        first = self.run_golly("out/cells_000000.rle", 0)
        left, top = (min(c[i] for c in first) - min(c[i] for c in start[3]) for i in (0, 1))
        self.assertEqual({(x - left, y - top) for x, y in first}, start[3])
        last = self.run_golly("out/cells_000000.rle", generations)
        self.assertEqual({(x - left, y - top) for x, y in last}, end[3])
        self.assertNotEqual(end[3], start[3])
        return len(end[3])

    def test_same_cells_after_1000_generations(self):
        for rule in ("B3/S23", "B36/S23", "B3678/S34678", "B2/S"):
            for size in ([257, 130], [61, 45]):
                with self.subTest(rule=rule, size=size):
                    self.compare(size, rule, 1000)

    def test_patterns_in_every_format_as_golly_reads_them(self):
        gun = sorted(read_rle((SOURCE / "assets/patterns/gosper_gun.rle").read_text(encoding="ascii"))[3])
        rows = ["".join("O" if (x, y) in gun else "." for x in range(36)) for y in range(9)]
        runs = "$\n".join(row.rstrip(".").replace("O", "o").replace(".", "b") for row in rows)
        files = {
            "gun.cells": "!Name: Gun\n!\n" + "\n".join(row.rstrip(".") for row in rows) + "\n",
            "six.lif": "#Life 1.06\n" + "".join(f"{x - 18} {y - 4}\n" for x, y in gun),
            "five.lif": "#Life 1.05\n#N\n#P -18 -4\n" + "\n".join(row.replace("O", "*") for row in rows) + "\n",
            "bare.rle": runs + "!\n",
            "open.rle": "x = 36, y = 9, rule = b3s23\n" + runs + "\n",
            "swapped.rle": "x = 36, y = 9, rule = S23/B36\n" + runs + "!\n",
            "capital.rle": "x = 36, y = 9, rule = 23/3\n" + runs.replace("b", ".").replace("o", "A") + "!\n",
        }

        def put(cells):
            left, top = (min(c[i] for c in cells) for i in (0, 1))
            return {(x - left, y - top) for x, y in cells}
        for name, text in files.items():
            with self.subTest(file=name):
                self.write(name, text)
                self.write("s.json", scene([400, 300], 90, patterns=[{"file": name}], border="dead"))
                self.good("bake", "s.json", "-o", "out", "--frames", "0,10", "--overwrite")
                for frame, generations in ((0, 0), (10, 90)):
                    ours = read_rle((self.folder / f"out/cells_{frame:06}.rle").read_text(encoding="ascii"))
                    self.assertEqual(ours[2], ("B36" if "swapped" in name else "B3") + "/S23:P400,300")
                    # bgolly reads the file with a header instead, because it requires a header.
                    theirs = self.run_golly("gun.cells" if name == "bare.rle" else name, generations)
                    self.assertEqual(put(ours[3]), put(theirs))

    def test_a_bounded_grid_of_a_file(self):
        """Dead borders reveal the pattern's position in the grid."""
        for border, rule in (("P", "P31,20"), ("T", "T40,33")):
            self.write("g.rle", f"x = 3, y = 3, rule = B3/S23:{rule}\nbo$2bo$3o!\n")
            self.write("s.json", with_object(patterns=[{"file": "g.rle"}], stepsPerSecond=70))
            self.good("bake", "s.json", "-o", "out", "--frames", "0,10", "--overwrite")
            start, end = (read_rle((self.folder / f"out/cells_{frame:06}.rle").read_text(encoding="ascii"))
                          for frame in (0, 10))
            self.assertEqual(start[2], f"B3/S23:{rule}")
            first, last = self.run_golly("g.rle", 0), self.run_golly("g.rle", 70)
            left, top = (min(c[i] for c in first) - min(c[i] for c in start[3]) for i in (0, 1))
            self.assertEqual({(x - left, y - top) for x, y in last}, end[3], border)

    def test_several_generations_per_pass_equal_golly(self):
        self.compare([128, 67], "B3/S23", 1000)


class Life(Case):
    def test_written_patterns_are_read_back(self):
        self.write("s.json", scene([257, 130], 1000, fill=0.3))
        self.good("bake", "s.json", "-o", "out", "--frames", "0,10")
        shutil.copy(self.folder / "out/cells_000000.rle", self.folder / "start.rle")
        self.write("again.json", scene([257, 130], 1000, patterns=[{"file": "start.rle"}]))
        self.good("bake", "again.json", "-o", "again", "--frames", "0,10", "--memory-path", "storage")
        for frame in (0, 10):
            one, two = ((self.folder / f"{folder}/cells_{frame:06}.rle").read_text(encoding="ascii")
                        for folder in ("out", "again"))
            self.assertEqual(read_rle(one), read_rle(two))
        self.assertIn("#C object cells frame 10 time 1 s seed 4", one)

    def test_a_loop_that_the_driver_ends_is_an_error(self):
        """Many generations in one dispatch need many loop iterations; the test doubles them with iterations that do
        nothing."""
        shutil.copytree(SOURCE / "glsl", self.folder / "glsl")
        own = (SOURCE / "glsl/life/active.comp").read_text(encoding="utf-8")
        place = "  int reached = 0;\n"
        self.assertEqual(own.count(place), 1)
        more = "  for (int i = 0; i < 1000 * passes; ++i) if (cellsAt(i & 1) == 7u + uint(i)) list[0] = 1u;\n"
        self.write("glsl/life/active.comp", own.replace(place, more + place))
        self.write("s.json", scene([256, 64], 20000, fill=0.3, rule="B2/S"))
        bake = ("bake", "s.json", "-o", "out", "--frames", "10", "--memory-path", "texel", "--overwrite")
        self.good(*bake)
        right = (self.folder / "out/cells_000010.rle").read_bytes()
        env = {"SIMREEL_GLSL": str(self.folder / "glsl")}
        if "end silently" in self.good("doctor", env=env).stdout.decode():
            self.bad(4, ['life "cells"', "ended a loop too early", "--memory-path storage"], *bake, env=env)
        else:
            self.good(*bake, env=env)
        self.assertEqual((self.folder / "out/cells_000010.rle").read_bytes(), right)

    def test_the_rule_of_a_pattern_file_is_used(self):
        self.write("hi.rle", "x = 3, y = 3, rule = B36/S23\nbo$2bo$3o!")
        self.write("s.json", scene([33, 31], 10, patterns=[{"file": "hi.rle", "at": [3, 4]}], border="dead"))
        self.good("bake", "s.json", "-o", "out", "--frames", "0")
        self.assertEqual(read_rle((self.folder / "out/cells_000000.rle").read_text(encoding="ascii")),
                         (33, 31, "B36/S23:P33,31", {(4, 4), (5, 5), (3, 6), (4, 6), (5, 6)}))
        self.write("lo.rle", "x = 1, y = 1, rule = B3/S23\no!")
        two = [{"file": "hi.rle"}, {"file": "lo.rle"}]
        self.write("two.json", scene([33, 31], 10, patterns=two))
        self.bad(2, ["hi.rle is for the rule B36/S23", "lo.rle for B3/S23", "\"rule\""], "bake", "two.json", "-o", "two")
        self.write("two.json", scene([33, 31], 10, patterns=two, rule="B2/S"))
        self.good("bake", "two.json", "-o", "two", "--frames", "0")
        self.write("torus.rle", "x = 1, y = 1, rule = B3/S23:T32,31\no!")
        self.write("torus.json", scene([33, 31], 10, patterns=[{"file": "torus.rle"}]))
        self.bad(2, ["torus.rle is for a grid of 32 x 31", "33 x 31"], "bake", "torus.json", "-o", "torus")

    def bright(self, name, width, height, *more):
        """Returns the pixels of frame 0 with bright green."""
        data = self.good("render", name, "-o", "-", "--frames", "0", "--size", f"{width}x{height}", *more).stdout
        self.assertEqual(len(data), 4 * width * height)
        return [(i % width, i // width) for i in range(width * height) if data[4 * i + 1] > 150]

    def test_the_smallest_scene_shows_its_pattern(self):
        shutil.copy(SOURCE / "assets/patterns/gosper_gun.rle", self.folder)
        self.write("s.json", {"version": 1, "objects": {"c": {"life": {"patterns": [{"file": "gosper_gun.rle"}]}}}})
        pixels = self.bright("s.json", 320, 180)
        # The 36 cells of the gun have 4 x 4 pixels each. The grid has 80 x 45 cells.
        self.assertEqual(len(pixels), 36 * 16)
        for axis, (least, most) in enumerate(((88, 231), (72, 107))):
            self.assertEqual((min(p[axis] for p in pixels), max(p[axis] for p in pixels)), (least, most))
        # A picture with another aspect ratio shows the whole grid.
        self.assertEqual(len(self.bright("s.json", 160, 160)), 36 * 4)
        listed = self.good("list", "life").stdout.decode()
        self.assertIn("[default [512,512], or fits the patterns;", " ".join(listed.split()))
        self.assertRegex(" ".join(listed.split()), r"patterns\[\]\.at [^\[]*\[default the middle")

    def test_a_pattern_is_a_scene(self):
        for name, text in (("g.rle", "bo$2bo$3o!"), ("g.CELLS", "!\n.O\n..O\nOOO\n"),
                           ("g.life", "#Life 1.06\n0 -1\n1 0\n-1 1\n0 1\n1 1\n")):
            with self.subTest(file=name):
                self.write(name, text)
                self.good("validate", name)
                # The picture shows 48 x 27 cells of 4 x 4 pixels each.
                self.assertEqual(len(self.bright(name, 192, 108, "-D", "render.bloom.strength=0")), 5 * 16)
        self.bad(2, ["unknown key \"trial\"", "\"trail\""], "validate", "g.rle", "-D", "objects.cells.life.trial=0")
        self.good("bake", "g.rle", "-o", "cells", "--frames", "0")
        self.assertEqual(read_rle((self.folder / "cells/cells_000000.rle").read_text(encoding="ascii"))[:3],
                         (48, 27, "B3/S23:P48,27"))
        self.write("h.rle", "x = 3, y = 3, rule = B2-z/S12\n3o!")
        self.bad(2, ["h.rle:1:25", "there is no arrangement z of 2 neighbours"], "validate", "h.rle")
        self.bad(2, ["h.rle:1:25", "there is no arrangement z of 2 neighbours"], "render", "h.rle", "-o", "h.png")
        self.bad(2, ["2 of 2 scenes"], "validate", "h.rle", "none.rle")

    def test_mistakes(self):
        self.write("s.json", scene([33, 31], 10, rule="B39/S23"))
        self.bad_scene(["s.json:", "character 3 of the rule", "8 neighbours, not 9"], "bake", "s.json", "-o", "out")
        self.write("s.json", scene([33, 0], 10))
        self.bad_scene("s.json:", "bake", "s.json", "-o", "out")
        self.write("s.json", scene([33, 31], 10, patterns=[{"file": "none.rle"}]))
        self.bad_scene("none.rle", "bake", "s.json", "-o", "out")
        self.write("s.json", scene([33, 31], 10, patterns=[{"at": [1, 2]}]))
        self.bad_scene("needs \"file\"", "bake", "s.json", "-o", "out")
        self.write("p.rle", "x = 3, y = 1\n2oA!")
        self.write("s.json", scene([33, 31], 10, patterns=[{"file": "p.rle"}]))
        self.good("bake", "s.json", "-o", "two", "--frames", "0")  # In the pattern, the letter A is state 1, which is a
                                                                   # living cell.
        self.write("p.rle", "x = 3, y = 1\n2oB!")
        self.bad(2, ["p.rle:2:3", "a cell of state 2, but the rule B3/S23 has the states 0 to 1"], "bake", "s.json", "-o", "out")
        self.write("s.json", scene([33, 31], 10, patterns=[{"file": "p.rle", "rotate": 45}]))
        self.bad_scene("0, 90, 180 or 270", "bake", "s.json", "-o", "out")
        self.write("p.rle", "x = 3, y = 1\n3o!")
        self.write("s.json", scene([33, 31], 10, border="dead", patterns=[{"file": "p.rle", "at": [31, 0]}]))
        self.bad(2, ["p.rle", "[33, 0]", "outside the grid of 33 x 31", "torus"], "bake", "s.json", "-o", "out")
        self.write("s.json", scene([1048576, 1048576], 10))
        self.bad(4, ["1048576 x 1048576", "GL_MAX_SHADER_STORAGE_BLOCK_SIZE"], "bake", "s.json", "-o", "out")
        self.write("s.json", scene([33, 31], 10))
        self.bad(2, "no object of the scene has points", "bake", "s.json", "-o", "out", "--format", "ply")
        self.bad(2, "no object of the scene has cells", "bake", "scene.json", "-o", "out", "--format", "rle")
        self.assertFalse((self.folder / "out").exists())

    def test_every_shipped_pattern_is_read(self):
        files = sorted((SOURCE / "assets/patterns").glob("*.rle"))
        # The rule file of the pattern is in the same folder.
        self.good("validate", SOURCE / "assets/patterns/parity.rle")
        files = [file for file in files if "WireWorld" not in file.read_text(encoding="ascii")]
        self.assertGreater(len(files), 4)
        patterns = [{"file": f"patterns/{file.name}", "at": [5, 45 * i]} for i, file in enumerate(files)]
        self.write("s.json", scene([128, 45 * len(files)], 10, patterns=patterns))
        self.good("bake", "s.json", "-o", "out", "--frames", "0", env={"SIMREEL_ASSETS": str(SOURCE / "assets")})
        cells = read_rle((self.folder / "out/cells_000000.rle").read_text(encoding="ascii"))[3]
        for i, file in enumerate(files):
            self.assertEqual({(x - 5, y - 45 * i) for x, y in cells if 45 * i <= y < 45 * (i + 1)},
                             read_rle(file.read_text(encoding="ascii"))[3])


if __name__ == "__main__":
    main()
