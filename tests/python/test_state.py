"""Tests state arrays of users' kernels, exports to other libraries, and warnings of the Python module."""
import os
import subprocess
import sys
import unittest
import warnings

from module_case import SOURCE, ModuleCase, numpy, simreel

BIRDS = """
#pragma kernel Start
#pragma kernel Fly
struct Bird { float3 position; float3 velocity; uint flock; float weight; };
RWStructuredBuffer<Bird> _Birds;
RWStructuredBuffer<int> _Counts;
RWTexture2D<float2> _Map;
[numthreads(8, 1, 1)]
void Start(uint3 id : SV_DispatchThreadID) { _Birds[id.x].position = float3(id.x, 1, 2); _Birds[id.x].flock = id.x % 3; }
[numthreads(8, 1, 1)]
void Fly(uint3 id : SV_DispatchThreadID) {
    _Birds[id.x].position += _Birds[id.x].velocity;
    _Counts[id.x] -= 1;
    _Map[uint2(id.x % 8, 0)] = float2(id.x, 7);
}
"""


def birds(**more):
    return {"birds": {"kernels": {
        "source": BIRDS, "buffers": {"_Birds": {"size": [16, 2]}, "_Counts": [32]}, "textures": {"_Map": {"size": [8, 4], "format": "rg32f"}},
        "first": [{"kernel": "Start", "threads": 32}], "step": [{"kernel": "Fly", "threads": 32}], "points": {"of": "_Birds", "position": "position"}, **more}}}


class Kernels(ModuleCase):
    def scene(self, **more):
        scene = simreel.Scene(objects=birds(**more), camera={"position": [0, 0, 9], "target": [0, 0, 0]})
        self.addCleanup(scene.close)
        return scene

    def test_structures_and_textures_have_the_shader_s_shapes(self):
        thing = self.scene()["birds"]
        array = thing._Birds
        self.assertEqual(array.shape, (2, 16))
        self.assertEqual(array.dtype.names, ("position", "velocity", "flock", "weight"))
        self.assertEqual(array["position"].shape, (2, 16, 3))
        self.assertEqual(array["position"].ravel()[::3].tolist(), list(range(32)))
        self.assertEqual((array["flock"].dtype, array["flock"][1, 1]), (numpy.uint32, 17 % 3))
        self.assertEqual((thing._Counts.shape, thing._Counts.dtype), ((32, 1), numpy.int32) if thing._Counts.ndim == 2
                         else ((32,), numpy.int32))
        self.assertEqual((thing._Map.shape, thing._Map.dtype), ((4, 8, 2), numpy.float32))

    def test_members_are_written_and_the_run_goes_on_from_them(self):
        scene = self.scene()
        thing = scene["birds"]
        array = thing._Birds.copy()
        array["velocity"] = [0, 0, 5]
        array["flock"] = 9
        thing._Birds = array
        thing._Counts = -7
        values = numpy.arange(64, dtype=numpy.float32).reshape(4, 8, 2)
        thing._Map = values
        self.assert_same(thing._Map, values)
        scene.step(2)
        self.assertEqual(set(thing._Birds["position"][..., 2].ravel()), {12.0})
        self.assertEqual(set(thing._Birds["flock"].ravel()), {9})
        self.assertEqual(set(thing._Counts.ravel()), {-9})
        self.assert_same(thing._Map[1:], values[1:])

    def test_what_was_read_can_be_written_without_a_change(self):
        scene = self.scene()
        scene.step()
        before = scene.state_hash
        for name in scene["birds"].arrays:
            scene["birds"][name] = scene["birds"][name]
        self.assertEqual(scene.state_hash, before)

    def test_values_that_do_not_fit_are_named(self):
        thing = self.scene()["birds"]
        array = thing._Birds.copy()
        with self.assertRaisesRegex(simreel.Error, "_Birds holds structures with the members position, velocity"):
            thing._Birds = numpy.zeros((2, 16))
        array["weight"][1, 3] = numpy.nan
        with self.assertRaisesRegex(simreel.Error, r"birds\._Birds\.weight\[1, 3\] is NaN"):
            thing._Birds = array
        with self.assertRaisesRegex(simreel.Error, r"birds\._Map holds float32, and 1e\+300 does not fit"):
            thing._Map = numpy.full((4, 8, 2), 1e300)
        with self.assertRaisesRegex(simreel.Error, "_Counts holds int32, and 3000000000 does not fit"):
            thing._Counts = 3_000_000_000

    def test_a_constant_beyond_a_float_is_refused(self):
        source = ("#pragma kernel Step\nfloat _Rate;\nRWTexture2D<float> _Cells;\n[numthreads(8, 8, 1)]\n"
                  "void Step(uint3 id : SV_DispatchThreadID) { _Cells[id.xy] += _Rate; }\n")

        def scene(rate, start=0):
            return {"objects": {"a": {"kernels": {
                "source": source, "textures": {"_Cells": {"size": [8, 8], "start": start}}, "step": ["Step"],
                "constants": {"_Rate": rate}, "field": {"of": "_Cells", "show": "r"}}}}}
        with self.assertRaisesRegex(simreel.Error, "up to 3.4e\\+38; found -1e\\+300"):
            simreel.load(scene(-1e300))
        with self.assertRaisesRegex(simreel.Error, "between -1e\\+30 and 1e\\+30, found 1e\\+300"):
            simreel.load(scene({"keys": [[0, 0], [1, 1e300]]}))
        with self.assertRaisesRegex(simreel.Error, "up to 3.4e\\+38; found 1e\\+300"):
            simreel.load(scene(1, 1e300))


class Exports(ModuleCase):
    def test_arrays_are_read_through_dlpack(self):
        positions = self.scene()["flag"].positions
        read = numpy.from_dlpack(positions)
        self.assert_same(read, numpy.asarray(positions))
        image = numpy.from_dlpack(self.scene().image())
        self.assertEqual(image.shape, (36, 64, 3))

    def test_an_export_says_which_path_it_takes(self):
        flag = self.scene()["flag"]
        export = flag.export("positions")
        if export.path == "device":
            self.assertEqual(export.__dlpack_device__()[0], 2)
            return
        self.assertRegex(repr(export), r"on the host \(.+\)")
        self.assertEqual(export.__dlpack_device__(), (1, 0))
        self.assert_same(numpy.from_dlpack(export), numpy.asarray(flag.positions))
        with self.assertRaisesRegex(KeyError, "has no array") as caught:
            flag.export("position")
        self.assertIsInstance(caught.exception, simreel.Error)
        self.assertEqual(caught.exception.suggestion, "positions")
        with self.assertRaisesRegex(simreel.Error, 'has no member "x"'):
            flag.export("positions", "x")

    def test_an_export_on_the_card_has_the_same_numbers(self):
        done = subprocess.run([sys.executable, str(SOURCE / "tools/bench/export"), "--check", str(self.folder / "scene.json")],
                              capture_output=True, text=True, check=False)
        if done.returncode == 77:
            self.skipTest(done.stdout.strip())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class Warnings(ModuleCase):
    def test_a_warning_comes_from_the_line_that_caused_it(self):
        scene = self.warned()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            scene.step(3)
            scene.image()
        self.assertEqual([(one.category, one.filename) for one in caught], [(simreel.Warning, __file__)])
        self.assertIn('writes "_Cells"', str(caught[0].message))

    def test_a_warning_of_drawn_numbers_appears_with_their_picture(self):
        source = ("#pragma kernel Step\nRWTexture2D<float> _Cells;\nfloat _Zero;\n[numthreads(8, 8, 1)]\n"
                  "void Step(uint3 id : SV_DispatchThreadID) { float n = _Cells[id.xy] + 1; _Cells[id.xy] = n > 2.5 ? n / _Zero : n; }\n")
        scene = simreel.Scene(objects={"a": {"kernels": {"source": source, "textures": {"_Cells": [8, 8]}, "step": ["Step"],
                                                         "constants": {"_Zero": 0}, "nonFinite": "warn",
                                                         "field": {"of": "_Cells", "show": "r"}}}})
        self.addCleanup(scene.close)
        for number in range(1, 5):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                scene.step().image()
            self.assertEqual([str(one.message)[:24] for one in caught], ['kernels "a", frame 3: "_'] if number == 3 else [])

    def test_a_warning_that_is_an_error_ends_the_call(self):
        scene = self.warned()
        with warnings.catch_warnings():
            warnings.simplefilter("error", simreel.Warning)
            scene.step(3)
            with self.assertRaisesRegex(simreel.Warning, 'writes "_Cells"'):
                scene.image()
        scene.step()

    def warned(self):
        source = ("#pragma kernel Step\nRWTexture2D<float> _Cells;\n[numthreads(8, 8, 1)]\n"
                  "void Step(uint3 id : SV_DispatchThreadID) { _Cells[id.xy + 4] = 1; }\n")
        scene = simreel.Scene(objects={"a": {"kernels": {"source": source, "textures": {"_Cells": [8, 8]}, "step": ["Step"],
                                                         "field": {"of": "_Cells", "show": "r"},
                                                         "bounds": "ignore"}}})
        self.addCleanup(scene.close)
        return scene


if __name__ == "__main__":
    unittest.main()
