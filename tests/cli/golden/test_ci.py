"""Tests the results that CI servers display: annotations, Markdown with pictures, JUnit attachments; and the steps of
tools/ci."""
import base64
import os
import re
import shutil
import subprocess
import urllib.parse
import xml.etree.ElementTree as ElementTree

from common import PROGRAM, SOURCE, main, png_rows
from golden_common import RED, GoldenCase, png

# Clears variables that a CI server sets when it runs these tests.
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
            "a": ("scenes/a.json", self.line_of("scenes/a.json", '"flag"')),  # scene a: the picture differs
            "b": ("scenes/b.json", self.line_of("scenes/b.json", '"mass"') - 1),  # scene b: the check fails
            "c": ("scenes/c.json", 3),
            "d": ("scenes/d.json", self.line_of("scenes/d.json", '"test"')),
            "e": ("scenes/e.json", self.line_of("scenes/e.json", '"flag"')),  # scene e: the state differs
            "f": ("scenes/f.test.json", 2)})

    def test_nine_annotations_and_a_count_of_the_rest(self):
        for count, shown in ((10, 10), (12, 10)):
            for i in range(count):
                self.write(f"scenes/s{i:02}.json", "no json")
            (self.folder / "scenes/a.json").unlink(missing_ok=True)
            made = self.annotations(code=2)
            self.assertEqual(len(made), shown)
        self.assertEqual(made[9][1:], ("", "", "simreel", "3 more; the summary and the report have all"))
        self.assertEqual(made[8][1], "scenes/s08.json")

    def pictures(self):
        """Makes x.png, which differs from its baseline."""
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
        # With picture files, the page shows small copies of the report's pictures.
        self.compare(1, "--markdown", "deep/s.md", "--report", "r & d")
        images = self.images(read("deep/s.md"))
        self.assertEqual([what for _, what in images], ["before", "after", "difference"])
        for address, _ in images:
            self.assertTrue((self.folder / "deep" / urllib.parse.unquote(address)).is_file(), address)
        # Without a report, the pictures are stored in the Markdown file's folder.
        self.compare(1, "--markdown", "s.md")
        self.assertEqual([(self.folder / address).is_file() for address, _ in self.images(read("s.md"))], [True] * 3)
        # Pictures can be embedded in the text (as in a job summary), referred to at an address, or left out.
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
        # Paths are relative to the project's folder if the CI server names it, and otherwise to the working folder.
        for name in ("CI_PROJECT_DIR", "WORKSPACE"):
            self.compare(1, "--report", "out/r", "--junit", "j.xml", **{name: str(self.folder / "out")})
            self.assertEqual(self.attachments("j.xml")[0], paths[0].removeprefix("out/"))
            self.compare(1, "--report", "out/r", "--junit", "j.xml", **{name: "/nowhere"})
            self.assertEqual(self.attachments("j.xml")[0], str(self.folder / paths[0]))
        # Pictures are not attached if they are not kept.
        self.compare(1, "--junit", "j.xml")
        self.assertNotIn("ATTACHMENT", (self.folder / "j.xml").read_text(encoding="utf-8"))


def shell_steps(text):
    """Returns {job: its shell steps in order} of a GitHub Actions or GitLab workflow, parsed by indentation; steps of
    an extended job come first. A step is (its own environment, script)."""
    jobs, job, steps, bases, env = {}, None, [], {}, {}
    lines = [line for line in text.split("\n") if line.strip() and not line.strip().startswith("#")]
    github = "jobs:" in lines
    top = 2 if github else 0
    inside = not github
    for i, line in enumerate(lines):
        depth = len(line) - len(line.lstrip())
        word = line.strip()
        inside = inside or word == "jobs:"
        if inside and depth == top and word.endswith(":") and word != "jobs:":
            job = word[:-1]
            steps = jobs.setdefault(job, [])
        elif word.startswith("extends: "):
            bases[job] = word.removeprefix("extends: ")
        elif github and word.startswith("- "):
            env = {}
        if github and word.startswith("env: {") and depth > top + 2:
            env.update(re.findall(r'(\w+): "([^"]*)"', word))
        if github and "run: " in word:
            script = word.partition("run: ")[2]
            if script == "|":
                block = []
                for more in lines[i + 1:]:
                    if len(more) - len(more.lstrip()) <= depth:
                        break
                    block.append(more.strip())
                script = "\n".join(block)
            steps.append((env, script))
        elif not github and word in ("script:", "before_script:"):
            for more in lines[i + 1:]:
                if not more.strip().startswith("- ") or len(more) - len(more.lstrip()) <= depth:
                    break
                steps.append(({}, more.strip()[2:]))
    return {name: jobs.get(bases.get(name), []) + own for name, own in jobs.items() if not name.startswith(".")}


class Workflows(GoldenCase):
    """Runs the shell steps of tools/ci/github.yml and gitlab.yml in a repository that contains scenes but no simreel,
    on machines without simreel until a step installs the package."""

    def setUp(self):
        super().setUp()
        self.set_scene({}, "b")
        self.make_baselines()
        self.set_scene(RED, "b")
        package = self.write("package.deb", "the package")
        # Replaces programs by stubs: curl copies the package, and apt-get installs given files and known packages.
        self.tools = self.folder / "tools"
        self.machines = 0
        stubs = {"curl": f'[ "$1 $2 $4" = "-fsSL -o https://example.com/simreel_amd64.deb" ] && cp "{package}" "$3"',
                 "apt-get": 'case "$*" in "update -qq") ;; "install -y -qq ca-certificates curl"*) ;;\n'
                            '"install -y -qq /tmp/simreel.deb") [ "$(cat /tmp/simreel.deb)" = "the package" ] && ln -s "$PROGRAM" "$BIN/simreel" ;;\n'
                            "*) echo \"apt-get: $*?\" >&2; exit 100 ;; esac"}
        for name, text in stubs.items():
            self.write(f"tools/{name}", "#!/bin/sh\n" + text.replace("/tmp/simreel.deb", str(self.folder / "fetched.deb")) + "\n").chmod(0o755)

    def run_job(self, steps, values, reports, **env):
        """Runs a job in a fresh clone with its own program folder; returns the last step's exit code and the output.
        Copies reports of earlier jobs in and new reports out, like a server's artifacts."""
        self.machines += 1
        clone, binaries = (self.folder / f"{kind}{self.machines}" for kind in ("clone", "bin"))
        binaries.mkdir()
        shutil.copytree(self.folder / "scenes", clone / "scenes")
        if reports.exists():
            shutil.copytree(reports, clone / "simreel-reports")
        whole = {"PATH": f"{self.tools}:{binaries}:/usr/bin:/bin", "BIN": str(binaries), "PROGRAM": PROGRAM, "HOME": str(clone),
                 "SIMREEL_PACKAGE": "https://example.com/simreel_amd64.deb", "SCENES": "scenes", **env}
        said = ""
        for own, script in steps:
            for name, value in values.items():
                script = script.replace(name, value)
                own = {key: text.replace(name, value) for key, text in own.items()}
            script = script.replace("/tmp/simreel.deb", str(self.folder / "fetched.deb"))
            self.assertNotIn("${{", script + "".join(own.values()))
            if "MESA_SHADER_CACHE_DIR=" in script:  # The tests' own shader cache is used, because it is already filled.
                script = script.replace(script[script.index("export MESA"):].split("\n")[0], ":")
            done = subprocess.run(["bash", "-e", "-c", script], cwd=clone, env={**whole, **own}, capture_output=True, text=True, check=False)
            said += done.stdout + done.stderr
            if done.returncode != 0:
                break
        if (clone / "simreel-reports").exists():
            shutil.copytree(clone / "simreel-reports", reports, dirs_exist_ok=True)
        return done.returncode, said

    def declared(self, text):
        self.assertIn("SIMREEL_PACKAGE: https://example.com/simreel_amd64.deb", text)
        self.assertIn("SCENES: scenes", text)

    def test_github(self):
        text = (SOURCE / "tools/ci/github.yml").read_text(encoding="utf-8")
        self.declared(text)
        self.assertIn("part: [1, 2, 3, 4]", text)
        jobs = shell_steps(text)
        self.assertEqual(list(jobs), ["test", "merge"])
        reports, summary = self.folder / "reports", self.folder / "summary"
        codes = [self.run_job(jobs["test"], {"${{ matrix.part }}": str(part)}, reports) for part in (1, 2, 3, 4)]
        self.assertEqual([code for code, _ in codes], [0, 1, 0, 0], codes)
        self.assertEqual(sorted(p.name for p in reports.iterdir()), ["1", "2", "3", "4"])
        for address, source in (("", "data:image/png"), ("https://host/r", 'src="https://host/r/files/b/')):
            code, said = self.run_job(jobs["merge"], {"${{ vars.REPORT_URL }}": address}, reports, GITHUB_STEP_SUMMARY=str(summary))
            self.assertEqual(code, 1, said)
            self.assertIn("::error file=scenes/b.json,line=", said)
            self.assertIn(source, summary.read_text(encoding="utf-8"))
            self.assertTrue((reports / "all/index.html").exists())
            summary.unlink()
            shutil.rmtree(reports / "all")
        shutil.rmtree(reports / "3")
        code, said = self.run_job(jobs["merge"], {"${{ vars.REPORT_URL }}": ""}, reports, GITHUB_STEP_SUMMARY=str(summary))
        self.assertIn("no report of shard 3/4", said)  # The machine that ran this shard has been lost.

    def test_gitlab(self):
        text = (SOURCE / "tools/ci/gitlab.yml").read_text(encoding="utf-8")
        self.declared(text)
        self.assertIn("parallel: 4", text)
        jobs = shell_steps(text)
        jobs.pop("variables")
        self.assertEqual(list(jobs), ["golden", "golden-report"])
        reports = self.folder / "reports"
        codes = [self.run_job(jobs["golden"], {}, reports, CI_NODE_INDEX=str(part), CI_NODE_TOTAL="4")[0] for part in (1, 2, 3, 4)]
        self.assertEqual(codes, [0, 1, 0, 0])
        code, said = self.run_job(jobs["golden-report"], {}, reports)
        self.assertEqual(code, 1, said)
        self.assertIn("[[ATTACHMENT|", (reports / "junit.xml").read_text(encoding="utf-8"))
        self.assertTrue((reports / "summary.md").exists())

    def test_a_missing_package_ends_the_job(self):
        (self.folder / "package.deb").unlink()
        jobs = shell_steps((SOURCE / "tools/ci/github.yml").read_text(encoding="utf-8"))
        self.assertNotEqual(self.run_job(jobs["test"], {"${{ matrix.part }}": "1"}, self.folder / "reports")[0], 0)
        self.assertFalse((self.folder / "reports").exists())


if __name__ == "__main__":
    main()
