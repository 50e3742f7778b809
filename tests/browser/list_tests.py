"""Tests the list of scenes and the keyboard."""
from common import FLAG, ReportTest
from driver import Keys


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
        self.assertEqual([row.get_attribute("aria-posinset") for row in b.all(".row")],
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
        self.assertNotIn("cloth/flaky", self.names())  # with --allow-flaky, flaky scenes do not count as failing
        b.click("#allStatuses")
        self.assertEqual(len(self.names()), 13)
        b.run("arguments[0].dispatchEvent(new MouseEvent('click', {altKey: true}))", b.one(".chip.missing"))
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
    def test_keys_move_between_scenes_and_frames(self):
        b = self.open()
        self.assertEqual(b.text("#name"), "life/broken")
        b.keys("j")
        # the first failing frame of the scene is selected first
        self.assertEqual(self.chosen(), ("cloth/flag", 60, "side"))
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

    def test_number_keys_choose_views(self):
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
        b.keys("4")  # keys are ignored while the help is open
        self.assertEqual(self.chosen()[2], "side")
        b.keys(Keys.ESCAPE)
        self.assertEqual(b.visible("#keys"), [])
        b.click("#help")
        b.keys("?")
        self.assertEqual(b.visible("#keys"), [])

    def test_letters_go_into_the_filter_and_escape_leaves_it(self):
        b = self.open(FLAG + "side")
        b.keys("/", "j", "4")
        self.assertEqual(b.value("byId('filter').value"), "j4")
        self.assertEqual(self.chosen(), ("cloth/flag", 120, "side"))
        b.keys(Keys.ESCAPE)
        self.assertEqual(b.value("document.activeElement.id"), "list")

    def test_arrow_keys_move_through_the_list(self):
        b = self.open()
        b.run("byId('list').focus()")
        b.keys(Keys.ARROW_DOWN, Keys.ARROW_DOWN, Keys.ARROW_UP)
        self.assertEqual(b.text("#name"), "cloth/flag")
        active = b.one("#list").get_attribute("aria-activedescendant")
        self.assertEqual(b.text(f"#{active} .rowName"), "cloth/flag")
        b.keys(Keys.END)
        self.assertEqual(b.text("#name"), "cloth/tablecloth")

    def test_the_focus_outline_is_visible(self):
        b = self.open(FLAG + "side")
        for _ in range(12):
            b.keys(Keys.TAB)
            style = [b.style(":focus", name) for name in ("outlineStyle", "outlineWidth")]
            self.assertEqual(style, ["solid", "2px"], b.value("document.activeElement.outerHTML"))

    def test_every_control_has_an_accessible_name(self):
        b = self.open(FLAG + "swipe")
        nameless = b.value("""[...document.querySelectorAll('button, input, select, img, [role]')]
            .filter((e) => e.getAttribute('role') !== 'presentation' &&
                    !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length || e.hasAttribute('alt')))
            .map((e) => e.outerHTML)""")
        self.assertEqual(nameless, [])
