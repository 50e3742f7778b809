"""Tests a report of 500 failed pictures written by the program: its size, groups of similar failures, loaded files, the
command that accepts a group, small differences. Runs in Chromium and in Firefox."""
import importlib.util
import os
import pathlib
import shlex
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

from common import CHROMEDRIVER, CHROMIUM
from driver import Browser
from firefox import FIREFOX, Firefox

SIMREEL = os.environ.get("SIMREEL")
SIZE = (16, 9)
COUNT = 500


def cli_common():
    """Loads tests/cli/common.py under another name, because this folder has a common.py too."""
    spec = importlib.util.spec_from_file_location("cli_common", pathlib.Path(__file__).parents[1] / "cli/common.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png(rows):
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    pixels = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


def base(number):
    return [[(90 + 4 * x, 60 + 9 * y, (number * 37) % 200) for x in range(SIZE[0])] for y in range(SIZE[1])]


def brighter(rows):
    return [[tuple(value + 1 for value in pixel) for pixel in row] for row in rows]


def dotted(rows):
    return [[(250, 250, 250) if (x, y) == (11, 6) else pixel for x, pixel in enumerate(row)] for y, row in enumerate(rows)]


def shuffled(rows):
    return rows[::-1]


def wider(rows):
    return [row + row[-1:] for row in rows]


CHANGES = (brighter, dotted, shuffled, wider)
# Names that the page gives to the groups.
GROUPS = {"pictures differ|by 1 of 255|most of the picture", "pictures differ|by more than 64 of 255|under 1 %",
          "pictures differ|by more than 64 of 255|most of the picture", "sizes differ"}


class ManyReport:
    """The report, made once for both browsers."""
    folder = None

    @classmethod
    def make(cls):
        if cls.folder:
            return
        cls.folder = tempfile.TemporaryDirectory(prefix="simreel-many-")
        root = pathlib.Path(cls.folder.name)
        for number in range(COUNT):
            rows = base(number)
            for where, made in (("golden", rows), ("out", CHANGES[number % 4](rows))):
                file = root / where / f"ui{number % 7}" / f"it's {number:03}.png"
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(png(made))
        done = subprocess.run([SIMREEL, "test", "--expected", "golden", "--actual", "out", "--report", "report", "-q"], cwd=root,
                              check=False)
        assert done.returncode == 1, done.returncode


class ManyTests:
    """Tests for any browser; `browser` has open(), value(), click(), picture_of() and size()."""

    @classmethod
    def setUpClass(cls):
        ManyReport.make()
        cls.root = pathlib.Path(ManyReport.folder.name)
        cls.page = cls.root / "report/index.html"
        cls.browser = cls.start()
        cls.addClassCleanup(cls.browser.quit)

    def until(self, expression):
        end = time.monotonic() + 600
        while not (value := self.browser.value(expression)) and time.monotonic() < end:
            time.sleep(0.02)
        return value

    def test_groups(self):
        b = self.browser
        b.open(self.page)
        self.assertIn("overview", b.value("document.body.className"))
        groups = b.value("overview.groups.map((group) => [group.words.join('|'), group.scenes.length])")
        self.assertEqual({words for words, _ in groups}, GROUPS)
        self.assertEqual([count for _, count in groups], [COUNT // 4] * 4)
        self.assertEqual(b.value("document.querySelectorAll('.group').length"), 4)
        b.value("document.querySelector('.failures').scrollIntoView()")
        self.assertTrue(self.until(f"document.querySelectorAll('.failures tbody tr').length === {COUNT}"))
        line = b.value("document.querySelector('.failures tbody tr').textContent")
        for word in ("it's", "maxDiffPixels 0", "100 %"):
            self.assertIn(word, line)

    def test_pictures_load_when_scrolled_near(self):
        b = self.browser
        b.open(self.page)
        b.value("document.querySelectorAll('.group > .link').forEach((more) => more.click())")
        self.assertEqual(b.value("document.querySelectorAll('.small img:not(.over)').length"), COUNT)
        loaded = "[...document.querySelectorAll('.small img')].filter((image) => image.naturalWidth > 0).length"
        self.assertTrue(self.until(loaded + " > 5"))
        time.sleep(0.3)
        self.assertLess(b.value(loaded), COUNT / 2)
        b.value("[...document.querySelectorAll('.thumb')].pop().scrollIntoView()")
        self.assertTrue(self.until("[...document.querySelectorAll('.small img:not(.over)')].pop().naturalWidth > 0"))

    def test_one_click_chooses_a_group_and_shows_the_command(self):
        b = self.browser
        b.open(self.page)
        b.click(".group:nth-of-type(2) .accept")
        names = b.value("overview.groups[1].scenes.map((scene) => scene.name)")
        words = shlex.split(b.value("document.querySelector('#choice code').textContent"))
        self.assertEqual(words[:3], ["simreel", "accept", "report/report.json"])
        self.assertEqual(words[3:], [word for name in names for word in ("--only", name)])
        self.assertEqual(b.value("document.querySelector('#choice b').textContent"), f"{COUNT // 4} pictures chosen")
        # Deselects one picture, then selects all pictures. The command then contains no --only NAME.
        b.value("document.querySelectorAll('.group:nth-of-type(2) .thumb .choose')[0].click()")
        self.assertEqual(b.value("overview.chosen.size"), COUNT // 4 - 1)
        self.assertTrue(b.value("document.querySelector('.group:nth-of-type(2) header .choose').indeterminate"))
        b.value("document.querySelector('.overviewHead .choose').click()")
        b.value("overview.chosen.size < suite.scenes.length && document.querySelector('.overviewHead .choose').click()")
        self.assertEqual(b.value("document.querySelector('#choice code').textContent"), "simreel accept report/report.json")
        b.value("document.querySelector('#choice > button').click()")
        self.assertTrue(b.value("byId('choice').hidden"))

    def test_an_amplified_difference_of_1_is_visible(self):
        b = self.browser
        b.open(self.page)
        name = b.value("overview.groups.find((group) => group.words[1] === 'by 1 of 255').scenes[0].name")
        b.open(self.page, "#scene=" + b.value(f"encodeURIComponent({name!r})") + "&view=amplified")
        self.assertTrue(self.until("viewer.size.width === 16"))
        b.value("toggleMarks()")
        self.assertEqual(b.value("document.querySelector('.pane figcaption').textContent"), "|actual − expected| × 255")
        self.assertGreater(min(self.middle_of("#panes")), 250)
        b.value("(byId('factor').value = 16, byId('factor').dispatchEvent(new Event('change')))")
        self.assertEqual(b.value("document.querySelector('.pane figcaption').textContent"), "|actual − expected| × 16")
        for value in self.middle_of("#panes"):
            self.assertAlmostEqual(value, 16, delta=2)

    def middle_of(self, selector):
        cli = cli_common()
        data = self.browser.picture_of(selector)
        channels = {2: 3, 6: 4}[data[25]]
        width, height, rows = cli.png_rows(data)
        stride = width * channels
        half = height // 2 + 1
        row = cli.unfiltered(rows[:half * (stride + 1)], stride, channels)[-1]
        # The position is slightly beside the middle, because pixels may be mixed where the pictures meet.
        at = (width // 2 + 9) * channels
        return row[at:at + 3]

    def test_pictures_fill_the_window(self):
        b = self.browser
        b.open(self.page)
        b.open(self.page, "#scene=" + b.value("encodeURIComponent(suite.scenes[0].name)") + "&view=swipe")
        self.assertTrue(self.until("viewer.size.width >= 16"))
        self.assertGreater(b.value("fitScale(viewer.panes[0]) * viewer.size.width / byId('panes').clientWidth"), 0.95)
        beside = b.value("byId('panes').clientWidth")
        b.value("toggleWide()")
        self.assertGreater(b.value("byId('panes').clientWidth"), beside + 300)
        self.assertGreater(b.value("byId('panes').clientWidth / innerWidth"), 0.93)


@unittest.skipUnless(SIMREEL, "SIMREEL names no program")
class InChromium(ManyTests, unittest.TestCase):
    @classmethod
    def start(cls):
        browser = Browser(CHROMIUM, CHROMEDRIVER)
        browser.size(1000, 620)
        browser.picture_of = lambda selector: browser.one(selector).screenshot_as_png
        return browser

    def test_the_page_is_smaller_than_1_megabyte(self):
        self.assertLess(self.page.stat().st_size, 1e6)

    def test_scrollbars_follow_the_theme(self):
        b = self.browser
        for theme, dark in (("light", False), ("dark", True)):
            b.open(self.page)
            b.run(f"showTheme('{theme}')")
            self.assertEqual(b.value("getComputedStyle(byId('scene')).colorScheme"), theme)
            cli, data = cli_common(), b.driver.get_screenshot_as_png()
            width, _, rows = cli.png_rows(data)
            channels = {2: 3, 6: 4}[data[25]]
            stride = width * channels
            row = cli.unfiltered(rows[:400 * (stride + 1)], stride, channels)[-1]
            edge = row[(width - 3) * channels:(width - 2) * channels][:3]
            self.assertEqual(max(edge) < 100, dark, (theme, list(edge)))

    def test_the_command_accepts_the_group(self):
        b = self.browser
        b.open(self.page)
        b.click(".group:nth-of-type(2) .accept")
        command = b.value("document.querySelector('#choice code').textContent")
        files = {name: self.root / "golden" / name for name in b.value("suite.scenes.map((scene) => scene.name)")}
        before = {name: file.read_bytes() for name, file in files.items()}
        environment = {**os.environ, "PATH": f"{pathlib.Path(SIMREEL).parent}:{os.environ['PATH']}"}
        subprocess.run(command, shell=True, cwd=self.root, env=environment, check=True, stdout=subprocess.DEVNULL)
        changed = {name for name, file in files.items() if file.read_bytes() != before[name]}
        self.assertEqual(changed, set(b.value("overview.groups[1].scenes.map((scene) => scene.name)")))
        for name, content in before.items():
            files[name].write_bytes(content)


@unittest.skipUnless(SIMREEL and FIREFOX, "firefox-esr is not installed (tools/setup does), or SIMREEL names no program")
class InFirefox(ManyTests, unittest.TestCase):
    @classmethod
    def start(cls):
        browser = Firefox()
        browser.size(1000, 700)
        return browser
