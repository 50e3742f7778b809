"""Tests motion blur and text through the command line: a picture does not depend on which frames are drawn before
it."""
import json
import re

from common import SOURCE, Case, main, png_rows, unfiltered

FALL = {"version": 1, "render": {"size": [96, 54], "samples": 1}, "time": {"fps": 12, "duration": 1},
        "camera": {"position": [0, 0.3, 3], "target": [0, 0, 0], "shutter": {"angle": 360, "samples": 4}},
        "objects": {"sheet": {"cloth": {"size": [7, 9]}},
                    "drops": {"particles": {"emitters": [{"rate": 40, "lifetime": 0.5}], "look": {"shape": "sphere", "size": 0.08}}},
                    "rod": {"capsule": {"rotation": {"keys": [[0, [0, 0, 0]], [1, [0, 0, 300]]]}, "radius": 0.1, "length": 0.8}}}}


def pixels(png):
    width, _, rows = png_rows(png)
    data = b"".join(unfiltered(rows, width * 3, 3))
    return [tuple(data[i:i + 3]) for i in range(0, len(data), 3)]


class Motion(Case):
    def frame(self, folder, number):
        return (self.folder / folder / f"{number:06}.png").read_bytes()

    def test_a_single_frame_equals_that_of_a_sequence(self):
        self.write("scene.json", FALL)
        self.good("render", "scene.json", "-o", "all/", "-q")
        for number in (0, 1, 7):
            self.good("render", "scene.json", "-o", f"one{number}/", "--frames", str(number), "-q")
            self.assertEqual(pixels(self.frame(f"one{number}", number)), pixels(self.frame("all", number)), number)
        self.good("render", "scene.json", "-o", "sharp/", "-D", "camera.shutter=false", "-q")
        # The first frame has no motion blur, because there is no earlier state.
        self.assertEqual(pixels(self.frame("sharp", 0)), pixels(self.frame("all", 0)))
        self.assertNotEqual(pixels(self.frame("sharp", 7)), pixels(self.frame("all", 7)))
        states = [json.loads((self.folder / name / "manifest.json").read_text())["frames"] for name in ("all", "sharp")]
        self.assertEqual([[frame["state"] for frame in one] for one in states][0], [frame["state"] for frame in states[1]])

    def test_motion_blur_is_equal_in_resumed_runs_and_pieces(self):
        self.write("scene.json", FALL)
        self.good("render", "scene.json", "-o", "all/", "-q")
        for number in (5, 6):  # Frame 5 has the state of the checkpoint, and frame 6 is the next one.
            with self.subTest(number):
                self.good("render", "scene.json", "-o", "part/", "--frames", "0-5", "--checkpoint-at", "5", "-q", "--overwrite")
                self.frame("part", number) if number == 5 else None
                (self.folder / "part" / "000005.png").unlink(missing_ok=number == 6)
                self.good("render", "scene.json", "-o", "part/", "--resume", "-q")
                for each in range(12):
                    self.assertEqual(pixels(self.frame("part", each)), pixels(self.frame("all", each)), each)

    def test_motion_blur_is_equal_on_both_memory_paths(self):
        self.write("scene.json", FALL)
        for path in ("texel", "storage"):
            self.good("render", "scene.json", "-o", f"{path}/", "--frames", "7", "--memory-path", path, "-q")
        self.assertEqual(pixels(self.frame("texel", 7)), pixels(self.frame("storage", 7)))


class Track(Case):
    SCENE = {"version": 1, "render": {"size": [97, 55], "transparent": True}, "time": {"fps": 10, "duration": 2},
             "camera": {"position": [0.5, 1, 4], "track": "ball"},
             "objects": {"ball": {"sphere": {"radius": 0.3, "position": {"keys": [[0, [-1, 0, 0]], [2, [1.5, 0.6, -1]]]}}}}}

    def middle(self, *arguments):
        self.good("render", "scene.json", "-o", "a.png", "-q", "--overwrite", *arguments)
        width, height, rows = png_rows((self.folder / "a.png").read_bytes())
        alpha = b"".join(unfiltered(rows, width * 4, 4))[3::4]
        total = sum(alpha)
        return [sum(share * (at % width) for at, share in enumerate(alpha)) / total - (width - 1) / 2,
                sum(share * (at // width) for at, share in enumerate(alpha)) / total - (height - 1) / 2], total

    def test_a_tracked_object_stays_in_the_centre(self):
        self.write("scene.json", self.SCENE)
        orbit = ("-D", "camera={\"track\": \"ball\", \"orbit\": {\"distance\": 4}}")
        sizes = []
        for frame in ("0", "7", "19"):
            for more in ((), orbit, ("-D", "camera.shutter=true")):
                at, size = self.middle("--frames", frame, *more)
                self.assertLess(max(map(abs, at)), 0.5, (frame, more))
                if more == orbit:
                    sizes.append(size)
        # The camera follows the object, so the object's size stays constant.
        self.assertLess(max(sizes) - min(sizes), 0.01 * max(sizes))
        at, _ = self.middle("--frames", "7", "-D", "camera.track={\"object\": \"ball\", \"offset\": [0, 0.3, 0]}")
        self.assertGreater(at[1], 3)  # The camera aims above the object, so the object is lower in the picture.

    def test_simulated_objects_are_tracked(self):
        scene = json.loads(json.dumps(self.SCENE))
        scene["objects"] = {"ball": {"cloth": {"size": [9, 9]}}}
        self.write("scene.json", scene)
        at, _ = self.middle("--frames", "5")
        self.assertLess(max(map(abs, at)), 6)

    def test_a_damped_camera_lags_independently_of_the_selected_frames(self):
        scene = json.loads(json.dumps(self.SCENE))
        scene["objects"] = {"ball": {"cloth": {"size": [9, 9], "pins": []}}}
        scene["camera"] = {"track": {"object": "ball", "damping": 0.1}, "orbit": {"distance": 4}}
        scene["time"] = {"fps": 10, "duration": 1, "start": 0.2}
        self.write("scene.json", scene)
        self.good("render", "scene.json", "-o", "all/", "-q")
        frame = lambda folder, number: png_rows((self.folder / folder / f"{number:06}.png").read_bytes())
        for folder, arguments in (("one", ("--frames", "7")), ("part", ("--frames", "0-3", "--checkpoint-at", "3")),
                                  ("part", ("--resume",))):
            self.good("render", "scene.json", "-o", f"{folder}/", "-q", *arguments)
        self.assertEqual(frame("one", 7), frame("all", 7))
        for number in (0, 4, 9):
            self.assertEqual(frame("part", number), frame("all", number), number)
        # The sheet falls and the camera lags behind, so the tracked object is below the middle of the picture.
        (_, low), _ = self.middle("--frames", "7")
        (_, level), _ = self.middle("--frames", "7", "-D", "camera.track.damping=0")
        self.assertGreater(low, level + 3)

    def test_keyed_targets_and_paths_can_be_damped(self):
        # With damping T, the camera's target lags behind an object in steady motion by the time T, after an initial
        # phase.
        keys = [[0, [-3, 0, 0]], [2, [3, 0, 0]]]
        scene = {**self.SCENE, "camera": {"position": [0, 0, 6], "target": {"keys": keys}, "damping": 0.2},
                 "objects": {"ball": {"sphere": {"radius": 0.3}}}, "time": {"fps": 10, "duration": 2}}
        self.write("scene.json", scene)
        (late, _), _ = self.middle("--frames", "12")
        (same, _), _ = self.middle("--frames", "10", "-D", "camera.damping=0")
        (ahead, _), _ = self.middle("--frames", "12", "-D", "camera.damping=0")
        self.assertLess(abs(late - same), 0.2)
        self.assertGreater(abs(ahead - same), 3)
        self.good("render", "scene.json", "-o", "part/", "-q", "--frames", "0-3", "--checkpoint-at", "3")
        self.good("render", "scene.json", "-o", "part/", "-q", "--resume")
        self.good("render", "scene.json", "-o", "whole/", "-q", "--frames", "15")
        frame = lambda folder: png_rows((self.folder / folder / "000015.png").read_bytes())
        self.assertEqual(frame("part"), frame("whole"))
        self.write("scene.json", {**scene, "camera": {"track": "ball", "damping": 0.2}})
        self.bad_scene("this \"damping\" is only for \"target\"", "render", "scene.json", "-o", "a.png", "--frames", "0")
        flat = {"projection": "orthographic", "height": 3}
        for more, said in (({"fieldOfView": 30}, "an orthographic camera has no angle of view"),
                           ({"lens": True}, "an orthographic camera has no lens"), ({"projection": "perspective"}, "a perspective camera has no height")):
            self.write("scene.json", {**scene, "camera": {**flat, **more}})
            self.bad_scene(said, "render", "scene.json", "-o", "a.png", "--frames", "0")

    def test_mistakes(self):
        self.write("scene.json", {**self.SCENE, "camera": {"track": {"object": "ball", "damping": 1e-5}}})
        self.bad_scene("a damping of 1e-05 s is too short", "render", "scene.json", "-o", "a.png", "--frames", "0")
        self.write("scene.json", {**self.SCENE, "camera": {"track": "bal"}})
        for track in ("bal", {"object": "bal"}):
            self.write("scene.json", {**self.SCENE, "camera": {"track": track}})
            place = self.bad_scene("no object is named \"bal\"; did you mean \"ball\"?", "render", "scene.json", "-o", "a.png", "--frames", "0")
            _, line, caret = place.err.splitlines()
            self.assertEqual(line[caret.index("^"):].rstrip("},"), "\"bal\"")
        for camera, said in (({"track": "ball", "target": [0, 0, 0]}, "\"track\" says what the camera looks at"),
                             ({"track": "ball", "follow": {"object": "ball"}}, "leave out \"track\"")):
            self.write("scene.json", {**self.SCENE, "camera": camera})
            self.bad_scene(said, "render", "scene.json", "-o", "a.png", "--frames", "0")


class Chart(Case):
    SCENE = {"version": 1, "render": {"size": [200, 100], "samples": 1}, "time": {"fps": 10, "duration": 1, "start": 0.2},
             "objects": {"sheet": {"cloth": {"size": [9, 9]}},
                         "curves": {"chart": {"curves": [{"of": "sheet.population", "color": [1, 0, 0]}, {"of": "sheet.kineticEnergy", "color": [0, 0, 1]}],
                                              "low": 0, "high": 162, "seconds": 1, "x": 0.1, "y": 0.1, "width": 0.8, "height": 0.8}}}}

    def test_values_are_drawn_to_scale_up_to_the_current_frame(self):
        self.write("scene.json", self.SCENE)
        self.good("render", "scene.json", "-o", "all/", "--frames", "0,5,9", "-q")
        for frame, share in ((0, 0), (5, 0.5), (9, 0.9)):
            picture = pixels((self.folder / f"all/{frame:06}.png").read_bytes())
            red = [(at % 200, at // 200) for at, (r, g, b) in enumerate(picture) if r > 200 and g < 90 and b < 90 and 30 <= at // 200 <= 72]
            # The plot area spans x from 29 to 171 and y from 30 to 72 in chartLayout(). The curve is at half of its height.
            rows = [y + 0.5 for _, y in red]
            self.assertAlmostEqual(sum(rows) / len(rows), 51, delta=0.6)
            self.assertAlmostEqual(max(x for x, _ in red), 29 + share * 142, delta=3)

    def test_a_chart_does_not_depend_on_the_selected_frames(self):
        scene = json.loads(json.dumps(self.SCENE))
        for end in ("low", "high"):
            del scene["objects"]["curves"]["chart"][end]
        self.write("scene.json", scene)
        self.good("render", "scene.json", "-o", "all/", "-q")
        for folder, arguments in (("one", ("--frames", "7")), ("part", ("--frames", "0-3", "--checkpoint-at", "3")), ("part", ("--resume",))):
            self.good("render", "scene.json", "-o", f"{folder}/", "-q", *arguments)
        for folder, number in (("one", 7), ("part", 0), ("part", 4), ("part", 9)):
            drawn = [pixels((self.folder / each / f"{number:06}.png").read_bytes()) for each in (folder, "all")]
            self.assertEqual(*drawn, (folder, number))


class Text(Case):
    def scene(self, text, **more):
        return {"version": 1, "render": {"size": [97, 55]}, "objects": {"a": {"text": {"text": text, **more}}}}

    def test_text_changes_with_the_frame(self):
        fire = json.loads((SOURCE / "assets/scenes/wildfire.json").read_text())
        name = next(iter(fire["objects"]))
        fire["objects"] = {name: fire["objects"][name]}
        fire["objects"][name]["wildfire"]["display"] = {}
        fire["objects"]["words"] = {"text": {"text": "{frame} {time:1}", "screen": {"height": 0.2}}}
        # Text with the quantity of another object must be drawn like plain text of that number.
        fire["objects"]["count"] = {"text": {"text": f"{{{name}.unburnt:0}}", "screen": {"height": 0.1, "y": 0.6}}}
        fire["test"] = {"frames": [5], "size": [161, 91]}
        fire["checks"] = [{"what": "unburnt", "max": 0}]
        self.write("scene.json", fire)
        drawn = {}
        for frame in (0, 5):
            self.good("render", "scene.json", "-o", "a.png", "--frames", str(frame), "--size", "161x91", "-q", "--overwrite")
            with_text = pixels((self.folder / "a.png").read_bytes())
            self.good("render", "scene.json", "-o", "b.png", "--frames", str(frame), "--size", "161x91", "-q", "--overwrite",
                      "-D", "objects.words.text.text= ")
            drawn[frame] = [at for at, (a, b) in enumerate(zip(with_text, pixels((self.folder / "b.png").read_bytes()))) if a != b]
        self.assertGreater(min(map(len, drawn.values())), 100)
        self.assertNotEqual(drawn[0], drawn[5])
        # The quantity must equal the value that a check measures.
        said = self.run_program("test", "scene.json").stdout.decode()
        count = re.search(r"unburnt[^\n]*?(\d[\d.e+]*)", said)
        self.assertIsNotNone(count, said)
        count = count[1]
        for number, equal in ((str(round(float(count))), True), ("12345", False)):
            self.good("render", "scene.json", "-o", "c.png", "--frames", "5", "--size", "161x91", "-q", "--overwrite",
                      "-D", f"objects.count.text.text=\"{number}\"")
            self.good("render", "scene.json", "-o", "a.png", "--frames", "5", "--size", "161x91", "-q", "--overwrite")
            pictures = [pixels((self.folder / each).read_bytes()) for each in ("a.png", "c.png")]
            self.assertEqual(pictures[0] == pictures[1], equal, number)

    def test_both_rasterizers_draw_the_same_text(self):
        scene = self.scene("same", screen={"height": 0.3, "color": [1, 0, 0]})
        self.write("scene.json", scene)
        found = []
        for rasterizer in ("exact", "driver"):
            self.good("render", "scene.json", "-o", f"{rasterizer}.png", "--frames", "0", "--rasterizer", rasterizer, "-q")
            picture = pixels((self.folder / f"{rasterizer}.png").read_bytes())
            found.append([at for at, color in enumerate(picture) if color == (255, 0, 0)])
        self.assertGreater(len(found[0]), 100)
        self.assertEqual(*found)

    def test_mistakes(self):
        for text, more, said in (("{fame}", {}, "use {frame}, {time} or {OBJECT.QUANTITY}"),
                                 ("{b.energy}", {}, "no object is named \"b\""),
                                 ("{a.energy}", {}, "object \"a\" is a"),
                                 ("{time:33}", {}, "a number of digits"),
                                 ("x", {"height": 1, "screen": {}}, "leave it out with \"screen\""),
                                 ("x", {"font": "no.ttf"}, "no.ttf")):
            with self.subTest(text):
                self.write("scene.json", self.scene(text, **more))
                self.bad_scene(said, "render", "scene.json", "-o", "a.png", "--frames", "0")
        self.write("scene.json", self.scene("\u96ea"))
        self.bad(2, "text \"a\": the font has no \"\u96ea\" (U+96EA)", "render", "scene.json", "-o", "a.png", "--frames", "0")


if __name__ == "__main__":
    main()
