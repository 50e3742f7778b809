"""Tests the page as a whole: links, colours, narrow screens, many scenes, errors."""
import pathlib
import subprocess

from common import FLAG, MAKE_REPORT, ReportTest
from driver import Keys


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
        self.assertEqual(page(), light)  # a chosen colour scheme is kept when the page is opened again
        b.keys("t")
        b.dark(False)
        self.assertEqual(page(), dark)
        b.keys("t")
        self.assertEqual(page(), light)
        b.run("localStorage.clear()")

    def test_without_local_storage(self):
        denied = """Object.defineProperty(window, 'localStorage',
                        {get() { throw new DOMException('denied', 'SecurityError'); }})"""
        script = self.browser.command("Page.addScriptToEvaluateOnNewDocument", source=denied)
        try:
            b = self.open(FLAG + "side")
            b.keys("t", "t")
            self.assertEqual(b.value("document.documentElement.dataset.theme"), "dark")
            self.assertEqual(b.text("#name"), "cloth/flag")
        finally:
            self.browser.command("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])

    def test_only_its_own_pictures_are_requested(self):
        self.browser.requests()
        self.open(FLAG + "side")
        asked = [a for a in self.browser.requests() if not a.startswith(("about:", "data:"))]
        self.assertGreater(len(asked), 3)
        for address in asked:
            self.assertTrue(address.startswith(self.page.parent.as_uri()), address)

    def test_a_narrow_screen_shows_either_list_or_scene(self):
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

    def test_an_unwritable_page_is_an_error(self):
        folder = pathlib.Path(self.folder.name) / "blocked"
        (folder / "index.html").mkdir(parents=True)
        made = subprocess.run([MAKE_REPORT, folder, "none"], capture_output=True, text=True)
        self.assertEqual((made.returncode, made.stderr.count("\n")), (6, 1), made.stderr)
        self.assertIn(str(folder / "index.html"), made.stderr)
        self.assertEqual([p.name for p in folder.iterdir()], ["index.html"])

    def test_five_hundred_failing_scenes(self):
        """The page keeps a few rows and pictures only, so its speed does not depend on the number of scenes."""
        page = self.make("bulk", "bulk", "500")
        b = self.browser
        b.open(page)
        self.assertEqual(len(self.names()), 500)
        self.assertLess(len(b.all(".row")), 60)
        b.run("byId('list').focus()")
        for _ in range(40):
            b.keys("f")
        self.assertLess(len(b.all("img")), 75)
        b.keys(Keys.END)
        self.assertEqual(b.text("#name"), self.names()[-1])
        self.assertEqual(b.text(".row[aria-selected=true] .rowName"), self.names()[-1])
        self.assertLess(len(b.all(".row")), 60)
        self.assertLess(len(b.all("img")), 75)
        b.run("byId('filter').value = 'scene49'; filterList()")
        self.assertEqual(len(self.names()), 11)
