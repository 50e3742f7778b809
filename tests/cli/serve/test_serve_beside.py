"""Tests `simreel serve` with two sides in step, and changes of a simulation that keep as many frames as possible: every
picture equals that of `simreel render` with the values of its side."""
import json
import os
import unittest

from common import PROGRAM, SCENE, with_values
from serve_client import Server, files_of
from serve_case import FIELD, ServeCase

os.environ.setdefault("SIMREEL", PROGRAM)
DAMPING = "objects.flag.cloth.damping"


class TwoSides(ServeCase):
    def sides(self, viewer, frame):
        picture = viewer.rest(frame)
        self.assertIn("beside", picture[0])
        return [self.pixels(file) for file in files_of(picture)]

    def shows(self, viewer, frame, left, right, file="scene.json", frames=None):
        """Waits until both sides' pictures of the frame equal those of render with these values."""
        wanted = [self.rendered(frame, *left, frames=frames), self.rendered(frame, *right, file=file, frames=frames)]
        while (found := self.sides(viewer, frame))[:2] != wanted:
            pass  # The loop ends at the latest when rest() times out.
        self.assertEqual(viewer.pictures[-1][0]["beside"]["different"], self.differing(*wanted))
        return found

    def differing(self, a, b):
        if a[:2] != b[:2]:
            return None
        step = len(a[2]) // (a[0] * a[1])
        return sum(a[2][i:i + step] != b[2][i:i + step] for i in range(0, len(a[2]), step))

    def in_step(self, viewer):
        """Checks that every picture contains both sides from the moment when the second side was ready."""
        both = ["beside" in about for about, _ in viewer.pictures]
        self.assertEqual(both, sorted(both))

    def test_one_scene_with_two_values(self):
        left, right = ["-D", "sun.intensity=2"], ["-D", "sun.intensity=2", "-D", f"{DAMPING}=3"]
        server = self.serve(*left, "--beside", f"{DAMPING}=3")
        viewer = server.viewer()
        for frame in (0, 5, 2):
            viewer.send(do="seek", frame=frame)
            self.shows(viewer, frame, left, right, frames="0-5")
        self.assertGreater(viewer.pictures[-1][0]["beside"]["different"], 0)
        # A change of a value that both sides have, including the mouse's camera, affects both sides. Values that are
        # set only on the right side take precedence there.
        viewer.send(do="camera", position=[0.5, 1, 3], target=[0, 1, 0])
        viewer.send(do="set", path="camera.fieldOfView", value=30)
        view = ["-D", "camera.position=[0.5,1,3]", "-D", "camera.target=[0,1,0]", "-D", "camera.fieldOfView=30"]
        viewer.until(lambda kind, m: kind == "scene" and len(m["edits"]) == 3)
        self.shows(viewer, 2, left + view, right + view)
        viewer.send(do="set", path=DAMPING, value=1)
        self.shows(viewer, 2, left + view + ["-D", f"{DAMPING}=1"], right + view)
        self.assertEqual(viewer.latest["scene"]["beside"]["edits"], [[DAMPING, "3"]])
        self.in_step(viewer)

    def test_a_wrong_value_of_the_right_side_is_named_in_the_terminal(self):
        """Takes 1 s."""
        server = Server(self.folder / "scene.json", "--beside", "objects.flag.cloth.dampling=3", cwd=self.folder)
        self.addCleanup(server.stop)
        self.assertIn('--beside objects.flag.cloth.dampling=3: error: unknown key "dampling"; did you mean "damping"?', server.stop()[2])

    def test_both_sides_stay_in_step_while_they_play(self):
        server = self.serve("--beside", "objects.flag.cloth.substeps=200")
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(do="play")
        viewer.until(lambda kind, m: kind == "picture" and m[0]["frame"] == 5)
        viewer.send(do="pause")
        viewer.send(do="seek", frame=3, moving=True)
        self.shows(viewer, 3, [], ["-D", "objects.flag.cloth.substeps=200"])
        self.in_step(viewer)
        self.assertTrue(all(len(about["files"]) == 2 for about, _ in viewer.pictures))

    def test_the_page_turns_the_second_side_on(self):
        server = self.serve("--edit")
        viewer = server.viewer()
        viewer.send(do="seek", frame=4)
        viewer.rest(4)
        viewer.send(do="beside", on=True, difference=True)
        self.shows(viewer, 4, [], [])
        self.assertEqual(viewer.pictures[-1][0]["beside"]["different"], 0)
        for moving in (True, False):
            viewer.send(do="set", path="sun.intensity", value=9, moving=moving, beside=True)
        files = self.shows(viewer, 4, [], ["-D", "sun.intensity=9"])
        self.assertEqual(files[2][:2], (64, 36))  # The third picture is the difference.
        self.assertGreater(viewer.pictures[-1][0]["beside"]["different"], 50)
        viewer.send(do="set", path=DAMPING, value=4, beside=True)
        self.shows(viewer, 4, [], ["-D", "sun.intensity=9", "-D", f"{DAMPING}=4"])
        viewer.send(do="set", path=DAMPING, value="much", beside=True)
        self.assertIn("damping", viewer.until(lambda kind, _: kind == "refused")["text"])
        self.shows(viewer, 4, [], ["-D", "sun.intensity=9", "-D", f"{DAMPING}=4"])
        viewer.send(do="forget", path=DAMPING, beside=True)
        self.shows(viewer, 4, [], ["-D", "sun.intensity=9"])
        self.assertIn("-D sun.intensity=9", viewer.latest["scene"]["beside"]["command"])
        viewer.send(do="beside", on=False)
        while "beside" in viewer.rest(4)[0]:
            pass
        # Changes on the right side are not written to the file.
        self.assertEqual(json.loads((self.folder / "scene.json").read_text()), SCENE)

    def test_two_scenes(self):
        other = with_values({"camera.position": [1, 1, 2], "time.duration": 0.1, "render.size": [48, 40], DAMPING: 2})
        self.write("other.json", other)
        server = self.serve("other.json", "--beside", "sun.intensity=1")
        viewer = server.viewer()
        viewer.send(do="seek", frame=5)
        # Both sides run up to the shorter duration.
        self.shows(viewer, 2, [], ["-D", "sun.intensity=1"], file="other.json")
        self.assertIsNone(viewer.pictures[-1][0]["beside"]["different"])
        viewer.send(do="camera", position=[0, 1, 4], target=[0, 1, 0], beside={"position": [2, 1, 2], "target": [0, 1, 0]})
        view = ["-D", "camera.target=[0,1,0]", "-D", "camera.fieldOfView=40"]
        viewer.until(lambda kind, m: kind == "scene" and m["edits"])
        self.shows(viewer, 2, ["-D", "camera.position=[0,1,4]", *view],
                   ["-D", "sun.intensity=1", "-D", "camera.position=[2,1,2]", *view], file="other.json")
        self.write("other.json", "{")  # The last valid scene remains, and the error is reported.
        viewer.until(lambda kind, m: kind == "scene" and "other.json:1" in m["beside"]["mistakes"])
        self.write("other.json", {**other, "ground": {"height": 0.2}})
        viewer.until(lambda kind, m: kind == "scene" and not m["beside"]["mistakes"])
        self.shows(viewer, 2, ["-D", "camera.position=[0,1,4]", *view],
                   ["-D", "sun.intensity=1", "-D", "camera.position=[2,1,2]", *view], file="other.json")
        self.assertEqual(self.run_program("serve", "scene.json", "none.json").returncode, 2)


class Changes(ServeCase):
    """Tests changes of a simulation: frames before the change are kept; if no frame is known to be unaffected, the
    simulation runs again to the displayed frame."""

    def change(self, viewer, frame, edits, most):
        """Sets these values at once; checks that only pictures of that frame arrive and that at most `most` frames are
        simulated."""
        before = viewer.pictures[-1][0]["stepped"]
        for path, value in edits.items():
            viewer.send(do="set", path=path, value=value)
        viewer.until(lambda kind, m: kind == "scene" and {path for path, _ in m["edits"]} >= set(edits))
        given = [word for path, value in viewer.latest["scene"]["edits"] for word in ("-D", f"{path}={value}")]
        wanted = self.rendered(frame, *given)
        while self.pixels(viewer.rest()[1]) != wanted:
            self.assertEqual(viewer.pictures[-1][0]["frame"], frame)
        self.assertLessEqual(viewer.pictures[-1][0]["stepped"] - before, most, edits)

    def test_changed_keys_and_strokes_keep_earlier_states(self):
        feed, strokes = "objects.dish.grayScott.feed", "objects.dish.grayScott.strokes"
        scene = with_values({feed: {"keys": [[0, 0.03], [0.2, 0.03], [0.3, 0.05]]},
                             strokes: [{"at": 0.1, "from": [20, 20, 0], "radius": 4}]}, FIELD)
        self.write("scene.json", scene)
        server = self.serve()
        viewer = server.viewer()
        for frame in range(0, 12, 11):
            viewer.send(do="seek", frame=frame)
            viewer.rest(frame)
        self.change(viewer, 11, {f"{feed}.keys": [[0, 0.03], [0.2, 0.03], [0.3, 0.02]]}, 6)
        self.change(viewer, 11, {strokes: scene["objects"]["dish"]["grayScott"]["strokes"] +
                                 [{"at": 0.3, "from": [40, 30, 0], "radius": 6}]}, 3)
        self.change(viewer, 11, {strokes: [{"at": 0.1, "from": [20, 20, 0], "radius": 5}]}, 9)
        self.change(viewer, 11, {"objects.dish.grayScott.kill": 0.061}, 12)
        for frame in (1, 7, 3, 10):
            viewer.send(do="seek", frame=frame)
            given = [word for path, value in viewer.latest["scene"]["edits"] for word in ("-D", f"{path}={value}")]
            self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, *given, frames="1-10"), frame)

    def test_a_first_stroke_restarts_a_fluid(self):
        """Without strokes before, the fluid is simulated again from the start."""
        self.write("scene.json", {**FIELD, "objects": {"pool": {"fluid": {"size": [32, 32], "sides": {"left": {"velocity": [1, 0, 0]}}}}}})
        server = self.serve()
        viewer = server.viewer()
        viewer.send(do="seek", frame=6)
        viewer.rest(6)
        self.change(viewer, 6, {"objects.pool.fluid.strokes": [{"at": 0.1, "from": [16, 16, 0], "radius": 5, "dye": [1, 0, 0]}]}, 7)

    def test_undoing_a_change_needs_no_steps(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.send(do="seek", frame=5)
        before = viewer.rest(5)[1]
        self.change(viewer, 5, {DAMPING: 3}, 6)
        stepped = viewer.pictures[-1][0]["stepped"]
        viewer.send(do="forget")
        while viewer.rest(5)[1] != before:
            pass
        self.assertEqual(viewer.pictures[-1][0]["stepped"], stepped)

    def test_display_changes_do_not_restart_the_simulation(self):
        scene = with_values({"ground": {"height": -1, "color": [0.2, 0.2, 0.2]},
                             "objects.dish.grayScott.display": {"extent": [0.5, 1, 0]}}, FIELD)
        self.write("scene.json", scene)
        server = self.serve()
        viewer = server.viewer()
        viewer.send(do="seek", frame=6)
        viewer.rest(6)
        for edits in ({"ground.color": [0.5, 0.1, 0.1]}, {"ground.roughness": 0.2}, {"objects.dish.grayScott.display.extent": [0.4, 0.5, 0]},
                      {"objects.dish.grayScott.display.opacity": 0.5}):
            self.change(viewer, 6, edits, 0)


if __name__ == "__main__":
    unittest.main()
