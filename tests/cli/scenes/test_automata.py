"""Compares automata of every family with Golly's bgolly, and tests --rule. tools/bench/automata is the long
comparison."""
import pathlib
import shutil
import unittest

import golly
from common import PROGRAM, Case, main

GLIDER = "x = 3, y = 3\nbo$2bo$3o!\n"


@unittest.skipUnless(golly.GOLLY, "bgolly is not installed (Debian package golly; tools/setup installs it)")
class Families(Case):
    def hold(self, cases, generations):
        results = golly.compare(self.folder, str(pathlib.Path(PROGRAM).resolve()), cases, generations)
        for name, problem, _ in results:
            with self.subTest(case=name):
                self.assertEqual(problem, "")
        self.assertTrue(any(living for _, _, living in results))

    def test_random_cells_of_every_family_equal_golly(self):
        for family in golly.FAMILIES + (golly.NEWER if golly.version() >= (4, 0) else []):
            if not family.startswith("far"):  # The far families read thousands of cells around each cell.
                self.hold(golly.soups(family, 4, 1), 40)
        far = [case for case in golly.soups("farthest", 20, 1) if max(case["size"]) < 320]
        self.hold(far[:4], 3)

    def test_long_lived_rules_equal_golly(self):
        """Soups that still change after 60 generations."""
        self.hold([{"size": size, "rule": rule, "fill": fill, "border": border}
                   for rule, fill in (("B2-a/S12", 0.3), ("B3/S2-i34q", 0.3), ("B2/S34H", 0.3), ("B13/S012V", 0.3), ("/2/3", 0.3),
                                      ("345/2/4", 0.4), ("2-a/3n/8", 0.3), ("2/13/21", 0.3), ("R5,C0,M1,S34..58,B34..45,NM", 0.5),
                                      ("R3,C0,M0,S8..13,B9..11,NC", 0.4), ("R2,C4,M0,S3..5,B3..4,NN", 0.4))
                   for size, border in (([61, 45], "torus"), ([33, 70], "dead"))], 60)

    def test_all_borders_equal_golly(self):
        self.hold([{"size": size, "rule": rule, "fill": 0.3, "border": border, "shift": shift}
                   for rule in ("B3/S23", "345/2/4")
                   for border, size, shift in (("klein", [31, 20], [0, 0]), ("klein", [30, 21], [1, 0]),
                                               ("kleinSideways", [31, 20], [0, 0]), ("kleinSideways", [31, 20], [0, 1]),
                                               ("crossSurface", [31, 20], [0, 0]), ("sphere", [27, 27], [0, 0]),
                                               ("torus", [31, 20], [5, 0]), ("torus", [31, 20], [0, -7]))], 60)

    def test_rule_files_equal_golly(self):
        """A table with bound variables, and one whose walls turn a torus into a cylinder, which Golly does not have."""
        self.write("Signal.rule", "@RULE Signal\n@TABLE\nn_states:5\nneighborhood:vonNeumann\nsymmetries:rotate4reflect\n"
                   "var a={0,1,2,3,4}\nvar b={1,2}\nvar c={0,3,4}\nvar d={a}\nvar e={a}\nvar f={a}\n"
                   "0,b,c,a,d,b\n1,2,a,d,e,3\n2,a,b,d,b,4\n3,b,a,d,e,b\n4,a,d,e,f,0\n3,a,d,e,f,1\n")
        self.write("WalledLife.rule", golly.WALLED_LIFE)
        cases = [{"size": [47, 32], "ruleFile": "Signal.rule", "fill": 0.3, "border": b} for b in ("torus", "dead", "klein")]
        self.hold(cases, 60)

    def test_a_cylinder_equals_a_walled_torus_of_golly(self):
        self.write("WalledLife.rule", golly.WALLED_LIFE)
        width, height = 40, 27
        life = {"size": [width, height], "rule": "B3/S23", "border": "cylinder", "fill": 0.4, "stepsPerSecond": 80}
        self.write("s.json", {"version": 1, "seed": 7, "render": {"size": [64, 36], "samples": 1},
                              "time": {"fps": 10, "duration": 1.1}, "objects": {"cells": {"life": life}}})
        self.good("bake", "s.json", "-o", "out", "--frames", "0,10", "--format", "rle")
        start, end = (golly.read_rle((self.folder / f"out/cells_{f:06}.rle").read_text(encoding="ascii")) for f in (0, 10))
        self.assertEqual(start[2], "B3/S23")  # The notation of the border is removed, because Golly has no such grid.
        rows = ["".join(".A"[start[3].get((x, y), 0)] for x in range(width)) for y in range(height)]
        self.write("w.rle", f"x = {width}, y = {height + 1}, rule = WalledLife:T{width},{height + 1}\n"
                   + "$\n".join([*rows, "B" * width]) + "!\n")
        last = golly.run_golly(self.folder, "w.rle", 80, self.folder)
        wall = next(y for (_, y), s in last.items() if s == 2)
        left = min(x for (x, _), s in last.items() if s == 2)
        self.assertEqual({(x - left, (y - wall + height) % (height + 1)): s for (x, y), s in last.items() if s == 1}, end[3])
        self.assertGreater(len(end[3]), 5)


class Shapes(Case):
    """Neighbourhoods unknown to Golly 3, by their definition: True if a cell at offset (dx, dy) counts in range r."""
    DRAWN = {"2": lambda dx, dy, r: dx * dx + dy * dy <= r * r, "+": lambda dx, dy, r: dx * dy == 0,
             "X": lambda dx, dy, r: abs(dx) == abs(dy), "*": lambda dx, dy, r: dx * dy == 0 or abs(dx) == abs(dy),
             "#": lambda dx, dy, r: abs(dx) == 1 or abs(dy) == 1, "B": lambda dx, dy, r: (dx + dy) % 2 == 1,
             "D": lambda dx, dy, r: (dx + dy) % 2 == 0, "H": lambda dx, dy, r: abs(dx - dy) <= r,
             "A": lambda dx, dy, r: dx * dy == 0 or dx == dy, "3": lambda dx, dy, r: dx == 0 > dy or dy == 0 > dx or dx == dy > 0}

    def test_neighbourhoods_have_the_drawn_shapes(self):
        width, height, steps = 23, 17, 4
        cases = [(f"R{r},C{states},S2-4,6,B3-5,N{letter}", states, r, drawn) for letter, drawn in self.DRAWN.items()
                 for r, states in ((2, 2), (3, 4))]
        objects = {f"c{i}": {"life": {"size": [width, height], "rule": rule, "fill": 0.4, "stepsPerSecond": 10 * steps}}
                   for i, (rule, *_) in enumerate(cases)}
        self.write("s.json", {"version": 1, "seed": 7, "render": {"size": [64, 36], "samples": 1},
                              "time": {"fps": 10, "duration": 0.2}, "objects": objects})
        self.good("bake", "s.json", "-o", "out", "--frames", "0,1", "--format", "rle")
        for i, (rule, states, r, drawn) in enumerate(cases):
            (_, _, said, cells), (*_, last) = (golly.read_rle((self.folder / f"out/c{i}_{f:06}.rle").read_text(encoding="ascii"))
                                               for f in (0, 1))
            around = [(dx, dy) for dx in range(-r, r + 1) for dy in range(-r, r + 1) if (dx, dy) != (0, 0) and drawn(dx, dy, r)]
            for _ in range(steps):
                new = {}
                for x in range(width):
                    for y in range(height):
                        state = cells.get((x, y), 0)
                        count = sum(cells.get(((x + dx) % width, (y + dy) % height)) == 1 for dx, dy in around)
                        if state == 0:
                            new[x, y] = int(3 <= count <= 5)
                        else:
                            new[x, y] = 1 if state == 1 and count in (2, 3, 4, 6) else (state + 1) % states
                cells = {at: state for at, state in new.items() if state}
            with self.subTest(rule=rule):
                self.assertEqual(said.split(":")[0], rule.replace("C2", "C0"))
                self.assertEqual(cells, last)


class Rule(Case):
    def test_the_rule_option_replaces_the_rule_of_a_pattern(self):
        self.write("g.rle", GLIDER)
        self.good("render", "g.rle", "--rule", "B2-a/S12", "-o", "out", "--frames", "0,30", "--size", "64x36")
        self.assertEqual(len(list((self.folder / "out").glob("*.png"))), 2)
        self.good("render", "g.rle", "--rule", "/2/3", "-o", "brain", "--frames", "5", "--size", "64x36")
        self.good("render", "g.rle", "--rule", "Brian's Brain", "-o", "named", "--frames", "5", "--size", "64x36")
        first, second = (next((self.folder / f).glob("*.png")).read_bytes() for f in ("brain", "named"))
        self.assertEqual(len(first), len(second))
        self.assertNotEqual(first, next((self.folder / "out").glob("*30.png")).read_bytes())
        if shutil.which("ffmpeg"):
            self.good("render", "g.rle", "--rule", "B36/S23", "-o", "out.mp4", "--frames", "0-9", "--size", "64x36")

    def test_mistakes(self):
        self.write("g.rle", GLIDER)
        render = ("render", "g.rle", "-o", "out", "--rule")
        self.bad(2, ["--rule \"B39/S23\", character 3: a cell has 8 neighbours, not 9"], *render, "B39/S23")
        self.bad(2, ["--rule \"B2z/S\", character 3: there is no arrangement z of 2 neighbours"], *render, "B2z/S")
        self.bad(2, ["this rule is unknown"], *render, "Nonsense")
        self.bad(2, ["--rule needs a file of cells"], "render", "scene.json", "-o", "out", "--rule", "B3/S23")
        self.write("m.rle", "x = 2, y = 1, rule = /2/3\nAC!\n")
        self.bad(2, ["m.rle:2:2: a cell of state 3, but the rule /2/3 has the states 0 to 2"], "render", "m.rle", "-o", "out")
        self.write("n.rle", "x = 2, y = 1, rule = Unheard\nAC!\n")
        self.bad(2, ["n.rle:1:22: the rule Unheard is no notation and there is no file Unheard.rule"], "render", "n.rle", "-o", "out")
        self.write("Unheard.rule", "@RULE Unheard\n@TABLE\nn_states:4\nneighborhood:Moore\nsymmetries:permute\n0,1,2\n")
        self.bad(2, ["Unheard.rule:6:6: a transition has 10 states here"], "render", "n.rle", "-o", "out")
        self.write("c.mc", "[M2] (golly 3.3)\n#R B3/S23\n.*$*\n4 1 2 0 0\n")
        self.bad(2, ["c.mc:4:5: square 2 does not come before this one"], "render", "c.mc", "-o", "out")
        self.assertFalse((self.folder / "out").exists())

    def test_the_list_names_rules(self):
        listed = self.good("list", "life").stdout.decode()
        for name in ("Brian's Brain", "Bosco", "Cyclic", "R5,C0,M1,S34..58,B34..45,NM"):
            self.assertIn(name, listed)


if __name__ == "__main__":
    main()
