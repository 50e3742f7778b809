"""Tests a scene's own reaction rules through the program: overrides, time and noise in resumed runs, lost states,
errors."""
import struct
import zlib

from common import SCENE, Case, main, with_values

# The rule uses every quantity that depends on the step number, the model's time or the scene's time.
RULE = {"size": [37, 21], "steps": 5, "dt": 0.01, "presteps": 3, "method": "rk4",
        "parameters": {"p": 0.3, "q": {"keys": [[0, 1], [0.3, -1]]}}, "lets": {"w": "u - laplacian(u)"},
        "species": {"u": {"diffusion": 1, "start": "random(1)", "rate": "p*sin(t) + q*u - u^3 + noise(2)"},
                    "v": {"start": "x*0.01", "rate": "0.1*laplacian(w) - v"}},
        "strokes": [{"at": 0.1, "from": [5, 5, 0], "radius": 4, "value": 0.5, "species": "v"}]}


def values_of(data):
    (length,) = struct.unpack("<H", data[8:10])
    return struct.unpack(f"<{(len(data) - 10 - length) // 4}f", data[10 + length:])


def gray_png(width, height, levels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + bytes(levels[y * width:(y + 1) * width]) for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Reaction(Case):
    def setUp(self):
        super().setUp()
        self.write_rule(RULE)

    def write_rule(self, rule, **others):
        objects = {"r": {"reaction": rule}, **{name: {"reaction": other} for name, other in others.items()}}
        self.write("scene.json", with_values({"objects": objects, "time.duration": 10 / 30}, SCENE))

    def render(self, *more):
        return ["render", "scene.json", "-o", "out/", "--fields", "npy", *more]

    def test_species_fields_are_equal_on_both_memory_paths_and_in_pieces(self):
        # The second object reads this object and itself.
        self.write_rule(RULE, reader={"size": [22, 30], "parameters": {"f": {"field": "r.v"}, "own": {"field": "reader"}},
                                      "show": "w + f", "species": {"w": {"rate": "f - w*own"}}})
        self.good(*self.render())
        whole = self.content("out")
        names = {name.split(".", 1)[1] for name in whole if name.startswith("000004")}
        names.discard("csv")
        self.assertEqual(names, {"png", "r.npy", "r.u.npy", "r.v.npy", "reader.npy", "reader.w.npy"})
        self.assertEqual(whole["000004.r.npy"], whole["000004.r.u.npy"])
        self.assertEqual(len(values_of(whole["000004.r.v.npy"])), 37 * 21)
        # The stroke changes only v.
        self.assertEqual(values_of(whole["000003.r.v.npy"])[5 * 37 + 5], 0.5)
        for path in ("texel", "storage"):
            self.good(*self.render("--overwrite", "--memory-path", path))
            self.assertEqual({k: v for k, v in self.content("out").items() if k.endswith("npy")},
                             {k: v for k, v in whole.items() if k.endswith("npy")}, path)
        # The run continues from a checkpoint. Step numbers and times must continue as well.
        self.good("render", "scene.json", "-o", "kept/", "--checkpoint-at", "4", "--frames", "0-4")
        self.good("render", "scene.json", "-o", "more/", "--from", "kept/checkpoint.000004", "--fields", "npy", "--frames", "5-9")
        for name, data in self.content("more").items():
            if name.endswith("npy"):
                self.assertEqual(data, whole[name], name)

    def test_volumes_and_meshes_are_equal_on_both_memory_paths_and_in_pieces(self):
        volume = {"size": [13, 9], "depth": 7, "preset": "cahnHilliard", "steps": 5, "surface": {"color": "mu"},
                  "strokes": [{"at": 0.1, "until": 0.3, "from": [3, 4, 2], "to": [12, 8, 9], "radius": 2.5}]}
        mesh = {"mesh": {"shape": "torus", "resolution": [24, 13], "refine": 1}, "preset": "barkley", "steps": 5,
                "strokes": [{"at": 0.1, "until": 0.3, "from": [1, 0.3, 0], "to": [-1, 0.3, 0.2], "radius": 0.4}]}
        for rule, name, cells in ((volume, "c", 13 * 9 * 7), (mesh, "u", 4 * 23 * 12)):
            self.write_rule(rule)
            for path in ("texel", "storage"):
                self.good(*self.render("--overwrite", "--memory-path", path))
                files = self.content("out")
                if path == "texel":
                    whole = files
                self.assertEqual({k: v for k, v in files.items() if k.endswith(("npy", "png"))},
                                 {k: v for k, v in whole.items() if k.endswith(("npy", "png"))}, path)
            self.assertEqual(len(values_of(whole[f"000009.r.{name}.npy"])), cells)
            self.good("render", "scene.json", "-o", "kept/", "--overwrite", "--checkpoint-at", "4", "--frames", "0-4")
            self.good("render", "scene.json", "-o", "more/", "--overwrite", "--from", "kept/checkpoint.000004", "--fields", "npy", "--frames", "5-9")
            for name, data in self.content("more").items():
                if name.endswith(("npy", "png")):
                    self.assertEqual(data, whole[name], name)

    def test_several_steps_per_pass_are_equal_on_both_memory_paths(self):
        rule = {"size": [132, 37], "steps": 11, "dt": 1, "species": {
            "u": {"diffusion": 0.06, "start": "1 - 0.5*abs(random(1))", "rate": "0.04*(1 - u) - u*v^2"},
            "v": {"diffusion": 0.03, "start": "0.4*abs(random(2))", "rate": "u*v^2 - 0.1*v"}}}
        closed = {**rule, "boundary": "no-flux", "species": {**rule["species"], "w": {"rate": "laplacian(u) - w"}}}
        for one in (closed, rule):
            self.write_rule(one)
            for path in ("texel", "storage"):
                self.good(*self.render("--overwrite", "--memory-path", path))
                files = {k: v for k, v in self.content("out").items() if k.endswith("npy")}
                if path == "texel":
                    whole = files
                self.assertEqual(files, whole)
        self.assertNotEqual(whole["000009.r.u.npy"], whole["000008.r.u.npy"])
        # The error must name the first lost cell and its step, even inside a pass of several steps.
        self.write_rule({**rule, "species": {"u": {"start": "1 + 0.3*random(1)", "rate": "u^3"}}})
        said = [self.bad(4, ["\"u\" of cell ("], *self.render("--overwrite", "--memory-path", path)).stderr for path in ("texel", "storage")]
        self.assertEqual(*said)

    def test_pictures_give_first_values_and_diffusion(self):
        self.write("map.png", gray_png(4, 3, [0, 255, 0, 255] * 3))
        self.write_rule({"size": [4, 4], "steps": 1, "dt": 0.5, "parameters": {"p": {"value": 0, "white": 2, "image": "map.png"}},
                         "species": {"u": {"start": "p", "rate": "diffuse(p, u)"}}})
        self.good(*self.render("--frames", "0"))
        self.assertEqual(values_of(self.content("out")["000000.r.u.npy"])[:4], (0, 2, 0, 2))

    def test_counts_are_mean_and_max_values(self):
        self.good(*self.render())
        files = self.content("out")
        rows = files["counts.csv"].decode().splitlines()
        names = rows[0].split(",")
        row = dict(zip(names, rows[-1].split(",")))
        u, v = (values_of(files[f"000009.r.{name}.npy"]) for name in "uv")
        self.assertEqual(len(rows), 11)
        for name, want in (("mean_u", sum(u) / len(u)), ("mean_v", sum(v) / len(v)), ("mean_u^2", sum(a * a for a in u) / len(u)),
                           ("mean_v^2", sum(a * a for a in v) / len(v)), ("most_u", max(u)), ("most_v", max(v))):
            key = next(k for k in names if k.endswith(name))
            self.assertAlmostEqual(float(row[key]), want, delta=1e-5 * (1 + abs(want)))

    def test_overrides_reach_parameters(self):
        self.good(*self.render("--frames", "5"))
        before = self.content("out")["000005.r.npy"]
        self.good(*self.render("--frames", "5", "--overwrite", "-D", "objects.r.reaction.parameters.p=0.31"))
        self.assertNotEqual(self.content("out")["000005.r.npy"], before)
        self.good(*self.render("--frames", "5", "--overwrite", "-D", 'objects.r.reaction.species.u.rate="p*sin(t) + q*u - u^3 + noise(2)"'))
        self.assertEqual(self.content("out")["000005.r.npy"], before)
        self.bad_scene(["-D", "unknown name \"pp\"; did you mean"], *self.render("-D", 'objects.r.reaction.species.u.rate="p + q + pp"'))

    def test_the_shown_field_may_be_an_expression(self):
        self.write_rule({**RULE, "show": "2*u + v"})
        self.good(*self.render("--frames", "7"))
        files = self.content("out")
        u, v, shown = (values_of(files[f"000007.r{name}.npy"]) for name in (".u", ".v", ""))
        for a, b, c in zip(u, v, shown):
            self.assertAlmostEqual(c, 2 * a + b, delta=1e-5)

    def test_a_diverged_state_is_reported_with_species_cell_and_step(self):
        # With 15 steps before the first frame, the step at t = 0.2 belongs to frame 2.
        rule = {"size": [13, 9], "steps": 3, "dt": 0.1, "method": "euler", "species": {
            "calm": {}, "loud": {"rate": "if(x > 4 and x < 5 and y > 6 and y < 7, 1/step(t, 0.75), 0)"}}}
        self.write_rule(rule)
        for path in ("texel", "storage"):
            self.bad(4, ["reaction \"r\"", "\"loud\" of cell (4, 6)", "after step 9;"], *self.render("--overwrite", "--memory-path", path))

    def test_mistakes(self):
        species = {"u": {"rate": "u"}}
        for words, rule in ((["unknown name \"w\"", "^"], {"species": {"u": {"rate": "u + w"}}}),
                            (["no equations", "preset"], {}),
                            (["division by zero"], {"species": {"u": {"rate": "u/0"}}}),
                            (["nested deeper"], {"species": {"u": {"rate": "(" * 5000}}}),
                            (["at most 16384 bytes"], {"species": {"u": {"rate": "+".join(["u"] * 1000000)}}}),
                            (["form a circle"], {"species": species, "lets": {"a": "b", "b": "a"}}),
                            (["the rates need"], {"species": {"u": {"rate": "+".join(f"tanh(u+{i})" for i in range(99))}}}),
                            (["takes 2 arguments, found 1"], {"species": {"u": {"rate": "step(u)"}}}),
                            (["exclude each other"], {"species": species, "parameters": {"p": {"across": 1, "down": 2}}}),
                            (["a stroke paints the species \"x\""], {"species": species, "strokes": [{"species": "x"}]})):
            self.write_rule({"size": [8, 8], **rule})
            self.bad_scene(words, *self.render())
        # An unstable setting is not an error, but it causes a message.
        self.write_rule({"size": [8, 8], "steps": 1, "dt": 1, "species": {"u": {"diffusion": 0.5}}})
        done = self.good(*self.render())
        self.assertIn("stable up to 0.375; lower dt to 0.75", done.err)

    def test_the_page_has_presets_and_functions(self):
        page = self.good("list", "reaction").stdout.decode()
        for words in ("kuramotoSivashinsky: Kuramoto 1978", "mu = pow(c, 3.0) - c - gamma * laplacian(c);", "diffuse(D, u): div(D grad u)"):
            self.assertIn(words, page)


if __name__ == "__main__":
    main()
