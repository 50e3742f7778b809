"""Tests meshes given as scenes, and files that mesh files refer to: pictures, libraries, unsupported features."""
import base64
import json
import struct

from common import Case, main, png_rows

SQUARE = ("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
          "usemtl m\nf 1/1 2/2 3/3 4/4\n")
BMP = (b"BM" + struct.pack("<IIIIiiHHIIIIII", 58, 0, 54, 40, 1, 1, 1, 24, 0, 4, 0, 0, 0, 0) + b"\0\0\xff\0")


class MeshFiles(Case):
    def said(self, obj, material=None, **files):
        """Returns the messages of `validate` for a scene with this OBJ, beside files in whose names _ stands for a
        dot."""
        self.write("m.obj", obj)
        for name, content in files.items():
            self.write(name.replace("_", "."), content)
        thing = {"mesh": {"file": "m.obj"}, **({"material": material} if material else {})}
        self.write("m.json", json.dumps({"version": 1, "objects": {"m": thing}}))
        return self.good("validate", "m.json").err

    def test_a_mesh_file_is_rendered_like_a_scene_that_names_it(self):
        self.write("a model.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")
        self.good("render", "a model.obj", "--size=48x27", "-o", "model.png")
        self.write("m.json", json.dumps({"version": 1, "objects": {"model": {"mesh": {"file": "a model.obj"}}}}))
        self.good("render", "m.json", "--size=48x27", "--frames=0", "-o", "scene.png")
        self.assertEqual(png_rows((self.folder / "model.png").read_bytes()), png_rows((self.folder / "scene.png").read_bytes()))

    def test_turn_moves_the_camera_once_around_the_scene(self):
        self.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nf 1 2 3\n")
        self.good("render", "m.obj", "--size=48x27", "--turn=0.5", "--fps=8", "-o", "out/")
        self.good("render", "m.obj", "--size=48x27", "--turn=0.5", "--fps=8", "--frames=last", "-o", "last.png")
        self.assertEqual(png_rows((self.folder / "last.png").read_bytes()), png_rows((self.folder / "out/000003.png").read_bytes()))
        frames = sorted((self.folder / "out").glob("*.png"))
        self.assertEqual(len(frames), 4)
        self.assertEqual(len({frame.read_bytes() for frame in frames}), 4)
        self.bad(2, ["--turn takes seconds above 0"], "render", "m.obj", "--turn=0", "-o", "no/")

    def test_turn_starts_at_the_position_of_the_camera(self):
        self.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nf 1 2 3\n")
        scene = {"version": 2, "camera": {"position": [1, 1.5, 3], "target": [0.2, 0.4, 0]}, "objects": {"m": {"mesh": {"file": "m.obj"}}}}
        self.write("s.json", json.dumps(scene))
        self.good("render", "s.json", "--size=48x27", "--frames=0", "-o", "still.png")
        self.good("render", "s.json", "--size=48x27", "--turn=0.5", "--fps=8", "-o", "turn/")
        still, first, second = (png_rows((self.folder / name).read_bytes())[2] for name in ("still.png", "turn/000000.png", "turn/000001.png"))
        far = sum(abs(a - b) > 8 for a, b in zip(still, first))
        self.assertLess(far, len(still) // 100)  # Angles are rounded, so single pixels differ.
        self.assertGreater(sum(abs(a - b) > 8 for a, b in zip(still, second)), len(still) // 20)

    def test_frames_of_a_changed_file_are_not_resumed(self):
        self.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nf 1 2 3\n")
        self.write("s.json", json.dumps({"version": 2, "time": {"fps": 10, "duration": 0.3}, "objects": {"m": {"mesh": {"file": "m.obj"}}}}))
        self.good("render", "s.json", "--size=48x27", "-o", "out/")
        (self.folder / "out/000002.png").unlink()
        self.good("render", "s.json", "--size=48x27", "-o", "out/", "--resume")
        self.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 2 0.3\nf 1 2 3\n")
        (self.folder / "out/000002.png").unlink()
        for flag in ("--resume", "--skip-existing"):
            self.bad(2, ["scene hash"], "render", "s.json", "--size=48x27", "-o", "out/", flag)

    def test_lights_of_a_file_may_have_any_name(self):
        lamp = {"type": "point", "intensity": 5}
        node = lambda **more: {"translation": [1, 2, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}, **more}
        data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
        self.write("m.gltf", json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1, 2, 3, 4, 5]}],
            "nodes": [{"mesh": 0}, node(name="Light.001"), node(name="Light_001"), node(), node(name="rim"), node(name="\u00fc" * 70)],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
            "extensions": {"KHR_lights_punctual": {"lights": [lamp]}}}))
        said = self.good("explain", "m.gltf").stdout.decode()
        for name in ("Light_001", "Light_001_2", "node_3", "rim_2"):
            self.assertIn(f"lights.{name}.", said)

    def test_a_model_with_an_animation_is_one_picture_or_all_its_frames(self):
        data = struct.pack("<9f2f6f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.1, 0, 0, 0, 3, 0, 0)
        place = lambda count, kind, view: {"bufferView": view, "componentType": 5126, "count": count, "type": kind}
        self.write("m.gltf", json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [place(3, "VEC3", 0), place(2, "SCALAR", 1), place(2, "VEC3", 2)],
            "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in ((0, 36), (36, 8), (44, 24))],
            "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
            "animations": [{"samplers": [{"input": 1, "output": 2}],
                            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]}))
        self.good("render", "m.gltf", "--size=48x27", "-o", "one.png")
        self.good("render", "m.gltf", "--size=48x27", "-o", "all/")
        frames = [png_rows(frame.read_bytes()) for frame in sorted((self.folder / "all").glob("*.png"))]
        self.assertEqual(len(frames), 3)
        self.assertEqual(png_rows((self.folder / "one.png").read_bytes()), frames[0])
        self.assertNotEqual(frames[0], frames[1])
        self.bad(2, ["one name for 8 frames"], "render", "m.gltf", "--turn=0.25", "-o", "two.png")

    def test_texture_coordinates_that_are_not_finite_are_refused(self):
        # This test takes 0.1 s.
        head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + "".join(f"property float {name}\n" for name in "xyzst") + "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        self.write("a.ply", head.encode() + struct.pack("<15f", 0, 0, 0, 0, 0, 1, 0, 0, float("nan"), 0, 0, 1, 0, 0, 1) + struct.pack("<B3i", 3, 0, 1, 2))
        self.write("a.json", {"version": 2, "objects": {"m": {"mesh": {"file": "a.ply"}}}})
        self.bad(6, "a.ply has a texture coordinate that is not finite or beyond 1e9 (vertex 1)", "render", "a.json", "--frames", "0", "-o", "a.png")

    def test_unsupported_mesh_formats_are_refused(self):
        self.write("m.fbx", "Kaydara")
        self.bad(2, ["m.fbx is a mesh, not a scene, and of a format that is not read"], "render", "m.fbx", "-o", "out/")

    def test_lines_and_points_are_reported_as_not_drawn_for_any_material(self):
        for material in (None, {"color": [1, 0, 0]}):
            self.assertIn("not drawn: lines (1); points (1)", self.said(SQUARE.replace("usemtl m\n", "") + "l 1 2\np 3\n", material))
        self.assertIn("not drawn: usemtl \"m\" (no material library has that name)", self.said(SQUARE))

    def test_libraries_pictures_and_comments_of_other_programs_are_read(self):
        library = "newmtl m # red\nKd 1 1 1 # white\nmap_Kd maps\\red.bmp\n"
        (self.folder / "maps").mkdir()
        (self.folder / "maps/red.bmp").write_bytes(BMP)
        for line in ("mtllib a.mtl", "mtllib a.mtl b.mtl", "mtllib none.mtl a.mtl # two"):
            said = self.said(f"{line}\n{SQUARE}", a_mtl=library, b_mtl="newmtl n\n")
            self.assertEqual("none.mtl (it does not exist" in said, "none" in line, said)
            self.assertNotIn("usemtl", said)
            self.assertNotIn("red.bmp", said)
        said = self.said(f"mtllib a.mtl\n{SQUARE}", a_mtl="newmtl m\nmap_Kd t.tga\n", t_tga=b"\0\0\2" + b"\0" * 40)
        self.assertIn("t.tga (only PNG, JPEG, PNM and BMP are read)", said)
        self.assertIn("a.mtl (it does not exist", self.said(f"mtllib c d/a.mtl\n{SQUARE}"))


if __name__ == "__main__":
    main()
