"""Tests epidemics and wildfires through the program: their counts as a table, and errors."""
import csv
import io
import json
import signal

from common import Case, main, with_values

SCENE = {
    "version": 1,
    "render": {"size": [64, 36], "samples": 1},
    "time": {"fps": 30, "duration": 0.4},
    "objects": {"town": {"epidemic": {"size": [67, 35], "stepsPerSecond": 60, "infected": 0.02, "beta": 0.2}}},
}
FIRE = {
    "version": 1,
    "render": {"size": [64, 36], "samples": 1},
    "time": {"fps": 30, "duration": 0.4},
    "objects": {"fire": {"wildfire": {"size": [67, 35], "strokes": [{"from": [30, 20, 0], "radius": 3}]}}},
}
FRAMES = 12


class SpreadCase(Case):
    def setUp(self):
        super().setUp()
        self.write("town.json", SCENE)
        self.write("fire.json", FIRE)

    def rows(self, name):
        return list(csv.reader(io.StringIO((self.folder / name).read_text(encoding="utf-8"))))


class Strokes(SpreadCase):
    def warnings(self, kind, name, extra, *strokes):
        """Returns the warnings that rendering prints about further strokes."""
        scene = with_values({f"objects.{name}": {kind: {"size": [67, 35], **extra, "strokes": [
            {"from": [30, 20, 0], "radius": 3}, *strokes]}}}, FIRE)
        self.write("strokes.json", scene)
        done = self.good("render", "strokes.json", "-o", "out/", "--overwrite", "--frames", "0")
        return [line for line in done.err.splitlines() if "warning" in line]

    def test_strokes_outside_the_grid_are_reported(self):
        kinds = (("wildfire", "fire", {}), ("epidemic", "fire", {}), ("life", "fire", {"border": "dead"}))
        for kind, name, bounded in kinds:
            for stroke in ({"from": [71, 20, 0], "radius": 3}, {"from": [-3, 20, 0], "radius": 3.4},
                           {"shape": "line", "from": [-9, 30, 0], "to": [9, 50, 0], "radius": 2},
                           {"from": [5, 90, 0], "to": [60, 40, 0], "until": 1, "radius": 4}):
                lines = self.warnings(kind, name, bounded, stroke)
                self.assertEqual(len(lines), 1, lines)
                self.assertIn(f"{kind} \"{name}\": strokes[1] paints nothing, it lies wholly outside", lines[0])
                self.assertEqual(self.warnings(kind, name, {"border": "torus"}, stroke), [])
            for stroke in ({"from": [-3, 20, 0], "radius": 3.6}, {"from": [-50, 0, 0], "to": [90, 30, 0], "until": 1},
                           {"shape": "line", "from": [-9, 30, 0], "to": [9, 44, 0], "radius": 3}):
                self.assertEqual(self.warnings(kind, name, bounded, stroke), [])

    def test_strokes_outside_volumes_and_meshes_are_reported(self):
        """Tests strokes in volumes and on meshes."""
        for space, stroke, said in (({"size": [8, 8], "depth": 8, "boundary": "no-flux"}, {"from": [4, 4, 19]},
                                     "lies wholly outside the volume of 8x8x8 cells"),
                                    ({"mesh": {"shape": "torus"}}, {"from": [0, 0, 0], "radius": 0.1},
                                     "reaches no vertex of the mesh")):
            self.write("space.json", {"version": 1, "objects": {"r": {"reaction": {
                "preset": "heat", **space, "strokes": [{"from": [1, 0, 0], "radius": 3}, stroke]}}}})
            done = self.good("validate", "space.json")
            lines = [line for line in done.err.splitlines() if "paints nothing" in line]
            self.assertEqual(len(lines), 1, lines)
            self.assertIn(f"reaction \"r\": strokes[1] paints nothing, it {said}", lines[0])


class Counts(SpreadCase):
    def test_table(self):
        self.good("render", "town.json", "-o", "out/")
        rows = self.rows("out/counts.csv")
        self.assertEqual(rows[0], ["step", "time", "town.susceptible", "town.infected", "town.recovered"])
        # The first row is the start. Between the first picture and the last, there are 11 frames with two steps each.
        self.assertEqual([int(row[0]) for row in rows[1:]], list(range(1 + 2 * (FRAMES - 1))))
        self.assertEqual([row[1] for row in rows[1:4]], ["0.000000", "0.016667", "0.033333"])
        for row in rows[1:]:
            self.assertEqual(sum(map(int, row[2:])), 67 * 35)
        self.assertNotEqual(rows[1][2:], rows[-1][2:])

    def test_force_on_obstacles(self):
        """A flow from the left pushes a disc downstream, with a much smaller force across."""
        disc = {"center": [20, 16, 0], "radius": 4}
        for measured in (False, True):
            self.write("flow.json", {"version": 1, "render": {"size": [64, 36]}, "time": {"fps": 30, "duration": 0.4}, "objects": {
                "flow": {"fluid": {"size": [64, 32], "flow": [30, 0, 0], "viscosity": 4, "strokes": [],
                                   "obstacles": [{**disc, "measured": measured}],
                                   "sides": {"left": {"kind": "inflow", "velocity": [30, 0, 0]}, "right": "open"}}}}})
            self.good("render", "flow.json", "-o", "flow.png", "--frames", "8", "--overwrite")
            self.assertEqual(self.rows("flow.counts.csv")[0][10:], ["flow.drag", "flow.lift"] if measured else [])
        drag, lift = (float(value) for value in self.rows("flow.counts.csv")[-1][10:])
        self.assertGreater(drag, 30 * 30)  # The frontal size is 8 cells, so the drag coefficient is above 1/4.
        self.assertLess(abs(lift), 0.2 * drag)

    def test_floats(self):
        """Tests quantities of floating bodies, and the water volume without the displaced part."""
        box = {"shape": "box", "size": [0.5, 0.4, 0.5], "density": 500, "position": [0.1, 0, 0]}
        self.write("pool.json", {"version": 1, "render": {"size": [64, 36]}, "time": {"fps": 20, "duration": 0.2}, "objects": {
            "w": {"water": {"size": [16, 16], "cell": 0.1, "level": 0, "terrain": {"bed": -1}, "floats": [box]}}}})
        self.good("render", "pool.json", "-o", "pool.png", "--frames", "3")
        names, *rows = self.rows("pool.counts.csv")
        self.assertEqual(names[9:], ["w.displaced", "w.floatSpeed", "w.leastUpright", "w.draft", "w.floatX", "w.floatY", "w.floatZ"])
        for row in rows:
            values = {name[2:]: float(value) for name, value in zip(names[2:], row[2:])}
            self.assertAlmostEqual(values["volume"] + values["displaced"], 1.6 ** 2, delta=0.05)
            self.assertAlmostEqual(values["displaced"], 0.05, delta=0.01)
            self.assertAlmostEqual(values["draft"], 0.2, delta=0.03)
            self.assertAlmostEqual(values["floatX"], 0.1, delta=0.01)
            self.assertAlmostEqual(values["leastUpright"], 1, delta=0.01)

    def test_names_of_the_table_and_its_columns(self):
        for output, table in (("out/", "out/counts.csv"), ("a_####.png", "a.counts.csv"), ("b.mp4", "b.mp4.counts.csv")):
            self.good("render", "fire.json", "-o", output)
            self.assertEqual(self.rows(table)[0],
                             ["step", "time", "fire.unburnt", "fire.burning", "fire.burnt", "fire.bare"])
        self.good("render", "fire.json", "-o", "c.png", "--frames", "3")
        self.assertEqual(len(self.rows("c.counts.csv")), 2 + 6)
        self.good("render", "fire.json", "-o", "quiet/", "--no-counts")
        self.assertNotIn("counts.csv", self.content("quiet"))
        self.good("render", "scene.json", "-o", "cloth/")
        self.assertNotIn("counts.csv", self.content("cloth"))
        self.good("render", "fire.json", "-o", "-")

    def test_a_pre_roll_with_a_low_step_rate(self):
        self.write("slow.json", with_values({"time.start": 0.2, "objects.town.epidemic.stepsPerSecond": 15}, SCENE))
        self.good("render", "slow.json", "-o", "out/")
        rows = self.rows("out/counts.csv")[1:]
        self.assertEqual(rows[0][:2], ["0", "-0.200000"])
        self.assertEqual([row[1] for row in rows[1:4]], ["-0.133333", "-0.066667", "0.000000"])
        self.assertEqual(len(rows), 1 + 3 + 5)

    def test_objects_with_different_step_rates_share_a_table(self):
        scene = with_values({"objects.fire": FIRE["objects"]["fire"], "objects.fire.wildfire.stepsPerSecond": 30}, SCENE)
        self.write("both.json", scene)
        self.good("render", "both.json", "-o", "out/")
        rows = self.rows("out/counts.csv")
        fire = rows[0].index("fire.burning")
        self.assertEqual([row[fire] == "" for row in rows[1:6]], [False, True, False, True, False])
        town = rows[0].index("town.infected")
        self.assertTrue(all(row[town] for row in rows[1:]))

    def test_a_shorter_run_keeps_the_longer_table(self):
        self.good("render", "town.json", "-o", "out/")
        whole = self.content("out")
        self.good("render", "town.json", "-o", "out/", "--overwrite", "--frames", "2")
        self.assertEqual(self.content("out"), whole)
        self.good("render", "town.json", "-o", "out/", "--overwrite", "--seed", "9")
        self.assertNotEqual(self.content("out")["counts.csv"], whole["counts.csv"])

    def test_resume(self):
        self.good("render", "town.json", "-o", "out/")
        whole = self.content("out")
        (self.folder / "out/000004.png").unlink()
        for damage in (lambda p: p.unlink(), lambda p: p.write_bytes(p.read_bytes()[:50]), lambda p: p.write_text("x"),
                       lambda p: p.write_bytes(p.read_bytes() + b"9,9,9\n")):
            damage(self.folder / "out/counts.csv")
            self.good("render", "town.json", "-o", "out/", "--resume")
            self.assertEqual(self.content("out"), whole)

    def test_interrupted_and_resumed(self):
        self.write("long.json", with_values({"time.duration": 4, "render.size": [320, 240],
                                             "objects.town.epidemic.size": [515, 257],
                                             "objects.town.epidemic.stepsPerSecond": 600}, SCENE))
        arguments = ("render", "long.json", "-o", "out/")
        code, messages = self.signal_after(3, "out", signal.SIGINT, *arguments)
        self.assertEqual(code, 128 + signal.SIGINT, messages)
        self.good("render", "long.json", "-o", "whole/")
        part = (self.folder / "out/counts.csv").read_bytes()
        whole = (self.folder / "whole/counts.csv").read_bytes()
        self.assertTrue(whole.startswith(part) and len(part) < len(whole))
        self.good(*arguments, "--resume")
        self.assertEqual(self.content("out"), self.content("whole"))

    def test_memory_paths_agree(self):
        for scene in ("town.json", "fire.json"):
            for path in ("texel", "storage"):
                self.good("render", scene, "-o", f"{scene}.{path}/", "--memory-path", path)
            texel, storage = (self.content(f"{scene}.{path}") for path in ("texel", "storage"))
            # With exact pictures, the memory path changes only the fingerprint in the manifest.
            manifests = [json.loads(files.pop("manifest.json")) for files in (texel, storage)]
            self.assertEqual(*(manifest["frames"] for manifest in manifests))
            self.assertEqual(texel, storage)
            self.good("render", scene, "-o", f"{scene}.texel/", "--memory-path", "storage", "--resume")
            by_driver = ("render", scene, "-o", f"{scene}.driver/", "--rasterizer", "driver")
            self.good(*by_driver, "--memory-path", "texel")
            self.bad(2, "memory path", *by_driver, "--memory-path", "storage", "--resume")

    def test_an_unwritable_table_is_an_error(self):
        (self.folder / "out/counts.csv").mkdir(parents=True)
        self.bad(6, ["counts.csv"], "render", "town.json", "-o", "out/")


class Mistakes(SpreadCase):
    def wrong(self, words, path, value, scene="fire"):
        done = self.bad_scene(words, "render", f"{scene}.json", "-o", "out/", "-D", f"objects.{path}={json.dumps(value)}")
        self.assertFalse((self.folder / "out").exists())
        return done

    def test_values(self):
        for name in ("beta", "gamma", "waning", "infected", "immune"):
            self.wrong(name, f"town.epidemic.{name}", 1.5, "town")
            self.wrong(name, f"town.epidemic.{name}", -0.1, "town")
        self.wrong("more than all people", "town.epidemic.immune", 0.99, "town")
        self.wrong("size", "town.epidemic.size", [2, 9], "town")
        self.wrong("size", "town.epidemic.size", [9, 70000], "town")
        self.wrong(["mixing", "did you mean \"global\"?"], "town.epidemic.mixing", "globl", "town")
        self.wrong("\"colors\"", "town.epidemic.display", {"map": "magma"}, "town")
        for name in ("spread", "moisture", "fuelLevel", "patchiness"):
            self.wrong(name, f"fire.wildfire.{name}", 1.5)
        self.wrong("burnSteps", "fire.wildfire.burnSteps", 64)
        self.wrong("chance", "fire.wildfire.embers", {"chance": 0.5})
        self.wrong("strength", "fire.wildfire.wind", {"strength": -1})

    def test_a_scene_without_a_start_is_refused(self):
        self.wrong("nobody is ever infected", "town.epidemic.infected", 0, "town")
        self.wrong("nothing is ever lit", "fire.wildfire.strokes", [])
        self.wrong("nothing is ever lit", "fire.wildfire.strokes", [{"value": 0}])

    def test_maps(self):
        self.write("text.png", "no picture")
        for scene, kind, names in (("town", "epidemic", [("population", "population map")]),
                                   ("fire", "wildfire", [("fuel", "fuel map"), ("obstacles", "obstacle map"),
                                                         ("terrain", "terrain map"), ("moistureMap", "moisture map")])):
            for name, words in names:
                self.bad(6, [words, "text.png", "PNG"], "render", f"{scene}.json", "-o", "out/", "-D",
                         f"objects.{scene}.{kind}.{name}=text.png")
                self.bad_scene([name, "nowhere.png"], "render", f"{scene}.json", "-o", "out/", "-D",
                               f"objects.{scene}.{kind}.{name}=nowhere.png")

    def test_limits(self):
        for scene, kind in (("town", "epidemic"), ("fire", "wildfire")):
            self.bad(4, [scene, "65536x65536", "make \"size\" smaller"], "render", f"{scene}.json", "-o", "out/", "-D",
                     f"objects.{scene}.{kind}.size=[65536,65536]")

    def test_nothing_burns(self):
        self.bad(2, ["nothing on the wildfire's map can burn"], "render", "fire.json", "-o", "out/", "-D",
                 "objects.fire.wildfire.fuelLevel=0")


if __name__ == "__main__":
    main()
