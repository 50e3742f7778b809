"""Tests the views of the pictures."""
import functools
import http.server
import shutil
import threading

from common import FLAG, ReportTest
from driver import Keys


class PictureTest(ReportTest):
    def middle(self, pane=0):
        box = self.browser.box(f".pane:nth-child({pane + 1})")
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def test_panes_side_by_side_move_together(self):
        b = self.open(FLAG + "side")
        self.assertEqual(b.texts(".pane figcaption"), ["expected", "actual", "difference"])
        self.assertEqual(b.picture_widths(), [320] * 3)
        before = b.transform()
        x, y = self.middle(1)
        point = b.picture_at(x + 40, y - 20, 1)
        b.wheel(x + 40, y - 20, -400)
        after = b.transform()
        self.assertGreater(after[0], 2 * before[0])
        for pane in (1, 2):
            self.assertEqual(b.transform(pane)[0], after[0])
            self.assertAlmostEqual(b.transform(pane)[1], after[1], delta=1.01)
        moved = b.picture_at(x + 40, y - 20, 1)
        self.assertAlmostEqual(moved[0], point[0], delta=1)
        self.assertAlmostEqual(moved[1], point[1], delta=1)
        b.drag(x, y, x + 50, y + 30)
        self.assertAlmostEqual(b.transform(2)[1] - after[1], 50, delta=2)
        self.assertAlmostEqual(b.transform()[2] - after[2], 30, delta=2)

    def test_zoom_buttons_and_keys(self):
        b = self.open(FLAG + "difference")
        fit = b.transform()
        pane = b.box(".pane")
        self.assertAlmostEqual(fit[0], min(pane["width"] / 320, pane["height"] / 180), places=3)
        b.click("#oneToOne")
        self.assertEqual((b.transform()[0], b.text("#zoom")), (1, "100 %"))
        b.keys("+", "+")
        self.assertEqual(b.transform()[0], 3)
        b.keys("-")
        self.assertEqual(b.transform()[0], 2)
        self.assertEqual(b.style(".layer img", "imageRendering"), "pixelated")
        b.keys("0")
        self.assertEqual(b.transform(), fit)
        b.click("#zoomIn")
        self.assertGreater(b.transform()[0], fit[0])
        b.click("#zoomOut")
        b.click("#fit")
        self.assertEqual(b.transform(), fit)
        b.keys("o")
        left = b.transform()[1]
        b.keys_with_shift(Keys.ARROW_RIGHT)
        self.assertEqual(b.transform()[1], left - 60)

    def test_zoom_stays_from_frame_to_frame(self):
        b = self.open(FLAG + "difference")
        b.keys("o", "+", "+", "l")
        self.assertEqual((self.chosen()[1], b.transform()[0]), (150, 3))
        b.keys("j")
        self.assertEqual(b.value("viewer.scale"), None)  # another scene is shown, fitted to its pane

    def test_worst_pixel_and_densest_window(self):
        b = self.open(FLAG + "side")
        metrics = b.value("frameOf(state.scene).metrics")
        self.assertEqual((metrics["worstX"], metrics["worstY"]), (100, 20))
        b.keys("w")
        self.assertEqual(b.transform()[0], 12)
        point = b.picture_at(*self.middle())
        self.assertAlmostEqual(point[0], 100.5, delta=0.1)
        self.assertAlmostEqual(point[1], 20.5, delta=0.1)
        mark = b.box(".mark.worst")
        self.assertAlmostEqual(b.picture_at(mark["x"], mark["y"])[0], 100, delta=0.1)
        self.assertAlmostEqual(mark["width"], 12, delta=0.1)
        b.keys("0")
        window = b.box(".mark.window")
        point = b.picture_at(window["x"], window["y"])
        self.assertAlmostEqual(point[0], metrics["windowX"], delta=0.1)
        self.assertAlmostEqual(point[1], metrics["windowY"], delta=0.1)
        self.assertAlmostEqual(window["width"], 16 * b.transform()[0], delta=0.1)
        b.keys("m")
        self.assertEqual(b.visible(".mark"), [])
        b.click("#worst")
        self.assertEqual(len(b.visible(".mark.worst")), 3)

    def test_swipe(self):
        b = self.open(FLAG + "swipe")
        clip = lambda: b.value("document.querySelectorAll('.layer')[1].style.clipPath")
        pane = b.box(".pane")
        self.assertEqual(clip(), "inset(0px 0px 0px 50%)")
        handle = b.box(".handle")
        x, y = handle["x"] + handle["width"] / 2, handle["y"] + 60
        b.drag(x, y, pane["x"] + pane["width"] * 0.25, y)
        self.assertAlmostEqual(float(clip().split()[-1][:-2]), 25, delta=0.5)
        self.assertEqual(b.one(".handle").get_attribute("aria-valuenow"), "25")
        # the picture fits, so dragging anywhere moves the slider
        b.drag(*self.middle(), pane["x"] + pane["width"] * 0.75, y)
        self.assertAlmostEqual(float(clip().split()[-1][:-2]), 75, delta=0.5)
        b.run("document.querySelector('.handle').focus()")
        b.keys(Keys.ARROW_LEFT)
        self.assertAlmostEqual(float(clip().split()[-1][:-2]), 73, delta=0.5)
        self.assertEqual(self.chosen()[1], 120)  # the arrow key moved the slider; the frame stays the same
        b.keys("w")
        before = clip(), b.transform()
        x, y = self.middle()
        b.drag(x, y + 50, x + 40, y + 50)  # zoomed in, so dragging moves the picture
        self.assertEqual(clip(), before[0])
        self.assertAlmostEqual(b.transform()[1] - before[1][1], 40, delta=1)

    def test_blink(self):
        b = self.open(FLAG + "side")
        other = "getComputedStyle(document.querySelectorAll('.layer')[1]).visibility"
        shown = lambda: b.value(other)
        b.keys("b")
        self.assertEqual(self.chosen()[2], "blink")
        first = shown()
        self.assertTrue(b.until(f"{other} !== '{first}'"))  # the timer switches the picture
        b.keys("b")  # the key switches the picture and stops the timer
        now = shown()
        self.assertEqual(b.texts("figcaption:not([hidden])"), ["actual" if now == "visible" else "expected"])
        self.assertEqual(b.one("#play").get_attribute("aria-pressed"), "false")
        self.assertFalse(b.until(f"{other} !== '{now}'", 0.8))
        b.click("#swap")
        self.assertNotEqual(shown(), now)
        b.keys("p")
        self.assertEqual(b.one("#play").get_attribute("aria-pressed"), "true")
        b.keys("1")
        self.assertEqual(b.visible("#blinkTools"), [])

    def test_two_fingers_zoom(self):
        b = self.browser
        b.size(400, 800)
        self.open(FLAG + "side")
        before = b.transform()[0]
        x, y = self.middle()
        point = b.picture_at(x, y)
        touch = lambda kind, apart: b.command("Input.dispatchTouchEvent", type=kind, touchPoints=[
            {"x": x - apart, "y": y, "id": 1}, {"x": x + apart, "y": y, "id": 2}] if apart else [])
        touch("touchStart", 40)
        for apart in (50, 60, 70, 80):
            touch("touchMove", apart)
        touch("touchEnd", 0)
        b.settle()
        self.assertAlmostEqual(b.transform()[0] / before, 2, delta=0.1)
        self.assertAlmostEqual(b.picture_at(x, y)[0], point[0], delta=4)

    def test_pixel_under_the_pointer(self):
        b = self.open(FLAG + "side")
        b.keys("w")
        b.move(*self.middle(2))
        self.assertRegex(b.text("#pixel"), r"^x 100  y 20")
        b.move(5, 5)
        self.assertEqual(b.text("#pixel"), "")

    def test_pixel_colours_are_shown_over_http(self):

        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass

        files = functools.partial(Quiet, directory=str(self.page.parent))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), files)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        b = self.browser
        b.open(f"http://127.0.0.1:{server.server_port}/index.html", FLAG + "side")
        b.keys("w")
        b.move(*self.middle(0))
        self.assertRegex(b.text("#pixel"), r"^x 100  y 20  ·  expected \d+ \d+ \d+  ·  actual 0 0 0$")

    def test_missing_pictures_are_reported(self):
        gone = self.page.parent.parent / "gone"
        shutil.copytree(self.page.parent, gone)
        (gone / "files/cloth/flag/000120.actual.png").unlink()
        self.browser.open(gone / "index.html", FLAG + "side")
        self.assertIn("000120.actual.png cannot be loaded", self.browser.text(".lost"))
        self.assertTrue(all("ERR_FILE_NOT_FOUND" in problem for problem in self.browser.problems()))
