"""Tests the strip of frames, the curve, and the information about a scene."""
import shlex

from common import FLAG, ReportTest
from driver import Keys


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
        for left in range(0, 7000, 700):
            b.run("byId('strip').scrollLeft = arguments[0]", left)
            index = left // 89 + 2
            self.assertTrue(b.until(f"document.querySelector('.tile[data-index=\"{index}\"] img') !== null"))
        self.assertTrue(b.until("document.querySelectorAll('img').length < 36"))
        b.keys("G")
        self.assertTrue(b.until("document.querySelector('.tile[data-index=\"89\"] img') !== null"))
        self.assertTrue(b.until("document.querySelectorAll('img').length < 36"))
        tile, strip = b.box(".tile[data-index='89']"), b.box("#strip")
        self.assertLessEqual(tile["right"], strip["right"] + 1)

    def test_passed_frames_show_a_note(self):
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
        self.assertLess(ys[8], ys[2] - 20)  # the curve is higher where the difference is larger
        mark = svg["x"] + float(b.one("#curve line.diverges").get_attribute("x1"))
        self.assertAlmostEqual((mark - toX(0)) / (toX(8) - toX(0)), 37 / 240, places=3)
        self.assertEqual(b.text("#curve text.diverges"), "leaves the baseline: frame 37, step 4/22")
        self.assertEqual(b.text("#curve text.bound"), "maxDiffRatio 0.5 %")

    def test_the_curve_shows_the_chosen_metric(self):
        b = self.open(FLAG + "side")
        for metric in ("worst", "ratioBeyond", "flipMean", "ssim"):
            b.run("byId('metric').value = arguments[0]; byId('metric').dispatchEvent(new Event('change'))", metric)
            m = b.value("state.scene.frames[8].metrics")
            most = b.value("Math.max(...state.scene.frames.map((f) => curveValue(curveChosen(), f)))")
            value = 1 - m["ssim"] if metric == "ssim" else m[metric]
            self.assertAlmostEqual(b.value("curveValue(curveChosen(), state.scene.frames[8])"), value)
            dots = [float(e.get_attribute("cy")) for e in b.all("#curve .dot")]
            self.assertAlmostEqual((dots[0] - dots[8]) / (dots[0] - min(dots)), value / most, places=3)

    def test_frames_without_comparison_are_gaps_in_the_curve(self):
        self.open("#scene=particles%2Fnew&view=side")
        self.assertEqual(len(self.browser.all("#curve .dot.gap")), 3)
        self.assertIn("not measured", self.browser.one("#curve").get_attribute("aria-label"))


class WordsTest(ReportTest):
    def card(self, name):
        return self.browser.text(".card." + name)

    def test_failed_scene(self):
        b = self.open(FLAG + "side")
        self.assertEqual(b.text("#badge"), "✕ failed")
        messages = b.texts("#messages li")
        self.assertEqual(messages[1], "frame 60: energy of flag is 3.1, above 3")
        self.assertEqual((len(messages), b.text("#messages .more")), (3, "6 more"))
        b.click("#messages button")
        self.assertEqual(len(b.all("#messages li")), 9)
        self.assertIn("leaves the baseline at frame 37, step 4 of 22: flag.positions, within elements 128–191",
                      self.card("divergence"))
        row = lambda i: b.texts(f".checks tbody tr:nth-child({i + 1}) > *")
        self.assertEqual(row(0)[:4], ["energy of flag", "60", "3.1", "0 to 3"])
        self.assertEqual(row(0)[4], "✕ frame 60: energy of flag is 3.1, above 3")
        self.assertEqual(row(2), ["max of flag positions.y", "240", "2.75", "≤ 3.2", "✓ holds"])
        b.click(".checks .link")
        self.assertEqual(self.chosen()[1], 60)
        self.assertIn("maxWindowRatio0.91--max-window-ratio", self.card("tolerance"))
        self.assertIn("scenes/golden/cloth/flag/any/baseline.json", self.card("tolerance"))
        self.assertIn("any (this run is llvmpipe)", self.card("baseline"))
        self.assertIn("which is not tested", self.card("notes"))
        self.assertIn("5f1c09b24e7d4c38", self.card("environment"))

    def test_a_frame_does_not_repeat_its_number(self):
        b = self.open(FLAG + "side")
        self.assertRegex(b.text("#frameMessage"), r"^2 s · 5 of 9 ✕ failed 3\.88 % of the pixels")

    def test_measurements_over_their_bounds(self):
        b = self.open(FLAG + "side")
        over = [text for text in b.texts("#metrics .over dt")]
        self.assertEqual(over, ["beyond 12", "FLIP"])

    def test_other_statuses(self):
        b = self.open("#scene=particles%2Ffountain&view=side")
        self.assertEqual(b.texts(".pane figcaption"), ["run 1", "run 2", "difference"])
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
        self.assertEqual(b.texts(".attempts li"),
                         ["attempt 1: failed: frame 60: 4.1 % of the pixels differ", "attempt 2: passed"])
        self.scene("cloth/tablecloth")
        self.assertEqual(b.visible("#accept"), [])

    def test_text_is_never_markup(self):
        b = self.open()
        name = b.value("suite.scenes[5].name")
        self.assertIn("<script>", name)
        self.scene(name)
        self.assertIsNone(b.value("window.hacked || null"))
        self.assertEqual((b.text("#name"), b.text("#file"), b.texts("#messages li")[0]), (name,) * 3)
        self.assertEqual(b.all("main script, main img[onerror], #side script"), [])
        self.assertEqual(b.text(".checks tbody th"), name)
        self.assertIn("before frame 0, at pre-roll frame -12", self.card("divergence"))
        # The folder of this scene's pictures has "#", "?", "%" and a space in its name.
        self.assertEqual(b.picture_widths(), [320] * 3)
        words = shlex.split(b.text("#accept code"))
        self.assertEqual(words, ["simreel", "accept", "out/report", "--only", name])
        self.browser.open(self.page, b.value("location.hash"))
        self.assertEqual(b.text("#name"), name)

    def test_copying_the_command(self):
        for refuse in (False, True):  # tests the page with the asynchronous clipboard API and without it
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
