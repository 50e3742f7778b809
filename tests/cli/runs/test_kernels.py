"""Tests simreel kernels and scenes that run a user's compute shaders."""
import json
import signal
import struct

from common import Case, main, png_rows

BLUR = """#pragma kernel Blur
RWStructuredBuffer<float> _Data;
float _Share;
[numthreads(8, 1, 1)]
void Blur(uint3 id : SV_DispatchThreadID)
{
    float left = _Data[id.x == 0 ? 0 : id.x - 1];
    _Data[id.x] = lerp(_Data[id.x], left, _Share);
}
"""


class Kernels(Case):
    def scene(self, shader=BLUR, **more):
        (self.folder / "a.compute").write_text(shader)
        kernels = {"file": "a.compute", "buffers": {"_Data": {"size": 32, "start": "i^2"}}, "constants": {"_Share": 0.5}, **more}
        scene = {"version": 1, "render": {"size": [64, 36]}, "objects": {"k": {"kernels": kernels}}}
        (self.folder / "k.json").write_text(json.dumps(scene))

    def test_printed_scenes_are_accepted(self):
        for shader in (
            # The first kernel processes rows, and writes a texture and a buffer. The second has workgroups in two axes,
            # and writes a buffer.
            "RWStructuredBuffer<float> _Sum; RWTexture2D<float4> _Seen; [numthreads(64, 1, 1)] void A(uint3 id : SV_DispatchThreadID) { _Sum[id.x] = 1; _Seen[id.xy] = 1; }",
            "RWStructuredBuffer<float> _Sum; Texture2D<float4> _Seen; [numthreads(8, 8, 1)] void A(uint3 id : SV_DispatchThreadID) { _Sum[id.x] = _Seen[id.xy].x; }",
            "RWStructuredBuffer<float> _Sum; [numthreads(8, 8, 1)] void A(uint3 id : SV_DispatchThreadID) { _Sum[id.x] = 1; }",
            # The constants are in structs and arrays.
            "struct Light { float3 at; float4x4 view; }; cbuffer Given { Light light; float4 planes[6]; float deltaT; }; RWStructuredBuffer<float4> _Sum;"
            "[numthreads(8, 1, 1)] void A(uint3 id : SV_DispatchThreadID) { _Sum[id.x] = mul(light.view, float4(light.at, 1)) + planes[id.x % 6] * deltaT; }",
        ):
            (self.folder / "a.compute").write_text("#pragma kernel A\n" + shader + "\n")
            (self.folder / "k.json").write_bytes(self.good("kernels", "a.compute", "--scene").stdout)
            self.good("validate", "k.json")

    def test_constants_of_a_printed_scene_have_the_sizes_that_it_chooses(self):
        # This test takes 0.3 s.
        def printed(shader):
            (self.folder / "a.compute").write_text("#pragma kernel A\n" + shader)
            return json.loads(self.good("kernels", "a.compute", "--scene").stdout)["objects"]["mine"]["kernels"]

        seen = printed("RWTexture2D<float4> _Seen; StructuredBuffer<float2> _Agents; uint _NumAgents, _W, _H; float _Resolution, _LineWidth; int2 _Size; float4 _Seen_TexelSize; float3 _gridSize;"
                       "[numthreads(8, 8, 1)] void A(uint3 id : SV_DispatchThreadID) { if (id.x < _W && id.y < _H) _Seen[id.xy] = _Agents[id.x % _NumAgents].x * _Resolution + _Size.x + _Seen_TexelSize + _LineWidth + _gridSize.x; }")
        self.assertEqual(seen["constants"], {
            "_NumAgents": "count(_Agents)", "_W": "width(_Seen)", "_H": "height(_Seen)", "_Resolution": "width(_Seen)", "_LineWidth": 1, "_Size": ["width(_Seen)", "height(_Seen)"],
            "_Seen_TexelSize": ["1 / width(_Seen)", "1 / height(_Seen)", "width(_Seen)", "height(_Seen)"], "_gridSize": ["width(_Seen)", "height(_Seen)", "depth(_Seen)"]})
        cloth = printed("struct P { float3 position; float mass; }; RWStructuredBuffer<P> _Cloth; uint _ClothWidth, _ClothHeight;"
                        "[numthreads(8, 8, 1)] void A(uint3 id : SV_DispatchThreadID) { if (id.x < _ClothWidth && id.y < _ClothHeight) _Cloth[id.y * _ClothWidth + id.x].mass = 1; }")
        self.assertEqual(cloth["buffers"]["_Cloth"]["size"], [32, 32])
        self.assertEqual(cloth["constants"], {"_ClothWidth": "width(_Cloth)", "_ClothHeight": "height(_Cloth)"})
        self.assertEqual(cloth["step"], ["A"])

    def test_drawn_numbers_that_are_not_finite_are_told(self):
        # This test takes 2 s.
        shader = """#pragma kernel A
struct P { float3 pos; float life; };
RWStructuredBuffer<P> _P; RWTexture2D<float4> _H; float _T;
[numthreads(8, 4, 1)] void A(uint3 id : SV_DispatchThreadID) {
    _P[id.x + 8 * id.y].pos.y = sqrt(3 - _T * id.x);
    _H[id.xy] = 1 / (_T - id.x);
}
"""
        def scene(version, **more):
            self.scene(shader, buffers={"_P": {"size": [8, 4], "start": {"pos": ["x", 0, "y"], "life": "if(x == 7, 0, 1)"}}}, textures={"_H": [8, 4]}, constants={"_T": "frame"}, **more)
            path = self.folder / "k.json"
            path.write_text(path.read_text().replace('"version": 1', f'"version": {version}'))

        what = 'kernels "k", frame {}: "_P.pos" is NaN or infinite in {} of 32 elements (the first is {}), which "{}" draws; '
        surface = {"surface": {"of": "_P", "position": "pos"}}
        scene(2, **surface)
        self.bad(4, what.format(2, 16, "(4, 0)", "surface"), "trace", "k.json", "--frames", "0-3")
        scene(2, points={"of": "_P", "position": "pos", "alive": "life"})
        self.bad(4, what.format(2, 12, "(4, 0)", "points"), "trace", "k.json", "--frames", "0-3")
        scene(2, terrain={"of": "_H"})
        self.bad(4, 'frame 1: "_H" is NaN or infinite in 4 of 32 texels (the first is (0, 0)), which "terrain" draws', "trace", "k.json", "--frames", "0-3")
        scene(1, **surface)
        self.assertIn("warning: " + what.format(2, 16, "(4, 0)", "surface"), self.good("trace", "k.json", "--frames", "0-3").err)
        scene(2, nonFinite="ignore", **surface)
        self.assertNotIn("NaN", self.good("trace", "k.json", "--frames", "0-3").err)

    def test_the_printed_scene_runs(self):
        (self.folder / "a.compute").write_text(BLUR)
        printed = self.good("kernels", "a.compute", "--scene").stdout
        (self.folder / "k.json").write_bytes(printed)
        self.good("validate", "k.json")
        self.good("render", "k.json", "-o", "out/", "--frames", "0-1", "--size", "64x36")

    def test_compiled_shaders_are_cached(self):
        env = {"XDG_CACHE_HOME": str(self.folder / "cache")}
        self.scene()
        self.good("validate", "k.json", env=env)
        entries = list((self.folder / "cache/simreel").glob("*.kernel"))
        self.assertEqual(len(entries), 1)
        for text in (entries[0].read_text(), "{}", "\0damaged"):
            entries[0].write_text(text)
            self.good("validate", "k.json", env=env)
        # A changed file must be compiled again.
        self.scene(BLUR.replace("lerp(", "lrp("))
        self.bad(2, "a.compute:8:19: error: ", "validate", "k.json", env=env)

    def test_a_cube_map_is_read_by_a_direction_across_its_edges(self):
        # Texel (x, y) of face z has the value x + 10 y + 100 z. The directions point to the middle of two texels, to an
        # edge between +x and +z, and near a texel's centre.
        shader = """#pragma kernel K
TextureCube<float4> _Sky; SamplerState sampler_linear_clamp, sampler_point_clamp; RWTexture2D<float> _Out;
[numthreads(1, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {
    uint w, h;
    _Sky.GetDimensions(w, h);
    _Out[uint2(0, 0)] = _Sky.SampleLevel(sampler_linear_clamp, float3(2, 0.5, 0), 0).r;
    _Out[uint2(1, 0)] = _Sky.SampleLevel(sampler_linear_clamp, float3(1, -0.25, 1), 0).r;
    _Out[uint2(2, 0)] = _Sky.SampleLevel(sampler_point_clamp, float3(0.3, -0.22, -0.4), 0).r;
    _Out[uint2(3, 0)] = _Sky.SampleLevel(sampler_point_clamp, float3(-0.1, -3, 0.8), 0).r;
    _Out[uint2(4, 0)] = w + 10*h;
}
"""
        sky = {"size": [4, 4], "start": {"r": "x + 10*y + 100*z"}}
        for numerics in ({}, {"fast": True}):
            self.scene(shader, buffers={}, textures={"_Sky": sky, "_Out": {"size": [5, 1], "format": "r32f"}}, constants={},
                       step=[{"kernel": "K", "threads": [1]}], field={"of": "_Out", "show": "r"}, **numerics)
            self.good("bake", "k.json", "-o", "out", "--format", "npy", "--frames", "1", "--overwrite")
            values = struct.unpack("<5f", (self.folder / "out/k_000001.npy").read_bytes()[-20:])
            for value, right in zip(values, (11.5, 221.5, 530, 311, 44)):
                self.assertAlmostEqual(value, right, places=3)
        self.scene(shader, buffers={}, textures={"_Sky": {"size": [4, 8]}, "_Out": [5, 1]}, constants={})
        self.bad(2, "the faces of a cube are squares, found 4 x 8", "validate", "k.json")

    def test_an_array_of_textures_is_refused(self):
        # Arrays of textures are refused, because a scene would set only the first texture.
        self.scene("#pragma kernel K\nTexture2D<float4> _Seen[3]; RWStructuredBuffer<float4> _Data;\n"
                   "[numthreads(8, 1, 1)] void K(uint3 id : SV_DispatchThreadID) { _Data[id.x] = _Seen[id.x % 3][uint2(0, 0)]; }\n",
                   textures={"_Seen": [4, 4]}, constants={}, buffers={"_Data": 8})
        self.bad(2, '"_Seen" is an array of textures, 2D[3]; a scene sets single ones', "validate", "k.json")

    def test_a_race_exits_with_1(self):
        self.scene()
        done = self.bad(1, "k.json: 1 place of its kernels races", "kernels", "a.compute", "--check", "k.json")
        self.assertIn('a.compute:7: kernel "Blur" races: invocation ', done.stdout.decode())
        self.scene(buffers={"_Data": {"size": 32, "start": "i^2", "previous": True}})
        self.good("kernels", "a.compute", "--check", "k.json")

    def test_errors_are_reported_at_their_position(self):
        self.scene(BLUR.replace("lerp(", "lrp("))
        self.bad(2, ["a.compute:8:19: error: ", "lrp"], "validate", "k.json")
        self.scene(constants={"_Shar": 0.5})
        self.bad(2, 'the shader has no constant "_Shar"; did you mean "_Share"?', "validate", "k.json")
        self.scene(constants={})
        self.bad(2, 'kernel "Blur" reads the constant "_Share" (float), which has no value', "validate", "k.json")
        self.scene(buffers={})
        self.bad(2, "the buffer _Data has no size", "validate", "k.json")
        self.scene(step=["Blurr"])
        self.bad(2, 'the shader has no kernel "Blurr"; did you mean "Blur"?', "validate", "k.json")

    def test_threads_must_be_given_if_buffers_do_not_determine_them(self):
        both = BLUR.replace("float _Share;", "float _Share; RWTexture2D<float4> _Seen;")
        both = both.replace("    _Data[id.x] =", "    _Seen[id.xy] = 1;\n    _Data[id.x] =")
        self.scene(both, textures={"_Seen": [8, 8]})
        self.bad(2, 'kernel "Blur" has groups of 8 x 1 x 1, and what it writes does not tell how many threads it needs', "validate", "k.json")
        self.scene(both, textures={"_Seen": [8, 8]}, step=[{"kernel": "Blur", "threads": [32]}])
        self.good("validate", "k.json")

    def test_a_group_of_one_thread_that_uses_its_number_runs_for_each_element(self):
        self.scene(BLUR.replace("[numthreads(8, 1, 1)]", "[numthreads(1, 1, 1)]").replace("_Share);", "_Share) + 1;"), buffers={"_Data": {"size": 32, "previous": True}},
                   measures={"least": {"of": "_Data", "what": "min"}})
        scene = json.loads((self.folder / "k.json").read_text())
        scene["checks"] = [{"what": "least", "object": "k", "min": 0.9}]
        scene["test"] = {"frames": [1], "size": [32, 18]}
        (self.folder / "k.json").write_text(json.dumps(scene))
        self.good("test", "k.json", "--update")
        self.good("test", "k.json")
        self.scene(BLUR.replace("[numthreads(8, 1, 1)]", "[numthreads(1, 1, 1)]").replace("id.x] = lerp", "id.x + id.y] = lerp"))
        self.bad(2, "does not tell how many threads it needs", "validate", "k.json")

    def test_what_cannot_run_is_refused(self):
        painted = BLUR.replace("float _Share;", "float _Share; RWTexture2D<float4> _Seen;").replace("    _Data[id.x] =", "    _Seen[id.xy] = 1;\n    _Data[id.x] =")
        step = [{"kernel": "Blur", "threads": 32}]
        for texture, message in (
            ({"size": [8, 8], "format": "RGBA32F"}, 'unknown format "RGBA32F"; did you mean "rgba32f"?'),
            ({"size": [8, 8], "format": ""}, 'a format has a name, such as "rgba32f"'),
            ({"size": [8, 8], "format": "r32ui"}, 'a texel of _Seen holds float numbers, those of "r32ui" are uint'),
            ([8, 8, 4], "this texture has 2 axes: expected 2 numbers, found 3"),
            ([16384, 16384], "the buffers and textures need 8.0 GB"),
        ):
            self.scene(painted, textures={"_Seen": texture}, step=step)
            self.bad(2, message, "validate", "k.json")
        for entry, message in (
            ({"threads": -5}, "a number of threads is a whole number from 1, found -5"),
            ({"threads": 2.5}, "a number of threads is a whole number from 1, found 2.5"),
            ({"threads": "0/0"}, "a number of threads is a whole number from 1, found NaN"),
            ({"swap": ["_Data", "_Data"]}, '"_Data" is named twice'),
            ({"indirect": "_Data"}, '"_Data" holds floats; the numbers of groups are three uints'),
            ({"repeat": 1000000}, "1000000 dispatches a frame are more than 100000"),
        ):
            self.scene(step=[{"kernel": "Blur", **entry}])
            self.bad(2, message, "validate", "k.json")
        (self.folder / "a.csv").write_text("a,b\n1,2\n")
        for buffer, message in (
            ({"file": "a.csv"}, 'no column has the name of a member of _Data; add "start" with formulas of the columns a, b'),
            ({"size": "count(_Data)"}, "sizes cannot depend on each other in a circle"),
            ({"size": 8, "start": {"position": "1"}}, 'an element of _Data is a float without members: give "start": FORMULA'),
        ):
            self.scene(buffers={"_Data": buffer})
            self.bad(2, message, "validate", "k.json")

    def test_a_dispatch_of_too_many_threads_ends_with_4(self):
        shader = BLUR.replace("float _Share;", "float _Share; RWStructuredBuffer<uint> _Groups;").replace("    float left", "    if (_Groups[0] == 0) return;\n    float left")
        self.scene(shader, buffers={"_Data": 32, "_Groups": {"size": 3, "start": 4e9}}, step=[{"kernel": "Blur", "indirect": "_Groups"}])
        self.bad(4, 'a dispatch of kernel "Blur" has 4000000000 x 4000000000 x 4000000000 groups', "trace", "k.json", "--frames", "0-1")

    def test_races_are_searched_in_scenes_that_run_the_file(self):
        self.scene()
        (self.folder / "b.compute").write_text(BLUR)
        self.bad(2, "k.json: no object runs the shader b.compute", "kernels", "b.compute", "--check", "k.json")

    def test_a_kernel_of_an_included_file_is_named(self):
        (self.folder / "b.hlsl").write_text("#pragma kernel Other\n")
        self.scene('#include "b.hlsl"\n' + BLUR, step=["Other"])
        self.bad(2, 'the kernel "Other" is announced in b.hlsl, which the shader includes', "validate", "k.json")

    def test_a_read_out_of_bounds_ends_with_4(self):
        self.scene(BLUR.replace("id.x == 0 ? 0 : id.x - 1", "id.x - 1"))
        self.bad(4, 'a.compute:7: kernel "Blur" reads "_Data" at -1, but it has 32 elements', "render", "k.json", "-o", "out/", "--frames", "0-2")

    def test_a_thousand_points_at_one_place_are_drawn_as_one(self):
        pictures = []
        for count in (1, 1000):
            self.scene(BLUR.replace("<float>", "<float4>").replace("float left", "float4 left"), buffers={"_Data": count}, points={"of": "_Data", "position": "_Data"})
            scene = json.loads((self.folder / "k.json").read_text())
            scene["camera"] = {"position": [0, 0, 1], "target": [0, 0, 0]}
            (self.folder / "k.json").write_text(json.dumps(scene))
            self.good("render", "k.json", "-o", f"{count}.png", "--frames", "0", "--size", "64x36")
            pictures.append(png_rows((self.folder / f"{count}.png").read_bytes()))
        self.assertEqual(*pictures)

    def test_a_read_that_a_condition_makes_unneeded_is_no_mistake(self):
        # HLSL computes both sides of && and ?:, so threads after the last element also read it.
        shader = """#pragma kernel K
RWStructuredBuffer<float> _Data; uint _Count;
[numthreads(64, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {
    if (id.x < _Count && _Data[id.x] > 0.5) _Data[id.x] = 1;
    float kept = id.x >= _Count ? 0 : _Data[id.x];
    if (kept > 2) _Data[id.x] = 2;
}
"""
        self.scene(shader, constants={"_Count": 32})
        self.good("trace", "k.json", "--frames", "0-1")
        self.scene(shader, constants={"_Count": 33})
        self.bad(4, 'a.compute:4: kernel "K" reads "_Data" at 32, but it has 32 elements', "trace", "k.json", "--frames", "0-1")

    def test_a_signal_ends_a_long_frame_between_dispatches(self):
        slow = BLUR.replace("    _Data[id.x] =", "    for (int i = 0; i < 20000; i++) left = left * 0.999 + 0.001;\n    _Data[id.x] =")
        self.scene(slow, buffers={"_Data": {"size": [32, 16], "start": "i^2", "previous": True}}, step=[{"kernel": "Blur", "repeat": 100000}])
        # Frame 0 takes no step and is written at once. Frame 1 takes hours.
        code, messages = self.signal_when((self.folder / "out/k_000000.npy").exists, "out", signal.SIGTERM, "bake", "k.json", "-o", "out/", "--frames", "0-9", "--format", "npy")
        self.assertEqual(code, 128 + signal.SIGTERM, messages)
        self.assertIn("interrupted; the 1 files written so far are whole", messages)

    def test_an_image_is_drawn(self):
        (self.folder / "a.frag").write_text("void mainImage(out vec4 c, in vec2 at) { c = vec4(at / iResolution.xy, 0.5, 1.0); }\n")
        scene = {"version": 1, "objects": {"k": {"image": {"file": "a.frag", "size": [64, 36]}}}}
        (self.folder / "k.json").write_text(json.dumps(scene))
        self.good("render", "k.json", "-o", "out.png", "--frames", "0", "--size", "64x36")


    def test_derivatives_of_an_image_are_differences_within_two_by_two_pixels(self):
        # The global variable has its initial value in each run. Only odd columns take the branch.
        (self.folder / "a.frag").write_text("""float seed = 2.0;
void mainImage(out vec4 c, in vec2 at) {
    seed += 1.0;
    float wide = fwidth(at.x * at.y), along = dFdxFine(at.x * at.x * seed);
    c = vec4(vec3(along + 1000.0 * wide + 100000.0 * dFdy(vec2(at.y, 0.0)).x), 1.0);
    if (mod(at.x, 2.0) > 1.0) c.rgb += dFdx(at).x;
}
""")
        scene = {"version": 1, "objects": {"k": {"image": {"file": "a.frag", "size": [4, 2]}}}}
        (self.folder / "k.json").write_text(json.dumps(scene))
        self.good("bake", "k.json", "-o", "out", "--format", "npy", "--frames", "1", "--overwrite")
        values = struct.unpack("<8f", (self.folder / "out/k_000001.npy").read_bytes()[-32:])
        right = []
        for y in (1, 0):
            for x in range(4):
                first = x // 2 * 2  # x of the first of the two columns
                slope = 3 * ((first + 1.5)**2 - (first + 0.5)**2)
                right.append(slope + 1000 * ((y + 0.5) + (x + 0.5)) + 100000)
        self.assertEqual(values, tuple(right))


if __name__ == "__main__":
    main()
