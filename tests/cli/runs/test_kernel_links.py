"""Tests what a user's kernels give to other objects of a scene, and what they take from them."""
import json
import math
import struct

from common import Case, main


class KernelLinks(Case):
    def kernel(self, text, name="a.compute"):
        (self.folder / name).write_text(text)

    def scene(self, objects, **more):
        (self.folder / "k.json").write_text(json.dumps({"version": 1, "time": {"fps": 30, "duration": 1}, "render": {"size": [64, 36]}, "objects": objects, **more}))

    def points(self, name, frame, count):
        """Returns the rows of the PLY file of an object at a frame."""
        self.good("bake", "k.json", "--object", name, "--format", "ply", "--frames", str(frame), "-o", "b", "--overwrite")
        head, rows = (self.folder / f"b/{name}_{frame:06}.ply").read_bytes().split(b"end_header\n", 1)
        width = head.count(b"property float")
        return [struct.unpack_from(f"<{width}f", rows, 4 * width * i) for i in range(count)]

    def test_velocities_of_a_kernel_are_the_wind_of_particles(self):
        # A linear field, which interpolation does not change: exact in the whole rectangle up to half a cell from its edges.
        self.kernel("""RWTexture2D<float2> _Velocity;
            [numthreads(8, 8, 1)] void Blow(uint3 id : SV_DispatchThreadID) {
                float2 p = id.xy + 0.5;
                _Velocity[id.xy] = float2(2 + 0.25*p.x - 0.125*p.y, 1 + 0.25*p.x - 0.5*p.y);
            }""")
        at = [[1, 2, 3], [1.7, 2.6, 2.2], [0, 1, 5.1], [1, 9, 3]]
        self.scene({
            "p": {"particles": {"method": "none", "wind": {"fluid": "air", "drag": 1}, "groups": [{"shape": "ball", "count": 1, "radius": 1e-4, "position": place} for place in at]}},
            "air": {"kernels": {"file": "a.compute", "textures": {"_Velocity": [16, 8]},
                                "wind": {"of": "_Velocity", "scale": 2, "plane": {"position": [1, 2, 3], "rotation": [0, 90, 0], "cell": 0.5}}}}})
        for before, after in zip(self.points("p", 0, 4), self.points("p", 1, 4)):
            _, up, depth = before[:3]
            x, y = 8 - (depth - 3) / 0.5, 4 - (up - 2) / 0.5  # the turned plane's x points along -z
            wind = (0, -2 * (1 + 0.25 * x - 0.5 * y), -2 * (2 + 0.25 * x - 0.125 * y)) if 0 <= x <= 16 and 0 <= y <= 8 else (0, 0, 0)
            for found, speed in zip(after[4:7], wind):
                self.assertAlmostEqual(found, speed * (1 - math.exp(-1 / 30)), delta=3e-4)

    def test_particles_lie_on_the_terrain_of_a_kernel(self):
        self.kernel("""RWStructuredBuffer<float> _Heights; float _Now;
            [numthreads(64, 1, 1)] void Raise(uint3 id : SV_DispatchThreadID) { if (id.x < 63) _Heights[id.x] = 3 + 2*_Now; }""")
        self.scene({
            "p": {"particles": {"method": "none", "collides": True, "bounce": 0, "acceleration": [0, -9.81, 0], "groups": [{"shape": "ball", "count": 1, "radius": 1e-4, "position": [0.2, 1.5, -0.3]}]}},
            "hill": {"kernels": {"file": "a.compute", "buffers": {"_Heights": [9, 7]}, "constants": {"_Now": "time + dt"}, "terrain": {"of": "_Heights", "width": 4, "scale": 0.1, "position": [0, 0.5, 1], "collides": True}}}})
        self.assertAlmostEqual(self.points("p", 30, 1)[0][1], 0.5 + 0.1 * (3 + 2), delta=1e-3)
        self.good("bake", "k.json", "--object", "hill", "--format", "obj", "--frames", "30", "-o", "b")
        vertices = [[float(x) for x in line.split()[1:]] for line in (self.folder / "b/hill_000030.obj").read_text().splitlines() if line.startswith("v ")]
        self.assertEqual(len(vertices), 63)
        for i, vertex in enumerate(vertices):
            for found, wanted in zip(vertex, (0.5 * (i % 9) - 2, 1, 0.5 * (i // 9) - 0.5)):
                self.assertAlmostEqual(found, wanted, delta=1e-6)

    def test_grids_that_are_no_wind_or_terrain_are_refused(self):
        self.kernel("""struct Cell { float2 flow; float height; };
            RWStructuredBuffer<Cell> _Cells; RWTexture2D<float> _Red;
            [numthreads(8, 8, 1)] void K(uint3 id : SV_DispatchThreadID) { _Cells[id.x].height = 1; _Red[id.xy] = 1; }""")
        for more, message in (
            ({"wind": {}}, '"wind" needs "of", a texture or buffer'),
            ({"wind": {"of": "_Cell"}}, 'the shader has no texture or buffer "_Cell"; did you mean "_Cells"?'),
            ({"wind": {"of": "_Cells"}}, '"_Cells" has the size 64 x 1 x 1; "wind" needs a grid of two axes'),
            ({"wind": {"of": "_Red"}}, 'a texel of "_Red" is one number; a velocity needs two'),
            ({"buffers": {"_Cells": [8, 8]}, "wind": {"of": "_Cells"}}, '"wind" needs "velocity", a member of "_Cells"'),
            ({"buffers": {"_Cells": [8, 8]}, "wind": {"of": "_Cells", "velocity": "height"}}, '"height" is a float; expected 2 to 4 numbers'),
            ({"buffers": {"_Cells": [8, 8]}, "terrain": {"of": "_Cells", "height": "flow.z"}}, '"_Cells" has no member "flow.z"'),
        ):
            self.scene({"k": {"kernels": {"file": "a.compute", "buffers": {"_Cells": 64}, "textures": {"_Red": {"size": [8, 8], "format": "r32f"}}, **more}}})
            self.bad(2, message, "validate", "k.json")


if __name__ == "__main__":
    main()
