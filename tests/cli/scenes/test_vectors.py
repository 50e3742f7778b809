"""Checks pictures of velocities: flows of files and formulas, arrows, streamlines, and trails of particles."""
import ast
import math
import re
import struct

from common import Case, main

SMALL = {"size": [96, 54], "samples": 1, "quality": "draft"}
SHORT = ("render", "a.json", "-o", "x.png", "--frames", "0", "-q")


def read_npy(data):
    length, = struct.unpack("<H", data[8:10])
    rows, columns = ast.literal_eval(data[10:10 + length].decode())["shape"]
    values = struct.unpack(f"<{rows * columns}f", data[10 + length:])
    return [values[i * columns:(i + 1) * columns] for i in range(rows)]


def write_npy(shape, values):
    header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + struct.pack(f"<{len(values)}f", *values)


class Vectors(Case):
    def scene(self, objects, **more):
        self.write("a.json", {"version": 2, "render": SMALL, "time": {"fps": 30, "duration": 1}, "objects": objects, **more})

    def baked(self, name, frame=0):
        self.good("bake", "a.json", "-o", "baked", "--format", "npy", "--object", name, "--frames", str(frame), "--overwrite", "-q")
        return read_npy((self.folder / f"baked/{name}_{frame:06}.npy").read_bytes())

    def test_arrows_point_along_a_rotation(self):
        self.scene({"w": {"flow": {"u": "-2 * y", "v": "2 * x", "size": [20, 10], "plane": {"cell": 0.1}}},
                    "a": {"arrows": {"of": "w", "spacing": 0.2, "height": 0, "high": 1.5, "low": 0.5}}})
        rows = self.baked("a")
        self.assertEqual(len(rows), 50)
        for x, y, z, dx, dy, dz, length in rows:
            speed = 2 * math.hypot(x, y)
            self.assertAlmostEqual(z, 0, 6)
            self.assertAlmostEqual(dx, -2 * y / speed, 5)
            self.assertAlmostEqual(dy, 2 * x / speed, 5)
            self.assertAlmostEqual(dz, 0, 6)
            # An arrow is as long as the spacing at the speed "high", and never longer.
            self.assertAlmostEqual(length, min(0.2, 0.2 * speed / 1.5), 5)
        # The positions of the arrows form a square grid around the middle.
        self.assertEqual({round(row[0], 4) for row in rows}, {round(0.2 * i - 0.9, 4) for i in range(10)})
        self.assertEqual({round(row[1], 4) for row in rows}, {round(0.2 * i - 0.4, 4) for i in range(5)})

    def test_arrows_of_particles_start_at_them(self):
        self.write("p.csv", "x,y,z,vx,vy,vz\n0,0,0,3,0,0\n1,0,0,0,0,9\n2,0,0,0,0,0\n3,0,0,0,0.6,0.8\n")
        dust = {"particles": {"groups": [{"file": "p.csv"}], "method": "none"}}
        self.scene({"dust": dust, "a": {"arrows": {"of": "dust", "length": 2, "high": 4}}})
        # An arrow starts at its particle, so its centre is half its length ahead. The speed 9 m/s is more than "high".
        # A particle at rest has no arrow.
        expected = [(0.75, 0, 0, 1, 0, 0, 1.5), (1, 0, 1, 0, 0, 1, 2), (3, 0.15, 0.2, 0, 0.6, 0.8, 0.5)]
        for row, wanted in zip(self.baked("a"), expected, strict=True):
            for value, right in zip(row, wanted):
                self.assertAlmostEqual(value, right, 5)
        self.scene({"dust": dust, "a": {"arrows": {"of": "dust", "length": 2, "high": 4, "every": 3, "anchor": "middle"}}})
        self.assertEqual([round(row[0], 5) for row in self.baked("a")], [0, 3])

    def high(self, objects):
        """Returns the speed `high` that a first run measures for the object "a", or None without a first run."""
        self.scene(objects)
        found = re.search(r"objects\.a\.\w+\.high=([0-9.e+-]+)", self.good(*SHORT[:-1], "--overwrite").err)
        return found and float(found[1])

    def test_the_range_of_speeds_is_that_of_the_run(self):
        self.write("p.csv", "x,y,z\n0,0,0\n1,0,0\n")
        fall = {"particles": {"groups": [{"file": "p.csv"}], "method": "none", "acceleration": [0, -3, 0]}}
        # Both particles fall from rest at 3 m/s^2 up to frame 29 of 30 frames per second.
        self.assertAlmostEqual(self.high({"dust": fall, "a": {"arrows": {"of": "dust", "length": 2}}}), 2.9, delta=0.01)
        smoke = {"fluid": {"size": [32, 18], "display": {"layer": "none"},
                           "strokes": [{"until": 9, "from": [16, 9, 0], "radius": 4, "velocity": [20, 0, 0]}]}}
        for kind in ("arrows", "streamlines"):
            high = self.high({"smoke": smoke, "a": {kind: {"of": "smoke", "sheet": True}}})
            self.assertGreater(high, 0.8)  # 20 cells/s are 1 m/s.
            self.assertLess(high, 2)
        self.assertIsNone(self.high({"w": {"flow": {"u": "y", "v": "-x"}}, "a": {"arrows": {"of": "w"}}}))

    def test_streamlines_of_a_rotation_are_circles(self):
        self.scene({"w": {"flow": {"u": "-y", "v": "x", "size": [40, 40], "plane": {"cell": 0.05, "rotation": [90, 0, 0]}}},
                    "a": {"streamlines": {"of": "w", "separation": 0.1, "length": 4, "height": 0}}})
        lines = {}
        for x, y, z, line, _ in self.baked("a"):
            self.assertAlmostEqual(y, 0, 5)
            lines.setdefault(line, []).append((x, z))
        self.assertGreater(len(lines), 8)
        stride, turns = 4 / 80, []
        for points in lines.values():
            radii = [math.hypot(*point) for point in points]
            # A step of the fourth-order method changes the radius r by less than r (h/r)^5 / 100, where h is the step
            # length in metres. Rounding adds 1e-6 per step.
            bound = sum(r * (stride / r) ** 5 / 100 + 1e-6 for r in radii)
            self.assertLess(max(radii) - min(radii), bound)
            turns.append(sum(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) for a, b in zip(points, points[1:])))
            for a, b in zip(points, points[1:]):
                self.assertAlmostEqual(math.dist(a, b), stride, delta=stride * (stride / min(radii)) ** 2 / 20)
        # Lines follow the flow, which turns from x to y (here from z to x). Closed lines end where they began.
        self.assertLess(max(map(abs, turns)), 2 * math.pi + 2 * stride / 0.1)
        self.assertEqual(len({turn > 0 for turn in turns}), 1)
        # No two lines may be closer than half the separation.
        names = list(lines)
        for i, one in enumerate(names):
            for other in names[i + 1:]:
                self.assertGreater(min(math.dist(a, b) for a in lines[one] for b in lines[other]), 0.05)

    def test_streamlines_of_a_saddle_are_hyperbolas(self):
        self.scene({"w": {"flow": {"u": "x", "v": "-y", "size": [40, 40], "plane": {"cell": 0.05}}},
                    "a": {"streamlines": {"of": "w", "separation": 0.1, "length": 2, "height": 0.25}}})
        lines = {}
        for x, y, z, line, color in self.baked("a"):
            self.assertAlmostEqual(z, 0.25, 5)
            # The scale ends at the speed in the centre of a corner cell, the greatest of all cells.
            self.assertAlmostEqual(color, min(1, math.hypot(x, y) / math.hypot(0.975, 0.975)), delta=0.03)
            lines.setdefault(line, []).append(x * y)
        self.assertGreater(len(lines), 20)
        for products in lines.values():
            self.assertLess(max(products) - min(products), 1e-4)
            self.assertGreaterEqual(len(products), 10)

    def test_seeds_move_streamlines_and_runs_repeat(self):
        flow = {"flow": {"u": "1 + y", "v": "sin(3 * x)"}}
        self.scene({"w": flow, "a": {"streamlines": {"of": "w"}}})
        first = self.baked("a")
        self.assertEqual(self.baked("a"), first)
        self.scene({"w": flow, "a": {"streamlines": {"of": "w", "seed": 7}}})
        self.assertNotEqual(self.baked("a"), first)

    def test_flows_of_files(self):
        # u = x and v = 2 y + 1 in metres per second, given at 3 x 2 points that are 0.5 m apart.
        points = [(x, y, x, 2 * y + 1) for y in (1, 0.5) for x in (0.5, 0, 1)]
        self.write("w.csv", "y,x,v,u\n" + "".join(f"{y},{x},{v},{u}\n" for x, y, u, v in points))
        rows = [value for y in (1, 0.5) for x in (0, 0.5, 1) for value in (x, -(2 * y + 1))]
        self.write("w.npy", write_npy((2, 3, 2), rows))
        self.write("up.npy", write_npy((2, 3, 2), [2 * value for y in (0.5, 1) for x in (0, 0.5, 1) for value in (x, 2 * y + 1)]))
        arrows = []
        for flow in ({"file": "w.csv"}, {"file": "w.npy", "plane": {"cell": 0.5}},
                     {"file": "up.npy", "plane": {"cell": 0.5}, "rows": "up", "scale": 0.5}):
            self.scene({"w": {"flow": flow}, "a": {"arrows": {"of": "w", "spacing": 0.5, "length": 10, "scale": 1, "height": 0, "anchor": "tail"}}})
            arrows.append(self.baked("a"))
        self.assertEqual(arrows[0], arrows[1])
        self.assertEqual(arrows[0], arrows[2])
        # An arrow's vector is its velocity. Its tail is at a point of the grid, whose middle is the plane's position.
        for row, (x, y) in zip(arrows[0], [(x, y) for y in (1, 0.5) for x in (0, 0.5, 1)], strict=True):
            tail = [row[i] - 0.5 * row[6] * row[3 + i] for i in range(2)]
            self.assertAlmostEqual(tail[0], x - 0.5, 5)
            self.assertAlmostEqual(tail[1], y - 0.75, 5)
            self.assertAlmostEqual(row[6] * row[3], x, 5)
            self.assertAlmostEqual(row[6] * row[4], 2 * y + 1, 5)

    def test_a_flow_is_wind_for_particles(self):
        self.scene({"w": {"flow": {"u": "2", "v": "0"}},
                    "dust": {"particles": {"groups": [{"count": 1, "radius": 1e-4}], "method": "none", "wind": {"fluid": "w", "drag": 60}}}})
        # After 10 frames, the speed is nearly the wind speed.
        self.assertAlmostEqual(self.baked("dust", 10)[0][4], 2, 4)

    def test_pictures_continue_from_a_checkpoint(self):
        self.scene({"w": {"flow": {"u": "-y", "v": "x"}}, "lines": {"streamlines": {"of": "w"}}, "arrows": {"arrows": {"of": "dust", "length": 0.4}},
                    "dust": {"particles": {"groups": [{"count": 9, "speed": 1}], "gravity": 0.1, "trails": {"frames": 6, "width": 0.1}}}},
                   camera={"position": [0, 0, 6], "target": [0, 0, 0]}, time={"fps": 30, "duration": 0.4})
        self.good("render", "a.json", "-o", "one/", "--frames", "9", "-q")
        self.good("render", "a.json", "-o", "part/", "--frames", "0-5", "--checkpoint-at", "5", "-q")
        self.good("render", "a.json", "-o", "rest/", "--from", "part/checkpoint.000005", "--frames", "9", "-q")
        picture = (self.folder / "one/000009.png").read_bytes()
        self.assertEqual((self.folder / "rest/000009.png").read_bytes(), picture)
        # The other memory path, and a single thread, must give the same bytes.
        self.good("render", "a.json", "-o", "other/", "--frames", "9", "-q", "--memory-path", "storage", env={"LP_NUM_THREADS": "1"})
        self.assertEqual((self.folder / "other/000009.png").read_bytes(), picture)

    def test_mistakes(self):
        def objects(value, kind="arrows", **more):
            self.scene({"a": {kind: value}, "w": {"flow": {}}, **more})
        objects({})
        self.bad_scene('whose velocities? Give "of"', *SHORT)
        objects({"of": "x"})
        self.bad_scene('no object is named "x"', *SHORT)
        objects({"of": "sheet"}, sheet={"cloth": {}})
        self.bad_scene('object "sheet" is a cloth, which has no velocities to draw; fluids, flows, particles', *SHORT)
        objects({"of": "w", "low": 2, "high": 1})
        self.bad_scene('"high" must be above "low"', *SHORT)
        objects({"of": "w", "spacing": 0.001})
        self.bad(2, ['arrows "a": 5760000 arrows are more than the 65536 that fit here; raise "spacing"'], *SHORT)
        objects({"of": "w", "separation": 0.001}, "streamlines")
        self.bad(2, ["more than the 8192 that fit here", 'raise "separation"'], *SHORT)
        objects({"of": "dust"}, "streamlines", dust={"particles": {"groups": [{}]}})
        self.bad_scene('object "dust" is a particles, which does not blow', *SHORT)
        objects({"u": "x +"}, "flow")
        self.bad_scene("the expression ends where a value is missing", *SHORT)
        objects({"u": "z"}, "flow")
        self.bad_scene('"z"', *SHORT)
        objects({"groups": [{"count": 20000}], "trails": True}, "particles")
        self.bad(2, ['particles "a": 20000 trails of 31 points are 620000, more than the 262144', '"every": 3'], *SHORT)
        smoke = {"fluid": {"size": [16, 9]}}
        self.scene({"smoke": smoke, "a": {"arrows": {"of": "smoke"}}})
        self.assertIn('"smoke" is drawn over the whole picture and hides "a"', self.good(*SHORT[:-1], "--overwrite").err)

    def test_mistakes_in_files_of_flows(self):
        for name, content, words in (
                ("a.csv", "x,y,u\n0,0,1\n", 'has no column "v"; a flow needs x, y, u and v, and there are x, y, u'),
                ("a.csv", "x,y,u,v\n0,0,1,1\n0,1,1,1\n", "all points have the same x"),
                ("a.csv", "x,y,u,v\n0,0,1,1\n1,0,1,1\n0,1,1,1\n", "the point x = 1, y = 1 of the grid has no velocity"),
                ("a.csv", "x,y,u,v\n0,0,1,1\n1,0,1,1\n0,1,1,1\n1,1,1,1\n1,1,1,1\n", "the point x = 1, y = 1 has two velocities"),
                ("a.csv", "x,y,u,v\n0,0,1,1\n1,0,1,1\n3,0,1,1\n0,1,1,1\n", "the values of x are not evenly spaced at 1"),
                ("a.csv", "x,y,u,v\n0,0,1,1\n1,0,1,1\n0,2,1,1\n1,2,1,1\n", "points are 1 apart in x and 2 in y"),
                ("a.npy", write_npy((4, 2), [0] * 8), "expected an array of shape (rows, columns, 2), found 1 x 4 x 2"),
                ("a.npy", write_npy((2, 2, 3), [0] * 12), "expected an array of shape (rows, columns, 2), found 2 x 2 x 3"),
                ("a.npy", write_npy((2, 2, 2), [0] * 5 + [math.nan] + [0] * 2), "the velocity of column 0, row 1 is not a number")):
            with self.subTest(words):
                self.write(name, content)
                self.scene({"w": {"flow": {"file": name}}})
                self.bad(2, ['flow "w": ', words], *SHORT)


if __name__ == "__main__":
    main()
