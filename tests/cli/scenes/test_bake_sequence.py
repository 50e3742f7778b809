"""Tests `simreel bake` of all frames into one file: glTF against the rules of its specification, point caches against
their formats, and both against frames baked one by one. Blender, if installed, reads the files too."""
import json
import math
import os
import resource
import shutil
import signal
import struct
import subprocess
import unittest

from common import PATIENCE, Case, main, with_values

PROGRAM = os.environ.get("SIMREEL", "simreel")
SHEET = {"mesh": {"resolution": [7, 5], "deform": [{"ripple": {}}]}}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}
FLOAT, UNSIGNED, VERTICES, INDICES = 5126, 5125, 34962, 34963


def single(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def read_obj(path):
    """Returns rows of v, vt and vn, and faces as triples of a single zero-based index."""
    rows = {"v": [], "vt": [], "vn": [], "f": []}
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *words = line.split()
        if kind == "f":
            corners = [set(word.split("/")) for word in words]
            assert all(len(corner) == 1 for corner in corners), line
            rows["f"].append(tuple(int(corner.pop()) - 1 for corner in corners))
        elif kind != "#":
            rows[kind].append(tuple(map(float, words)))
    return rows


class Glb:
    """A binary glTF file, checked by the rules of the glTF 2.0 specification; comments give the sections."""

    def __init__(self, data):
        magic, version, total = struct.unpack_from("<4sII", data)
        self.need((magic, version, total) == (b"glTF", 2, len(data)), "header", "4.4.2")
        length, kind = struct.unpack_from("<I4s", data, 12)
        self.need(kind == b"JSON" and length % 4 == 0, "first chunk", "4.4.3.2")
        text = data[20:20 + length]
        self.document = json.loads(text.decode("utf-8"))
        self.need(text.rstrip(b" ") == text.strip(), "padding of spaces", "4.4.3.2")
        size, kind = struct.unpack_from("<I4s", data, 20 + length)
        self.need(kind == b"BIN\0" and size % 4 == 0 and 28 + length + size == total, "second chunk", "4.4.3.3")
        self.binary = data[28 + length:]
        (buffer,) = self.document["buffers"]
        self.need("uri" not in buffer and 0 <= size - buffer["byteLength"] <= 3, "buffer", "4.4.3.3")
        self.need(self.document["asset"]["version"] == "2.0", "asset", "3.2")
        self.used = set()
        for view in self.document["bufferViews"]:
            self.check_view(view, buffer["byteLength"])
        for node in self.document["nodes"]:
            self.need("mesh" not in node or node["mesh"] < len(self.document["meshes"]), "mesh of a node", "5.25")
        for mesh in self.document["meshes"]:
            self.check_mesh(mesh)
        for animation in self.document.get("animations", []):
            self.check_animation(animation)
        self.need(self.used == set(range(len(self.document["accessors"]))), "accessors without use", "")

    @staticmethod
    def need(condition, what, section):
        if not condition:
            raise AssertionError(f"glTF {section}: {what}")

    def check_view(self, view, size):
        self.need(view["byteLength"] >= 1 and view["byteOffset"] + view["byteLength"] <= size, "view in buffer", "3.6.1")
        self.need(view["byteOffset"] % 4 == 0, "alignment", "3.6.2.4")
        if "byteStride" in view:
            self.need(4 <= view["byteStride"] <= 252 and view["byteStride"] % 4 == 0, "stride", "5.11")
            self.need(view.get("target") == VERTICES, "stride of vertices only", "5.11.4")
        self.need(view.get("target", VERTICES) in (VERTICES, INDICES), "target", "5.11")

    def values(self, index, target=None, bounded=False):
        """Returns the rows of an accessor and checks its rules; `target` is the required target of its view."""
        self.used.add(index)
        accessor = self.document["accessors"][index]
        view = self.document["bufferViews"][accessor["bufferView"]]
        self.need(view.get("target") == target, f"use of accessor {index}", "3.6.2.4")
        width, offset = COMPONENTS[accessor["type"]], accessor.get("byteOffset", 0)
        stride = view.get("byteStride", 4 * width)
        shared = sum(other["bufferView"] == accessor["bufferView"] for other in self.document["accessors"]) > 1
        self.need(not shared or target is None or "byteStride" in view, "stride of a shared view", "3.6.2.4")
        self.need(accessor["count"] >= 1 and offset % 4 == 0, f"accessor {index}", "3.6.2.4")
        self.need(stride == 4 * width, "no gaps", "")
        self.need(offset + stride * (accessor["count"] - 1) + 4 * width <= view["byteLength"], "accessor in view", "3.6.2.4")
        kind = {FLOAT: "f", UNSIGNED: "I"}[accessor["componentType"]]
        flat = struct.unpack_from(f"<{width * accessor['count']}{kind}", self.binary, view["byteOffset"] + offset)
        self.need(all(map(math.isfinite, flat)), "finite values", "3.6.2.2")
        rows = [flat[i:i + width] for i in range(0, len(flat), width)]
        self.need(not bounded or ("min" in accessor and "max" in accessor), f"bounds of accessor {index}", "3.6.2.5")
        for name, choose in (("min", min), ("max", max)):
            if name in accessor:
                found = [choose(column) for column in zip(*rows)]
                self.need(accessor[name] == found, f"{name} of accessor {index}: {accessor[name]}, {found}", "3.6.2.5")
        return rows

    def check_mesh(self, mesh):
        (primitive,) = mesh["primitives"]
        self.need(primitive.get("mode", 4) == 4, "triangles", "5.24")
        self.need(primitive.get("material", 0) < len(self.document.get("materials", [0])), "material", "5.24")
        wide = {"POSITION": 3, "NORMAL": 3, "TEXCOORD_0": 2, "COLOR_0": 3}
        self.columns = {name: self.values(index, VERTICES, name == "POSITION")
                        for name, index in primitive["attributes"].items()}
        self.need({len(rows) for rows in self.columns.values()} == {len(self.columns["POSITION"])}, "counts", "3.7.2.1")
        for name, rows in self.columns.items():
            self.need(len(rows[0]) == wide[name], f"type of {name}", "3.7.2.1")
        for normal in self.columns["NORMAL"]:
            self.need(abs(math.hypot(*normal) - 1) < 1e-5, "unit normals", "3.7.2.1")
        self.indices = [row[0] for row in self.values(primitive["indices"], INDICES)]
        self.need(len(self.indices) % 3 == 0, "whole triangles", "3.7.2.1")
        self.need(max(self.indices) < len(self.columns["POSITION"]), "indices", "3.7.2.1")
        self.targets = []
        for target in primitive.get("targets", []):
            self.need(set(target) <= set(primitive["attributes"]), "attributes of a target", "3.7.2.2")
            rows = {name: self.values(index, VERTICES, name == "POSITION") for name, index in target.items()}
            self.need({len(r) for r in rows.values()} == {len(self.columns["POSITION"])}, "count of a target", "3.7.2.2")
            self.targets.append(rows)
        names = mesh.get("extras", {}).get("targetNames", [])
        self.need(len(names) == len(self.targets) and len(mesh.get("weights", names)) == len(names), "weights", "3.7.2.2")

    def check_animation(self, animation):
        samplers = animation["samplers"]
        aims = [(c["target"]["node"], c["target"]["path"]) for c in animation["channels"]]
        self.need(len(set(aims)) == len(aims), "one channel for each aim", "3.11")
        for channel in animation["channels"]:
            self.need(channel["sampler"] < len(samplers), "sampler", "5.6")
            self.need(channel["target"]["path"] == "weights", "path", "5.7")
            self.need("mesh" in self.document["nodes"][channel["target"]["node"]] and self.targets, "weights of a mesh", "5.7")
            sampler = samplers[channel["sampler"]]
            self.times = [row[0] for row in self.values(sampler["input"], None, True)]
            self.need(self.times[0] >= 0 and all(a < b for a, b in zip(self.times, self.times[1:])), "times", "3.11")
            self.need(sampler.get("interpolation", "LINEAR") == "LINEAR", "interpolation", "5.8")
            weights = [row[0] for row in self.values(sampler["output"])]
            self.need(len(weights) == len(self.times) * len(self.targets), "number of weights", "3.11")
            self.weights = [weights[i:i + len(self.targets)] for i in range(0, len(weights), len(self.targets))]

    def at(self, key, name):
        """Returns an attribute at a key of the animation: base + sum of weight x target (3.7.2.2)."""
        rows = [list(row) for row in self.columns[name]]
        for weight, target in zip(self.weights[key], self.targets):
            if weight:
                rows = [[a + weight * b for a, b in zip(row, extra)] for row, extra in zip(rows, target[name])]
        return rows


def read_cache(data):
    """Returns (points, frame numbers or seconds, step or None, frames of rows) of a PC2 or MDD file."""
    if data.startswith(b"POINTCACHE2\0"):
        version, points, start, step, frames = struct.unpack_from("<iiffi", data, 12)
        assert version == 1
        at, order, times = 32, "<", [start + step * i for i in range(frames)]
    else:
        frames, points = struct.unpack_from(">ii", data)
        at, order, step, times = 8 + 4 * frames, ">", None, list(struct.unpack_from(f">{frames}f", data, 8))
    assert len(data) == at + 12 * points * frames, (len(data), points, frames)
    flat = struct.unpack_from(f"{order}{3 * points * frames}f", data, at)
    rows = [flat[i:i + 3] for i in range(0, len(flat), 3)]
    return points, times, step, [rows[i:i + points] for i in range(0, len(rows), points)]


BLENDER = """
import bpy, json, numpy, sys
numpy.bool = bool  # Debian's Blender 3.4 uses a name that its numpy no longer has.
folder, frames = sys.argv[-1], {frames}
found = {{}}
def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = 30
def look(name):
    found[name] = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        it = bpy.data.objects["flag"].evaluated_get(bpy.context.evaluated_depsgraph_get())
        found[name].append([tuple(it.matrix_world @ v.co) for v in it.to_mesh().vertices])
fresh()
bpy.ops.import_scene.gltf(filepath=folder + "/flag.glb")
look("glb")
for kind in ("pc2", "mdd"):
    fresh()
    bpy.ops.wm.obj_import(filepath=folder + "/flag.obj")
    cache = bpy.data.objects["flag"].modifiers.new("cache", "MESH_CACHE")
    cache.cache_format, cache.filepath = kind.upper(), folder + "/flag." + kind
    look(kind)
open(folder + "/found.json", "w").write(json.dumps(found))
"""


class Sequence(Case):
    def bake(self, *arguments):
        return self.good("bake", "scene.json", "-o", "out", *arguments)

    def frames(self, name, numbers):
        """Returns the frames baked one by one."""
        self.good("bake", "scene.json", "-o", "frames", "--format", "obj", "--object", name, "--overwrite",
                  "--frames", ",".join(map(str, numbers)))
        return [read_obj(self.folder / f"frames/{name}_{frame:06}.obj") for frame in numbers]

    def glb(self, name):
        return Glb((self.folder / f"out/{name}.glb").read_bytes())

    def test_the_gltf_animation_equals_the_frames(self):
        self.write("scene.json", with_values({"objects.sheet": SHEET}))
        self.bake("--sequence")
        self.assertEqual(sorted(self.content("out")), ["flag.glb", "sheet.glb"])
        for name in ("flag", "sheet"):
            frames, glb = self.frames(name, range(6)), self.glb(name)
            self.assertEqual(glb.times, [single(i / 30) for i in range(6)])
            self.assertEqual(glb.weights, [[float(i == k + 1) for k in range(5)] for i in range(6)])
            self.assertEqual(glb.columns["POSITION"], [tuple(map(single, p)) for p in frames[0]["v"]])
            # v points down in glTF and up in OBJ.
            for (u, v), (x, y) in zip(glb.columns["TEXCOORD_0"], frames[0]["vt"]):
                self.assertEqual((u, round(v, 6)), (single(x), round(1 - y, 6)))
            self.assertEqual(glb.indices, [i for face in frames[0]["f"] for i in face])
            self.assertEqual(glb.document["meshes"][0]["extras"]["targetNames"], [f"frame {i}" for i in range(1, 6)])
            self.assertTrue(glb.document["materials"][0]["doubleSided"])
            for key, frame in enumerate(frames):
                for attribute, column, near in (("POSITION", "v", 3e-7), ("NORMAL", "vn", 3e-7)):
                    for got, want in zip(glb.at(key, attribute), frame[column]):
                        self.assertLess(max(abs(a - b) for a, b in zip(got, want)), near, (name, key, attribute))

    def test_selected_frames_start_at_time_0(self):
        self.bake("--sequence", "--format", "glb", "--frames", "1,2,5")
        self.assertEqual(self.glb("flag").times, [single(i / 30) for i in (0, 1, 4)])
        frames = self.frames("flag", (1, 2, 5))
        self.assertEqual(self.glb("flag").columns["POSITION"], [tuple(map(single, p)) for p in frames[0]["v"]])

    def test_one_frame_has_no_animation(self):
        self.bake("--sequence", "--frames", "3")
        self.bake("--format", "glb", "--frames", "3", "--object", "flag")
        still = self.glb("flag")
        self.assertEqual(still.targets, [])
        self.assertNotIn("animations", still.document)
        once = Glb((self.folder / "out/flag_000003.glb").read_bytes())
        self.assertEqual((still.columns, still.indices), (once.columns, once.indices))

    def test_point_caches_equal_the_frames(self):
        self.bake("--format", "pc2")
        self.bake("--format", "mdd", "--overwrite")
        self.assertEqual(sorted(self.content("out")), ["flag.mdd", "flag.obj", "flag.pc2"])
        frames = self.frames("flag", range(6))
        wanted = [[tuple(map(single, p)) for p in frame["v"]] for frame in frames]
        points, numbers, step, found = read_cache((self.folder / "out/flag.pc2").read_bytes())
        self.assertEqual((points, numbers, step), (63, [0, 1, 2, 3, 4, 5], 1))
        self.assertEqual(found, wanted)
        points, seconds, _, found = read_cache((self.folder / "out/flag.mdd").read_bytes())
        self.assertEqual((points, seconds), (63, [single(i / 30) for i in range(6)]))
        self.assertEqual(found, wanted)
        self.assertEqual(read_obj(self.folder / "out/flag.obj"), frames[0])

    def test_uneven_frames(self):
        self.bad(2, ["--frames", "3 follows 1", "4 follows 3", "mdd"], "bake", "scene.json", "-o", "out", "--format", "pc2",
                 "--frames", "1,3,4")
        self.assertEqual(self.content("out"), {})
        self.bake("--format", "pc2", "--frames", "1-5x2")
        self.assertEqual(read_cache((self.folder / "out/flag.pc2").read_bytes())[1:3], ([1, 3, 5], 2))
        self.bake("--format", "mdd", "--frames", "1,3,4", "--overwrite")
        self.assertEqual(read_cache((self.folder / "out/flag.mdd").read_bytes())[1], [single(i / 30) for i in (0, 2, 3)])

    def test_a_surface_with_changing_topology_is_refused(self):
        pattern = {"grayScott": {"size": [48, 32], "presteps": 5, "display": {"layer": "none"}}}
        self.write("scene.json", with_values({"objects": {
            "hills": {"contour": {"field": "pattern", "levels": 3, "low": 0.1, "high": 0.3}}, "pattern": pattern}}))
        for how in (["--sequence"], ["--format", "pc2"], ["--format", "mdd"]):
            self.bad(2, ["hills", "frame 1", "a file a frame"], "bake", "scene.json", "-o", "out", *how)
            self.assertEqual(self.content("out"), {})

    def test_two_bakes_write_the_same_bytes(self):
        for folder in ("out", "again"):
            for how in (["--sequence"], ["--format", "pc2"], ["--format", "mdd", "--overwrite"]):
                self.good("bake", "scene.json", "-o", folder, *how)
        self.assertEqual(self.content("out"), self.content("again"))

    def test_existing_files_are_kept(self):
        self.write("out/flag.obj", "mine")
        self.bad(6, ["out/flag.obj", "--overwrite"], "bake", "scene.json", "-o", "out", "--format", "pc2")
        self.assertEqual(self.content("out"), {"flag.obj": b"mine"})
        self.bad(2, ["--sequence", "obj", "glb, pc2 or mdd"], "bake", "scene.json", "-o", "out", "--format", "obj", "--sequence")
        self.bad(2, ["no object", "a mesh"], "bake", "scene.json", "-o", "out", "--sequence", "-D", 'objects={"b":{"sphere":{}}}')

    def test_a_full_disk_leaves_no_files(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
        for how in (["--sequence"], ["--format", "pc2"], ["--format", "mdd"]):
            self.bad(6, ["out/flag.", "File too large"], "bake", "scene.json", "-o", "out", *how, preexec_fn=limit)
            self.assertEqual(self.content("out"), {})

    def test_an_interrupt_leaves_no_files(self):
        self.write("scene.json", with_values({"time.duration": 300}))
        part = self.folder / "out/flag.mdd.part"
        code, messages = self.signal_when(lambda: part.exists() and part.stat().st_size > 100_000, "out", signal.SIGTERM, "bake", "scene.json",
                                          "-o", "out", "--format", "mdd")
        self.assertEqual(code, 143, messages)
        self.assertIn("no file was written", messages)
        self.assertEqual(self.content("out"), {})

    def test_memory_does_not_grow_with_frames(self):
        self.write("scene.json", with_values({"objects": {"sheet": {"mesh": {"resolution": [301, 301], "deform": [{"ripple": {}}]}}}}))
        def peak(frames):
            script = "import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True); " \
                     "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
            done = subprocess.run(["python3", "-c", script, PROGRAM, "bake", "scene.json", "-o", f"out{frames}", "--sequence", "-q",
                                   "--frames", f"0-{frames - 1}"], cwd=self.folder, capture_output=True, check=True)
            return int(done.stdout) * 1024
        few, many = peak(3), peak(63)
        grown = sum(f.stat().st_size for f in self.folder.glob("out63/*")) - sum(f.stat().st_size for f in self.folder.glob("out3/*"))
        self.assertGreater(grown, 100e6)
        self.assertLess(many - few, grown / 4)

    @unittest.skipUnless(shutil.which("blender"), "Blender is not installed")
    def test_blender_plays_the_sequences(self):
        self.bake("--sequence")
        self.bake("--format", "pc2")
        self.bake("--format", "mdd", "--overwrite")
        self.write("look.py", BLENDER.format(frames=list(range(6))))
        # Blender runs the first python3 in PATH. Another one than the system's may lack modules that Blender needs.
        system = {**os.environ, "PATH": "/usr/bin:/bin"}
        done = subprocess.run([shutil.which("blender"), "--background", "--factory-startup", "--python-exit-code", "3", "--python", self.folder / "look.py",
                               "--", self.folder / "out"], cwd=self.folder, env=system, capture_output=True, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        found = json.loads((self.folder / "out/found.json").read_text())
        for kind in ("glb", "pc2", "mdd"):
            for got, frame in zip(found[kind], self.frames("flag", range(6)), strict=True):
                for a, (x, y, z) in zip(got, frame["v"], strict=True):
                    self.assertLess(math.dist(a, (x, -z, y)), 1e-6, kind)  # Blender's z axis points up.


if __name__ == "__main__":
    main()
