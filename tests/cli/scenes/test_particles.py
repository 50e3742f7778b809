"""Tests particles through the command line: unusable files, and state that other programs can read."""
from common import Case, main
from test_bake import read_ply

PLY = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"


class Particles(Case):
    def set_groups(self, groups, **others):
        self.write("scene.json", {"version": 1, "time": {"fps": 30, "duration": 0.1},
                                  "render": {"size": [64, 36], "samples": 1},
                                  "objects": {"p": {"particles": {"groups": groups, **others}}}})

    def test_files_that_cannot_be_used(self):
        for name, content, words in (
                ("a.csv", "", "no particles"), ("a.csv", "x,y,z\n1,2\n", ["line 2", "2 values"]),
                ("a.csv", "x,y,z,mass\n1,2,3,nan\n", ["line 2", "mass is not a finite number"]),
                ("a.csv", "x,y,z,mass\n1,2,3,0\n", ["line 2", "the mass is 0"]),
                ("a.csv", "a,b\n1,2\n", 'no column "x"'), ("a.csv", "x,y,z\n1,2,hello\n", '"hello" is not a number'),
                ("a.ply", PLY + "1 2 3\n", "vertex 1 of 2"), ("a.ply", "plx\n", "a.ply")):
            self.write(name, content)
            self.set_groups([{"shape": "file", "file": name}])
            done = self.run_program("render", "scene.json", "-o", "out/")
            self.assertEqual(done.returncode, 6, f"{content!r}: {done.err}")
            self.assertEqual(len(done.err.splitlines()), 1, done.err)
            self.assert_words(words, done)
            self.assertFalse((self.folder / "out").exists())

    def test_too_many_particles_are_refused(self):
        self.set_groups([{"count": 200_000_000}])
        self.bad_scene("16777216", "render", "scene.json", "-o", "out/")

    def test_a_particle_file_is_read_and_baked_back(self):
        self.write("a.csv", "x,y,z,vx,vy,vz,mass\n1,0,0,0,0.5,0,2\n-1,0,0,0,-0.5,0,2\n0,3,0,0,0,0,1\n")
        self.set_groups([{"shape": "file", "file": "a.csv"}], method="none")
        self.good("bake", "scene.json", "-o", "out")
        _, names, rows = read_ply((self.folder / "out/p_000000.ply").read_bytes())
        self.assertEqual(names, ["x", "y", "z", "mass", "vx", "vy", "vz", "age"])
        self.assertEqual([row[:4] for row in rows], [(1, 0, 0, 2), (-1, 0, 0, 2), (0, 3, 0, 1)])
        # Without forces, a particle moves in a straight line, for 1/30 s per frame.
        _, _, rows = read_ply((self.folder / "out/p_000002.ply").read_bytes())
        self.assertAlmostEqual(rows[0][1], 0.5 * 2 / 30, places=6)
        # Baked particles must be readable as input.
        (self.folder / "out/p_000002.ply").rename(self.folder / "b.ply")
        self.set_groups([{"shape": "file", "file": "b.ply"}], method="none")
        self.good("bake", "scene.json", "-o", "again", "--frames", "0")
        self.assertEqual(read_ply((self.folder / "again/p_000000.ply").read_bytes())[2], rows)

    def test_glows_look_the_same_on_both_memory_paths(self):
        """Sizes from specks to glows that cover the picture; positions before, inside and behind a sphere, and behind
        the camera."""
        rows = [(x, y, z, 8.0 ** (i % 5 - 2)) for i, (x, y, z) in enumerate(
            (0.37 * (i % 9) - 1.5, 0.29 * (i % 7) - 0.9, 0.41 * (i % 11) - 2.2) for i in range(83))]
        self.write("a.csv", "x,y,z,mass\n0.2,0.1,4.7,300\n" + "".join(
            f"{x:.3f},{y:.3f},{z:.3f},{mass}\n" for x, y, z, mass in rows))
        look = {"additive": True, "brightness": 0.15, "size": 0.03, "massExponent": 0.6}
        for samples in (1, 4):
            self.write("scene.json", {
                "version": 1, "time": {"fps": 30, "duration": 0}, "camera": {"position": [0, 0.3, 4], "target": [0, 0, 0]},
                "sky": {"zenith": [0, 0, 0.01], "horizon": [0.01, 0.01, 0.02], "ground": [0, 0, 0]},
                "render": {"size": [203, 117], "samples": samples, "bloom": {"strength": 0.3}},
                "objects": {"ball": {"sphere": {"radius": 0.8}},
                            "p": {"particles": {"groups": [{"shape": "file", "file": "a.csv"}], "method": "none",
                                                "look": look}}}})
            for path in ("texel", "storage"):
                self.good("render", "scene.json", "-o", f"{path}.png", "--memory-path", path, "--overwrite")
            self.good("diff", "texel.png", "storage.png", "--max-channel-diff", "3", "--max-diff-ratio", "0.002",
                      "--hard-fail", "12")
            self.good("render", "scene.json", "-o", "none.png", "-D", "objects.p.particles.look.brightness=0", "--overwrite")
            done = self.run_program("diff", "texel.png", "none.png", "--max-channel-diff", "3", "--max-diff-ratio", "0.3")
            self.assertEqual(done.returncode, 1, "the glows do not show")


if __name__ == "__main__":
    main()
