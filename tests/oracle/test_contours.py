"""Contours, areas and regions of caves and of smooth pictures against scikit-image, which knows nothing of this
program: fifty random maps and ten random pictures. Skipped (77), saying so, where scikit-image is not installed.
By hand: SIMREEL=build/simreel /usr/bin/python3 tests/oracle/test_contours.py"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    from skimage import filters, measure
except ImportError as missing:
    print(f"skipped: {missing}; install python3-skimage")
    sys.exit(77)

SIMREEL = os.environ["SIMREEL"]


def loops_of(document):
    """Closed lines by level, each an array of (x, y) with y down, the first point repeated at the end."""
    loops = {}
    for feature in document["features"]:
        if "level" not in feature["properties"]:
            continue
        points = numpy.array(feature["geometry"]["coordinates"]) * [1, -1]
        assert (points[0] == points[-1]).all()
        loops.setdefault(feature["properties"]["level"], []).append(points)
    return loops


def length(loops):
    return sum(numpy.hypot(*numpy.diff(points, axis=0).T).sum() for points in loops)


def signed_area(loops):
    """Of what lies within, one way round minus the other way: holes have the other sign."""
    return sum(0.5 * numpy.sum(p[:-1, 0] * p[1:, 1] - p[1:, 0] * p[:-1, 1]) for p in loops)


class Contours(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bake(self, scene, *formats):
        """Every object of the scene; what costs is the start of a process, so many go into one."""
        (self.folder / "scene.json").write_text(json.dumps({"version": 1, **scene}), encoding="utf-8")
        for file_format in formats:
            subprocess.run([SIMREEL, "bake", "scene.json", "-o", "out", "--frames", "0", "--format", file_format, "--overwrite"],
                           cwd=self.folder, check=True, capture_output=True)

    def baked(self, name, file_format):
        return self.folder / "out" / f"{name}_000000.{file_format}"

    def expected(self, values, level):
        found = measure.find_contours(values, level, fully_connected="high")
        return [points[:, ::-1] for points in found]  # In these arrays, the row index comes first.

    def check_same(self, loops, expected):
        self.assertEqual(len(loops), len(expected))
        self.assertAlmostEqual(length(loops), length(expected), delta=1e-3)
        self.assertAlmostEqual(abs(signed_area(loops)), abs(signed_area(expected)), delta=1e-2)

    def check_cave(self, name, cave):
        """How many rooms and rocks it has."""
        rock = numpy.pad(numpy.load(self.baked(name, "npy")), 1, constant_values=1)
        self.assertEqual(rock.shape, (cave["size"][1] + 2, cave["size"][0] + 2))
        self.assertLessEqual(set(numpy.unique(rock)), {0.0, 1.0})
        loops = loops_of(json.loads(self.baked(name, "geojson").read_text())).get(1, [])
        self.check_same(loops, self.expected(rock, 0.5))
        open_regions, rooms = measure.label(rock == 0, connectivity=1, return_num=True)
        rocks = measure.label(rock == 1, connectivity=2, return_num=True)[1]
        self.assertEqual(len(loops), rooms + rocks - 1)  # There is one loop around each room, and one around each rock
                                                         # in a room.
        if cave["connect"]:
            self.assertLessEqual(rooms, 1)
        sizes = numpy.bincount(open_regions.ravel())[1:]
        if rooms > 1:  # The largest room is kept regardless of its size.
            self.assertGreaterEqual(sorted(sizes)[0], cave["smallestRoom"])
        steps = numpy.load(self.baked(f"{name}.distance", "npy")) if rooms else None
        if rooms == 1:
            self.assertTrue(((steps >= 0) == (rock[1:-1, 1:-1] == 0)).all())
        return rooms + rocks

    def test_fifty_random_maps(self):
        random = numpy.random.default_rng(7)
        regions = 0
        for seed in range(1, 6):
            caves = {f"c{number}": {
                "size": [int(n) for n in random.integers(3, 90, 2)], "fill": float(random.uniform(0.3, 0.65)),
                "smoothing": int(random.integers(0, 6)), "smallestRoom": int(random.integers(0, 20)),
                "smallestRock": int(random.integers(0, 12)), "connect": bool(number % 2), "corridor": int(random.integers(1, 5))}
                for number in range(10)}
            self.bake({"seed": seed, "objects": {name: {"cave": cave} for name, cave in caves.items()}}, "npy", "geojson")
            for name, cave in caves.items():
                with self.subTest(seed=seed, cave=cave):
                    regions += self.check_cave(name, cave)
        self.assertGreater(regions, 300)

    def test_smooth_pictures_at_several_levels(self):
        random = numpy.random.default_rng(11)
        pictures, objects = {}, {}
        for number in range(10):
            height, width = (int(n) for n in random.integers(20, 80, 2))
            noise = filters.gaussian(random.uniform(0, 1, (height, width)), 3)
            picture = numpy.round(255 * (noise - noise.min()) / numpy.ptp(noise)).astype(numpy.uint8)
            picture[[0, -1], :] = 0
            picture[:, [0, -1]] = 0
            (self.folder / f"{number}.pgm").write_bytes(b"P5\n%d %d\n255\n" % (width, height) + picture.tobytes())
            pictures[f"c{number}"] = picture
            objects[f"c{number}"] = {"contour": {"image": f"{number}.pgm", "levels": 4, "low": 0.2013, "high": 0.8017}}
        self.bake({"objects": objects}, "geojson")
        for name, picture in pictures.items():
            loops = loops_of(json.loads(self.baked(name, "geojson").read_text()))
            for level in range(4):
                value = 0.2013 + (0.8017 - 0.2013) * level / 3
                with self.subTest(name=name, level=level):
                    self.check_same(loops.get(level + 1, []), self.expected(picture / 255, value))


if __name__ == "__main__":
    unittest.main()
