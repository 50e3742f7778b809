"""Shared helpers of the tests of `simreel serve`: servers that end with their test, and pictures by `simreel
render`."""
import os
import signal

from common import PROGRAM, Case, png_rows, unfiltered
from serve_client import Server

os.environ.setdefault("SIMREEL", PROGRAM)

FIELD = {
    "version": 1,
    "render": {"size": [64, 64], "samples": 1},
    "time": {"fps": 30, "duration": 0.4},
    "objects": {"dish": {"grayScott": {"size": [64, 64], "steps": 4}}},
}


class ServeCase(Case):
    mistake = None  # the only error that the terminal may show

    def serve(self, *arguments, scene="scene.json"):
        server = Server(self.folder / scene, *arguments, cwd=self.folder)
        self.addCleanup(self.end, server)
        return server

    def end(self, server, expected=(128 + signal.SIGTERM,)):
        code, _, err = server.stop()
        self.assertIn(code, expected, err)
        shown = [line for line in err.splitlines() if "error" in line]
        self.assertEqual([line for line in shown if self.mistake is None or self.mistake not in line], [])

    def rendered(self, frame, *arguments, file="scene.json", frames=None):
        """Returns a frame as `simreel render` draws it. `frames`, such as "2-8", are rendered by the same process for
        later calls; each frame is rendered once."""
        text = (self.folder / file).read_bytes()
        known = self.__dict__.setdefault("pictures", {})
        if (text, arguments, frame) not in known:
            self.good("render", file, "-o", self.folder / "rendered_####.png", "--frames", frames or frame, "--overwrite", *arguments)
            for picture in self.folder.glob("rendered_*.png"):
                known[text, arguments, int(picture.stem[-4:])] = self.pixels(picture.read_bytes())
                picture.unlink()
        return known[text, arguments, frame]

    def pixels(self, png):
        width, height, rows = png_rows(png)
        step = (len(rows) // height - 1) // width
        return width, height, b"".join(unfiltered(rows, step * width, step))
