"""Tests cameras without a position in the scene, if the visible content is known only after a run: a first run places
them."""
import shlex

from common import Case, main


class Framing(Case):
    # The sheet falls over a sphere. The scene has its own sky, so there is no stage.
    SCENE = {"version": 1, "sky": {}, "time": {"duration": 0.5}, "render": {"size": [64, 36]},
             "objects": {"sheet": {"cloth": {"size": [12, 12], "pins": [], "position": [0, 1.5, 0]}}, "ball": {"sphere": {"radius": 0.4}}}}

    def render(self, output, *more, scene="scene.json"):
        return self.good("render", scene, "-o", output, *more).err

    def test_the_camera_does_not_depend_on_the_selected_frames(self):
        self.write("scene.json", self.SCENE)
        said = self.render("all/", "--frames", "0-12")
        self.assertEqual(said.count("a first run of 30 frames placed the camera; to keep it there: -D 'camera.position="), 1)
        self.render("one/", "--frames", "10")
        picture = (self.folder / "all/000010.png").read_bytes()
        self.assertEqual((self.folder / "one/000010.png").read_bytes(), picture)
        (self.folder / "all/000010.png").unlink()
        self.render("all/", "--frames", "0-12", "--resume")
        self.assertEqual((self.folder / "all/000010.png").read_bytes(), picture)
        self.assertEqual(self.render("quiet/", "--frames", "10", "-q"), "")

    def test_both_memory_paths_place_the_same_camera(self):
        self.write("scene.json", {**self.SCENE, "objects": {**self.SCENE["objects"], "jet": {"particles": {"emitters": [{"rate": 300}]}}}})
        found = []
        for path in ("texel", "storage"):
            self.render(f"{path}/", "--frames", "10", "--memory-path", path)
            manifest = self.manifest(path)
            found.append((manifest["camera"], manifest["frames"][0]["pixels"]))
        self.assertEqual(found[0], found[1])

    def test_the_printed_override_keeps_the_camera_there(self):
        stage = {key: value for key, value in self.SCENE.items() if key != "sky"}
        # The sheet is so small that the camera would be closer than its minimum distance.
        far = {"sheet": {"cloth": {"size": [12, 12], "spacing": 0.004, "pins": []}}}
        for name, scene in ("sky", self.SCENE), ("stage", stage), ("small", {**stage, "objects": far}):
            with self.subTest(name):
                self.write("scene.json", scene)
                said = self.render(f"{name}/found/", "--frames", "10")
                words = shlex.split(said.split("to keep it there: ")[1].splitlines()[0])
                kept = self.render(f"{name}/kept/", "--frames", "10", *words)
                self.assertNotIn("first run", kept)
                found = self.manifest(f"{name}/found")
                self.assertEqual(found["camera"], words[1::2])
                again = self.manifest(f"{name}/kept")
                self.assertNotIn("camera", again)
                self.assertEqual(again["frames"][0]["pixels"], found["frames"][0]["pixels"])

    def test_a_large_scene_is_framed_by_its_parameters_with_a_message(self):
        self.write("scene.json", {**self.SCENE, "objects": {"sheet": {"cloth": {"size": [400, 400]}}}, "time": {"duration": 5}})
        said = self.render("a/", "--frames", "0")
        self.assertEqual(said.count("a first run to measure the motion would take too long; give \"camera\""), 1)
        self.assertNotIn("camera", self.manifest("a"))


if __name__ == "__main__":
    main()
