"""Tests meshes given as scenes, and files that mesh files refer to: pictures, libraries, unsupported features."""
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

    def test_unsupported_mesh_formats_are_refused(self):
        self.write("m.stl", "solid\n")
        self.bad(2, ["m.stl is a mesh, not a scene, and of a format that is not read"], "render", "m.stl", "-o", "out/")

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
            self.assertEqual("none.mtl (it is not there" in said, "none" in line, said)
            self.assertNotIn("usemtl", said)
            self.assertNotIn("red.bmp", said)
        said = self.said(f"mtllib a.mtl\n{SQUARE}", a_mtl="newmtl m\nmap_Kd t.tga\n", t_tga=b"\0\0\2" + b"\0" * 40)
        self.assertIn("t.tga (it is none of PNG, JPEG, PNM and BMP)", said)
        self.assertIn("a.mtl (it is not there", self.said(f"mtllib c d/a.mtl\n{SQUARE}"))


if __name__ == "__main__":
    main()
