"""Tests the parts of the program for new users: help, lists, starter scenes, shipped scenes, explanations and the
reference."""
import json
import re
import shutil

from common import SOURCE, Case, main


class Help(Case):
    def test_help_shows_first_steps_and_exit_codes(self):
        out = self.good("--help").stdout.decode()
        for words in ("Where to start:", "simreel render flag -o flag.mp4", "simreel new cloth > cloth.json", "Exit codes:", "128 + n",
                      "\nWrite a scene:\n", "\nRender many:\n", "\nTools:\n"):
            self.assertIn(words, out)
        self.assertEqual(len(re.findall(r"^  simreel \w+ ", out, re.M)), 5)

    def test_help_fits_the_terminal_width(self):
        commands = re.findall(r"^  (\w+)  +[A-Z]", self.good("--help").stdout.decode(), re.M)
        self.assertGreater(len(commands), 17)
        for width in (60, 100):
            for arguments in (["list"], ["list", "cloth"], ["list", "--search", "wind"], ["render", "--help"], ["test", "--help"], ["sweep", "status", "--help"]):
                out = self.good(*arguments, env={"COLUMNS": str(width)}).stdout.decode()
                wide = [line for line in out.splitlines() if len(line) > width and "In a scene:" not in line]
                self.assertEqual([line for line in wide if " " in line.strip()], [], (width, arguments))

    def test_the_page_of_a_parameter_has_facts_and_an_example(self):
        out = self.good("list", "cloth.pins").stdout.decode()
        for words in ("cloth.pins: ", "  default   none; in a scene of version 1 the last row", "  example   \"pins\": [{", "-D objects.NAME.cloth.pins=VALUE", "pins[].rows"):
            self.assertIn(words, out)
        self.assertIn("  unit      N/m", self.good("list", "cloth.stiffness").stdout.decode())
        self.assertEqual(self.good("list", "cloth.pins.rows").stdout, self.good("list", "cloth.pins[].rows").stdout)
        self.bad(2, 'cloth has no parameter "pns"; did you mean "pins"?', "list", "cloth.pns")

    def test_search_finds_names_and_sentences(self):
        self.assertIn("fluid.viscosity", self.good("list", "--search", "viscosity").stdout.decode())
        self.assertIn("material.castsShadow", self.good("list", "--search", "Shadow casts").stdout.decode())
        self.bad(2, 'nothing in `simreel list` holds "qwertz"', "list", "--search", "qwertz")

    def test_lists_as_json_and_markdown(self):
        kinds = [kind["name"] for kind in json.loads(self.good("list", "--format", "json").stdout)["kinds"]]
        page = json.loads(self.good("list", "cloth", "--format", "json").stdout)
        self.assertIn("cloth", kinds)
        self.assertEqual(page["name"], "cloth")
        spacing = next(one for one in page["parameters"] if one["name"] == "spacing")
        self.assertEqual((spacing["default"], spacing["unit"]), (0.1, "m"))
        self.assertEqual(page["states"][0].split(":")[0], "positions")
        self.assertIn("# cloth\n", self.good("list", "cloth", "--format", "markdown").stdout.decode())


class Starters(Case):
    def test_every_kind_has_a_valid_starter_scene(self):
        kinds = [kind["name"] for kind in json.loads(self.good("list", "--format", "json").stdout)["kinds"]]
        files = sorted((SOURCE / "assets/starters").iterdir())
        self.assertEqual(sorted(file.stem for file in files), sorted(kinds))
        done = self.good("validate", *files)
        self.assertEqual(done.err, "")
        self.assertEqual(done.stdout.count(b": ok\n"), len(kinds))
        for file in files:
            lines = file.read_text().splitlines()
            self.assertTrue(8 <= len(lines) <= 31, (file.name, len(lines)))
            self.assertIn(f"Render it: simreel render {file.name} -o ", lines[0])
            self.assertIn(f'"{file.stem}": {{', file.read_text())

    def test_new_prints_the_starter_scene(self):
        self.assertEqual(self.good("new", "cloth").stdout, (SOURCE / "assets/starters/cloth.json").read_bytes())
        self.assertIn(b"  cloth ", self.good("new").stdout)
        self.bad(2, ['no starter scene is named "clth"', 'did you mean "cloth"?'], "new", "clth")


class Shipped(Case):
    def test_shipped_scenes_are_found_by_name(self):
        for name in ("flag", "scenes/flag.json", "flag.json"):
            done = self.good("validate", name)
            self.assertIn(f"{name} is the shipped scene ", done.err)
        self.assertEqual(self.good("-q", "validate", "flag").err, "")
        self.bad(2, ["there is no scene flga here", 'did you mean "flag"?'], "render", "flga", "-o", "x.png")
        shutil.copy(self.folder / "scene.json", self.folder / "flag.json")
        self.assertEqual(self.good("validate", "flag.json").err, "")

    def test_a_shipped_scene_is_not_edited_in_place(self):
        self.bad(2, "--edit would change the shipped scene; copy it first: cp ", "serve", "flag", "--edit")

    def test_pictures_are_not_scenes(self):
        self.bad(2, ["a.png is a picture, not a scene"], "render", "a.png", "-o", "x.png")


class Explain(Case):
    def rows(self, *arguments):
        found = json.loads(self.good("explain", *arguments, "--format", "json", "--quick").stdout)
        return {one["path"]: (one["value"], one["from"]) for one in found}

    def test_every_value_has_its_origin(self):
        self.write("ball.json", {"version": 1, "objects": {"ball": {"sphere": {"radius": 0.5}}}})
        rows = self.rows("ball.json", "-D", "time.fps=24", "--size", "64x36")
        self.assertEqual(rows["objects.ball.sphere.radius"], (0.5, "ball.json:6"))
        self.assertEqual(rows["time.fps"], (24, "command line"))
        self.assertEqual(rows["render.size"], ([64, 36], "command line"))
        self.assertEqual(rows["time.duration"][1], "default")
        self.assertEqual(rows["sun.intensity"], (3.3, "stage"))
        self.assertEqual(rows["render.quality"], ("standard", "stage"))
        self.assertEqual(rows["objects.ball.material.roughness"], (0.38, "stage"))
        self.assertEqual(rows["camera.position"][1], "placed to show all objects")
        self.assertEqual(rows["camera.near"][1], "default")

    def test_explain_shows_presets_and_parts(self):
        self.write("silk.json", {"version": 1, "camera": {"position": [0, 1, 3]}, "objects": {"sheet": {"cloth": {"fabric": "silk"}}}})
        rows = self.rows("silk.json", "objects.sheet.cloth")
        self.assertEqual(rows["objects.sheet.cloth.fabric.material"], ("silk", "silk.json:13"))
        self.assertEqual(rows["objects.sheet.cloth.fabric.density"][1], "the material's")
        self.assertTrue(all(path.startswith("objects.sheet.cloth.") for path in rows))
        changed = self.rows("silk.json", "--changed")
        self.assertNotIn("time.fps", changed)
        self.assertIn("camera.position", changed)


class Reference(Case):
    def test_the_committed_reference_is_up_to_date(self):
        self.good("list", "--reference", "reference")
        committed = SOURCE / "assets/guide/reference"
        names = {file.name for file in (self.folder / "reference").iterdir()}
        self.assertEqual({file.name for file in committed.iterdir()}, names, "run tools/reference")
        stale = [name for name in sorted(names) if (committed / name).read_bytes() != (self.folder / "reference" / name).read_bytes()]
        self.assertEqual(stale, [], "run tools/reference and commit what changes")
        for name in names:
            for picture in re.findall(r"!\[[^]]*\]\(\.\./(pictures/[^)]*)\)", (committed / name).read_text()):
                size = (SOURCE / "assets/guide" / picture).stat().st_size
                self.assertLessEqual(size, 102400, picture)

    def test_messages_occur_in_the_source(self):
        own = SOURCE / "src/cli/list/messages.cpp"
        text = "".join(file.read_text() for file in sorted((SOURCE / "src").rglob("*.[ch]pp")) if file != own)
        text = re.sub(r'"\s*\n\s*"', "", text)
        table = re.sub(r'"\s*\n\s*"', "", own.read_text())
        found = re.findall(r'\{"(?:\d|warning)",\s*"(?:[^"\\]|\\.)*",\s*"((?:[^"\\]|\\.)*)",', table)
        self.assertGreater(len(found), 25)
        self.assertEqual([part for part in found if part not in text], [])

    def test_state_arrays_of_the_pages_are_in_the_source(self):
        source = "".join(file.read_text() for file in sorted((SOURCE / "src/sim").rglob("*.cpp")))
        for page in (SOURCE / "assets/guide/reference").glob("*.md"):
            for name in re.findall(r"^\| `(\w+)` \|", page.read_text().partition("## State arrays")[2], re.M):
                self.assertIn(f'"{name}"', source, page.name)

    def test_environment_has_every_variable_that_the_source_reads(self):
        page = (SOURCE / "assets/guide/reference/environment.md").read_text()
        text = "".join(file.read_text() for file in sorted((SOURCE / "src").rglob("*.cpp")))
        names = set(re.findall(r'(?:getenv|setenv|variable)\("(\w+)"', text)) | set(re.findall(r'"((?:SIMREEL|MESA|LIBGL|GALLIUM|LP|EGL|VK|CI)_[A-Z_]+)"', text))
        names -= {"SIMREEL_VERSION"}
        self.assertGreater(len(names), 10)
        self.assertEqual([name for name in sorted(names) if name not in page], [])


if __name__ == "__main__":
    main()
