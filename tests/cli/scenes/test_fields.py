"""Tests raw values of fields: `render --fields` beside the pictures, and `bake --format`; reads the files with struct
only."""
import ast
import struct
import zlib

from common import SCENE, Case, main, with_values

ROWS = ["#....", "..#..", "....#", "##..#"]  # start pattern of 5 x 4 cells; # marks v = 0.5


def read_npy(data):
    """Returns (rows, columns, values) of an NPY 1.0 file of little-endian floats."""
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    (length,) = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0, length
    header = data[10:10 + length].decode("ascii")
    assert header.endswith("\n"), header
    fields = ast.literal_eval(header)
    assert fields["descr"] == "<f4" and fields["fortran_order"] is False, fields
    rows, columns = fields["shape"]
    assert len(data) == 10 + length + 4 * rows * columns, len(data)
    return rows, columns, struct.unpack(f"<{rows * columns}f", data[10 + length:])


def read_pfm(data):
    kind, size, scale, body = data.split(b"\n", 3)
    assert kind == b"Pf" and float(scale) < 0, (kind, scale)
    columns, rows = map(int, size.split())
    values = struct.unpack(f"<{rows * columns}f", body)
    flipped = [value for row in reversed(range(rows)) for value in values[row * columns:(row + 1) * columns]]
    return rows, columns, tuple(flipped)


def grey_png(rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    pixels = b"".join(b"\0" + bytes(255 if c == "#" else 0 for c in row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


class Fields(Case):
    def setUp(self):
        super().setUp()
        self.write("start.png", grey_png(ROWS))
        dish = {"size": [5, 4], "image": "start.png", "seeds": {"value": 0.5, "noise": 0}, "steps": 3}
        scene = with_values({"objects": {"dish": {"grayScott": dish}}, "time.duration": 4 / 30}, SCENE)
        self.write("scene.json", scene)

    def render(self, *more):
        return ["render", "scene.json", "-o", "out/", *more]

    def test_values_are_written_beside_the_pictures(self):
        self.good(*self.render("--fields", "npy"))
        files = self.content("out")
        self.assertEqual(sorted(files), sorted(["as-run.json", "manifest.json"] + [f"{i:06}.{kind}" for i in range(4)
                                                                    for kind in ("png", "dish.npy", "dish.u.npy")]))
        rows, columns, values = read_npy(files["000000.dish.npy"])
        self.assertEqual((rows, columns), (4, 5))
        self.assertEqual(values, tuple(0.5 if c == "#" else 0.0 for row in ROWS for c in row))
        # u is 1 - v in frame 0, but not in later frames.
        self.assertEqual(read_npy(files["000000.dish.u.npy"])[2], tuple(1 - value for value in values))
        _, _, later = read_npy(files["000003.dish.npy"])
        self.assertNotEqual(read_npy(files["000003.dish.u.npy"])[2], tuple(1 - value for value in later))
        self.assertNotEqual(later, values)
        self.assertTrue(all(0 <= value <= 1 for value in later), later)

    def test_pfm_and_bake_hold_the_same_values(self):
        self.good(*self.render("--fields", "npy"))
        self.good("render", "scene.json", "-o", "other_##.png", "--fields", "pfm", "--frames", "3")
        self.good("bake", "scene.json", "-o", "baked", "--format", "npy", "--frames", "1,3")
        wanted = self.content("out")["000003.dish.npy"]
        self.assertEqual(read_pfm((self.folder / "other_03.dish.pfm").read_bytes()), read_npy(wanted))
        baked = self.content("baked")
        self.assertEqual(sorted(baked), ["dish.u_000001.npy", "dish.u_000003.npy", "dish_000001.npy", "dish_000003.npy"])
        self.assertEqual(baked["dish.u_000003.npy"], self.content("out")["000003.dish.u.npy"])
        self.assertEqual(baked["dish_000003.npy"], wanted)

    def test_clamped_values_are_reported_once(self):
        """Without feed and kill the sum of u and v is conserved, except for values clamped to 1."""
        dish = {"size": [31, 24], "feed": 0, "kill": 0, "steps": 10, "seeds": {"count": 3, "radius": 4}}
        scene = with_values({"objects": {"dish": {"grayScott": dish}}, "time.duration": 1}, SCENE)
        self.write("scene.json", scene)

        def mass(frame):
            return sum(sum(read_npy(self.content("out")[f"{frame:06}.dish{name}.npy"])[2]) for name in ("", ".u"))
        for path in ("texel", "storage"):
            done = self.good(*self.render("--fields", "npy", "--overwrite", "--memory-path", path))
            self.assertEqual(done.err.count("is held there"), 1, done.err)
            self.assertIn("grayScott \"dish\"", done.err)
            self.assertLess(mass(29), mass(0) - 0.1)
        # There must be no message if no value is clamped.
        for values in ({"diffuseV": 0.21, "dt": 0.4}, {"feed": 0.03, "kill": 0.06}):
            scene["objects"]["dish"]["grayScott"] = {**dish, **values}
            self.write("scene.json", scene)
            for path in ("texel", "storage"):
                done = self.good(*self.render("--fields", "npy", "--overwrite", "--memory-path", path))
                self.assertNotIn("held", done.err)
            if "dt" in values:
                self.assertAlmostEqual(mass(29), mass(0), delta=0.001)

    def test_existing_files(self):
        self.write("out/000002.dish.npy", "mine")
        self.bad(6, ["000002.dish.npy", "--overwrite"], *self.render("--fields", "npy"))
        self.assertEqual(self.content("out"), {"000002.dish.npy": b"mine"})
        self.good(*self.render("--fields", "npy", "--skip-existing"))
        self.assertEqual((self.folder / "out/000002.dish.npy").read_bytes(), b"mine")
        self.good(*self.render("--fields", "npy", "--overwrite"))
        whole = self.content("out")
        self.assertEqual(read_npy(whole["000002.dish.npy"])[:2], (4, 5))
        # Resuming repairs truncated or missing files and leaves the others unchanged.
        (self.folder / "out/000001.dish.npy").write_bytes(whole["000001.dish.npy"][:-3])
        (self.folder / "out/000003.dish.npy").unlink()
        before = (self.folder / "out/000002.dish.npy").stat().st_mtime_ns
        self.good(*self.render("--fields", "npy", "--resume"))
        self.assertEqual(self.content("out"), whole)
        self.assertEqual((self.folder / "out/000002.dish.npy").stat().st_mtime_ns, before)

    def test_chosen_fields_alone_are_written(self):
        self.good(*self.render("--fields", "dish.u", "--frames", "3"))
        self.assertEqual([name for name in self.content("out") if "dish" in name], ["000003.dish.u.npy"])
        self.good("render", "scene.json", "-o", "other/", "--fields", "dish,pfm", "--frames", "3")
        self.assertEqual([name for name in self.content("other") if "dish" in name], ["000003.dish.pfm"])
        self.good("bake", "scene.json", "-o", "baked", "--fields", "dish.u", "--frames", "3")
        self.assertEqual(self.content("baked"), {"dish.u_000003.npy": self.content("out")["000003.dish.u.npy"]})
        self.bad(2, 'did you mean "dish.u"?', "render", "scene.json", "-o", "a/", "--fields", "npy,dish.w")
        self.bad(2, 'did you mean "dish.u"?', "bake", "scene.json", "-o", "b", "--fields", "dish.w")
        self.bad(2, "one format", "render", "scene.json", "-o", "a/", "--fields", "npy,pfm")
        self.bad(2, "a name is empty", "render", "scene.json", "-o", "a/", "--fields", "dish,,dish.u")
        self.bad(2, "npy or pfm", "bake", "scene.json", "-o", "b", "--fields", "dish", "--format", "ply")

    def test_mistakes(self):
        self.bad(2, ["--fields", "folder"], "render", "scene.json", "-o", "film.mp4", "--fields", "npy")
        self.bad(2, "tiff", *self.render("--fields", "tiff"))
        self.write("cloth.json", SCENE)
        self.bad(2, "no object of the scene is a field", "render", "cloth.json", "-o", "out/", "--fields", "npy")
        self.bad(2, "no object of the scene has a field", "bake", "cloth.json", "-o", "out", "--format", "pfm")
        self.bad(2, ["nobody", "dish"], "bake", "scene.json", "-o", "out", "--format", "pfm", "--object", "nobody")
        # A folder with the name of the file prevents writing.
        (self.folder / "out/000001.dish.npy").mkdir(parents=True)
        self.bad(6, "000001.dish.npy", *self.render("--fields", "npy", "--overwrite"))


    def test_damaged_files_are_written_again(self):
        self.good(*self.render("--fields", "npy"))
        whole = self.content("out")
        kept = (self.folder / "out/000000.dish.npy").stat().st_mtime_ns
        for damage in (lambda p: p.write_bytes(b""), lambda p: p.write_bytes(p.read_bytes()[:-1] + b"x"),
                       lambda p: p.unlink()):
            damage(self.folder / "out/000002.dish.npy")
            self.good(*self.render("--fields", "npy", "--resume"))
            self.assertEqual(self.content("out"), whole)
        self.assertEqual((self.folder / "out/000000.dish.npy").stat().st_mtime_ns, kept)

    def test_damaged_files_are_not_listed_by_a_run_without_fields(self):
        """The manifest does not list damaged files as complete."""
        self.good(*self.render("--fields", "npy"))
        (self.folder / "out/000002.dish.npy").write_bytes(b"")
        self.good(*self.render("--resume"))
        frames = self.manifest("out")["frames"]
        self.assertEqual([f"{i:06}.dish.npy" in frame["files"] for i, frame in enumerate(frames)], [True, True, False, True])
        self.assertTrue(all(f"{i:06}.dish.u.npy" in frame["files"] for i, frame in enumerate(frames)))

    def test_fields_are_added_to_existing_frames(self):
        self.good(*self.render())
        self.good(*self.render("--fields", "npy", "--resume"))
        files = self.content("out")
        self.good("render", "scene.json", "-o", "whole/", "--fields", "npy")
        self.assertEqual(files, self.content("whole"))


if __name__ == "__main__":
    main()
