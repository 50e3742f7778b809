"""Tests the page of `simreel serve` in a browser: actions change the picture, and the picture equals that of `simreel
render`. Skipped (exit code 77) without Chromium or Selenium."""
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

CHROMIUM, CHROMEDRIVER = shutil.which("chromium"), shutil.which("chromedriver")


def missing():
    packages = {"chromium": CHROMIUM, "chromium-driver": CHROMEDRIVER,
                "python3-selenium": importlib.util.find_spec("selenium")}
    return [name for name, found in packages.items() if not found]


if not missing():
    from common import PATIENCE, SCENE, png_rows, unfiltered, with_values
    from driver import Browser, Keys
    from serve_client import PROGRAM, Server

# Script that returns the displayed size and the RGB of every pixel.
PIXELS = """const canvas = document.getElementById(arguments[0] ?? "picture");
    const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    return [canvas.width, canvas.height, [...bytes].filter((_, i) => i % 4 !== 3)];"""
REST = "globalThis.simreel && simreel.state.picture && !simreel.state.picture.draft && !simreel.state.picture.carried"


class PageOfServe(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(CHROMIUM, CHROMEDRIVER, requests=False)
        cls.browser.size(1000, 640)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="simreel-serve-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = self.folder / "scene.json"

    def open(self, *arguments, scene=None):
        self.scene.write_text(json.dumps(scene or SCENE, indent=2))
        server = Server(self.scene, *arguments)
        self.addCleanup(server.stop)
        self.browser.problems()
        self.browser.driver.get(server.page)
        self.at(0)
        self.addCleanup(lambda: self.browser.driver.get("about:blank"))
        return self.browser

    def at(self, frame):
        self.assertTrue(self.browser.until(f"{REST} && simreel.state.picture.frame === {frame}"), frame)

    def pixels(self, canvas="picture"):
        width, height, rgb = self.browser.run(PIXELS, canvas)
        return width, height, bytes(rgb)

    def rendered(self, frame, *arguments):
        out = self.folder / "rendered.png"
        subprocess.run([PROGRAM, "render", self.scene, "-o", out, "--frames", str(frame), "--overwrite", *arguments], check=True)
        width, height, rows = png_rows(out.read_bytes())
        return width, height, b"".join(unfiltered(rows, 3 * width, 3))

    def shows(self, frame, *arguments, canvas="picture"):
        """Waits until the picture equals render's. Renders again each time, because the last change of a drag may reach
        the scene's file late."""
        end = time.monotonic() + PATIENCE
        while self.pixels(canvas) != self.rendered(frame, *arguments):
            self.assertLess(time.monotonic(), end, "the picture is another one")
            self.browser.until("false", 0.1)

    def row(self, path, kind):
        return f".row[data-path='{path}'] input[type='{kind}']"

    def tearDown(self):
        # Ignores the warning about reading the canvas, because only these tests read it.
        self.assertEqual([text for text in self.browser.problems() if "willReadFrequently" not in text], [])

    def test_scrubbing_back_shows_what_render_draws(self):
        b = self.open()
        b.keys(Keys.END)
        self.at(5)
        self.shows(5)
        b.run("""const scrub = document.getElementById("scrub"); scrub.value = 2;
            scrub.dispatchEvent(new Event("input")); scrub.dispatchEvent(new Event("change"));""")
        self.at(2)
        self.shows(2)
        b.keys(Keys.ARROW_LEFT)
        self.at(1)
        self.shows(1)
        self.assertEqual(b.text("#clock").split(" · ")[0], "1 / 5")
        self.addCleanup(b.size, 1000, 640)
        b.size(360, 640)
        self.assertLessEqual(b.value("document.documentElement.scrollWidth"), 360)

    def test_play_and_pause(self):
        b = self.open(scene=with_values({"time.duration": 60}))
        b.click("#play")
        self.assertTrue(b.until("simreel.state.status.playing && simreel.state.picture.frame > 3"))
        self.assertTrue(b.value("document.getElementById('play').getAttribute('aria-label') === 'Pause'"))
        b.keys(" ")
        self.assertTrue(b.until("!simreel.state.status.playing"))
        self.assertGreater(b.value("simreel.state.status.kept.count"), 3)
        b.run("document.getElementById('scrub').focus()")
        b.keys(" ")
        self.assertTrue(b.until("simreel.state.status.playing"))

    def test_a_slider_changes_the_picture_but_not_the_file(self):
        b = self.open()
        before, text = self.pixels(), self.scene.read_text()
        b.one("#filter").send_keys("intensity")
        self.assertTrue(b.until(f"document.querySelector(\"{self.row('sun.intensity', 'range')}\")"))
        b.run("""const slider = document.querySelector(arguments[0]); slider.max = 30; slider.value = 20;
            slider.dispatchEvent(new Event("input")); slider.dispatchEvent(new Event("change"));""", self.row("sun.intensity", "range"))
        self.assertTrue(b.until("simreel.state.scene.edits.length === 1"))
        self.shows(0, "-D", "sun.intensity=20")
        self.assertNotEqual(self.pixels(), before)
        self.assertEqual(self.scene.read_text(), text)
        b.click(".row[data-path='sun.intensity'] .undo")
        self.shows(0)

    def test_edit_writes_the_file(self):
        b = self.open("--edit")
        text, row = self.scene.read_text(), self.row("objects.flag.cloth.spacing", "number")
        put = "const box = document.querySelector(arguments[0]); box.value = arguments[1]; box.dispatchEvent(new Event('change'));"
        b.run(put, row, 0)  # the server rejects the value, so the box shows the previous value
        self.assertTrue(b.until("document.getElementById('note').classList.contains('report')"))
        self.assertEqual(b.value(f"document.querySelector(\"{row}\").value"), "0.1")
        b.run(put, row, 0.3)
        self.assertTrue(b.until("simreel.state.scene.scene.objects.flag.cloth.spacing === 0.3 && simreel.state.scene.edits.length === 0"))
        self.assertEqual(self.scene.read_text(), text.replace('"spacing": 0.1', '"spacing": 0.3'))
        self.shows(0)

    def save(self, text):
        """Writes the scene to a temporary file and renames it, as editors do, so that the server never reads half of
        it."""
        part = self.scene.with_suffix(".part")
        part.write_text(text)
        part.rename(self.scene)

    def test_errors_are_shown_over_the_last_valid_picture(self):
        b = self.open()
        before = self.pixels()
        text = self.scene.read_text()
        self.save(text.replace('"substeps": 4', '"substepz": 4'))
        self.assertTrue(b.until("!document.getElementById('mistakes').hidden"))
        self.assertRegex(b.text("#mistakes"), r"scene\.json:\d+:\d+: error: .*substeps.*\n.*substepz.*\n +\^")
        self.assertEqual(self.pixels(), before)
        self.save(text.replace('"jitter": 0.01', '"jitter": 0.02'))
        self.assertTrue(b.until("document.getElementById('mistakes').hidden"))
        self.shows(0)

    def test_the_mouse_moves_the_camera(self):
        b = self.open()
        before = self.pixels()
        box = b.box("#picture")
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        b.drag(x, y, x + 120, y + 40)
        at = "(simreel.state.scene.edits.find(([path]) => path === 'camera.position') ?? [])[1]"
        self.assertTrue(b.until(f"{at} === JSON.stringify(simreel.screen.panes[0].view.eye)"))
        edits = b.value("simreel.state.scene.edits.map(([path, value]) => `${path}=${value}`)")
        self.assertEqual(sorted(edit.split("=")[0] for edit in edits), ["camera.fieldOfView", "camera.position", "camera.target"])
        self.shows(0, *[word for edit in edits for word in ("-D", edit)])
        self.assertNotEqual(self.pixels(), before)
        b.wheel(x, y, 300)
        self.assertTrue(b.until(f"simreel.state.scene.edits.find(([path]) => path === 'camera.position')[1] !== "
                                f"{json.dumps(dict(e.split('=') for e in edits)['camera.position'])}"))
        self.assertTrue(b.until("!simreel.screen.held"))
        b.until("false", 0.2)
        b.click("#forget")
        self.shows(0)

    def test_the_wheel_zooms_an_orthographic_camera_by_its_height(self):
        b = self.open(scene=with_values({"camera.projection": "orthographic", "camera.height": 2}))
        before = b.value("simreel.screen.panes[0].view")
        box = b.box("#picture")
        b.wheel(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, 300)
        self.assertTrue(b.until("simreel.state.scene.edits.some(([path]) => path === 'camera.height')"))
        self.assertTrue(b.until("!simreel.screen.held"))
        after = b.value("simreel.screen.panes[0].view")
        self.assertGreater(after["height"], before["height"])
        self.assertEqual((after["eye"], after["target"]), (before["eye"], before["target"]))
        self.shows(0, *[word for path, value in b.value("simreel.state.scene.edits") for word in ("-D", f"{path}={value}")])

    def test_a_click_describes_the_pixel(self):
        b = self.open()
        box = b.box("#picture")
        x, y = box["x"] + box["width"] / 2, box["y"] + 0.6 * box["height"]
        b.drag(x, y, x, y)
        self.assertTrue(b.until("!document.getElementById('answer').hidden"))
        self.assertRegex(b.text("#answer h2 span"), r"^triangle \d+ of flag$")
        self.assertRegex(b.text("#answer table"), r"positions\.x-?[\d.]+[0-9a-f]{8}")

    def test_renders_what_is_on_screen(self):
        b = self.open("--output", self.folder / "out")
        b.keys(Keys.ARROW_RIGHT)
        self.at(1)
        b.click("#render")
        self.assertTrue(b.until("document.querySelector('#rendered a')"))
        width, height, rows = png_rows((self.folder / "out" / "scene_000001.png").read_bytes())
        self.assertEqual((width, height, b"".join(unfiltered(rows, 3 * width, 3))), self.rendered(1))
        self.assertEqual(b.run("return fetch('render.png').then((answer) => answer.headers.get('content-type'))"), "image/png")

    def test_keyframes_are_dragged_along_the_timeline(self):
        turning = with_values({"time.duration": 1, "camera.fieldOfView": {"keys": [[0, 30], [0.5, 40], [0.9, 50]]},
                               "sun.intensity": {"keys": [[0.2, 2], [0.5, 3]]}})
        b = self.open("--edit", scene=turning)
        text = self.scene.read_text()
        self.assertEqual(b.value("document.querySelectorAll('#keys i').length"), 4)
        track, mark = b.box("#track"), b.box("#keys i:nth-child(2)")
        x = lambda time: track["x"] + 6 + (track["width"] - 12) * time * 30 / 29
        y = mark["y"] + mark["height"] / 2
        self.assertAlmostEqual(mark["x"] + mark["width"] / 2, x(0.5), delta=1)
        b.drag(x(0.5), y, x(0.7), y)
        self.assertTrue(b.until("simreel.state.scene.scene.sun.intensity.keys[1][0] === 0.7 && simreel.state.scene.edits.length === 0"))
        self.assertEqual(self.scene.read_text(), text.replace("0.5,", "0.7,"))
        b.drag(x(0.7), y, x(1), y)  # the drag is limited to the frame before the next key of either value
        self.assertTrue(b.until("simreel.state.scene.scene.sun.intensity.keys[1][0] > 0.8 && simreel.state.scene.edits.length === 0"))
        self.assertEqual(b.value("simreel.state.scene.scene.camera.fieldOfView.keys[1][0]"), 0.866667)
        b.drag(x(0.9), y, x(0.9), y)
        self.at(27)
        self.shows(27)

    def test_a_dragged_keyframe_can_be_undone(self):
        b = self.open(scene=with_values({"camera.fieldOfView": {"keys": [[0, 30], [0.1, 60]]}}))
        before, box, track = self.scene.read_text(), b.box("#keys i:nth-child(2)"), b.box("#track")
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        b.drag(x, y, x + track["width"] / 5, y)
        self.assertTrue(b.until("simreel.state.scene.edits.length === 1 && simreel.state.scene.edits[0][0] === 'camera.fieldOfView.keys.1.0'"))
        b.keys(Keys.ARROW_RIGHT)
        self.at(1)
        self.shows(1, "-D", "camera.fieldOfView.keys.1.0=" + b.value("simreel.state.scene.edits[0][1]"))
        self.assertEqual(self.scene.read_text(), before)
        b.click(".row[data-path='camera.fieldOfView'] .undo")
        self.assertTrue(b.until("simreel.state.scene.edits.length === 0"))
        self.shows(1)

    def test_a_baseline_beside_the_picture(self):
        tested = with_values({"test": {"frames": [0, 3], "size": [48, 32]}})
        self.save(json.dumps(tested, indent=2))
        subprocess.run([PROGRAM, "test", self.scene, "--update"], check=True, stdout=subprocess.DEVNULL)
        b = self.open("--edit", scene=tested)
        self.assertFalse(b.visible("#golden"))
        b.click("#compare")
        self.assertTrue(b.until("document.getElementById('verdict').textContent === 'Every pixel is equal to the baseline.'"))
        self.assertFalse(b.visible("#accept"))
        b.one("#filter").send_keys("intensity")
        self.assertTrue(b.until(f"document.querySelector(\"{self.row('sun.intensity', 'number')}\")"))
        b.run("""const box = document.querySelector(arguments[0]); box.value = 9; box.dispatchEvent(new Event("change"));""",
              self.row("sun.intensity", "number"))
        self.assertTrue(b.until("document.getElementById('verdict').textContent.includes('of 1536 pixels differ')"))
        loaded = "[...document.querySelectorAll('#pairs img')].every((image) => image.naturalWidth === 48)"
        for mode, names in {"ours": ["ours"], "baseline": ["baseline"], "difference": ["difference"], "swipe": ["baseline", "ours"],
                            "beside": ["baseline", "ours", "difference"]}.items():
            b.click(f"#modes button[data-mode='{mode}']")
            self.assertEqual(b.value("[...document.querySelectorAll('#pairs figure')].map((one) => one.dataset.name)"), names)
            self.assertTrue(b.until(loaded), mode)
        ring, picture = b.box(".ring"), b.box("figure[data-name='difference'] img")
        worst = b.value("simreel.compare.message.worst")
        self.assertAlmostEqual(ring["x"] + ring["width"] / 2, picture["x"] + picture["width"] * (worst["x"] + 0.5) / 48, delta=1)
        b.keys(Keys.ARROW_RIGHT)
        self.at(1)
        self.assertTrue(b.until("document.getElementById('verdict').textContent === 'Frame 1 is not a tested frame; those are 0, 3.'"))
        self.assertFalse(b.visible("#pairs"))
        self.assertEqual(b.texts("#jumps button"), ["0", "3"])
        b.click("#testThis")
        self.assertTrue(b.until("document.getElementById('verdict').dataset.verdict === 'missing'"))
        self.assertEqual(json.loads(self.scene.read_text())["test"]["frames"], [0, 1, 3])
        b.click("#accept")
        self.assertTrue(b.until("document.getElementById('verdict').dataset.verdict === 'pass'"))
        subprocess.run([PROGRAM, "test", self.scene], check=True, stdout=subprocess.DEVNULL)
        b.click("#compare")
        self.assertTrue(b.until("document.getElementById('golden').hidden"))

    def test_two_sides_stay_at_the_same_frame(self):
        b = self.open(scene=with_values({"objects.flag.cloth.damping": 1}))
        self.assertFalse(b.visible("#pair, #pictureBeside"))
        b.keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        self.at(2)
        b.click("#beside")
        self.assertTrue(b.until("document.getElementById('pairWords').textContent === 'Every pixel is the same'"))
        self.assertTrue(b.value("document.querySelector('#pairSides [aria-pressed=true]').textContent === 'Right alone'"))
        b.run("""const box = document.querySelector(arguments[0]); box.value = 5; box.dispatchEvent(new Event("change"));""",
              self.row("objects.flag.cloth.damping", "number"))
        self.assertTrue(b.until("/^[1-9][0-9]* of 2,304 pixels differ/.test(document.getElementById('pairWords').textContent)"))
        right = ["-D", "objects.flag.cloth.damping=5"]
        self.shows(2, *right, canvas="pictureBeside")
        self.shows(2)
        self.assertEqual(b.texts(".chip"), ["objects.flag.cloth.damping = 5 ×"])
        b.click("#pairDifference")
        self.assertTrue(b.until("!document.getElementById('pictureDifference').parentNode.hidden && simreel.state.picture.files.length === 3"))
        boxes = [b.box(f"#{name}") for name in ("picture", "pictureBeside", "pictureDifference")]
        room = b.box("#screen")
        self.assertEqual(len({(round(box["width"]), round(box["height"])) for box in boxes}), 1)
        self.assertTrue(all(box["x"] >= room["x"] and box["right"] <= room["right"] and box["bottom"] <= room["bottom"] for box in boxes))
        b.run("""const scrub = document.getElementById("scrub"); scrub.value = 5; scrub.dispatchEvent(new Event("change"));""")
        self.at(5)
        self.shows(5, *right, canvas="pictureBeside")
        self.shows(5)
        # Dragging over either picture moves both cameras.
        x, y = boxes[1]["x"] + boxes[1]["width"] / 2, boxes[1]["y"] + boxes[1]["height"] / 2
        b.drag(x, y, x + 50, y + 10)
        at = "(simreel.state.scene.edits.find(([path]) => path === 'camera.position') ?? [])[1]"
        self.assertTrue(b.until(f"{at} === JSON.stringify(simreel.screen.panes[1].view.eye)"))
        edits = [word for path, value in b.value("simreel.state.scene.edits") for word in ("-D", f"{path}={value}")]
        self.assertEqual(len(edits), 6)
        self.shows(5, *edits, *right, canvas="pictureBeside")
        self.shows(5, *edits)
        b.click(".chip button")
        self.assertTrue(b.until("document.getElementById('pairWords').textContent === 'Every pixel is the same'"))
        b.click("#beside")
        self.assertTrue(b.until("document.getElementById('pictureBeside').parentNode.hidden"))

    def test_the_right_side_has_its_own_file(self):
        other = self.folder / "other.json"
        other.write_text(json.dumps(with_values({"objects.flag.cloth.damping": 2}), indent=2))
        b = self.open(other, "--edit", scene=with_values({"objects.flag.cloth.damping": 1}))
        left, right = self.scene.read_text(), other.read_text()
        b.click("#pairSides [data-side='right']")
        row = self.row("objects.flag.cloth.damping", "number")
        self.assertEqual(b.value(f"document.querySelector(\"{row}\").value"), "2")
        b.run("const box = document.querySelector(arguments[0]); box.value = 3; box.dispatchEvent(new Event('change'));", row)
        self.assertTrue(b.until("simreel.state.scene.beside.scene.objects.flag.cloth.damping === 3 && simreel.state.scene.beside.edits.length === 0"))
        b.click("#compare")
        self.assertTrue(b.until("document.getElementById('verdict').textContent.startsWith('Right side: This scene has no baseline yet')"))
        b.click("#pairSides [data-side='left']")
        self.assertTrue(b.until("document.getElementById('verdict').textContent.startsWith('This scene has no baseline yet')"))
        self.assertEqual((self.scene.read_text(), other.read_text()), (left, right.replace('"damping": 2', '"damping": 3')))

    def test_editing_one_component_or_a_colour_keeps_other_numbers(self):
        b = self.open(scene=with_values({"sun.color": [1, 0.9, 0.8], "camera.position": [0.1234567, 1, 3]}))
        b.one("#filter").send_keys("camera.position")
        box = ".row[data-path='camera.position'] input[type='number']"
        self.assertTrue(b.until(f"document.querySelector(\"{box}\")"))
        b.run("const box = document.querySelectorAll(arguments[0])[1]; box.value = 1.5; box.dispatchEvent(new Event('change'));", box)
        self.assertTrue(b.until("simreel.state.scene.edits.length === 1"))
        self.assertEqual(b.value("simreel.state.scene.edits[0]"), ["camera.position", "[0.1234567,1.5,3]"])
        b.run("const filter = document.getElementById('filter'); filter.value = 'sun.color'; filter.dispatchEvent(new Event('input'));")
        self.assertTrue(b.until(f"document.querySelector(\"{self.row('sun.color', 'color')}\")"))
        b.run("""const picker = document.querySelector(arguments[0]); picker.value = "#ff8000";
            picker.dispatchEvent(new Event("input")); picker.dispatchEvent(new Event("change"));""", self.row("sun.color", "color"))
        self.assertTrue(b.until("simreel.state.scene.edits.length === 2 && simreel.state.scene.edits[1][1] === '[1,0.216,0]'"))
        self.shows(0, "-D", "camera.position=[0.1234567,1.5,3]", "-D", "sun.color=[1,0.216,0]")

    def test_keyframes_are_added_and_removed(self):
        b = self.open("--edit", scene=with_values({"camera.fieldOfView": 40}))
        key, value = ".row[data-path='camera.fieldOfView'] .key", "simreel.state.scene.scene.camera.fieldOfView"
        b.click(key)
        self.assertTrue(b.until(f"JSON.stringify({value}) === '{{\"keys\":[[0,40]]}}'"))
        b.keys(Keys.END)
        self.at(5)
        b.click(key)
        self.assertTrue(b.until(f"{value}.keys?.length === 2"))
        b.run("""const box = document.querySelectorAll(arguments[0])[3]; box.value = 60; box.dispatchEvent(new Event("change"));""",
              self.row("camera.fieldOfView", "number"))
        self.assertTrue(b.until(f"{value}.keys[1][1] === 60 && simreel.state.scene.edits.length === 0"))
        self.assertEqual(json.loads(self.scene.read_text())["camera"]["fieldOfView"], {"keys": [[0, 40], [0.166667, 60]]})
        self.assertEqual(b.value("document.querySelectorAll('#keys i').length"), 2)
        b.keys(Keys.HOME)
        self.at(0)
        b.click(key)
        self.assertTrue(b.until(f"{value}.keys?.length === 1"))
        b.keys(Keys.END)
        self.at(5)
        b.click(key)
        self.assertTrue(b.until(f"{value} === 60"))
        self.shows(5)

    def test_a_brush_adds_strokes(self):
        b = self.open("--edit", scene={"version": 1, "render": {"size": [64, 64], "samples": 1}, "time": {"fps": 30, "duration": 0.2},
                                       "objects": {"dish": {"grayScott": {"size": [64, 64], "steps": 4}}}})
        b.keys(Keys.ARROW_RIGHT)
        self.at(1)
        before, box = self.pixels(), b.box("#picture")
        b.click("#brush")
        y = box["y"] + 0.3 * box["height"]
        b.drag(box["x"] + 0.2 * box["width"], y, box["x"] + 0.7 * box["width"], y)
        strokes = "simreel.state.scene.scene.objects.dish.grayScott.strokes"
        self.assertTrue(b.until(f"{strokes}?.length >= 2 && simreel.state.scene.edits.length === 0"))
        self.shows(1)
        self.assertNotEqual(self.pixels(), before)
        self.assertEqual(len(json.loads(self.scene.read_text())["objects"]["dish"]["grayScott"]["strokes"]), b.value(f"{strokes}.length"))

    def test_charts_mark_failed_checks(self):
        b = self.open(scene=with_values({"checks": [{"what": "mass", "min": 60, "max": 70}, {"what": "speed", "max": 0.01}]}))
        b.keys(Keys.ARROW_RIGHT)
        self.at(1)
        self.assertTrue(b.until("document.querySelectorAll('.chart.bad').length === 1"))
        self.assertEqual(b.texts(".chart header span")[:2], ["flag · mass", "flag · speed"])
        self.assertIn("flag · speed", b.text(".chart.bad header"))
        self.assertGreater(b.value("document.querySelectorAll('.chart line.bound').length"), 0)

    def test_markup_in_texts_is_escaped(self):
        b = self.open(scene=with_values({"title": "<img src=x onerror=alert(1)>"}))
        self.assertEqual(b.text("#title"), "<img src=x onerror=alert(1)>")
        self.save('{"version": 1, "<script>alert(1)</script>": 2}')
        self.assertTrue(b.until("!document.getElementById('mistakes').hidden"))
        self.assertIn("<script>", b.text("#mistakes"))
        self.assertEqual(b.value("document.scripts.length"), 1)


if __name__ == "__main__":
    if missing():
        print(f"skipped: {', '.join(missing())} not installed (tools/setup installs what the tests need)")
        sys.exit(77)
    os.chdir(tempfile.gettempdir())
    unittest.main(verbosity=2)
