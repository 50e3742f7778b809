"""Tests simreel kernels and scenes that run a user's compute shaders."""
import json

from common import Case, main

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
        # A changed file is compiled again.
        self.scene(BLUR.replace("lerp(", "lrp("))
        self.bad(2, "a.compute:8:19: error: ", "validate", "k.json", env=env)

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

    def test_an_out_of_bounds_read_exits_with_4(self):
        self.scene(BLUR.replace("id.x == 0 ? 0 : id.x - 1", "id.x - 1"))
        self.bad(4, 'a.compute:7: kernel "Blur" reads "_Data" at -1, but it has 32 elements', "render", "k.json", "-o", "out/", "--frames", "0-2")

    def test_an_image_is_drawn(self):
        (self.folder / "a.frag").write_text("void mainImage(out vec4 c, in vec2 at) { c = vec4(at / iResolution.xy, 0.5, 1.0); }\n")
        scene = {"version": 1, "objects": {"k": {"image": {"file": "a.frag", "size": [64, 36]}}}}
        (self.folder / "k.json").write_text(json.dumps(scene))
        self.good("render", "k.json", "-o", "out.png", "--frames", "0", "--size", "64x36")


if __name__ == "__main__":
    main()
