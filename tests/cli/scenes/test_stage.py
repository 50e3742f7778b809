"""Scenes of one line stand on a stage: their pictures, against baselines beside them."""
from common import SOURCE, Case, main


class Stage(Case):
    def test_pictures_of_scenes_of_one_line(self):
        done = self.good("test", str(SOURCE / "tests/cli/scenes/stage"))
        self.assertIn("4 scenes: 4 passed", done.stdout.decode())


if __name__ == "__main__":
    main()
