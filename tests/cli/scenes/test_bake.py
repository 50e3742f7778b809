"""Tests `simreel bake` through the command line."""
import json
import math
import struct
import zlib

from common import Case, main, png_rows, unfiltered, with_values


def read_ply(data):
    """Returns (comments, column names, rows) of a binary PLY of floats."""
    head, _, body = data.partition(b"end_header\n")
    lines = head.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"], lines
    names = [line.split()[2] for line in lines if line.startswith("property float ")]
    (count,) = [int(line.split()[2]) for line in lines if line.startswith("element vertex ")]
    faces = sum(int(line.split()[2]) for line in lines if line.startswith("element face "))
    assert len(body) == count * len(names) * 4 + faces * 13, (len(body), count)
    values = struct.unpack_from(f"<{count * len(names)}f", body)
    rows = [values[i:i + len(names)] for i in range(0, len(values), len(names))]
    return [line[8:] for line in lines if line.startswith("comment ")], names, rows


class Bake(Case):
    def read(self, name):
        return read_ply((self.folder / name).read_bytes())

    def test_points_of_every_frame(self):
        self.good("bake", "scene.json", "-o", "out")
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()),
                         [f"flag_{frame:06}.ply" for frame in range(6)])
        comments, names, rows = self.read("out/flag_000005.ply")
        self.assertEqual(names, ["x", "y", "z", "nx", "ny", "nz", "s", "t", "vx", "vy", "vz"])
        self.assertEqual(len(rows), 9 * 7)
        self.assertIn("object flag frame 5 time 0.166667 s seed 1", comments)
        # The sheet falls from rest, so it is lower in each frame and its speed increases.
        heights = [sum(row[1] for row in self.read(f"out/flag_{frame:06}.ply")[2]) for frame in range(6)]
        self.assertEqual(heights, sorted(heights, reverse=True))
        self.assertEqual({row[8:] for row in self.read("out/flag_000000.ply")[2]}, {(0.0, 0.0, 0.0)})
        self.assertLess(min(row[9] for row in rows), 0)

    def test_cloth_is_a_surface(self):
        self.good("bake", "scene.json", "-o", "out", "--frames", "5")
        self.good("bake", "scene.json", "-o", "out", "--frames", "5", "--format", "obj")
        head, _, body = (self.folder / "out/flag_000005.ply").read_bytes().partition(b"end_header\n")
        self.assertIn(b"element face 96\nproperty list uchar uint vertex_indices\n", head)
        rows = self.read("out/flag_000005.ply")[2]
        faces = [struct.unpack_from("<3I", body, len(rows) * 44 + 13 * i + 1) for i in range(96)]
        # Faces and normals have the same orientation, and the total area of the faces equals the sheet's.
        area = 0
        for face in faces:
            a, b, c = (rows[i] for i in face)
            across, along = ([q[k] - a[k] for k in range(3)] for q in (b, c))
            cross = [across[(k + 1) % 3] * along[(k + 2) % 3] - across[(k + 2) % 3] * along[(k + 1) % 3] for k in range(3)]
            area += 0.5 * math.sqrt(sum(x * x for x in cross))
            for i in face:
                self.assertGreater(sum(x * n for x, n in zip(cross, rows[i][3:6])), 0)
        self.assertAlmostEqual(area, 0.8 * 0.6, delta=0.1)  # The tolerance allows for folds of the sheet.
        # These are the uvs of three corners. The first row of a picture is at v = 1.
        self.assertEqual([rows[0][6:8], rows[8][6:8], rows[62][6:8]], [(0, 1), (1, 1), (1, 0)])

    def test_baked_files_are_read_back_as_the_same_surface(self):
        """Compares triangle by triangle, because the reader reorders vertices. Rotations are omitted, because even a
        rotation by 0 would not be exact."""
        self.good("bake", "scene.json", "-o", "out", "--frames", "5")
        rows = self.read("out/flag_000005.ply")[2]

        def surface(name):
            data = (self.folder / name).read_bytes()
            head, _, body = data.partition(b"end_header\n")
            (faces,) = [int(line.split()[2]) for line in head.decode().splitlines() if line.startswith("element face")]
            names, rows = self.read(name)[1:]
            corners = [struct.unpack_from("<3I", body, len(rows) * len(names) * 4 + 13 * i + 1) for i in range(faces)]
            return [x for face in corners for i in face for x in rows[i][:8]]

        wanted = surface("out/flag_000005.ply")
        self.assertEqual(len(rows), 63)
        for suffix in ("ply", "obj", "glb"):
            self.good("bake", "scene.json", "-o", "out", "--frames", "5", "--format", suffix, "--object", "flag", "--overwrite")
            self.write("again.json", with_values({"objects": {"m": {"mesh": {"shape": "file", "file": f"out/flag_000005.{suffix}"}}}}))
            self.good("bake", "again.json", "-o", "again", "--frames", "0", "--overwrite")
            found = surface("again/m_000000.ply")
            self.assertEqual(len(found), len(wanted))
            self.assertLess(max(abs(a - b) for a, b in zip(found, wanted)), 2e-6, suffix)

    def test_one_glb_holds_all_objects_of_the_scene_with_its_solids(self):
        """The readers are test_caves.read_glb() here and assimp in tests/unit/frame/solid_files.cpp."""
        from test_caves import read_accessor, read_glb
        ball = {"sphere": {"radius": 0.5, "position": {"keys": [[0, [0, 1, 0]], [0.1, [3, 1, 0]]]}}}
        rod = {"capsule": {"radius": 0.25, "length": 1, "rotation": [0, 0, 90]}, "material": {"color": [1, 0, 0]}}
        self.write("scene.json", with_values({"objects": {"ball": ball, "rod": rod, "flag": {"cloth": {"size": [9, 7]}},
                                                          "floor": {"plane": {"size": [2, 4]}},
                                                          "unseen": {"sphere": {"visible": False}}}}))
        self.good("bake", "scene.json", "-o", "out", "--frames", "0,5", "--format", "glb")
        self.assertEqual(sorted(self.content("out")), ["scene_000000.glb", "scene_000005.glb"])
        document, binary = read_glb(self.content("out")["scene_000005.glb"])
        self.assertEqual([document["nodes"][i]["name"] for i in document["scenes"][0]["nodes"]], ["ball", "rod", "flag", "floor"])

        def points(node):
            (primitive,) = document["meshes"][document["nodes"][node]["mesh"]]["primitives"]
            return read_accessor(document, binary, primitive["attributes"]["POSITION"])
        self.assertEqual(len(points(2)), 63)
        for x, y, z in points(0):
            self.assertAlmostEqual(math.dist((x, y, z), (3, 1, 0)), 0.5, places=5)
        for x, y, z in points(1):
            self.assertAlmostEqual(math.dist((x, y, z), (min(max(x, -0.5), 0.5), 0, 0)), 0.25, places=5)
        self.assertEqual(sorted(tuple(point) for point in points(3)), [(-1, 0, -2), (-1, 0, 2), (1, 0, -2), (1, 0, 2)])
        self.assertEqual(document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"], [1, 0, 0, 1])
        for suffix in ("obj", "ply"):
            self.good("bake", "scene.json", "-o", "solids", "--frames", "0", "--format", suffix)
            self.assertEqual(sorted(name for name in self.content("solids") if name.endswith(suffix)),
                             [f"{name}_000000.{suffix}" for name in ("ball", "flag", "floor", "rod")])

    def test_glb_keeps_the_alpha_of_textures(self):
        def chunk(name, body):
            return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        (self.folder / "holes.png").write_bytes(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 2, 1, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(b"\0\x10\x20\x30\xff\x40\x50\x60\0")) + chunk(b"IEND", b""))
        for alpha, mode in (("cut", "MASK"), ("blend", "BLEND")):
            self.write("holes.json", {"version": 2, "objects": {"m": {"mesh": {"shape": "torus"}, "material": {"texture": "holes.png", "alpha": alpha}}}})
            self.good("bake", "holes.json", "-o", "holes", "--frames", "0", "--format", "glb", "--object", "m", "--overwrite")
            data = (self.folder / "holes/m_000000.glb").read_bytes()
            size = struct.unpack_from("<I", data, 12)[0]
            document = json.loads(data[20:20 + size])
            self.assertEqual(document["materials"][0]["alphaMode"], mode)
            view = document["bufferViews"][document["images"][0]["bufferView"]]
            at = 28 + size + view.get("byteOffset", 0)
            self.assertEqual(data[at + 24:at + 26], b"\x08\x06")  # 8 bits per channel, RGBA

    def test_textures_are_upright_on_meshes_read_back(self):
        red, blue = bytes([255, 0, 0]), bytes([0, 0, 255])
        self.write("flag.ppm", b"P6 8 8 255\n" + 32 * red + 32 * blue)
        self.write("scene.json", with_values({"objects.flag.material": {"texture": "flag.ppm"}, "objects.flag.cloth.jitter": 0,
                                              "objects.flag.cloth.pins": [{"rows": [0]}], "objects.flag.cloth.position": [0, 1, 2]}))

        def upright(name):
            self.good("render", name, "-o", "out.png", "--frames", "0", "--overwrite")
            width, height, rows = png_rows((self.folder / "out.png").read_bytes())
            step = (len(rows) // height - 1) // width
            column = [line[step * width // 2:][:3] for line in unfiltered(rows, step * width, step)]
            self.assertGreater(column[height * 3 // 8][0], 2 * column[height * 3 // 8][2])
            self.assertGreater(column[height * 5 // 8][2], 2 * column[height * 5 // 8][0])

        upright("scene.json")
        for suffix in ("ply", "obj", "glb"):
            self.good("bake", "scene.json", "-o", "out", "--frames", "0", "--format", suffix, "--object", "flag")
            self.write("again.json", with_values({"objects": {"m": {
                "mesh": {"shape": "file", "file": f"out/flag_000000.{suffix}", "sides": "both"}, "material": {"texture": "flag.ppm"}}}}))
            upright("again.json")
        # A glb file contains its texture.
        self.write("again.json", with_values({"objects": {"m": {"mesh": {"shape": "file", "file": "out/flag_000000.glb"}}}}))
        (self.folder / "flag.ppm").unlink()
        upright("again.json")

    def test_particles_as_instances(self):
        dust = {"method": "none", "look": {"shape": "sphere", "size": 0.25},
                "groups": [{"shape": "cube", "count": 5, "radius": 1, "totalMass": 1, "position": [0, 1, 0], "speed": 1}]}
        self.write("scene.json", with_values({"objects": {"dust": {"particles": dust, "material": {"color": [0.5, 0.25, 0.125]}}}}))
        self.good("bake", "scene.json", "-o", "out", "--frames", "3")
        self.good("bake", "scene.json", "-o", "out", "--frames", "3", "--format", "glb", "--object", "dust")
        data = (self.folder / "out/dust_000003.glb").read_bytes()
        (length,) = struct.unpack_from("<I", data, 12)
        document, binary = json.loads(data[20:20 + length]), data[28 + length:]
        attributes = document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]

        def rows(name):
            accessor = document["accessors"][attributes[name]]
            start = document["bufferViews"][accessor["bufferView"]]["byteOffset"]
            flat = struct.unpack_from(f"<{3 * accessor['count']}f", binary, start)
            return [flat[i:i + 3] for i in range(0, len(flat), 3)]

        self.assertEqual(rows("TRANSLATION"), [row[:3] for row in self.read("out/dust_000003.ply")[2]])
        self.assertEqual(rows("SCALE"), 5 * [(0.25, 0.25, 0.25)])
        self.bad(2, ["no object", "a mesh"], "bake", "scene.json", "-o", "out", "--sequence")

    def test_a_mesh_on_keyframes(self):
        mesh = {"resolution": [2, 2], "size": [2, 0, 2], "position": {"keys": [[0, [0, 0, 0]], [0.1, [3, 0, 0]]]}}
        self.write("scene.json", with_values({"objects": {"plate": {"mesh": mesh}}}))
        self.good("bake", "scene.json", "-o", "out", "--frames", "0,1,5")
        for frame, x in ((0, 0), (1, 1), (5, 3)):
            self.assertEqual([tuple(round(v, 5) for v in row[:3]) for row in self.read(f"out/plate_{frame:06}.ply")[2]],
                             [(x - 1, 0, -1), (x + 1, 0, -1), (x - 1, 0, 1), (x + 1, 0, 1)])

    def test_selected_frames_equal_those_of_a_complete_bake(self):
        self.good("bake", "scene.json", "-o", "all")
        self.good("bake", "scene.json", "-o", "some", "--frames", "2,4", "--object", "flag")
        some = self.content("some")
        self.assertEqual(some, {name: self.content("all")[name] for name in ("flag_000002.ply", "flag_000004.ply")})

    def test_existing_files_are_kept(self):
        self.write("out/flag_000003.ply", "mine")
        self.bad(6, ["out/flag_000003.ply", "--overwrite"], "bake", "scene.json", "-o", "out")
        self.assertEqual(self.content("out"), {"flag_000003.ply": b"mine"})
        self.good("bake", "scene.json", "-o", "out", "--overwrite")
        self.assertEqual(len(self.content("out")), 6)

    def test_a_deformed_mesh_as_obj_and_ply(self):
        mesh = {"resolution": [7, 5], "deform": [{"ripple": {}}]}
        self.write("scene.json", with_values({"objects": {"sheet": {"mesh": mesh}}}))
        self.good("bake", "scene.json", "-o", "out", "--frames", "0,5", "--format", "obj")
        self.good("bake", "scene.json", "-o", "out", "--frames", "0,5")
        lines = (self.folder / "out/sheet_000005.obj").read_text(encoding="utf-8").splitlines()
        count = {kind: sum(line.startswith(kind + " ") for line in lines) for kind in ("v", "vt", "vn", "f")}
        self.assertEqual(count, {"v": 35, "vt": 35, "vn": 35, "f": 48})
        head, _, body = (self.folder / "out/sheet_000005.ply").read_bytes().partition(b"end_header\n")
        self.assertIn(b"element face 48\nproperty list uchar uint vertex_indices\n", head)
        self.assertEqual(len(body), 35 * 8 * 4 + 48 * 13)
        vertices = [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
        for i, vertex in enumerate(vertices):  # Both files must contain the same floats.
            self.assertEqual(struct.pack("<3f", *vertex), body[i * 32:i * 32 + 12])
        for x, y, z in vertices:  # The positions are compared with the formula of the ripple at frame 5.
            self.assertAlmostEqual(y, 0.25 * math.sin(2 * 5 / 30 + 6 - math.hypot(x, z)), places=5)
        self.assertNotEqual(self.content("out")["sheet_000000.obj"], self.content("out")["sheet_000005.obj"])
        # A baked mesh must be readable as a mesh.
        self.write("again.json", with_values({"objects": {"m": {"mesh": {"shape": "file", "file": "out/sheet_000005.ply"}}}}))
        self.good("render", "again.json", "-o", "again.png", "--frames", "0")

    def test_mistakes(self):
        self.bad(2, ["nobody", "flag"], "bake", "scene.json", "-o", "out", "--object", "nobody")
        self.write("scene.json", with_values({"objects": {"ball": {"sphere": {"visible": False}}}}))
        self.bad(2, "no object of the scene has state to bake", "bake", "scene.json", "-o", "out")
        self.bad(2, "there is no \"nobody\"; the scene has ball", "bake", "scene.json", "-o", "out", "--object", "nobody")
        self.bad(2, "no object of the scene has points or a mesh", "bake", "scene.json", "-o", "out", "--format", "ply")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
