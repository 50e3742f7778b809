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

    def field(self, name, frame):
        """Returns the values of the npy file of an object's field at a frame, in rows."""
        self.good("bake", "k.json", "--object", name, "--format", "npy", "--frames", str(frame), "-o", "b", "--overwrite")
        data = (self.folder / f"b/{name}_{frame:06}.npy").read_bytes()
        length = int.from_bytes(data[8:10], "little")
        self.assertIn(b"'<f4'", data[10:10 + length])
        rows, columns = (int(part) for part in data[10:10 + length].split(b"(")[1].split(b")")[0].split(b",")[:2])
        values = struct.unpack(f"<{rows * columns}f", data[10 + length:])
        return [values[columns * row:columns * (row + 1)] for row in range(rows)]

    def test_objects_may_read_each_other(self):
        (self.folder / "p.frag").write_text("void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy) + 0.125; }\n")
        image = lambda field: {"image": {"file": "p.frag", "size": [16, 9], "channels": {"0": {"field": field}}}}
        for objects in ({"a": image("b"), "b": image("a")}, {"a": image("a")}):
            self.scene(objects)
            self.good("render", "k.json", "--frames", "1", "-o", "k.png", "--overwrite")

    def test_velocities_of_a_kernel_are_the_wind_of_particles(self):
        # Interpolation does not change a linear field. The values are therefore exact in the whole rectangle, up to
        # half a cell from its edges.
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
            x, y = 8 - (depth - 3) / 0.5, 4 - (up - 2) / 0.5  # The x axis of the turned plane points along -z.
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

    def test_a_finer_terrain_lies_on_a_smooth_surface_through_the_heights(self):
        # The surface is a polynomial of the second degree, which the interpolation reproduces except at the borders.
        # This test takes 1 s.
        self.kernel("""RWTexture2D<float> _Heights;
            [numthreads(8, 8, 1)] void Raise(uint3 id : SV_DispatchThreadID) { if (all(id.xy < uint2(9, 7))) _Heights[id.xy] = id.x*(id.x - 2.0*id.y) + 3; }""")
        hill = lambda **more: {"hill": {"kernels": {"file": "a.compute", "textures": {"_Heights": [9, 7]}, "terrain": {"of": "_Heights", "width": 4, **more}}}}
        self.scene(hill(finer=4))
        self.good("bake", "k.json", "--object", "hill", "--format", "obj", "--frames", "1", "-o", "b")
        vertices = [[float(x) for x in line.split()[1:]] for line in (self.folder / "b/hill_000001.obj").read_text().splitlines() if line.startswith("v ")]
        self.assertEqual(len(vertices), 33 * 25)
        for i, (x, y, z) in enumerate(vertices):
            u, v = i % 33 / 4, i // 33 / 4
            self.assertAlmostEqual(x, 0.5 * u - 2, delta=1e-6)
            self.assertAlmostEqual(z, 0.5 * v - 1.5, delta=1e-6)
            if (1 <= u <= 7 and 1 <= v <= 5) or (u == int(u) and v == int(v)):
                self.assertAlmostEqual(y, u * (u - 2 * v) + 3, delta=1e-4)
        self.scene(hill(), version=2)
        self.good("bake", "k.json", "--object", "hill", "--format", "obj", "--frames", "1", "-o", "b", "--overwrite")
        self.assertEqual((self.folder / "b/hill_000001.obj").read_text().count("\nv "), 129 * 97)

    def test_textures_take_the_field_of_another_object_at_the_beginning_of_a_frame(self):
        self.kernel("""RWTexture2D<float> _Out; float _Now;
            [numthreads(8, 8, 1)] void Make(uint3 id : SV_DispatchThreadID) { if (id.x < 12) _Out[id.xy] = id.x + 100*id.y + 10000*_Now; }""")
        self.kernel("""Texture2D<float> _In, _Once; RWTexture2D<float4> _Seen; Texture2D<uint> _Whole;
            [numthreads(8, 8, 1)] void See(uint3 id : SV_DispatchThreadID) {
                if (id.x < 12) _Seen[id.xy] = _In[id.xy] + 0.5*_Once[id.xy]; else _Seen[id.xy] = _Whole[uint2(id.x - 12, id.y)]; }""", "b.compute")
        make = {"file": "a.compute", "textures": {"_Out": [12, 8]}, "constants": {"_Now": "frame + 1"}, "first": ["Make"]}
        see = {"file": "b.compute", "step": [{"kernel": "See", "threads": [24, 8]}], "field": {"of": "_Seen", "show": "r"},
               "textures": {"_In": {"size": [12, 8], "field": "source"}, "_Once": {"size": [12, 8], "field": "source", "taken": "start"},
                            "_Whole": {"size": [12, 8], "field": "source"}, "_Seen": [24, 8]}}
        for order in (("source", "reader"), ("reader", "source")):  # The order of the objects must not matter.
            self.scene({name: {"kernels": make if name == "source" else see} for name in order})
            for y, row in enumerate(self.field("reader", 3)):
                # In frame 3, the kernel reads the result of frame 2. Before the first step, it reads the values of
                # "first".
                self.assertEqual(list(row[:12]), [x + 100 * y + 20000 + 0.5 * (x + 100 * y + 10000) for x in range(12)])
                self.assertEqual(list(row[12:]), [x + 100 * y + 20000 for x in range(12)])
        # A texture of another size is interpolated between the centres of the cells.
        see |= {"bounds": "ignore"}
        see["textures"]["_In"]["size"], see["textures"]["_Once"] = [24, 4], {"size": [12, 8]}
        self.scene({"source": {"kernels": make}, "reader": {"kernels": see}})
        for y, row in enumerate(self.field("reader", 1)[:4]):
            self.assertEqual(list(row[:12]), [min(max(0.5 * x - 0.25, 0), 11) + 100 * (2 * y + 0.5) + 10000 for x in range(12)])

    def test_constants_use_quantities_of_other_objects(self):
        self.kernel("""RWStructuredBuffer<float> _Sum; float _Given;
            [numthreads(1, 1, 1)] void Add(uint3 id : SV_DispatchThreadID) { _Sum[0] += _Given; }""")
        kernel = {"file": "a.compute", "buffers": {"_Sum": {"size": 1, "start": 1}}, "constants": {"_Given": 1}, "measures": {"total": {"of": "_Sum", "what": "sum"}}}
        self.scene({"first": {"kernels": kernel | {"constants": {"_Given": "2*quantity(second-one.total)"}}}, "second-one": {"kernels": kernel}},
                   checks=[{"what": "total", "object": "first", "min": 1 + 2 * (1 + 2 + 3), "max": 13}], test={"frames": [3], "size": [16, 9]})
        self.good("test", "k.json", "--update")
        for constant, message in (
            ("quantity(second.total)", 'no object is named "second"'),
            ("quantity(first.totals)", 'object "first" has no quantity "first.totals"; did you mean "first.total"?'),
            ("quantity(total)", "a quantity has the name of an object and its own: quantity(OBJECT.QUANTITY)"),
        ):
            self.scene({"first": {"kernels": kernel | {"constants": {"_Given": constant}}}})
            self.bad(2, message, "validate", "k.json")
        self.scene({"first": {"kernels": kernel | {"buffers": {"_Sum": "quantity(first.total)"}}}})
        self.bad(2, "only constants use quantities of objects", "validate", "k.json")

    def test_an_image_reads_the_field_of_another_object(self):
        self.kernel("""RWTexture2D<float> _Out;
            [numthreads(8, 8, 1)] void Make(uint3 id : SV_DispatchThreadID) { _Out[id.xy] = id.y < 8 ? 1 : 0; }""")
        (self.folder / "a.frag").write_text("void mainImage(out vec4 c, in vec2 at) { c = vec4(texelFetch(iChannel0, ivec2(at), 0).xyz, 1.0); }\n")
        self.scene({"picture": {"image": {"file": "a.frag", "size": [32, 16], "channels": {"0": {"field": "half"}}}},
                    "half": {"kernels": {"file": "a.compute", "textures": {"_Out": [32, 16]}, "first": ["Make"]}}})
        rows = self.field("picture", 0)
        # The y axis of ShaderToy points up, as in the displayed field.
        self.assertEqual([set(row) for row in rows], [{1.0}] * 8 + [{0.0}] * 8)
        self.scene({"picture": {"image": {"file": "a.frag", "size": [32, 16], "channels": {"0": {"field": "hal"}}}}})
        self.bad(2, 'no object is named "hal"', "validate", "k.json")

    def obj(self, name, frame):
        """Returns (vertices, normals, triangles) of the OBJ file of an object at a frame."""
        self.good("bake", "k.json", "--object", name, "--format", "obj", "--frames", str(frame), "-o", "b", "--overwrite")
        lines = [line.split() for line in (self.folder / f"b/{name}_{frame:06}.obj").read_text().splitlines()]
        numbers = {kind: [[float(x) for x in line[1:]] for line in lines if line and line[0] == kind] for kind in ("v", "vn")}
        return numbers["v"], numbers["vn"], [[int(corner.split("/")[0]) - 1 for corner in line[1:]] for line in lines if line and line[0] == "f"]

    def test_the_level_surface_of_a_volume_is_a_sphere(self):
        self.kernel("""RWTexture3D<float2> _Inside; RWStructuredBuffer<float> _Also;
            [numthreads(4, 4, 4)] void Fill(uint3 id : SV_DispatchThreadID) {
                float3 p = float3(id) - 11.5; p.x += 1;
                if (id.x < 22) { _Inside[id] = float2(0, 12 - length(p)); _Also[(id.z*24 + id.y)*22 + id.x] = 12 - length(p); } }""")
        for of in ({"of": "_Inside", "show": "g"}, {"of": "_Also"}):
            self.scene({"k": {"kernels": {"file": "a.compute", "textures": {"_Inside": [22, 24, 24]}, "buffers": {"_Also": [22, 24, 24]}, "step": [{"kernel": "Fill", "threads": [24, 24, 24]}],
                                          "volume": {**of, "width": 11, "level": 4, "position": [1, 2, 3]}}}})
            vertices, normals, triangles = self.obj("k", 1)
            self.assertGreater(len(vertices), 500)
            for at, normal in zip(vertices, normals):
                out = [x - middle for x, middle in zip(at, (1, 2, 3))]
                # A cell is 0.5 m wide, so the radius is 8 cells.
                self.assertAlmostEqual(math.hypot(*out), 4, delta=0.02)
                self.assertGreater(sum(a * b for a, b in zip(out, normal)), 0.98 * 4)
            edges = {(face[i], face[(i + 1) % 3]) for face in triangles for i in range(3)}
            self.assertEqual(len(edges), 3 * len(triangles))
            self.assertTrue(all((b, a) in edges for a, b in edges))  # The surface is closed.

    def test_a_quaternion_or_a_direction_turns_copies_of_a_mesh(self):
        self.kernel("""struct Copy { float3 position; float4 turn; float3 along; };
            RWStructuredBuffer<Copy> _Copies;
            [numthreads(64, 1, 1)] void Keep(uint3 id : SV_DispatchThreadID) { if (id.x < 2) _Copies[id.x].position.y += 0; }""")
        corners = [(0, 0, 0), (1, 0, 0), (0, 0.6, 0), (0, 0, 1.4)]
        (self.folder / "t.obj").write_text("".join("v {} {} {}\n".format(*at) for at in corners) + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")

        def product(a, b):
            return [a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
                    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]]

        def about(axis, degrees):
            return [math.sin(math.radians(degrees / 2)) * (i == axis) for i in range(3)] + [math.cos(math.radians(degrees / 2))]

        turn = product(about(2, -40), product(about(1, 25), about(0, 70)))
        along = (0.3, -0.5, 0.8)

        def objects(**points):
            return {"k": {"kernels": {"file": "a.compute", "buffers": {"_Copies": {"size": 2, "start": {"position": ["0.3 + 2*i", 0.1, -0.2], "turn": [2 * x for x in turn], "along": list(along)}}},
                                      "points": {"of": "_Copies", "mesh": "t.obj", "size": 0.5, **points}}, "material": {"color": "tomato"}}}
        self.scene(objects(rotation="turn"))
        vertices, _, triangles = self.obj("k", 0)
        self.assertEqual(len(triangles), 8)

        def turned(v):
            return product(product(turn, [*v, 0]), [-turn[0], -turn[1], -turn[2], turn[3]])[:3]

        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

        def unit(a):
            return [x / math.hypot(*a) for x in a]

        z = unit(along)
        x = unit(cross((0, 1, 0), z))
        y = cross(z, x)
        for member, placed in (("turn", turned), ("along", lambda v: [v[0] * x[i] + v[1] * y[i] + v[2] * z[i] for i in range(3)])):
            self.scene(objects(rotation=member))
            found = {tuple(round(c, 4) for c in at) for at in self.obj("k", 0)[0]}
            wanted = {tuple(round(c, 4) for c in (0.3 + 2 * copy + 0.5 * at[0], 0.1 + 0.5 * at[1], -0.2 + 0.5 * at[2])) for copy in (0, 1) for at in map(placed, corners)}
            for at in wanted:
                self.assertTrue(any(math.dist(at, other) < 2e-4 for other in found), (member, at, found))
        # Two meshes with this rotation must give the same pictures.
        look = {"stage": False, "camera": {"position": [1.2, 1, 4], "target": [1.2, 0.2, 0], "fieldOfView": 40}}
        self.scene(objects(rotation="turn"), **look)
        self.good("render", "k.json", "-o", "copies.png", "--frames", "0", "--size", "160x90")
        self.scene({f"m{i}": {"mesh": {"file": "t.obj", "scale": 0.5, "position": [0.3 + 2 * i, 0.1, -0.2], "rotation": [70, 25, -40]}, "material": {"color": "tomato"}} for i in (0, 1)}, **look)
        self.good("render", "k.json", "-o", "meshes.png", "--frames", "0", "--size", "160x90")
        self.good("diff", "copies.png", "meshes.png", "--max-channel-diff", "4", "--max-diff-ratio", "0.005")
        for points, message in (({"rotation": "spin"}, '"_Copies" has no member "spin"'), ({"rotation": "turn", "alongVelocity": True}, 'give "rotation" or "alongVelocity", not both')):
            self.scene(objects(**points))
            self.bad(2, message, "validate", "k.json")

    def test_points_are_baked_as_rows_of_numbers(self):
        self.kernel("""struct Fly { float3 position; float3 velocity; };
            RWStructuredBuffer<Fly> _Flies;
            [numthreads(64, 1, 1)] void Move(uint3 id : SV_DispatchThreadID) { if (id.x < 3) _Flies[id.x].position += 0.5*_Flies[id.x].velocity; }""")
        self.scene({"k": {"kernels": {"file": "a.compute", "buffers": {"_Flies": {"size": 3, "start": {"position": ["i", 2, 3], "velocity": [0, "1 + i", 0]}}},
                                      "points": {"of": "_Flies", "position": "position", "velocity": "velocity"}}}})
        self.assertEqual([list(row) for row in self.field("k", 2)], [[i, 2 + 1 + i, 3, 0, 1 + i, 0, 1] for i in range(3)])

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
