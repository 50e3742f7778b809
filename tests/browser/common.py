"""Shared helpers of the page's tests: a browser, and reports made for them."""
import atexit
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from driver import Browser

CHROMIUM, CHROMEDRIVER = shutil.which("chromium"), shutil.which("chromedriver")
MAKE_REPORT = os.environ.get("MAKE_REPORT", "make_report")
FLAG = "#scene=cloth%2Fflag&frame=120&view="


class ReportTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        if hasattr(ReportTest, "browser"):
            return  # all test classes share one browser and one report folder
        ReportTest.folder = tempfile.TemporaryDirectory(prefix="simreel-report-")
        ReportTest.browser = Browser(CHROMIUM, CHROMEDRIVER)
        atexit.register(ReportTest.browser.quit)
        ReportTest.page = cls.make("showcase", "showcase")

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
