"""The HTML report in a browser: every control, from disk. Skipped (exit 77) without Chromium or Selenium."""
import functools
import http.server
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import urllib.parse

CHROMIUM, CHROMEDRIVER = shutil.which("chromium"), shutil.which("chromedriver")
try:
    from driver import Browser, Keys
    MISSING = None if CHROMIUM and CHROMEDRIVER else "chromium and chromedriver"
except ImportError:
    MISSING = "python3-selenium"
MAKE_REPORT = os.environ.get("MAKE_REPORT", "make_report")
FLAG = "#scene=cloth%2Fflag&frame=120&view="


class ReportTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="simreel-report-")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.browser = Browser(CHROMIUM, CHROMEDRIVER)
        cls.addClassCleanup(cls.browser.quit)
        cls.page = cls.make("showcase", "showcase")

    @classmethod
    def make(cls, name, *what):
        folder = pathlib.Path(cls.folder.name) / name
        subprocess.run([MAKE_REPORT, folder, *what], check=True)
        return folder / "index.html"

    def setUp(self):
        self.browser.size(1280, 800)
        self.browser.dark(False)
        self.browser.problems()
        self.browser.requests()

    def tearDown(self):
        self.assertEqual(self.browser.problems(), [])
        for address in self.browser.requests():
            self.assertRegex(address, r"^(file:|data:|about:blank|http://127\.0\.0\.1:)")

    def open(self, link=""):
        self.browser.open(self.page, link)
        return self.browser

    def scene(self, name):
        self.browser.run("go({scene: byName.get(arguments[0])})", name)
        self.browser.settle()

    def names(self):
        return self.browser.value("list.shown.map((scene) => scene.name)")

    def chosen(self):
        return tuple(self.browser.value("[state.scene.name, frameOf(state.scene).frame, state.view]"))


class ListTest(ReportTest):
    def test_statuses_are_counted_and_failures_come_first(self):
        b = self.open()
        shown = dict(reversed(text.split(" ", 1)) for text in b.texts(".chip"))
        self.assertEqual(shown, {"error": "1", "failed": "4", "nondeterministic": "1", "no baseline": "1",
                                 "xpass": "1", "flaky": "1", "xfail": "1", "updated": "1", "passed": "2"})
        self.assertEqual(b.text("#verdict"), "8 of 13 scenes failed")
        names = self.names()
        self.assertEqual(names[:3] + names[-2:],
                         ["life/broken", "cloth/flag", "cloth/long", "cloth/curtain", "cloth/tablecloth"])
        self.assertEqual(b.value("[...document.querySelectorAll('.row')].map((r) => r.getAttribute('aria-posinset'))"),
                         [str(i + 1) for i in range(len(b.all(".row")))])

    def test_status_filters(self):
        b = self.open()
        b.click(".chip.fail")
        self.assertNotIn("cloth/flag", self.names())
        self.assertIn("life/broken", self.names())
        self.assertEqual(b.one(".chip.fail").get_attribute("aria-pressed"), "false")
        self.assertEqual(b.text("#shown"), "9 of 13 scenes shown")
        b.click(".chip.fail")
        self.assertIn("cloth/flag", self.names())
        b.click("#onlyFailing")
        self.assertEqual(len(self.names()), 8)
        self.assertNotIn("cloth/flaky", self.names())  # --allow-flaky
        b.click("#allStatuses")
        self.assertEqual(len(self.names()), 13)
        b.run("document.querySelector('.chip.missing').dispatchEvent(new MouseEvent('click', {altKey: true, bubbles: true}))")
        self.assertEqual(self.names(), ["particles/new"])

    def test_text_filter_and_order(self):
        b = self.open()
        b.keys("/")
        b.keys(*"cloth /FLA")
        self.assertEqual(self.names(), ["cloth/flag", "cloth/flaky"])
        b.keys(Keys.ENTER)
        self.assertEqual(self.chosen()[0], "cloth/flag")
        b.run("byId('filter').value = ''; byId('filter').dispatchEvent(new Event('input'))")
        b.run("byId('sort').value = 'name'; byId('sort').dispatchEvent(new Event('change'))")
        self.assertEqual(self.names()[:2], ["cloth/curtain", "cloth/flag"])
        b.run("byId('sort').value = 'worst'; byId('sort').dispatchEvent(new Event('change'))")
        most = b.value("list.shown.map((s) => largest(s, (m) => m.ratioBeyond))")
        self.assertEqual(most, sorted(most, reverse=True))
        self.assertGreater(most[0], most[1])

    def test_clicking_a_row(self):
        b = self.open()
        b.click(".row[aria-posinset='3']")
        self.assertEqual((b.text("#name"), b.one(".row[aria-selected=true] .rowName").text), ("cloth/long",) * 2)


class KeyboardTest(ReportTest):
    def test_scenes_and_frames(self):
        b = self.open()
        self.assertEqual(b.text("#name"), "life/broken")
        b.keys("j")
        self.assertEqual(self.chosen(), ("cloth/flag", 60, "side"))  # its first failing frame
        b.keys("j", "k", "l")
        self.assertEqual(self.chosen(), ("cloth/flag", 90, "side"))
        b.keys("h", Keys.ARROW_LEFT)
        self.assertEqual(self.chosen()[1], 30)
        b.keys(Keys.ARROW_RIGHT, "G")
        self.assertEqual(self.chosen()[1], 240)
        b.keys("l", "g", "h")
        self.assertEqual(self.chosen()[1], 0)

    def test_next_failure_goes_through_frames_then_scenes(self):
        b = self.open("#scene=cloth%2Fflag&frame=0&view=side")
        b.keys("f")
        self.assertEqual(self.chosen()[:2], ("cloth/flag", 60))
        b.keys("G", "f")
        self.assertEqual(self.chosen()[:2], ("cloth/long", 2))
        b.keys("F")
        self.assertEqual(self.chosen()[:2], ("cloth/flag", 240))
        b.keys("F")
        self.assertEqual(self.chosen()[:2], ("cloth/flag", 210))

    def test_views_by_number(self):
        b = self.open(FLAG + "side")
        for key, view in (("2", "swipe"), ("3", "blink"), ("4", "difference"), ("1", "side")):
            b.keys(key)
            self.assertEqual(self.chosen()[2], view)
            self.assertEqual([e.get_attribute("data-view") for e in b.all("#views [aria-pressed=true]")], [view])

    def test_help_lists_every_key(self):
        b = self.open(FLAG + "side")
        self.assertEqual(b.visible("#keys"), [])
        b.keys("?")
        self.assertEqual(len(b.visible("#keys")), 1)
        listed = " ".join(b.texts("#keys kbd"))
        for key in b.value("Object.keys(keyActions)"):
            self.assertIn({"ArrowRight": "→", "ArrowLeft": "←", "-": "−", "=": "+"}.get(key, key), listed)
        b.keys("4")  # not while the help is open
        self.assertEqual(self.chosen()[2], "side")
        b.keys(Keys.ESCAPE)
        self.assertEqual(b.visible("#keys"), [])
        b.click("#help")
        b.keys("?")
        self.assertEqual(b.visible("#keys"), [])

    def test_filter_takes_letters_and_escape_leaves_it(self):
        b = self.open(FLAG + "side")
        b.keys("/", "j", "4")
        self.assertEqual(b.value("byId('filter').value"), "j4")
        self.assertEqual(self.chosen(), ("cloth/flag", 120, "side"))
        b.keys(Keys.ESCAPE)
        self.assertEqual(b.value("document.activeElement.id"), "list")

    def test_list_by_arrows(self):
        b = self.open()
        b.run("byId('list').focus()")
        b.keys(Keys.ARROW_DOWN, Keys.ARROW_DOWN, Keys.ARROW_UP)
        self.assertEqual(b.text("#name"), "cloth/flag")
        self.assertEqual(b.value("byId(byId('list').getAttribute('aria-activedescendant')).querySelector('.rowName').textContent"),
                         "cloth/flag")
        b.keys(Keys.END)
        self.assertEqual(b.text("#name"), "cloth/tablecloth")

    def test_focus_is_seen(self):
        b = self.open(FLAG + "side")
        for _ in range(12):
            b.keys(Keys.TAB)
            style = b.value("(({outlineStyle, outlineWidth}) => outlineStyle + outlineWidth)(getComputedStyle(document.activeElement))")
            self.assertEqual(style, "solid2px", b.value("document.activeElement.outerHTML"))

    def test_everything_has_a_name(self):
        b = self.open(FLAG + "swipe")
        nameless = b.value("""[...document.querySelectorAll('button, input, select, img, [role]')].filter((e) =>
            !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length || e.hasAttribute('alt') ||
              e.getAttribute('role') === 'presentation' || e.id === 'verdict' || e.id === 'shown')).map((e) => e.outerHTML)""")
        self.assertEqual(nameless, [])


class PictureTest(ReportTest):
    def middle(self, pane=0):
        box = self.browser.value(f"document.querySelectorAll('.pane')[{pane}].getBoundingClientRect().toJSON()")
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def test_panes_side_by_side_move_together(self):
        b = self.open(FLAG + "side")
        self.assertEqual(b.texts(".pane figcaption"), ["expected", "actual", "difference"])
        self.assertEqual(b.value("[...document.querySelectorAll('#panes img')].map((i) => i.naturalWidth)"), [320] * 3)
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
        self.assertEqual(b.value("getComputedStyle(document.querySelector('.layer img')).imageRendering"), "pixelated")
        b.keys("0")
        self.assertEqual(b.transform(), fit)
        b.click("#zoomIn")
        self.assertGreater(b.transform()[0], fit[0])
        b.click("#zoomOut")
        b.click("#fit")
        self.assertEqual(b.transform(), fit)
        b.keys("o")
        left = b.transform()[1]
        b.run("document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', shiftKey: true, bubbles: true}))")
        self.assertEqual(b.transform()[1], left - 60)

    def test_zoom_stays_from_frame_to_frame(self):
        b = self.open(FLAG + "difference")
        b.keys("o", "+", "l")
        self.assertEqual((self.chosen()[1], b.transform()[0]), (150, 2))
        b.keys("j")
        self.assertNotEqual(b.transform()[0], 2)

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
        b.drag(*self.middle(), pane["x"] + pane["width"] * 0.75, y)  # it fits: anywhere moves the slider
        self.assertAlmostEqual(float(clip().split()[-1][:-2]), 75, delta=0.5)
        b.run("document.querySelector('.handle').focus()")
        b.keys(Keys.ARROW_LEFT)
        self.assertAlmostEqual(float(clip().split()[-1][:-2]), 73, delta=0.5)
        self.assertEqual(self.chosen()[1], 120)  # the arrow moved the slider, not the frame
        b.keys("w")
        before = clip(), b.transform()
        x, y = self.middle()
        b.drag(x, y + 50, x + 40, y + 50)  # zoomed: the picture moves
        self.assertEqual(clip(), before[0])
        self.assertAlmostEqual(b.transform()[1] - before[1][1], 40, delta=1)

    def test_blink(self):
        b = self.open(FLAG + "side")
        shown = lambda: b.value("getComputedStyle(document.querySelectorAll('.layer')[1]).visibility")
        b.keys("b")
        self.assertEqual(self.chosen()[2], "blink")
        first = shown()
        b.until(f"getComputedStyle(document.querySelectorAll('.layer')[1]).visibility !== '{first}'")
        self.assertNotEqual(shown(), first)  # by the timer
        b.keys("b")  # by hand, which stops the timer
        now = shown()
        self.assertEqual(b.value("[...document.querySelectorAll('figcaption')].filter((c) => !c.hidden).map((c) => c.textContent)"),
                         ["actual" if now == "visible" else "expected"])
        self.assertEqual(b.one("#play").get_attribute("aria-pressed"), "false")
        self.assertFalse(b.until(f"getComputedStyle(document.querySelectorAll('.layer')[1]).visibility !== '{now}'", 0.8))
        b.click("#swap")
        self.assertNotEqual(shown(), now)
        b.keys("p")
        self.assertEqual(b.one("#play").get_attribute("aria-pressed"), "true")
        b.keys("1")
        self.assertEqual(b.visible("#blinkTools"), [])

    def test_pixel_under_the_pointer(self):
        b = self.open(FLAG + "side")
        b.keys("w")
        b.move(*self.middle(2))
        self.assertRegex(b.text("#pixel"), r"^x 100  y 20")
        b.move(5, 5)
        self.assertEqual(b.text("#pixel"), "")

    def test_colours_where_the_browser_allows(self):
        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(self.page.parent)))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        b = self.browser
        b.open(f"http://127.0.0.1:{server.server_port}/index.html", FLAG + "side")
        b.keys("w")
        b.move(*self.middle(0))
        self.assertRegex(b.text("#pixel"), r"^x 100  y 20  ·  expected \d+ \d+ \d+  ·  actual 0 0 0$")

    def test_pictures_that_are_gone(self):
        page = self.make("gone", "showcase")
        os.remove(page.parent / "files/cloth/flag/000120.actual.png")
        self.browser.open(page, FLAG + "side")
        self.assertIn("000120.actual.png cannot be loaded", self.browser.text(".lost"))
        self.assertTrue(all("ERR_FILE_NOT_FOUND" in problem for problem in self.browser.problems()))


class FrameTest(ReportTest):
    def test_strip(self):
        b = self.open(FLAG + "side")
        self.assertEqual(b.texts(".tile .number"), [str(i * 30) for i in range(9)])
        self.assertEqual([e.get_attribute("class") for e in b.all(".tile")], ["tile pass"] * 2 + ["tile fail"] * 7)
        b.click(".tile[data-index='6']")
        self.assertEqual(self.chosen()[1], 180)
        self.assertEqual([e.get_attribute("data-index") for e in b.all(".tile[aria-current=true]")], ["6"])
        b.click("#previous")
        self.assertEqual(b.text("#frame"), "frame 150")
        b.click("#next")
        self.assertEqual(b.text("#frame"), "frame 180")

    def test_long_strip_holds_few_pictures(self):
        b = self.open("#scene=cloth%2Flong&frame=2&view=side")
        self.assertEqual(len(b.all(".tile")), 90)
        self.assertTrue(b.until("document.querySelectorAll('.tile img').length > 5"))
        self.assertLess(len(b.all("img")), 36)
        b.keys("G")
        self.assertTrue(b.until("document.querySelector('.tile[data-index=\"89\"] img') !== null"))
        self.assertTrue(b.until("document.querySelectorAll('img').length < 36"))
        tile, strip = b.box(".tile[data-index='89']"), b.box("#strip")
        self.assertLessEqual(tile["right"], strip["right"] + 1)

    def test_frames_that_passed_say_so(self):
        b = self.open("#scene=cloth%2Fflag&frame=30&view=side")
        self.assertEqual(b.text(".empty"), "Frame 30 is equal to its baseline; its picture is not stored.")
        self.scene("cloth/curtain")
        b.keys("l")
        self.assertIn("within tolerance of its baseline", b.text(".empty"))
        b.keys("l")
        self.assertIn("equal to its accepted alternate 2", b.text(".empty"))

    def test_curve(self):
        b = self.open(FLAG + "side")
        self.assertEqual(len(b.all("#curve .dot")), 9)
        svg = b.box("#curve")
        toX = lambda i: svg["x"] + float(b.all("#curve .dot")[i].get_attribute("cx"))
        b.pointer("mousePressed", toX(6) + 8, svg["y"] + 50, button="left", clickCount=1)
        b.pointer("mouseReleased", toX(6) + 8, svg["y"] + 50, button="left", clickCount=1)
        self.assertEqual(self.chosen()[1], 180)
        ys = [float(e.get_attribute("cy")) for e in b.all("#curve .dot")]
        self.assertEqual(ys[0], ys[1])
        self.assertLess(ys[8], ys[2] - 20)  # a larger difference is higher
        mark = svg["x"] + float(b.one("#curve line.diverges").get_attribute("x1"))
        self.assertAlmostEqual((mark - toX(0)) / (toX(8) - toX(0)), 37 / 240, places=3)
        self.assertEqual(b.text("#curve text.diverges"), "leaves the baseline: frame 37, step 4/22")
        self.assertEqual(b.text("#curve text.bound"), "max_diff_ratio 0.5 %")

    def test_curve_of_each_measurement(self):
        b = self.open(FLAG + "side")
        for metric in ("worst", "ratioBeyond", "flipMean", "ssim"):
            b.run("byId('metric').value = arguments[0]; byId('metric').dispatchEvent(new Event('change'))", metric)
            m = b.value("state.scene.frames[8].metrics")
            most = b.value("Math.max(...state.scene.frames.map((f) => curveValue(curveChosen(), f)))")
            value = 1 - m["ssim"] if metric == "ssim" else m[metric]
            self.assertAlmostEqual(b.value("curveValue(curveChosen(), state.scene.frames[8])"), value)
            dots = [float(e.get_attribute("cy")) for e in b.all("#curve .dot")]
            self.assertAlmostEqual((dots[0] - dots[8]) / (dots[0] - min(dots)), value / most, places=3)

    def test_frames_that_cannot_be_compared_are_gaps(self):
        self.open("#scene=particles%2Fnew&view=side")
        self.assertEqual(len(self.browser.all("#curve .dot.gap")), 3)


class WordsTest(ReportTest):
    def card(self, name):
        return self.browser.text(".card." + name)

    def test_failed_scene(self):
        b = self.open(FLAG + "side")
        self.assertEqual(b.text("#badge"), "✕ failed")
        messages = b.texts("#messages li")
        self.assertEqual(messages[1], "frame 60: energy of flag is 3.1, above 3")
        self.assertEqual(messages[-1], "6 more")
        b.click("#messages button")
        self.assertEqual(len(b.all("#messages li")), 9)
        self.assertIn("first leaves the baseline at frame 37, step 4 of 22: flag.positions, elements 128–191", self.card("divergence"))
        rows = [b.run("return [...arguments[0].children].map((c) => c.textContent)", row) for row in b.all(".checks tbody tr")]
        self.assertEqual(rows[0], ["energy of flag", "60", "3.1", "0 to 3", "✕ frame 60: energy of flag is 3.1, above 3"])
        self.assertEqual(rows[2], ["max of flag positions.y", "240", "2.75", "≤ 3.2", "✓ holds"])
        b.click(".checks .link")
        self.assertEqual(self.chosen()[1], 60)
        self.assertIn("max_window_ratio0.91--max-window-ratio", self.card("tolerance"))
        self.assertIn("scenes/golden/cloth/flag/any/baseline.json", self.card("tolerance"))
        self.assertIn("any (this run is llvmpipe)", self.card("baseline"))
        self.assertIn("which is not tested", self.card("notes"))
        self.assertIn("5f1c09b24e7d4c38", self.card("environment"))

    def test_measurements_over_their_bounds(self):
        b = self.open(FLAG + "side")
        over = [text for text in b.texts("#metrics .over dt")]
        self.assertEqual(over, ["beyond 12", "FLIP"])

    def test_other_statuses(self):
        b = self.open("#scene=particles%2Ffountain&view=side")
        self.assertEqual(b.texts(".pane figcaption"), ["first run", "second run", "difference"])
        self.assertEqual(b.text("#accept"), "Nothing was kept to accept.")
        self.scene("particles/new")
        b.keys("l")
        self.assertEqual(b.texts(".pane figcaption"), ["actual"])
        b.keys("2")
        self.assertEqual(b.texts(".pane figcaption"), ["actual"])
        b.keys("4")
        self.assertIn("nothing to compare with", b.text(".empty"))
        self.scene("life/resized")
        self.assertIn("the pictures differ in size", b.text(".empty"))
        self.scene("life/broken")
        self.assertEqual(b.visible("#viewer, #time"), [])
        self.assertIn("unknown key", b.text("#messages"))
        self.scene("cloth/knot")
        self.assertIn("expected to fail: self-collision is not there yet", b.text("#messages"))
        self.scene("life/glider")
        self.assertIn("it was expected to fail: the glider turns left", b.text("#messages"))
        self.scene("cloth/flaky")
        self.assertEqual(b.texts(".attempts li"), ["attempt 1: failed: frame 60: 4.1 % of the pixels differ", "attempt 2: passed"])
        self.scene("cloth/tablecloth")
        self.assertEqual(b.visible("#accept"), [])

    def test_text_is_never_markup(self):
        b = self.open()
        name = b.value("suite.scenes[5].name")
        self.assertIn("<script>", name)
        self.scene(name)
        self.assertIsNone(b.value("window.hacked || null"))
        self.assertEqual((b.text("#name"), b.text("#file"), b.texts("#messages li")[0]), (name,) * 3)
        self.assertEqual(b.value("document.querySelectorAll('main script, main img[onerror], #side script').length"), 0)
        self.assertEqual(b.text(".checks tbody th"), name)
        self.assertIn("before frame 0, at pre-roll frame -12", self.card("divergence"))
        # The folder of its pictures has "#", "?", "%" and a space in its name.
        self.assertEqual(b.value("[...document.querySelectorAll('#panes img')].map((i) => i.naturalWidth)"), [320] * 3)
        words = shlex.split(b.text("#accept code"))
        self.assertEqual(words, ["simreel", "accept", "out/report", "--only", name])
        self.browser.open(self.page, b.value("location.hash"))
        self.assertEqual(b.text("#name"), name)

    def test_copying_the_command(self):
        for refuse in (False, True):  # the asynchronous clipboard, and a page that has none
            b = self.open(FLAG + "side")
            if refuse:
                b.run("Object.defineProperty(navigator, 'clipboard', {value: undefined})")
            b.run("byId('filter').value = ''")
            b.click("#accept .copy")
            self.assertEqual(b.until("document.querySelector('#accept .copy').textContent === 'copied'"), True)
            b.keys("/")
            b.one("#filter").send_keys(Keys.CONTROL, "v")
            self.assertEqual(b.value("byId('filter').value"), "simreel accept out/report --only 'cloth/flag'")
            b.keys(Keys.ESCAPE)
            b.run("byId('filter').value = ''; filterList()")
            b.keys("c")
            self.assertTrue(b.until("document.querySelector('#accept .copy').textContent === 'copied'"))


class PageTest(ReportTest):
    def test_link_keeps_scene_frame_and_view(self):
        b = self.open(FLAG + "swipe")
        self.assertEqual(self.chosen(), ("cloth/flag", 120, "swipe"))
        b.keys("l", "4")
        self.assertEqual(b.value("location.hash"), "#scene=cloth%2Fflag&frame=150&view=difference")
        b.keys("j")
        self.assertEqual(self.chosen()[0], "cloth/long")
        b.driver.back()
        self.assertTrue(b.until("state.scene.name === 'cloth/flag'"))
        self.assertEqual(self.chosen(), ("cloth/flag", 150, "difference"))
        self.open("#scene=no%2Fsuch&frame=7")
        self.assertEqual(b.text("#name"), "life/broken")

    def test_light_and_dark(self):
        light, dark = "rgb(243, 244, 246)", "rgb(18, 21, 24)"
        page = lambda: self.browser.value("getComputedStyle(document.body).backgroundColor")
        b = self.open()
        b.run("localStorage.clear()")
        b = self.open()
        self.assertEqual(page(), light)
        b.dark(True)
        self.assertEqual(page(), dark)
        b.click("#theme")
        self.assertEqual((page(), b.text("#theme")), (light, "○ light"))
        self.open()
        self.assertEqual(page(), light)  # kept
        b.keys("t")
        b.dark(False)
        self.assertEqual(page(), dark)
        b.keys("t")
        self.assertEqual(page(), light)
        b.run("localStorage.clear()")

    def test_without_local_storage(self):
        denied = "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('denied', 'SecurityError'); }})"
        script = self.browser.command("Page.addScriptToEvaluateOnNewDocument", source=denied)
        try:
            b = self.open(FLAG + "side")
            b.keys("t", "t")
            self.assertEqual(b.value("document.documentElement.dataset.theme"), "dark")
            self.assertEqual(b.text("#name"), "cloth/flag")
        finally:
            self.browser.command("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])

    def test_asks_for_its_own_pictures_only(self):
        self.browser.requests()
        self.open(FLAG + "side")
        asked = [a for a in self.browser.requests() if not a.startswith(("about:", "data:"))]
        self.assertGreater(len(asked), 3)
        for address in asked:
            self.assertTrue(address.startswith(self.page.parent.as_uri()), address)

    def test_phone(self):
        b = self.browser
        b.size(400, 800)
        self.open()
        self.assertEqual((len(b.visible("#list")), len(b.visible("#scene"))), (1, 0))
        b.click(".row[aria-posinset='2']")
        self.assertEqual((len(b.visible("#list")), len(b.visible("#scene"))), (0, 1))
        self.assertEqual(b.text("#name"), "cloth/flag")
        panes = b.value("[...document.querySelectorAll('.pane')].map((p) => p.getBoundingClientRect().toJSON())")
        self.assertEqual(len({round(p["x"]) for p in panes}), 1)
        self.assertGreater(panes[0]["width"], 340)
        for name in b.value("suite.scenes.map((s) => s.name)"):
            self.scene(name)
            self.assertLessEqual(b.value("document.documentElement.scrollWidth"), 400, name)
            self.assertLessEqual(b.value("byId('scene').scrollWidth - byId('scene').clientWidth"), 0, name)
        b.click("#back")
        self.assertEqual((len(b.visible("#list")), len(b.visible("#scene"))), (1, 0))
        self.open(FLAG + "side")  # a link to a scene shows the scene
        self.assertEqual(len(b.visible("#scene")), 1)

    def test_nothing_is_cut_off_on_the_desktop(self):
        b = self.open()
        for name in b.value("suite.scenes.map((s) => s.name)"):
            self.scene(name)
            self.assertEqual(b.value("byId('scene').scrollWidth - byId('scene').clientWidth"), 0, name)

    def test_no_scene(self):
        self.browser.open(self.make("none", "none"))
        self.assertEqual(self.browser.text("#nothing"), "This run tested no scene.")
        self.assertEqual(self.browser.visible("#side, #viewer, #time"), [])
        self.browser.keys("j", "f", "l", "w", "b", "+", "c", "2")

    def test_page_that_cannot_be_written(self):
        folder = pathlib.Path(self.folder.name) / "blocked"
        (folder / "index.html").mkdir(parents=True)
        made = subprocess.run([MAKE_REPORT, folder, "none"], capture_output=True, text=True)
        self.assertEqual((made.returncode, made.stderr.count("\n")), (6, 1), made.stderr)
        self.assertIn(str(folder / "index.html"), made.stderr)
        self.assertEqual([p.name for p in folder.iterdir()], ["index.html"])

    def test_five_hundred_failing_scenes(self):
        page = self.make("bulk", "bulk", "500")
        b = self.browser
        times = []
        for _ in range(3):
            b.open(page)
            times.append(b.value("performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd"))
        self.assertLess(min(times), 1000)
        self.assertEqual(len(self.names()), 500)
        self.assertLess(len(b.all(".row")), 60)
        b.run("byId('list').focus()")
        for _ in range(40):
            b.keys("f")
        self.assertLess(len(b.all("img")), 36)
        took = b.value("(() => {const t = performance.now(); for (let i = 0; i < 50; ++i) stepScene(1);"
                       " return (performance.now() - t) / 50;})()")
        self.assertLess(took, 100)  # ms a scene
        b.keys(Keys.END)
        self.assertEqual(b.text("#name"), self.names()[-1])
        self.assertEqual(b.text(".row[aria-selected=true] .rowName"), self.names()[-1])
        self.assertLess(len(b.all(".row")), 60)
        self.assertLess(len(b.all("img")), 36)
        took = b.value("(() => {const t = performance.now(); byId('filter').value = 'scene49'; filterList();"
                       " return performance.now() - t;})()")
        self.assertLess(took, 200)
        self.assertEqual(len(self.names()), 11)


if __name__ == "__main__":
    if MISSING:
        print(f"skipped: {MISSING} is not installed (tools/setup installs it)")
        sys.exit(77)
    unittest.main(verbosity=2)
