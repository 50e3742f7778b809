"""Tests the page of `simreel serve` in Firefox: it loads, a slider changes the picture, a baseline is shown beside it,
and the console stays empty. Skipped (exit code 77) without Firefox."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

from common import SCENE, png_rows, unfiltered, with_values
from firefox import FIREFOX, Firefox
from serve_client import PROGRAM, Server

REST = "page.simreel && page.simreel.state.picture && !page.simreel.state.picture.draft"
PIXELS = """const canvas = document.getElementById("picture");
    const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    return [canvas.width, canvas.height, [...bytes].filter((_, i) => i % 4 !== 3)];"""
SLIDE = """const slider = document.querySelector(".row[data-path='sun.intensity'] input[type='range']");
    slider.max = 30; slider.value = 20;
    slider.dispatchEvent(new Event("input")); slider.dispatchEvent(new Event("change"));"""


class PageInFirefox(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="simreel-serve-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = self.folder / "scene.json"
        self.scene.write_text(json.dumps(with_values({"test": {"frames": [0], "size": [48, 32]}})))
        subprocess.run([PROGRAM, "test", self.scene, "--update"], check=True, stdout=subprocess.DEVNULL)
        self.server = Server(self.scene)
        self.addCleanup(self.server.stop)
        self.browser = Firefox()
        self.addCleanup(self.browser.quit)

    def until(self, condition, seconds=600):
        end = time.monotonic() + seconds
        while not self.browser.run(f"return Boolean({condition})"):
            self.assertLess(time.monotonic(), end, condition)
            time.sleep(0.05)

    def shows(self, *arguments):
        out = self.folder / "rendered.png"
        subprocess.run([PROGRAM, "render", self.scene, "-o", out, "--frames", "0", "--overwrite", *arguments], check=True)
        width, height, rows = png_rows(out.read_bytes())
        wanted = [width, height, list(b"".join(unfiltered(rows, 3 * width, 3)))]
        end = time.monotonic() + 600
        while (pixels := self.browser.run(PIXELS)) != wanted:
            self.assertLess(time.monotonic(), end, "the picture is another one")
            time.sleep(0.1)
        return pixels

    def test_the_page_works(self):
        b = self.browser
        b.size(1280, 800)
        b.command("WebDriver:Navigate", url=self.server.page)
        self.until(REST)
        before = self.shows()
        b.run("const filter = document.getElementById('filter'); filter.value = 'intensity'; filter.dispatchEvent(new Event('input'));")
        self.until("document.querySelector(\".row[data-path='sun.intensity'] input[type='range']\")")
        b.run(SLIDE)
        self.until("page.simreel.state.scene.edits.length === 1")
        self.assertNotEqual(self.shows("-D", "sun.intensity=20"), before)
        b.click("#compare")
        self.until("document.getElementById('verdict').textContent.includes('of 1536 pixels differ')")
        self.until("[...document.querySelectorAll('#pairs img')].filter((image) => image.naturalWidth === 48).length === 3")
        b.click("#forget")
        self.until("document.getElementById('verdict').textContent === 'Every pixel is equal to the baseline.'")
        self.assertEqual(self.shows(), before)
        # Ignores the warning about reading the canvas, because only this test reads it.
        self.assertEqual([text for text in b.complaints(self.server.page) if "willReadFrequently" not in text], [])
        # Checks that messages are detected at all. The policy forbids inline scripts, so this script causes a message.
        b.run("document.body.append(Object.assign(document.createElement('script'), {textContent: '0'}))")
        end = time.monotonic() + 600
        while not any("script-src" in text for text in b.complaints("")):
            self.assertLess(time.monotonic(), end, "the console says nothing of a script that was not let in")
            time.sleep(0.1)


if __name__ == "__main__":
    if not FIREFOX:
        print("skipped: firefox-esr not installed (tools/setup installs what the tests need)")
        sys.exit(77)
    os.chdir(tempfile.gettempdir())
    unittest.main(verbosity=2)
