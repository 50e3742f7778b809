#!/usr/bin/env python3
"""Tests tools/site: the pages of this repository make a site without broken links; a broken link is reported."""
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from common import PATIENCE, SOURCE, main

# There are two valid pages and a picture. Each error is added to the second page.
PAGES = {
    "README.md": "# Start\n\n[Guide](assets/guide/01-first.md#a-heading)\n",
    "assets/guide/01-first.md": "# First\n\n## A heading\n\nText with `[no](link.md)` and a list:\n- ![dot](dot.png)\n- [back](../../README.md)\n",
}
MISTAKES = {
    "[gone](gone.md)": "01-first.md: the link gone.md leads nowhere",
    "![gone](gone.png)": "01-first.md: the link gone.png leads nowhere",
    "[heading](../../README.md#no-such)": "index.html#no-such names no heading",
    '<script src="https://example.org/x.js"></script>': "loads https://example.org/x.js",
}


@unittest.skipUnless(shutil.which("mkdocs"), "mkdocs is not installed")
class Site(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="simreel-site-test-"))
        self.addCleanup(shutil.rmtree, self.folder, True)

    def site(self, *arguments):
        return subprocess.run([SOURCE / "tools/site", *arguments, self.folder / "site"], capture_output=True, text=True,
                              timeout=PATIENCE, check=False)

    def test_the_site_of_this_repository_builds_and_its_links_hold(self):
        done = self.site()
        self.assertEqual(done.returncode, 0, done.stderr)
        pages = list((self.folder / "site").rglob("*.html"))
        self.assertGreater(len(pages), 30)
        index = (self.folder / "site/search_index.js").read_text(encoding="utf-8")
        for text in ("Red silk over your own OBJ", "viscosity"):
            self.assertIn(text, index)
        for page in pages:
            self.assertNotRegex(page.read_text(encoding="utf-8"), r"<(?:link|script|img)[^>]*(?:href|src)=.(?:https?:)?//", page)

    def test_mistakes_are_reported_with_their_page(self):
        tree = self.folder / "tree"
        (tree / "assets/guide").mkdir(parents=True)
        (tree / "assets/guide/dot.png").write_bytes(b"")
        for name, text in PAGES.items():
            (tree / name).write_text(text, encoding="utf-8")
        done = self.site("--source", tree)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.folder / "site/assets/guide/01-first.html").read_text(encoding="utf-8")
        self.assertIn("<code>[no](link.md)</code>", page)
        # The list must be recognized as on GitHub.
        self.assertEqual(len(re.findall("<li>", page.partition("<article>")[2])), 2)
        first = tree / "assets/guide/01-first.md"
        first.write_text(PAGES["assets/guide/01-first.md"] + "\n" + "\n\n".join(MISTAKES) + "\n", encoding="utf-8")
        done = self.site("--source", tree)
        self.assertEqual(done.returncode, 1, done.stdout)
        for mistake, message in MISTAKES.items():
            self.assertIn(message, done.stderr, mistake)


if __name__ == "__main__":
    main()
