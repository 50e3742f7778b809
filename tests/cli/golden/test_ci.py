"""What CI servers show of a test: annotations, Markdown with pictures, attachments of JUnit; and the steps of tools/ci."""
import base64
import os
import re
import shutil
import subprocess
import urllib.parse
import xml.etree.ElementTree as ElementTree

from common import PROGRAM, SOURCE, main, png_rows
from golden_common import RED, GoldenCase, png

STEPS = SOURCE / "tools/ci/steps.sh"
# Variables that a server running these tests sets itself.
SERVER = {"GITHUB_ACTIONS": "", "GITHUB_STEP_SUMMARY": "", "CI_PROJECT_DIR": "", "WORKSPACE": ""}


class Servers(GoldenCase):
    def attachments(self, name):
        system_out = ElementTree.parse(self.folder / name).find(".//testcase/system-out").text
        lines = [line for line in system_out.split("\n") if "ATTACHMENT" in line]
        return [re.fullmatch(r"\[\[ATTACHMENT\|(.+)\]\]", line)[1] for line in lines]

    def images(self, markdown):
        return re.findall(r'<img src="([^"]+)" width="160" alt="([a-z]+) ', markdown)

    def line_of(self, name, word):
        lines = (self.folder / name).read_text(encoding="utf-8").split("\n")
        return next(i for i, line in enumerate(lines, 1) if word in line)

    def annotations(self, *arguments, code=1):
        done = self.run_program("test", "scenes", "--github", "--report", "r", *arguments, env=SERVER)
        self.assertEqual(done.returncode, code, done.err)
        return re.findall(r"^::(\w+) (?:file=([^,]*),)?(?:line=(\d+),)?title=([^:]*)::(.*)$", done.stdout.decode(), re.M)

    def test_annotations_name_the_line(self):
        self.set_scene({}, "b")
        self.make_baselines()
        self.set_scene(RED)
        self.set_scene({"checks": [{"what": "no-nan"}, {"what": "mass", "object": "flag", "max": 0.001}]}, "b")
        self.write("scenes/c.json", '{"version": 1,\n\n "objects": {"x": {"clothh": {}}}}')
        self.set_scene({}, "d")
        self.set_scene({"objects.flag.cloth.stiffness": 40}, "e")
        shutil.copytree(self.golden("a"), self.golden("e"))
        self.set_scene({}, "f")
        self.write("scenes/f.test.json", '{\n "test": {"frames": [0], "size": [64, 36], "samples": 1}}')
        found = {title.split()[-2]: (file, int(line)) for _, file, line, title, _ in self.annotations()}
        self.assertEqual(found, {
            "a": ("scenes/a.json", self.line_of("scenes/a.json", '"flag"')),  # whose picture differs
            "b": ("scenes/b.json", self.line_of("scenes/b.json", '"mass"') - 1),  # the check
            "c": ("scenes/c.json", 3),
            "d": ("scenes/d.json", self.line_of("scenes/d.json", '"test"')),
            "e": ("scenes/e.json", self.line_of("scenes/e.json", '"flag"')),  # whose state differs
            "f": ("scenes/f.test.json", 2)})

    def test_nine_annotations_and_one_that_counts(self):
        for count, shown in ((10, 10), (12, 10)):
            for i in range(count):
                self.write(f"scenes/s{i:02}.json", "no json")
            (self.folder / "scenes/a.json").unlink(missing_ok=True)
            made = self.annotations(code=2)
            self.assertEqual(len(made), shown)
        self.assertEqual(made[9][1:], ("", "", "simreel", "3 more; the summary and the report have all"))
        self.assertEqual(made[8][1], "scenes/s08.json")

    def pictures(self):
        """x.png, drawn otherwise than its baseline."""
        def picture(value):
            return png(320, 20, [b"".join(bytes([value, x % 251, 9]) for x in range(320))] * 20)
        self.write("old/x.png", picture(10))
        self.write("new/x.png", picture(200))

    def compare(self, code, *arguments, **env):
        done = self.run_program("test", "--expected", "old", "--actual", "new", *arguments, env={**SERVER, **env})
        self.assertEqual(done.returncode, code, done.err)

    def test_markdown(self):
        self.pictures()
        read = lambda name: (self.folder / name).read_text(encoding="utf-8")
        # Files: the page shows small those of the report.
        self.compare(1, "--markdown", "deep/s.md", "--report", "r & d")
        images = self.images(read("deep/s.md"))
        self.assertEqual([what for _, what in images], ["before", "after", "difference"])
        for address, _ in images:
            self.assertTrue((self.folder / "deep" / urllib.parse.unquote(address)).is_file(), address)
        # Alone it keeps the pictures beside it.
        self.compare(1, "--markdown", "s.md")
        self.assertEqual([(self.folder / address).is_file() for address, _ in self.images(read("s.md"))], [True] * 3)
        # Within the text, as in a job summary; an address; none.
        summary = self.write("summary", "earlier\n")
        self.compare(1, "--report", "r", "--github", GITHUB_STEP_SUMMARY=str(summary))
        self.assertTrue(read("summary").startswith("earlier\n"))
        within = [base64.b64decode(a.removeprefix("data:image/png;base64,")) for a, _ in self.images(read("summary"))]
        self.assertEqual([png_rows(picture)[:2] for picture in within], [(160, 10)] * 3)
        self.assertEqual(len(set(within)), 3)
        for how, start in (("https://host/x", "https://host/x/files/x.png/"), ("https://host/", "https://host/files/x.png/")):
            self.compare(1, "--report", "r", "--markdown", "s.md", "--markdown-pictures", how)
            self.assertEqual([a.startswith(start) for a, _ in self.images(read("s.md"))], [True] * 3)
        self.compare(1, "--report", "r", "--markdown", "s.md", "--markdown-pictures", "none")
        self.assertEqual(self.images(read("s.md")), [])
        for bad in ("ftp://x", "x", 'https://x"onload', "https://x y"):
            self.bad(2, "--markdown-pictures takes", "test", "scenes", "--markdown", "s.md", "--markdown-pictures", bad)

    def test_attachments(self):
        self.pictures()
        self.compare(1, "--report", "out/r", "--junit", "j.xml")
        paths = self.attachments("j.xml")
        self.assertEqual([path.rpartition("/")[2] for path in paths], ["actual.png", "expected.png", "difference.png"])
        for path in paths:
            self.assertTrue((self.folder / path).is_file(), path)
        # The project's folder, where the server says it; else the one that it ran in.
        for name in ("CI_PROJECT_DIR", "WORKSPACE"):
            self.compare(1, "--report", "out/r", "--junit", "j.xml", **{name: str(self.folder / "out")})
            self.assertEqual(self.attachments("j.xml")[0], paths[0].removeprefix("out/"))
            self.compare(1, "--report", "out/r", "--junit", "j.xml", **{name: "/nowhere"})
            self.assertEqual(self.attachments("j.xml")[0], str(self.folder / paths[0]))
        # Nothing that is not kept.
        self.compare(1, "--junit", "j.xml")
        self.assertNotIn("ATTACHMENT", (self.folder / "j.xml").read_text(encoding="utf-8"))


class Steps(GoldenCase):
    def step(self, code, *arguments, **env):
        server = {**os.environ, **SERVER, "SIMREEL": PROGRAM, "SCENES": "scenes", "JOBS": "1", **env}
        done = subprocess.run([STEPS, *arguments], cwd=self.folder, env=server, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_steps(self):
        """As tools/ci/github.yml and gitlab.yml have a server run them, on one machine."""
        self.set_scene({}, "b")
        self.make_baselines()
        self.set_scene(RED, "b")
        self.step(0, "test", "1/3")
        self.step(1, "test", "2/3")
        self.step(0, "test", "3/3")  # which no scene falls into
        for _ in range(2):  # again, over what it left
            self.step(1, "merge")
        reports = self.folder / "simreel-reports"
        self.assertEqual(sorted(p.name for p in reports.iterdir()), ["1", "2", "3", "all", "junit.xml", "summary.md"])
        self.assertIn("data:image/png", (reports / "summary.md").read_text(encoding="utf-8"))
        self.assertIn("[[ATTACHMENT|simreel-reports/all/files/b/", (reports / "junit.xml").read_text(encoding="utf-8"))
        summary = self.folder / "summary"
        done = self.step(1, "merge", GITHUB_ACTIONS="true", GITHUB_STEP_SUMMARY=str(summary), REPORT_URL="https://host/r")
        self.assertIn("::error file=scenes/b.json,line=", done.stdout)
        self.assertIn('src="https://host/r/files/b/', summary.read_text(encoding="utf-8"))
        self.good("accept", "simreel-reports/all")
        shutil.rmtree(reports)
        for part in "12":
            self.step(0, "test", f"{part}/3")
        self.assertIn("no report of shard 3/3", self.step(5, "merge").stdout)  # its machine was lost
        self.step(2, "test")
        self.step(2, "tset")

    def test_the_examples_call_them(self):
        """Every step, with what their servers put in, and nothing that the steps do not know."""
        def calls(name):
            text = (SOURCE / "tools/ci" / name).read_text(encoding="utf-8")
            try:
                import yaml
                self.assertIsInstance(yaml.safe_load(text), dict)
            except ImportError:
                pass
            return re.findall(r"^ +- (?:run: )?(tools/ci/steps\.sh .+)$", text, re.M)
        self.assertEqual(calls("github.yml"), ["tools/ci/steps.sh test ${{ matrix.part }}/4", "tools/ci/steps.sh merge"])
        self.assertEqual(calls("gitlab.yml"),
                         ['tools/ci/steps.sh test "$CI_NODE_INDEX/$CI_NODE_TOTAL"', "tools/ci/steps.sh merge"])
        self.assertIn("part: [1, 2, 3, 4]", (SOURCE / "tools/ci/github.yml").read_text(encoding="utf-8"))
        self.assertIn("parallel: 4", (SOURCE / "tools/ci/gitlab.yml").read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
