"""simreel kernels and scenes that run compute shaders of a user."""
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

    def test_a_race_ends_with_1(self):
        self.scene()
        done = self.bad(1, "k.json: 1 place of its kernels races", "kernels", "a.compute", "--check", "k.json")
        self.assertIn('a.compute:7: kernel "Blur" races: invocation ', done.stdout.decode())
        self.scene(buffers={"_Data": {"size": 32, "start": "i^2", "previous": True}})
        self.good("kernels", "a.compute", "--check", "k.json")

    def test_mistakes_are_shown_at_their_place(self):
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

    def test_a_read_out_of_bounds_ends_with_4(self):
        self.scene(BLUR.replace("id.x == 0 ? 0 : id.x - 1", "id.x - 1"))
        self.bad(4, 'a.compute:7: kernel "Blur" reads "_Data" at -1, but it has 32 elements', "render", "k.json", "-o", "out/", "--frames", "0-2")

    def test_an_image_is_drawn(self):
        (self.folder / "a.frag").write_text("void mainImage(out vec4 c, in vec2 at) { c = vec4(at / iResolution.xy, 0.5, 1.0); }\n")
        scene = {"version": 1, "objects": {"k": {"image": {"file": "a.frag", "size": [64, 36]}}}}
        (self.folder / "k.json").write_text(json.dumps(scene))
        self.good("render", "k.json", "-o", "out.png", "--frames", "0", "--size", "64x36")


if __name__ == "__main__":
    main()
