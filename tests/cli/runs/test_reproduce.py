"""Tests simreel reproduce: renders a picture's frame again, from the files beside the picture or the data in it."""
import json
import shutil

from common import Case, main, with_values, without_hash


class Reproduce(Case):
    def setUp(self):
        super().setUp()
        self.once("render", "scene.json", "-o", "out/", "--seed", "3", "-D", "objects.flag.cloth.jitter=0.02", "-D", "title=it's")

    def test_frames_are_reproduced_from_the_files_beside_them(self):
        (self.folder / "scene.json").unlink()  # `reproduce` does not need the scene's file.
        done = self.good("reproduce", "out/000003.png")
        self.assertEqual(done.stdout, b"out/000003.png: frame 3 is the same, in state and in every pixel\n")
        self.assertIn(b"frame 5 is the same", self.good("reproduce", "out").stdout)
        self.good("reproduce", "out/manifest.json", "--frame", "2", "-o", "again/")
        self.assertEqual(sorted(self.content("again")), ["000002.png", "as-run.json", "manifest.json"])
        self.assertEqual(self.content("again")["as-run.json"], self.content("out")["as-run.json"])

    def test_a_picture_alone_needs_its_scene(self):
        shutil.move(self.folder / "out/000004.png", self.folder / "lone.png")
        self.bad(2, ["no as-run.json beside lone.png", "--scene"], "reproduce", "lone.png")
        self.good("reproduce", "lone.png", "--scene", "scene.json")
        self.write("scene.json", with_values({"objects.flag.cloth.spacing": 0.11}))
        done = self.run_program("reproduce", "lone.png", "--scene", "scene.json")
        self.assertEqual(done.returncode, 1)
        for word in ("not the same", "state: it was", "pixels: they were", "scene: scene.json is not the scene of the picture"):
            self.assertIn(word, done.stdout.decode())

    def test_folders_of_run_json_are_not_read(self):
        """run.json may come from a stranger together with the pictures, so it must not choose folders that are read."""
        self.write("in/t.png", (self.folder / "out/000000.png").read_bytes())
        self.write("in/scene.json", with_values({"objects.flag.material": {"texture": "t.png"}}))
        self.good("render", "in/scene.json", "-o", "there/", "--frames", "0")
        done = self.run_program("reproduce", "there/000000.png")
        self.assertEqual(done.returncode, 2, done.err)
        self.assert_words(["t.png", f"with: --assets {self.folder}/in"], done)
        self.good("reproduce", "there/000000.png", "--assets", "in")

    def test_differences_are_reported(self):
        def told(*arguments):
            done = self.run_program("reproduce", *arguments)
            self.assertEqual(done.returncode, 1, done.err)
            return done.stdout.decode()
        whole = self.content("out")
        shutil.copy(self.folder / "out/000002.png", self.folder / "out/000001.png")
        self.assertIn("picture: out/000001.png was changed", told("out/000001.png"))
        text = whole["as-run.json"].decode()
        self.write("out/as-run.json", text.replace('"jitter": 0.02', '"jitter": 0.03'))
        self.assertIn("scene: out/as-run.json was changed afterwards", told("out/000002.png"))
        self.write("out/as-run.json", text)
        self.write("out/manifest.json", without_hash(whole["manifest.json"].decode().replace('"program": "', '"program": "9')))
        self.assertIn(b"version: simreel 9", self.good("reproduce", "out/000002.png").stdout)

    def test_mistakes(self):
        self.bad(2, "not a picture that simreel rendered", "reproduce", "scene.json")
        self.bad(2, "no frame 77", "reproduce", "out/manifest.json", "--frame", "77")
        self.bad(2, "--frame needs a manifest", "reproduce", "out/000001.png", "--frame", "2")
        self.bad(2, "nowhere.png", "reproduce", "nowhere.png")

    def test_the_scene_beside_a_video_and_a_still(self):
        self.good("render", "scene.json", "-o", "poster.png", "--frames", "3")
        self.assertTrue((self.folder / "poster.as-run.json").exists())
        self.assertEqual(json.loads((self.folder / "poster.as-run.json").read_text()), json.loads((self.folder / "scene.json").read_text()))
        self.good("reproduce", "poster.png")
        self.good("render", "scene.json", "-o", "a.mp4", "--frames", "0-3")
        self.assertIn(b"a.mp4: frame 2 is the same", self.good("reproduce", "a.mp4", "--frame", "2").stdout)


if __name__ == "__main__":
    main()
