"""Checks overlays, panels, grids that fit the picture, and scenes of one object without keys."""
import json

from common import Case, main, png_rows

BALLS = {"a": {"sphere": {"radius": 0.6}}, "b": {"box": {"position": [1.5, 0, 0]}}}


def grid_of(done):
    """Returns the size that `simreel explain --format json` tells of the object "a"."""
    values = {value["path"]: value for value in json.loads(done.stdout)}
    return next(value for path, value in values.items() if path.startswith("objects.a.") and path.endswith(".size"))


class Views(Case):
    def scene(self, **more):
        self.write("a.json", {"version": 2, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 10, "duration": 0.3},
                              "objects": BALLS, **more})

    def test_a_flag_names_the_overlay_as_the_scene_does(self):
        self.scene()
        self.good("render", "a.json", "-o", "flag/", "--overlay", "objects", "--frames", "0", "-q")
        self.assertEqual(self.manifest("flag")["overrides"], ["render.overlay=objects"])
        self.scene(render={"size": [64, 36], "samples": 1, "overlay": "objects"})
        self.good("render", "a.json", "-o", "key/", "--frames", "0", "-q")
        self.assertEqual(png_rows(self.content("flag")["000000.png"]), png_rows(self.content("key")["000000.png"]))
        self.bad(2, "--overlay", "render", "a.json", "-o", "x/", "--overlay", "uvs")
        self.bad_scene("exact", "render", "a.json", "-o", "x/", "-D", "render.rasterizer=driver")

    def test_panels_resume_and_are_tested(self):
        panels = {"plain": {}, "edges": {"overlay": "wireframe", "view": "right"}, "b": {"objects": ["b"], "caption": ""}}
        self.scene(panels=panels, test={"frames": [0]})
        self.good("render", "a.json", "-o", "all/", "-q")
        whole = self.content("all")
        (self.folder / "all/000002.png").unlink()
        self.good("render", "a.json", "-o", "all/", "--resume", "-q")
        self.assertEqual(self.content("all")["000002.png"], whole["000002.png"])
        self.assert_manifest_is_whole("all")
        self.good("render", "a.json", "-o", "pieces/", "--pieces", "2", "-q")
        self.assertEqual(self.content("pieces")["000002.png"], whole["000002.png"])
        self.good("test", "a.json", "--update", "--repeat", "1")
        self.good("test", "a.json", "--repeat", "1")
        self.scene(panels={**panels, "edges": {"view": "left"}}, test={"frames": [0]})
        self.assertEqual(self.run_program("test", "a.json", "--repeat", "1").returncode, 1)

    def test_mistakes_of_panels(self):
        self.scene(panels={"p": {"objects": ["c"]}})
        self.bad_scene('no object is named "c"', "render", "a.json", "-o", "x/")
        self.scene(panels={"p": {"camera": {"target": [0, 0, 0]}}})
        self.bad_scene("a panel's camera stands at", "render", "a.json", "-o", "x/")
        self.scene(panels={"p": {"caption": "\u65e5"}})
        self.bad(2, 'the font has no "\u65e5"', "render", "a.json", "-o", "x/")
        self.scene(panels={"p": {"caption": 70 * "a"}})
        self.bad_scene("the caption has 70 bytes; at most 64 fit", "render", "a.json", "-o", "x/")
        self.scene(panels={"p": "top"})
        self.bad(2, "panels=null", "render", "a.json", "-o", "x_####.exr", "--frames", "0")

    def test_default_grids_have_the_aspect_ratio_of_the_picture(self):
        for kind in ("life", "grayScott", "reaction", "lenia", "fluid", "epidemic", "wildfire"):
            for size in ([640, 360], [90, 160]):
                self.write("a.json", {"version": 2, "render": {"size": size}, "objects": {"a": {kind: {}}}})
                told = grid_of(self.good("explain", "a.json", "--format", "json"))
                width, height = told["value"]
                self.assertEqual(width * size[1], height * size[0], (kind, told))
        self.write("a.json", {"version": 1, "objects": {"a": {"life": {}}}})
        self.assertEqual(grid_of(self.good("explain", "a.json", "--format", "json"))["value"], [512, 512])

    def test_kinds_without_keys_are_drawn(self):
        for kind in ("particles", "reaction", "epidemic", "wildfire", "mesh"):
            self.write("a.json", {"version": 2, "objects": {"a": {kind: {}}}})
            self.good("validate", "a.json")
            if kind != "mesh":
                self.bad(2, "", "validate", "a.json", "-D", "version=1")


if __name__ == "__main__":
    main()
