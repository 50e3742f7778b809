"""Tests `simreel serve`: its pictures equal those of `simreel render` after any change, save, request and stroke."""
import json
import os
import signal
import time
import unittest

from common import PATIENCE, SCENE, with_values
from serve_case import FIELD, ServeCase
from serve_client import Server


class Pictures(ServeCase):
    def test_every_frame_equals_that_of_render(self):
        server = self.serve()
        viewer = server.viewer()
        for frame in (0, 5, 2, 4, 0):
            viewer.send(do="seek", frame=frame)
            self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, frames="0-5"))
        viewer.send(do="play")
        viewer.until(lambda kind, message: kind == "status" and message.get("frame", 0) == 5)
        viewer.send(do="pause")
        viewer.send(do="seek", frame=3)
        self.assertEqual(self.pixels(viewer.rest(3)[1]), self.rendered(3))

    def test_steps_that_follow_each_other_at_once_add_up(self):
        viewer = self.serve().viewer()
        for by in (1, 1, 2, -1):
            viewer.send(do="seek", by=by)
        self.assertEqual(viewer.rest(3)[0]["frame"], 3)
        viewer.send(do="seek", by=2**31 - 1)
        self.assertEqual(viewer.rest(5)[0]["frame"], 5)
        viewer.send(do="seek", by=-2**31)
        viewer.rest(0)

    def test_frames_are_equal_with_little_memory_and_a_late_start(self):
        scene = with_values({"time.start": 0.2, "time.duration": 1, "objects.flag.cloth.size": [300, 200],
                             "objects.flag.cloth.spacing": 0.01, "objects.flag.cloth.substeps": "auto"})
        self.write("scene.json", scene)
        server = self.serve("--memory", "8")
        viewer = server.viewer()
        viewer.send(do="seek", frame=12)
        viewer.rest(12)
        # The message may have arrived already.
        if viewer.latest["status"].get("kept", {}).get("every", 1) <= 1:
            viewer.until(lambda kind, m: kind == "status" and m.get("kept", {}).get("every", 1) > 1)
        self.assertLessEqual(viewer.latest["status"]["kept"]["bytes"], 8 << 20)
        viewer.send(do="seek", frame=7)
        self.assertEqual(self.pixels(viewer.rest(7)[1]), self.rendered(7))

    def test_motion_blur(self):
        self.write("scene.json", with_values({"camera.shutter": {"angle": 300, "samples": 4}}))
        server = self.serve()
        viewer = server.viewer()
        for frame in (3, 0, 1, 0, 4):
            viewer.send(do="seek", frame=frame)
            self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, frames="0-4"), frame)

    def test_an_automatically_placed_camera_equals_that_of_render(self):
        """If the scene does not place the camera and a sheet falls, the camera is always where render places it."""
        self.write("scene.json", {"version": 1, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.4},
                                  "objects": {"sheet": {"cloth": {"size": [9, 9], "pins": []}}, "ball": {"sphere": {"radius": 0.2}}}})
        server = self.serve()
        viewer = server.viewer()
        viewer.send(do="seek", frame=6)
        self.assertEqual(self.pixels(viewer.rest(6)[1]), self.rendered(6))
        given = []
        for path, value in (("objects.sheet.cloth.position", [0.3, 0.5, 0]), ("time.duration", 0.8), ("objects.ball.material", {"color": [0, 0, 1]}),
                            ("objects.sheet.cloth.gravity", [0, -3, 4]), ("render.size", [36, 64]), ("sun", {"intensity": 2})):
            with self.subTest(path):
                for moving in (True, False):
                    viewer.send(do="set", path=path, value=value, moving=moving)
                given += ["-D", f"{path}={json.dumps(value)}"]
                end, right = time.monotonic() + PATIENCE, self.rendered(6, *given)
                while self.pixels(viewer.rest(6)[1]) != right:
                    self.assertLess(time.monotonic(), end, path)

    def test_pictures_after_changed_values_equal_those_of_render(self):
        """Values changed in place, with a new renderer, with a new world or from the start: the picture always equals
        render's."""
        server = self.serve()
        viewer = server.viewer()
        viewer.send(do="seek", frame=3)
        viewer.rest(3)
        changes = [("camera.position", [0.5, 1.2, 2.5]), ("camera.fieldOfView", 30), ("camera.roll", 12),
                   ("sun.direction", [1, 0.4, 0.2]), ("sun.color", [1, 0.2, 0.1]), ("sun.intensity", 9),
                   ("sky.zenith", [0.4, 0, 0.1]), ("sky.ambient", 2), ("render.exposure", 1),
                   ("render.vignette", 0.5), ("sun.shadow", False), ("render.samples", 4), ("render.tone", "agx"),
                   ("ground", {"height": 0.2}), ("ground.color", [0.5, 0.1, 0.1]),
                   ("objects.flag.material", {"color": [0.1, 0.2, 0.9]}), ("lights", {"lamp": {"position": [0, 2, 1], "intensity": 5}}),
                   ("time.duration", 0.4), ("objects.flag.cloth.damping", 3), ("seed", 5)]
        given = []
        for path, value in changes:
            with self.subTest(path):
                for moving in (True, False):
                    viewer.send(do="set", path=path, value=value, moving=moving)
                given += ["-D", f"{path}={json.dumps(value)}"]
                viewer.until(lambda kind, message, p=path, v=value: kind == "refused" or (
                    kind == "scene" and any(at == p and json.loads(text) == v for at, text in message["edits"])))
                self.assertNotIn("refused", viewer.latest, viewer.latest.get("refused"))
                end, right = time.monotonic() + PATIENCE, self.rendered(3, *given)
                while self.pixels(viewer.rest(3)[1]) != right:
                    self.assertLess(time.monotonic(), end, path)
        self.assertEqual(json.loads((self.folder / "scene.json").read_text()), SCENE)


    def test_a_changed_object_moves_the_stage(self):
        """Camera, ground and lamps of a stage depend on the objects."""
        scene = {"version": 1, "render": {"size": [48, 27], "samples": 1}, "objects": {"ball": {"sphere": {"radius": 0.5}}}}
        self.write("scene.json", scene)
        viewer = self.serve().viewer()
        viewer.rest(0)
        viewer.send(do="set", path="objects.ball.sphere.radius", value=0.8, moving=False)
        viewer.until(lambda kind, message: kind == "scene" and message["edits"])
        end, right = time.monotonic() + PATIENCE, self.rendered(0, "-D", "objects.ball.sphere.radius=0.8")
        while self.pixels(viewer.rest(0)[1]) != right:
            self.assertLess(time.monotonic(), end)


class Files(ServeCase):
    def test_saved_scenes_are_shown_and_errors_have_their_position(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        self.write("scene.json", json.dumps(with_values({"sun.intensity": "bright"}), indent=1))
        scene = viewer.until(lambda kind, message: kind == "scene" and message["mistakes"])
        self.assertRegex(scene["mistakes"], r'scene\.json:\d+:\d+: error: .*')
        self.assertIn("^", scene["mistakes"])
        viewer.send(do="seek", frame=2)  # The server continues with the last valid scene.
        self.assertEqual(self.pixels(viewer.rest(2)[1])[:2], (64, 36))
        self.write("scene.json", with_values({"sun.intensity": 1}))
        viewer.until(lambda kind, message: kind == "scene" and not message["mistakes"])
        self.assertEqual(self.pixels(viewer.rest(2)[1]), self.rendered(2))
        os.replace(self.write("other.json", with_values({"sun.intensity": 7})), self.folder / "scene.json")
        self.assertEqual(self.pixels(viewer.rest(2)[1]), self.rendered(2))

    def test_a_scene_that_is_invalid_at_the_start(self):
        self.write("scene.json", "{")
        server = Server(self.folder / "scene.json", cwd=self.folder)
        self.addCleanup(server.stop)
        viewer = server.viewer()
        viewer.until(lambda kind, message: kind == "scene" and "scene.json:1" in message["mistakes"])
        self.write("scene.json", SCENE)
        self.assertEqual(self.pixels(viewer.rest(0)[1]), self.rendered(0))
        self.assertIn("scene.json:1:2: error: ", server.stop()[2])

    def test_a_checkpoint_of_another_simulation_is_named_in_the_terminal(self):
        # This test takes 1 s.
        self.good("render", "scene.json", "-o", "states/", "--frames", "none", "--checkpoint-at", "1")
        server = Server(self.folder / "scene.json", "-D", "seed=9", "--from", "states/checkpoint.000001", cwd=self.folder)
        self.addCleanup(server.stop)
        self.assertIn("cannot begin at checkpoint states/checkpoint.000001: it belongs to another simulation", server.stop()[2])

    def test_edit_changes_only_the_value(self):
        text = ('{\r\n  "version": 1, // the format\n\t"render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30,   "duration": 0.2},\n'
                '  "camera": {"position": [0, 1, 3], /* from the front */ "target": [0, 1, 0]},\n'
                '  "sun": {\n    "shadowSize": 64 // small\n  },\n'
                '  "objects": {"flag": {"cloth": {"size": [9, 7], "spacing": 0.1, "position": [0, 1, 0]}}}\n}\n')
        path = self.write("scene.json", text)
        path.chmod(0o640)
        server = self.serve("--edit")
        viewer = server.viewer()
        viewer.rest(0)

        def saved(request, wanted):
            viewer.send(**request)
            end = time.monotonic() + PATIENCE
            while path.read_bytes().decode() != wanted and time.monotonic() < end:
                time.sleep(0.02)
            self.assertEqual(path.read_bytes().decode(), wanted)

        change = {"do": "set", "moving": False}
        text = text.replace("0.2}", "0.4}")
        saved({**change, "path": "time.duration", "value": 0.4}, text)
        text = text.replace('64 // small\n', '64, // small\n    "intensity": 3\n')
        saved({**change, "path": "sun.intensity", "value": 3}, text)
        text = text.replace('"samples": 1}', '"samples": 1, "exposure": -1}')
        saved({**change, "path": "render.exposure", "value": -1}, text)
        text = text.replace('"position": [0, 1, 0]}}}', '"position": [0, 1, 0], "air": {"drag": 2}}}}')
        saved({**change, "path": "objects.flag.cloth.air.drag", "value": 2}, text)
        text = text.replace("[0, 1, 3]", "[0,1,2]")
        saved({"do": "camera", "position": [0, 1, 2], "target": [0, 1, 0], "moving": False},
              text.replace('"target": [0, 1, 0]}', '"target": [0,1,0], "fieldOfView": 40}'))
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)
        viewer.send(**change, path="sun.intensity", value=-5)
        viewer.until(lambda kind, message: kind == "refused")
        self.assertIn('"intensity": 3', path.read_text())
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["scene.json"])

    def test_the_height_of_an_orthographic_camera_is_set_and_saved(self):
        """The mouse wheel changes the height of an orthographic camera; its positions stay."""
        camera = {"position": [0, 1, 3], "target": [0, 1, 0], "projection": "orthographic", "height": 2}
        self.write("scene.json", with_values({"camera": camera}))
        server = self.serve("--edit")
        viewer = server.viewer()
        self.assertEqual(self.pixels(viewer.rest(0)[1]), self.rendered(0))
        wide = self.rendered(0, "-D", "camera.height=3.5")
        self.assertNotEqual(wide, self.rendered(0))
        viewer.send(do="camera", position=camera["position"], target=camera["target"], height=3.5, moving=False)
        end = time.monotonic() + PATIENCE
        while self.pixels(viewer.rest(0)[1]) != wide:
            self.assertLess(time.monotonic(), end)
        while json.loads((self.folder / "scene.json").read_text())["camera"] == camera:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)
        self.assertEqual(json.loads((self.folder / "scene.json").read_text())["camera"], {**camera, "height": 3.5})

    def test_a_kill_while_saving_leaves_a_whole_file(self):
        filler = "".join(f"// {i:06} {'x' * 60}\n" for i in range(20_000))
        for round_ in range(4):
            path = self.write("scene.json", filler + json.dumps(SCENE))
            server = Server(path, "--edit", cwd=self.folder)
            viewer = server.viewer()
            viewer.rest(0)
            for i in range(12):
                viewer.send(do="set", path="sun.intensity", value=1 + i, moving=False)
            time.sleep(0.05 + 0.1 * round_)
            server.stop(signal.SIGKILL)
            text = path.read_text()
            self.assertTrue(text.startswith(filler))
            found = json.loads(text[len(filler):])
            self.assertIn(found["sun"], [{"shadowSize": 64}] + [{"shadowSize": 64, "intensity": 1 + i} for i in range(12)])

    def test_a_symbolic_link_is_kept(self):
        (self.folder / "real.json").write_text(json.dumps(SCENE))
        (self.folder / "scene.json").unlink()
        (self.folder / "scene.json").symlink_to("real.json")
        server = self.serve("--edit")
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(do="set", path="sun.intensity", value=2, moving=False)
        viewer.until(lambda kind, message: kind == "scene" and message["scene"]["sun"].get("intensity") == 2 and not message["edits"])
        self.assertTrue((self.folder / "scene.json").is_symlink())
        self.assertEqual(json.loads((self.folder / "real.json").read_text())["sun"]["intensity"], 2)


class Questions(ServeCase):
    def test_a_pixel_query_describes_the_object(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(asks="pixel", x=0.5, y=0.6)
        answer = viewer.until(lambda kind, _: kind == "answer")
        self.assertRegex(answer["title"], r"^triangle \d+ of flag$")
        rows = {name: (value, bits) for name, value, bits in answer["rows"]}
        self.assertRegex(rows["nearest element"][0], r"^particle \(\d, \d\)$")
        for axis in "xyz":
            self.assertLess(abs(rows[f"world {axis}, m"][0] - rows[f"positions.{axis}"][0]), 0.1)
            self.assertRegex(rows[f"positions.{axis}"][1], r"^[0-9a-f]{8}$")
        viewer.send(asks="pixel", x=0.01, y=0.01)
        self.assertEqual(viewer.until(lambda kind, _: kind == "answer")["title"], "the sky")


class Painting(ServeCase):
    def test_paint_save_render(self):
        for arguments in ((), ("--edit",)):
            path = self.write("scene.json", FIELD)
            server = self.serve(*arguments)
            viewer = server.viewer()
            viewer.send(do="seek", frame=4)
            before = self.pixels(viewer.rest(4)[1])
            for i in range(3):
                viewer.send(do="paint", **{"from": [0.2 + 0.2 * i, 0.3], "to": [0.4 + 0.2 * i, 0.3]}, radius=3)
            viewer.until(lambda kind, m: kind == "scene" and
                         len(m["scene"]["objects"]["dish"]["grayScott"].get("strokes", [])) == 3 and
                         bool(m["edits"]) != bool(arguments))
            painted = self.pixels(viewer.rest(4)[1])
            given = []
            if arguments:
                self.assertEqual(len(json.loads(path.read_text())["objects"]["dish"]["grayScott"]["strokes"]), 3)
            else:
                self.assertEqual(json.loads(path.read_text()), FIELD)
                given = [word for at, text in viewer.latest["scene"]["edits"] for word in ("-D", f"{at}={text}")]
            self.assertNotEqual(painted, before)
            self.assertEqual(painted, self.rendered(4, *given, frames="2-8"))
            for frame in (8, 2, 6):
                viewer.send(do="seek", frame=frame)
                self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, *given), frame)

    def test_painting_a_scene_without_fields_is_refused(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(do="paint", **{"from": [0.5, 0.5], "to": [0.5, 0.5]}, radius=3)
        viewer.until(lambda kind, _: kind == "refused")


if __name__ == "__main__":
    unittest.main()
