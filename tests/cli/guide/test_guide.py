"""Tests the pages for users: every example runs, links have targets, and texts and pictures stay within their size
limits."""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

from common import PATIENCE, PROGRAM, SOURCE, main

GUIDE = SOURCE / "assets/guide"
README = SOURCE / "README.md"
PAGES = [README, *sorted(GUIDE.rglob("*.md"))]
LONGEST_PARAGRAPH = 120  # maximum length of a paragraph in words
README_LINES, README_WORDS = 150, 1200
PICTURE_BYTES, PICTURE_SIZE = 100 * 1024, (720, 720)


BROKEN = """# A page whose examples are all wrong
```json
"ball": {"sphere": {"radus": 1}}
```
```json invalid
"ball": {"sphere": {"radius": 1}}
```
```sh
echo before
exit 3
```
```sh no-run
simreel render flag -o out/ --frams 0
```
`simreel rendr flag` ![nothing](PICTURES/none.png)
""".replace("PICTURES", str(GUIDE / "pictures"))


def without_code(text):
    """Returns the text with code blocks and code spans removed, with the same number of lines."""
    text = re.sub(r"^```.*?^```[ \t]*$", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S)
    text = re.sub(r"^(?: {4}|\t)[^\n]*$", "", text, flags=re.M)
    return re.sub(r"`[^`\n]*`", "code", text)


def anchors(path):
    """Returns the anchors of a page's headings, as GitHub makes them, and of <a id=...>."""
    text = path.read_text(encoding="utf-8")
    bare = re.sub(r"^```.*?^```[ \t]*$", "", text, flags=re.M | re.S)
    names, seen = set(re.findall(r'<a (?:id|name)="([^"]+)"', bare)), {}
    for heading in re.findall(r"^#+ +(.*?)(?: +#+)?$", bare, re.M):
        words = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        names.add(f"{name}-{seen[name]}" if name in seen else name)
        seen[name] = seen.get(name, 0) + 1
    return names


def links(path):
    """Yields (line, target) of each link and picture of a page that leads to a file or a heading."""
    text = without_code(path.read_text(encoding="utf-8"))
    for m in re.finditer(r"\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)|^\[[^\]]+\]: +(\S+)|(?:src|href)=\"([^\"]+)\"", text, re.M):
        target = m[1] or m[2] or m[3]
        if not re.match(r"[a-z]+:", target):
            yield text.count("\n", 0, m.start()) + 1, target


def paragraphs(path):
    """Yields (line, number of words) of each paragraph and list item."""
    start, words = 0, 0
    for i, line in enumerate(without_code(path.read_text(encoding="utf-8")).splitlines() + [""], 1):
        bare = line.strip()
        if bare and not re.match(r"\||#|!\[", bare):
            if re.match(r"([-*]|\d+\.) ", bare) and words:
                yield start, words
                words = 0
            start = start if words else i
            words += len(bare.split())
        elif words:
            yield start, words
            words = 0


class Guide(unittest.TestCase):
    maxDiff = None

    def assert_none(self, places):
        self.assertEqual([], list(places), "\n" + "\n".join(places))

    def test_every_example_runs(self):
        done = subprocess.run([sys.executable, SOURCE / "tools/guide", "--check"], env={**os.environ, "SIMREEL": PROGRAM},
                              capture_output=True, text=True, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_broken_examples_are_named_with_page_and_line(self):
        with tempfile.TemporaryDirectory(prefix="simreel-guide-") as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(BROKEN, encoding="utf-8")
            done = subprocess.run([sys.executable, SOURCE / "tools/guide", "--check", page], env={**os.environ, "SIMREEL": PROGRAM},
                                  capture_output=True, text=True, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for place in ("page.md:2: this scene is not valid", "page.md:5: this scene is valid", "page.md:8: these commands ended with 3",
                      "page.md:12: simreel render has no flag --frams", "page.md:15: simreel has no command rendr",
                      "page.md:15: no command writes none.png"):
            self.assertIn(place, done.stderr)

    def test_every_link_leads_to_a_file_and_a_heading_that_exist(self):
        def broken():
            for page in PAGES:
                for line, target in links(page):
                    name, _, heading = target.partition("#")
                    place = (page.parent / name).resolve() if name else page
                    if not place.exists():
                        yield f"{page.relative_to(SOURCE)}:{line}: there is no {target}"
                    elif heading and place.suffix == ".md" and heading not in anchors(place):
                        yield f"{page.relative_to(SOURCE)}:{line}: {name or 'this page'} has no heading #{heading}"
        self.assert_none(list(broken()))

    def test_no_paragraph_is_long(self):
        self.assert_none([f"{page.relative_to(SOURCE)}:{line}: {words} words; {LONGEST_PARAGRAPH} are allowed"
                          for page in PAGES for line, words in paragraphs(page) if words > LONGEST_PARAGRAPH])

    def test_the_readme_is_short(self):
        text = README.read_text(encoding="utf-8")
        self.assertLessEqual(len(text.splitlines()), README_LINES, "lines of README.md")
        self.assertLessEqual(len(text.split()), README_WORDS, "words of README.md")

    def test_pictures_are_small_and_all_are_shown(self):
        shown = {(page.parent / target).resolve() for page in PAGES for _, target in links(page)}
        wrong = []
        for picture in sorted((GUIDE / "pictures").glob("*")):
            data = picture.read_bytes()
            if picture not in shown:
                wrong.append(f"{picture.name}: no page shows it")
            if len(data) > PICTURE_BYTES:
                wrong.append(f"{picture.name}: {len(data)} bytes; {PICTURE_BYTES} are allowed")
            size = struct.unpack(">II", data[16:24]) if data[:4] == b"\x89PNG" else (0, 0)
            if size[0] > PICTURE_SIZE[0] or size[1] > PICTURE_SIZE[1]:
                wrong.append(f"{picture.name}: {size[0]}x{size[1]} pixels")
        self.assert_none(wrong)

    def test_the_index_lists_every_page(self):
        wrong = []
        for index in [GUIDE / "README.md", GUIDE / "cookbook/README.md"]:
            if index.exists():
                listed = {(index.parent / target.split("#")[0]).resolve() for _, target in links(index)}
                wrong += [f"{index.relative_to(SOURCE)} does not list {page.name}" for page in sorted(index.parent.glob("[0-9]*.md"))
                          if page not in listed]
        self.assert_none(wrong)


if __name__ == "__main__":
    main()
