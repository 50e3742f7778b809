"""Tests the Python module: state and pictures against the command line's, writing state, errors, several scenes."""
import contextlib
import io
import os
import pathlib
import shutil
import tempfile
import unittest
import warnings

from module_case import CLOTH, DISH, SOURCE, SPARKS, ModuleCase, numpy, picture_of, simreel, with_values


class Pictures(ModuleCase):
    def test_pictures_and_states_are_those_of_render(self):
        states, files = self.rendered()
        scene = self.scene()
        for frame in scene.frames():
            self.assertEqual(frame.state_hash, states[frame.number])
            image = frame.image()
            self.assertEqual((image.shape, image.dtype), ((36, 64, 3), numpy.uint8))
            self.assert_same(numpy.asarray(image), picture_of(files[frame.number]))
        self.assertEqual(frame.number, 5)

    def test_a_camera_that_the_scene_leaves_out_is_placed_as_by_render(self):
        self.write("scene.json", {key: value for key, value in with_values({"version": 2}).items() if key != "camera"})
        states, files = self.rendered()
        scene = self.scene()
        for frame in scene.frames(0, 3):
            pass
        self.assert_same(numpy.asarray(frame.image()), picture_of(files[2]))
        self.assertEqual(scene.step().state_hash, states[3])
        self.assert_same(numpy.asarray(scene.image()), picture_of(files[3]))

    def test_motion_blur_is_that_of_render(self):
        self.write("scene.json", with_values({"camera.shutter": {"samples": 2}}))
        _, files = self.rendered("--frames", "0,3")
        scene = self.scene()
        for number in (0, 3):
            self.assert_same(numpy.asarray(scene.advance_to(number).image()), picture_of(files[number]))

    def test_saved_files_are_those_of_render(self):
        self.good("-q", "render", "scene.json", "-o", "rendered/")
        self.scene().save(self.folder / "saved")
        self.assertEqual(self.content("saved"), self.content("rendered"))
        scene = simreel.Scene(objects={"flag": {"cloth": CLOTH}}, render={"size": [64, 36], "samples": 1})
        self.addCleanup(scene.close)
        scene.save(self.folder / "one.png", 0)
        self.assert_same(picture_of((self.folder / "one.png").read_bytes()), numpy.asarray(scene.image()))

    def test_saving_resumes_writes_layers_and_tells_its_progress(self):
        """Takes 1 s."""
        scene = self.scene()
        scene.save(self.folder / "saved", range(2))
        before = (self.folder / "saved/000000.png").stat().st_mtime_ns
        with contextlib.redirect_stderr(io.StringIO()) as shown:
            scene.save(self.folder / "saved", range(4), resume=True, progress=True)
            with self.assertRaisesRegex(TypeError, "resume is True or False"):
                scene.save(self.folder / "saved", range(4), resume="no")
        self.assertIn("4/4 frames", shown.getvalue())
        self.assertEqual((self.folder / "saved/000000.png").stat().st_mtime_ns, before)
        self.good("-q", "render", "scene.json", "-o", "rendered/", "--frames", "0-3")
        self.assertEqual(self.content("saved"), self.content("rendered"))
        scene.save(self.folder / "saved_#.exr", 0, layers=["normal", "depth"], bits=32)
        self.good("-q", "render", "scene.json", "-o", "rendered_#.exr", "--frames", "0", "--layers", "depth,normal", "--bits", "32", "--no-manifest")
        self.assertEqual((self.folder / "saved_0.exr").read_bytes(), (self.folder / "rendered_0.exr").read_bytes())
        for options, words in (({"layers": ["dept"]}, '"depth"'), ({"bits": 7}, "8, 16 or 32"), ({"fields": "x"}, "^fields: no object")):
            with self.assertRaisesRegex(simreel.Error, words):
                scene.save(self.folder / "wrong.exr", 0, **options)
        self.assertEqual(scene.step().number, 1)

    def test_layers_are_arrays_of_the_picture_s_size(self):
        scene = self.scene(motion=True)
        scene.step(2)
        layers = scene.layers(["depth", "normal", "object", "velocity", "light"])
        self.assertEqual({name: one.shape for name, one in layers.items()},
                         {"depth": (36, 64), "normal": (36, 64, 3), "object": (36, 64), "velocity": (36, 64, 3),
                          "light": (36, 64, 4)})
        seen = layers["object"] == scene.layer_objects.index("flag")
        self.assertTrue(seen.any())
        self.assertTrue(numpy.isfinite(layers["depth"][seen]).all())
        self.assertTrue(numpy.allclose(numpy.linalg.norm(layers["normal"][seen], axis=1), 1, atol=0.1))
        self.assertLess(layers["velocity"][seen][:, 1].mean(), 0)
        with self.assertRaisesRegex(simreel.Error, "there is no layer \"deep\""):
            scene.layers("deep")
        with self.assertRaisesRegex(simreel.Error, "load the scene with motion"):
            self.scene().layers("velocity")

    def test_a_notebook_shows_a_picture(self):
        image = self.scene().image()
        self.assert_same(picture_of(image._repr_png_()), numpy.asarray(image))


class State(ModuleCase):
    def test_arrays_have_natural_shapes_and_units(self):
        flag = self.scene()["flag"]
        self.assertEqual(flag.kind, "cloth")
        self.assertEqual(flag.arrays["positions"], ("m", numpy.dtype("float32"), (7, 9, 3), True))
        self.assertEqual(flag.positions.shape, (7, 9, 3))
        self.assertTrue(numpy.allclose(numpy.diff(flag.positions, axis=1)[..., 0], 0.1, atol=0.05))
        self.write("scene.json", SPARKS)
        self.assertEqual(self.scene()["sparks"].positions.shape[1:], (3,))

    def test_balls_that_roll_have_angular_velocities_and_orientations(self):
        # This test takes 0.5 s.
        ball = {"shape": "ball", "count": 4, "radius": 0.2, "position": [0, 1, 0]}
        with simreel.Scene(objects={"balls": {"particles": {"groups": [ball], "contact": {"rolls": True}}}}, stage=False) as scene:
            balls = scene["balls"]
            count = len(balls.positions)
            self.assertEqual(balls.arrays["spins"], ("rad/s", numpy.dtype("float32"), (count, 3), True))
            self.assertEqual(balls.arrays["turns"][2], (count, 4))  # unit quaternions x, y, z, w
            balls.spins = numpy.tile(numpy.float32([0, 2, 0]), (count, 1))
            turned = scene.step(1)["balls"].turns
            angle = 2 * numpy.arctan2(turned[:, 1], turned[:, 3])
            self.assertTrue(numpy.allclose(angle, 2 / scene.fps, rtol=0.01), angle)

    def test_a_field_is_that_of_render(self):
        self.write("scene.json", DISH)
        self.good("-q", "render", "scene.json", "-o", "rendered/", "--fields", "npy", "--frames", "3")
        scene = self.scene()
        scene.advance_to(3)
        self.assertIn("dish", scene.fields)
        for name in scene.fields:
            self.assert_same(scene.field(name), numpy.load(self.folder / f"rendered/000003.{name}.npy"))

    def test_a_run_goes_on_identically_from_a_written_state(self):
        scene, other = self.scene(), self.scene()
        kept = {name: getattr(scene.step(3)["flag"], name) if i == 0 else getattr(scene["flag"], name)
                for i, name in enumerate(scene["flag"].arrays)}
        snapshot, here = scene.snapshot(), scene.state_hash
        after = scene.step(2).state_hash
        other.step(3)
        for name, values in kept.items():
            setattr(other["flag"], name, values)
        self.assertEqual(other.state_hash, here)
        self.assertEqual(other.step(2).state_hash, after)
        third = self.scene()
        third.restore(snapshot)
        self.assertEqual(third.step(2).state_hash, after)

    def test_written_positions_count(self):
        scene = self.scene()
        flag = scene.step()["flag"]
        raised = flag.positions + numpy.float32([0, 1, 0])
        flag.positions = raised
        self.assert_same(flag.positions, raised)
        before = numpy.array(scene["flag"].positions[0])
        self.assertGreater(scene.step()["flag"].positions[..., 1].mean(), 1)
        self.assertFalse(numpy.array_equal(before, scene["flag"].positions[0]))
        with self.assertRaisesRegex(simreel.Error, "the state was written"):
            next(scene.frames(0, 2))
        with self.assertRaisesRegex(simreel.Error, "begins at the scene's start"):
            scene.save(self.folder / "out")
        scene.restart()
        self.assertEqual(scene.state_hash, self.scene().state_hash)

    def test_arrays_are_read_only_and_change_by_assignment(self):
        scene = self.scene(motion=True)
        flag = scene["flag"]
        arrays = [flag.positions, scene.image(), flag.mesh()["positions"], *scene.layers("depth").values()]
        for array in arrays:
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array[0, 0] = 0
        before = flag.positions
        flag.positions += numpy.float32([0, 1, 0])
        self.assert_same(flag.positions, before + numpy.float32([0, 1, 0]))
        flag.velocities -= 1
        self.assertEqual(set(numpy.unique(flag.velocities)), {-1.0})
        changed = flag.positions.copy()
        changed[0, 0] = 3
        flag.positions = changed
        self.assertEqual(list(flag.positions[0, 0]), [3, 3, 3])

    def test_derived_arrays_are_plain(self):
        for array in (self.scene()["flag"].positions, self.scene().image()):
            for derived in (array[1:3], array[..., 0], array.astype(float), array.copy(), array.T, array + 1, array // 2,
                            array.reshape(-1), array.mean(axis=0), array > 1, numpy.flip(array), numpy.array(array),
                            numpy.concatenate([array, array]), numpy.where(array > 1, array, 0), array.cumsum(axis=0)):
                self.assertIs(type(derived), numpy.ndarray)
            self.assertIsInstance(array.sum(), numpy.number)

    def test_fields_and_particles_can_be_written(self):
        self.write("scene.json", SPARKS)
        sparks = self.scene()["sparks"]
        sparks.velocities = 0
        self.assertFalse(sparks.velocities.any())
        self.write("scene.json", DISH)
        dish = self.scene()["dish"]
        cells = dish.cells
        dish.cells = cells
        self.assert_same(dish.cells, cells)

    def test_every_kind_goes_on_from_what_was_read_and_written(self):
        quick = ("body", "cave", "chart", "cloth", "contour", "epidemic", "isolines", "lenia", "life", "mesh", "particles")
        starters = sorted((SOURCE / "assets/starters").glob("*.json"))
        self.assertGreater(len(starters), 20)
        for file in starters:
            if file.stem not in quick and "SIMREEL_LONG" not in os.environ:
                continue
            with self.subTest(file.stem), simreel.load(file) as one, simreel.load(file) as other:
                here = one.step(2).state_hash
                kept = {(name, array): one[name][array] for name in one
                        for array, (_, _, _, writable) in one[name].arrays.items() if writable}
                for (name, array), values in kept.items():
                    one[name][array] = values
                self.assertEqual(one.state_hash, here)
                self.assertEqual(one.step(2).state_hash, other.step(4).state_hash)

    def test_two_scenes_at_once_go_on_as_each_alone(self):
        self.write("scene.json", DISH)
        dish = self.scene()
        states = [frame.state_hash for frame in dish.frames()]
        pictures = [numpy.asarray(frame.image()) for frame in dish.frames()]
        self.write("scene.json", with_values({}))
        alone = [(frame.state_hash, numpy.asarray(frame.image())) for frame in self.scene().frames()]
        flag = self.scene()
        for i, (one, other) in enumerate(zip(flag.frames(), dish.frames())):
            self.assertEqual((one.state_hash, other.state_hash), (alone[i][0], states[i]))
            self.assert_same(numpy.asarray(one.image()), alone[i][1])
            self.assert_same(numpy.asarray(other.image()), pictures[i])

    def test_a_frame_that_has_passed_is_refused(self):
        first = next(self.scene().frames())
        first._scene.step()
        with self.assertRaisesRegex(simreel.Error, "frame 0 has passed"):
            first["flag"]

    def test_kernels_may_be_text(self):
        scene = simreel.Scene(objects={"life": {"kernels": {
            "source": "#pragma kernel Step\nRWTexture2D<float> _Cells;\n[numthreads(8, 8, 1)]\n"
                      "void Step(uint3 id : SV_DispatchThreadID) { _Cells[id.xy] = _Cells[id.xy] + 1; }\n",
            "textures": {"_Cells": {"size": [16, 8], "format": "r32f"}}, "step": ["Step"],
            "field": {"of": "_Cells", "show": "r"}}}})
        self.addCleanup(scene.close)
        scene.step(3)
        self.assertEqual(set(scene["life"].field().ravel()), {3.0})
        self.assert_same(scene["life"]["_Cells"], scene["life"]._Cells)
        scene["life"]["_Cells"] = 7
        self.assertEqual(set(scene.step()["life"].field().ravel()), {8.0})


class Results(ModuleCase):
    def test_checks_are_those_of_the_scene(self):
        low = {"what": "max", "object": "flag", "of": "positions.y", "frames": [0, 2], "max": 0}
        self.write("scene.json", with_values({"checks": [{"what": "no-nan"}, low]}))
        scene = self.scene()
        scene.step(3)
        results = scene.check([0, 2])
        self.assertEqual({(one["frame"], one["passed"]) for one in results if "positions.y" in one["what"]},
                         {(0, False), (2, False)})
        self.assertTrue(all(one["passed"] for one in results if one["what"].startswith("no-nan")))
        self.assertEqual(scene.frame.number, 3)

    def test_measurements_and_meshes_are_of_the_present_frame(self):
        scene = self.scene()
        flag = scene.step(2)["flag"]
        self.assertTrue(flag.measure())
        self.assertTrue(all(numpy.isfinite(value) for value in flag.measure().values()))
        mesh = flag.mesh()
        self.assert_same(mesh["positions"], flag.positions.reshape(-1, 3))
        self.assertEqual((mesh["triangles"].shape, mesh["triangles"].dtype), ((2 * 6 * 8, 3), numpy.dtype("uint32")))
        self.write("scene.json", SPARKS)
        with self.assertRaisesRegex(simreel.Error, "has no mesh"):
            self.scene()["sparks"].mesh()

    @unittest.skipUnless(shutil.which("ffmpeg"), "no ffmpeg")
    def test_a_video_is_that_of_render_and_shows_itself(self):
        self.good("-q", "render", "scene.json", "-o", "rendered.mp4")
        video = self.scene().video()
        self.assertEqual(video.data, (self.folder / "rendered.mp4").read_bytes())
        self.assertIn("<video", video._repr_html_())


class Errors(ModuleCase):
    def test_an_error_has_its_place_and_a_suggestion(self):
        self.write("scene.json", '{"version": 2,\n "objects": {"flag": {"cloth": {"fabrik": "silk"}}}}')
        with self.assertRaises(simreel.Error) as raised:
            self.scene()
        error = raised.exception
        self.assertEqual((error.kind, error.line, error.column), ("scene", 2, 33))
        self.assertEqual(error.file, str(self.folder / "scene.json"))
        self.assertEqual((error.path, error.suggestion), ("objects.flag.cloth.fabrik", "fabric"))
        self.assertIn("^", str(error))

    def test_an_error_of_a_change_has_its_path(self):
        with self.assertRaises(simreel.Error) as raised:
            self.scene({"objects.flag.cloth.size": [0, 7], "render.sise": [1, 1]})
        self.assertEqual([one.path for one in raised.exception.mistakes], ["objects.flag.cloth.size.0", "render.sise"])
        self.assertIsNone(raised.exception.line)

    def test_a_name_is_that_of_a_shipped_scene(self):
        small = {"render.size": [32, 18]}
        for name in ("flag", "flag.json"):
            with simreel.load(name, small) as scene:
                self.assertEqual(scene.objects["flag"], "cloth")
        with self.assertRaisesRegex(simreel.Error, "there is no scene flga here") as raised:
            simreel.load("flga")
        self.assertEqual((raised.exception.kind, raised.exception.suggestion), ("usage", "flag"))
        printed = self.run_program("render", "flga").stderr.decode()
        self.assertEqual(printed, f"simreel: error: {raised.exception}\n")

    def test_an_error_in_the_text_of_kernels_has_its_path_and_line(self):
        source = "#pragma kernel Step\nRWTexture2D<float> _Cells;\n[numthreads(8, 8, 1)]\n" \
                 "void Step(uint3 id : SV_DispatchThreadID) { _Cells[id.xy] = _Cell[id.xy]; }\n"
        with self.assertRaises(simreel.Error) as raised:
            simreel.Scene(objects={"life": {"kernels": {
                "source": source, "textures": {"_Cells": [16, 8]}, "step": ["Step"]}}})
        error = raised.exception
        self.assertEqual((error.kind, error.path, error.file, error.line),
                         ("scene", "objects.life.kernels.source", None, 4))
        self.assertTrue(str(error).startswith("objects.life.kernels.source:4:"), str(error))

    def test_frames_count_from_zero(self):
        scene = self.scene()
        scene.step(2)
        for use in (lambda: scene.advance_to(-1), lambda: scene.frames(-2, 3), lambda: scene.frames(0, -1),
                    lambda: scene.check([-1]), lambda: scene.save(self.folder / "out", [-1])):
            with self.assertRaisesRegex(simreel.Error, "frames count from 0"):
                use()
        for use in (lambda: scene.step(-1), lambda: scene.frames(3, 0, -1)):
            with self.assertRaisesRegex(simreel.Error, "would go back|go forward"):
                use()
        self.assertEqual(list(scene.frames(5, 3)), [])
        self.assertEqual(scene.frame.number, 2)

    def test_a_picture_is_saved_as_png_only(self):
        image = self.scene().image()
        for name, kind, words in (("x.jpg", "usage", "png"), ("none/x.png", "inputOutput", "cannot write")):
            with self.assertRaisesRegex(simreel.Error, words) as raised:
                image.save(self.folder / name)
            self.assertEqual(raised.exception.kind, kind)
        self.assertFalse((self.folder / "x.jpg").exists())

    def test_files_frames_and_objects_that_cannot_be_are_named(self):
        scene, file = self.scene(), self.folder / "scene.json"
        for use, words in ((lambda: scene.save("-"), 'save\\(\\) writes files, and "-" is none'),
                           (lambda: scene.save("out/", frames=[]), "frames is empty"),
                           (lambda: simreel.load("\udcff.json"), "bytes that are not UTF-8"),
                           (lambda: simreel.load(file, assets=["none"]), r"assets\[0\] none: there is no such folder")):
            with self.assertRaisesRegex(simreel.Error, words):
                use()
        with self.assertRaisesRegex(TypeError, "found by their names, not by 0"):
            scene[0]

    def test_arguments_of_a_wrong_type_are_named(self):
        scene, file = self.scene(), self.folder / "scene.json"
        for use in (lambda: scene.step("x"), lambda: scene.advance_to(1.5), lambda: scene.frames("a"),
                    lambda: scene.layers(3), lambda: scene.layers([3]), lambda: scene.field(3), lambda: scene.restore(3),
                    lambda: scene.check(["a"]), lambda: scene.save(3), lambda: simreel.load(None),
                    lambda: simreel.load(file, [3]), lambda: simreel.load(file, {3: 1}),
                    lambda: simreel.load(file, assets=[3]), lambda: simreel.device(memory_path=3),
                    lambda: scene.image().save(3)):
            with self.assertRaisesRegex(TypeError, "not .") as raised:
                use()
            self.assertNotRegex(str(raised.exception), "_native|arg0")

    def test_a_closed_or_unmade_scene_has_a_text(self):
        scene = self.scene()
        flag, frame = self.scene()["flag"], scene.frame
        self.assertIn("positions", repr(flag))
        flag = scene["flag"]
        scene.close()
        self.assertIn("closed", repr(scene))
        self.assertIn("no state now", repr(flag))
        self.assertIn("Frame 0", repr(frame))
        self.assertIn("not loaded", repr(simreel.Scene.__new__(simreel.Scene)))

    def test_wrong_calls_say_what_there_is(self):
        scene = self.scene()
        for words, wrong in (('no object "flog"', lambda: scene["flog"]),
                             ("is before the current frame", lambda: scene.step(2) and scene.advance_to(1)),
                             ("has the shape", lambda: setattr(scene["flag"], "positions", numpy.zeros((2, 3)))),
                             ("not complex", lambda: setattr(scene["flag"], "positions", numpy.zeros((7, 9, 3), complex))),
                             ("cannot be read|No such file", lambda: simreel.load(self.folder / "none.json"))):
            with self.assertRaisesRegex(simreel.Error, words):
                wrong()
        with self.assertRaisesRegex(AttributeError, 'no array "places"; it has positions, velocities'):
            scene["flag"].places
        scene.close()
        with self.assertRaisesRegex(simreel.Error, "closed"):
            scene.image()

    def test_errors_of_save_name_keyword_arguments(self):
        """Takes 0.3 s."""
        scene = self.scene()
        scene.save(self.folder / "one.png", 0)
        for words, arguments, options in (("frames a: ", ("x/", "a"), {}), ("output .*x.foo: ", ("x.foo",), {}), ("overwrite=True or resume=True", ("one.png", 0), {"overwrite": False}),
                                          ("manifest=False: resume=True", ("x.mp4",), {"resume": True})):
            with self.assertRaisesRegex(simreel.Error, words) as raised:
                scene.save(self.folder / arguments[0] if "/" not in arguments[0] else arguments[0], *arguments[1:], **options)
            self.assertNotIn("--", str(raised.exception))
        with self.assertRaisesRegex(simreel.Error, "port is 0 to 65535, not 70000"):
            scene.serve(port=70000)

    def test_a_change_that_is_not_finite_is_named(self):
        for number in (numpy.nan, float("inf"), [1, float("nan")]):
            with self.assertRaisesRegex(simreel.Error, "the change of time.duration is .*; a scene holds only finite numbers"):
                simreel.load(self.folder / "scene.json", {"time.duration": number})

    def test_numbers_that_are_not_finite_cannot_be_written(self):
        scene = self.scene()
        flag, here = scene.step()["flag"], scene.state_hash
        for number, words in ((numpy.nan, "is NaN"), (-numpy.inf, "is infinite")):
            values = numpy.array(flag.positions)
            values[2, 3, 1] = values[4, 0, 0] = number
            with self.assertRaisesRegex(simreel.Error, rf"flag\.positions\[2, 3, 1\] {words}") as raised:
                flag.positions = values
            self.assertEqual(raised.exception.kind, "usage")
        self.assertEqual(scene.state_hash, here)

    def test_every_use_of_a_lost_state_gives_the_same_error_of_the_device(self):
        scene = self.scene()
        start, flag = scene.snapshot(), scene["flag"]
        second = scene.step().state_hash
        for recover in (scene.restart, lambda: scene.restore(start)):
            flag.velocities = 1e30
            frame, messages = scene.step(), set()
            for use in (lambda: frame.state_hash, lambda: flag.positions, lambda: setattr(flag, "positions", 0),
                        frame.image, scene.snapshot, scene.step, flag.measure, flag.mesh, lambda: scene.layers("depth"),
                        lambda: scene.state_hash):
                with self.assertRaises(simreel.Error) as raised:
                    use()
                messages.add((raised.exception.kind, str(raised.exception)))
            self.assertEqual([(kind, "blew up" in text) for kind, text in messages], [("device", True)])
            recover()
            self.assertEqual(scene.step().state_hash, second)

    def test_calls_after_a_lost_state_give_the_same_error_until_restart_or_restore(self):
        self.write("scene.json", {key: value for key, value in SPARKS.items() if key != "camera"})
        scene = self.scene()
        start = scene.state_hash
        scene.step(3)
        kept, here = scene.snapshot(), scene.state_hash
        scene["sparks"].velocities = 1e30
        scene.step()
        said = set()
        for call in (scene.image, scene.image, lambda: scene["sparks"].positions, scene.step, scene.snapshot,
                     lambda: scene.state_hash, lambda: setattr(scene["sparks"], "positions", 0)):
            with self.assertRaises(simreel.Error) as raised:
                call()
            said.add((raised.exception.kind, str(raised.exception)))
        self.assertEqual([kind for kind, _ in said], ["device"])
        scene.restore(kept)
        self.assertEqual(scene.state_hash, here)
        scene["sparks"].velocities = 1e30
        scene.step()
        scene.restore(kept)
        self.assertEqual(scene.state_hash, here)
        scene.restart()
        self.assertEqual(scene.state_hash, start)

    def test_checks_take_frames_in_any_order_but_none_before_0(self):
        scene = self.scene({"checks": [{"what": "no-nan", "object": "flag"}]})
        self.assertEqual([one["frame"] for one in scene.check((2, 0, 2))], [0, 2])
        for frames in ((-1,), range(0, -3, -1)):
            with self.assertRaisesRegex(simreel.Error, "frames count from 0"):
                scene.check(frames)

    def test_names_and_numbers_that_do_not_fit_are_not_taken(self):
        source = ("#pragma kernel Step\nRWTexture2D<uint> _Cells;\n[numthreads(8, 8, 1)]\n"
                  "void Step(uint3 id : SV_DispatchThreadID) { _Cells[id.xy] = _Cells[id.xy] + 1; }\n")
        things = {"kernels": {"source": source, "textures": {"_Cells": [8, 8]}, "step": ["Step"],
                              "field": {"of": "_Cells"}}}
        name = f"../{self.folder.name}"
        with self.assertRaisesRegex(simreel.Error, "must be 1 to 64 letters"):
            simreel.Scene(objects={name: things})
        self.assertFalse((pathlib.Path(tempfile.gettempdir()) / f"{self.folder.name}.compute").exists())
        scene = simreel.Scene(objects={"life": things})
        self.addCleanup(scene.close)
        cells = next(array for array, one in scene["life"].arrays.items() if one[1].kind == "u")
        for value in (2**40 + 5, -1):
            with self.assertRaisesRegex(simreel.Error, "holds uint32, and -?[0-9]+ does not fit"):
                scene["life"][cells] = value
        with self.assertRaisesRegex(TypeError, r"frames\[0\] is an integer, not 1\.5"):
            scene.save(self.folder / "out", [1.5])
        self.assertEqual(self.scene(assets=str(self.folder))._assets, [str(self.folder)])

    def test_another_device_can_be_opened_when_all_scenes_are_closed(self):
        with self.scene() as scene:
            with self.assertRaisesRegex(simreel.Error, "a process has one device"):
                simreel.device(memory_path="storage")
            states = scene.step(2).state_hash
        simreel.device(memory_path="storage")
        self.assertEqual(self.scene().step(2).state_hash, states)
        self.doCleanups()
        simreel.device()

    def test_warnings_are_python_s(self):
        self.write("scene.json", {"version": 2, "objects": {}})
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            self.scene()
        self.assertIs(caught[0].category, simreel.Warning)
        self.assertIn("no objects", str(caught[0].message))


if __name__ == "__main__":
    unittest.main()
