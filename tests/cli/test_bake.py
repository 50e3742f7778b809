"""`simreel bake` as a user meets it."""
import struct

from common import Case, main, with_values


def read_ply(data):
    """(comments, column names, rows) of a binary PLY of floats."""
    head, _, body = data.partition(b"end_header\n")
    lines = head.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"], lines
    names = [line.split()[2] for line in lines if line.startswith("property float ")]
    (count,) = [int(line.split()[2]) for line in lines if line.startswith("element vertex ")]
    assert len(body) == count * len(names) * 4, (len(body), count)
    values = struct.unpack(f"<{count * len(names)}f", body)
    rows = [values[i:i + len(names)] for i in range(0, len(values), len(names))]
    return [line[8:] for line in lines if line.startswith("comment ")], names, rows


class Bake(Case):
    def read(self, name):
        return read_ply((self.folder / name).read_bytes())

    def test_points_of_every_frame(self):
        self.good("bake", "scene.json", "-o", "out")
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()),
                         [f"flag_{frame:06}.ply" for frame in range(6)])
        comments, names, rows = self.read("out/flag_000005.ply")
        self.assertEqual(names, ["x", "y", "z", "vx", "vy", "vz"])
        self.assertEqual(len(rows), 9 * 7)
        self.assertIn("object flag frame 5 time 0.166667 s seed 1", comments)
        # It falls from rest: lower in each frame, and faster.
        heights = [sum(row[1] for row in self.read(f"out/flag_{frame:06}.ply")[2]) for frame in range(6)]
        self.assertEqual(heights, sorted(heights, reverse=True))
        self.assertEqual({row[3:] for row in self.read("out/flag_000000.ply")[2]}, {(0.0, 0.0, 0.0)})
        self.assertLess(min(row[4] for row in rows), 0)

    def test_some_frames_are_the_same_as_all(self):
        self.good("bake", "scene.json", "-o", "all")
        self.good("bake", "scene.json", "-o", "some", "--frames", "2,4", "--object", "flag")
        some = self.content("some")
        self.assertEqual(some, {name: self.content("all")[name] for name in ("flag_000002.ply", "flag_000004.ply")})

    def test_existing_files_are_kept(self):
        self.write("out/flag_000003.ply", "mine")
        self.bad(6, ["out/flag_000003.ply", "--overwrite"], "bake", "scene.json", "-o", "out")
        self.assertEqual(self.content("out"), {"flag_000003.ply": b"mine"})
        self.good("bake", "scene.json", "-o", "out", "--overwrite")
        self.assertEqual(len(self.content("out")), 6)

    def test_mistakes(self):
        self.bad(2, ["nobody", "flag"], "bake", "scene.json", "-o", "out", "--object", "nobody")
        self.write("scene.json", with_values({"objects": {"ball": {"sphere": {}}}}))
        self.bad(2, "no object of the scene has points", "bake", "scene.json", "-o", "out")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
