"""Tests caves and contours through the command line: files for other programs, and one clear line for each error."""
import json
import struct

from common import Case, main, with_values


def read_glb(data):
    """Returns (document, binary chunk) of a binary glTF file."""
    magic, version, total = struct.unpack("<4sII", data[:12])
    assert (magic, version, total) == (b"glTF", 2, len(data)), (magic, version, total)
    chunks, at = [], 12
    while at < len(data):
        length, kind = struct.unpack("<I4s", data[at:at + 8])
        assert length % 4 == 0
        chunks.append((kind, data[at + 8:at + 8 + length]))
        at += 8 + length
    assert [kind for kind, _ in chunks] == [b"JSON", b"BIN\0"]
    return json.loads(chunks[0][1]), chunks[1][1]


def read_accessor(document, binary, index):
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
    kind = {5126: "f", 5125: "I"}[accessor["componentType"]]
    values = struct.unpack_from(f"<{width * accessor['count']}{kind}", binary, view["byteOffset"])
    return list(values) if width == 1 else [values[i:i + width] for i in range(0, len(values), width)]


class Caves(Case):
    def scene(self, **cave):
        self.write("scene.json", with_values({"objects": {"c": {"cave": {"size": [41, 29], **cave}}}}))

    def baked(self, file_format, name="c"):
        self.good("bake", "scene.json", "-o", "out", "--frames", "0", "--format", file_format, "--object", name, "--overwrite")
        return self.folder / "out" / f"{name}_000000.{file_format}"

    def check_closed(self, positions, triangles):
        """Checks that every edge between two positions is used once in each direction."""
        edges = set()
        for triangle in triangles:
            places = [positions[i] for i in triangle]
            for edge in zip(places, places[1:] + places[:1]):
                self.assertNotIn(edge, edges)
                edges.add(edge)
        self.assertEqual(edges, {(b, a) for a, b in edges})

    def test_binary_gltf_is_one_closed_solid(self):
        for ceiling in (False, True):
            self.scene(ceiling=ceiling)
            document, binary = read_glb(self.baked("glb").read_bytes())
            (primitive,) = document["meshes"][0]["primitives"]
            columns = {name: read_accessor(document, binary, index) for name, index in primitive["attributes"].items()}
            indices = read_accessor(document, binary, primitive["indices"])
            positions = columns["POSITION"]
            self.assertEqual({len(column) for column in columns.values()}, {len(positions)})
            self.assertEqual(set(indices), set(range(len(positions))))  # The triangles must use every position.
            accessor = document["accessors"][primitive["attributes"]["POSITION"]]
            self.assertEqual(accessor["min"], [min(axis) for axis in zip(*positions)])
            self.assertEqual(accessor["max"], [max(axis) for axis in zip(*positions)])
            for normal in columns["NORMAL"]:
                self.assertAlmostEqual(sum(x * x for x in normal), 1, places=5)
            self.check_closed(positions, [indices[i:i + 3] for i in range(0, len(indices), 3)])
            # A baked mesh must be readable as a mesh.
            self.write("again.json", with_values({"objects": {"m": {"mesh": {"shape": "file", "file": "out/c_000000.glb"}}}}))
            self.good("render", "again.json", "-o", f"again{ceiling}.png", "--frames", "0")

    def test_obj_is_the_same_solid(self):
        self.scene()
        lines = self.baked("obj").read_text(encoding="utf-8").splitlines()
        positions = [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
        faces = [[int(corner.split("/")[0]) - 1 for corner in line.split()[1:]] for line in lines if line.startswith("f ")]
        self.check_closed(positions, faces)

    def test_navigation(self):
        self.scene(fill=0.5)
        features = json.loads(self.baked("geojson").read_text(encoding="utf-8"))["features"]
        (path,) = [f["geometry"]["coordinates"] for f in features if f["properties"].get("path")]
        ends = {f["properties"]["name"]: f["geometry"]["coordinates"] for f in features if "name" in f["properties"]}
        self.assertEqual((path[0], path[-1]), (ends["entrance"], ends["exit"]))
        self.baked("npy")
        data = (self.folder / "out/c.distance_000000.npy").read_bytes()
        width, height = 41, 29
        steps = struct.unpack(f"<{width * height}f", data[-4 * width * height:])
        at = {name: (round(x), round(-y)) for name, (x, y) in ends.items()}
        self.assertEqual(steps[at["entrance"][1] * width + at["entrance"][0]], 0)
        self.assertEqual(steps[at["exit"][1] * width + at["exit"][0]], max(steps))
        self.assertEqual(len(path), max(steps) + 1)
        for y in range(height):  # The numbers of steps to adjacent open cells differ by at most one.
            for x in range(width - 1):
                a, b = steps[y * width + x], steps[y * width + x + 1]
                if a >= 0 and b >= 0:
                    self.assertEqual(abs(a - b), 1)
        svg = self.baked("svg").read_text(encoding="utf-8")
        self.assertIn('viewBox="-1 -1 42 30"', svg)
        self.assertEqual(svg.count("M"), svg.count("Z"))

    def test_rooms(self):
        def rooms():
            features = json.loads(self.baked("geojson").read_text(encoding="utf-8"))["features"]
            return [(f["properties"], f["geometry"]["coordinates"]) for f in features if "room" in f["properties"]]
        self.scene(fill=0.52, connect=False, cell=0.5)
        separate = rooms()
        self.assertGreater(len(separate), 1)
        self.baked("npy")
        cells = struct.unpack(f"<{41 * 29}f", (self.folder / "out/c_000000.npy").read_bytes()[-4 * 41 * 29:])
        self.assertEqual(sum(room["cells"] for room, _ in separate), cells.count(0))
        for number, (room, (x, y)) in enumerate(separate, 1):
            self.assertEqual(room["room"], number)
            self.assertAlmostEqual(room["area"], room["cells"] * 0.25)
            self.assertTrue(0 <= x <= 40 and -28 <= y <= 0)
        self.scene(fill=0.52, cell=0.5)
        self.assertEqual(rooms(), separate)  # number of rooms before corridors connected them

    def test_contour_levels_follow_the_range_of_the_field(self):
        pattern = {"grayScott": {"size": [48, 32], "presteps": 50, "display": {"layer": "none", "low": 0.1, "high": 0.4}}}
        def lines(**contour):
            self.write("scene.json", with_values({"objects": {
                "p": pattern, "c": {"contour": {"field": "p", "levels": 3, **contour}}}}))
            return json.loads(self.baked("geojson").read_text())["features"]
        found = lines()
        self.assertTrue(found)
        self.assertEqual(found, lines(low=0.13, high=0.37))
        self.assertNotEqual(found, lines(low=0.13, high=0.33))
        self.write("scene.json", with_values({"objects": {"p": pattern, "c": {"contour": {"field": "p", "low": 0.5}}}}))
        self.bad(2, ["0.5", "0.37", '"low" and "high"'], "render", "scene.json", "-o", "out.png", "--frames", "0")

    def test_contours_of_a_running_field(self):
        pattern = {"grayScott": {"size": [48, 32], "presteps": 5, "display": {"layer": "none"}}}
        self.write("scene.json", with_values({"objects": {
            "hills": {"contour": {"field": "pattern", "levels": 3, "low": 0.1, "high": 0.3}}, "pattern": pattern}}))
        levels = [f["properties"]["level"] for f in json.loads(self.baked("geojson", "hills").read_text())["features"]]
        self.assertEqual(set(levels), {1, 2, 3})
        self.good("render", "scene.json", "-o", "out.png", "--frames", "5")

    def test_mistakes(self):
        def refused(parts, objects, **scene):
            self.write("scene.json", with_values({"objects": objects, **scene}))
            self.bad(2, parts, "validate", "scene.json")
        refused(["scene.json:", "\"roks\"", "rock"], {"c": {"cave": {"roks": 3}}})
        refused(["scene.json:", "patern", "pattern"], {"h": {"contour": {"field": "patern"}}, "pattern": {"grayScott": {}}})
        refused(["scene.json:", "no \"field\""], {"h": {"contour": {}}})
        refused(["scene.json:", "not a field"], {"h": {"contour": {"field": "b"}}, "b": {"sphere": {}}})
        refused(["\"low\"", "less than"], {"h": {"contour": {"field": "p", "low": 2, "high": 1}}, "p": {"grayScott": {}}})
        for kind, more in (("particles", {"groups": [{}]}), ("cloth", {})):
            named = lambda name: {"cave": {"cave": {}}, "b": {"sphere": {}}, "p": {kind: {**more, "walls": name}}}
            refused(["scene.json:", "no object is named \"cav\"", "did you mean \"cave\"?"], named("cav"))
            refused(["scene.json:", "\"b\" is a sphere, which has no walls"], named("b"))
        follow = {"follow": {"object": "cove"}}
        refused(["scene.json:", "no object is named \"cove\"; did you mean \"cave\"?", "^~~~~~"], {"cave": {"cave": {}}}, camera=follow)
        refused(["leave out \"target\""], {"cave": {"cave": {}}}, camera={"follow": {"object": "cave"}, "target": [0, 0, 1]})
        light = {"lamp": follow}
        refused(["scene.json:", "no object is named \"cove\"; did you mean \"cave\"?", "^~~~~~"], {"cave": {"cave": {}}}, lights=light)
        refused(["scene.json:", "the scene has none: add a cave"], {}, lights=light)
        for name in ("camera", "lights.lamp"):
            refused([f"{name}.follow.object: object \"cove\" is a sphere, which has no path", "add a cave"], {"cove": {"sphere": {}}},
                    camera=follow, lights=light)
        self.write("scene.json", with_values({"objects": {"cave": {"cave": {}}}, "lights": light, "camera": follow}))
        self.assertEqual(self.bad_scene("cove", "render", "scene.json", "-o", "a/").err.count("no object is named"), 2)
        self.write("scene.json", with_values({"objects": {"cave": {"cave": {"fill": 1}}}, "camera": {"follow": {"object": "cave"}}}))
        self.bad(2, ["cave", "no path"], "render", "scene.json", "-o", "out.png", "--frames", "0")

    def test_a_cave_without_open_cells_and_one_without_rock(self):
        for fill in (0, 1):
            self.scene(fill=fill)
            positions = [line for line in self.baked("obj").read_text().splitlines() if line.startswith("v ")]
            self.assertTrue(positions)
            self.good("render", "scene.json", "-o", f"fill{fill}.png", "--frames", "0")


if __name__ == "__main__":
    main()
