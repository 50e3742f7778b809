"""Tests simreel test --expected DIR: pictures of any program, their baselines, rules, and commands that make
pictures."""
import json
import math
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

from common import Case, main
from exr_file import write_exr
from golden_common import png

WIDTH, HEIGHT = 24, 16
LFS = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"


def ramp(x, y):
    return (7 * x) % 256, (9 * y) % 256, (x + y) % 256


def picture(at=ramp, size=(WIDTH, HEIGHT), depth=8, kind=2):
    def row(y):
        values = [c for x in range(size[0]) for c in at(x, y)]
        return struct.pack(f">{len(values)}H", *values) if depth == 16 else bytes(values)
    return png(*size, [row(y) for y in range(size[1])], depth, kind)


def changed(pixels, at=ramp, **options):
    return picture(lambda x, y: pixels.get((x, y), at(x, y)), **options)


def with_chunk(data, name, body):
    """Returns a PNG with one more chunk before its pixels."""
    made = struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    return data[:33] + made + data[33:]


def radiance(rows):
    """Returns a Radiance file with uncompressed RGBE scanlines."""
    return (f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {len(rows)} +X {len(rows[0])}\n".encode()
            + b"".join(bytes(pixel) for row in rows for pixel in row))


class PicturesCase(Case):
    def setUp(self):
        super().setUp()
        for folder in ("expected", "actual"):
            (self.folder / folder).mkdir()

    def both(self, name, expected, actual=None):
        self.write(f"expected/{name}", expected)
        self.write(f"actual/{name}", expected if actual is None else actual)

    def suite(self, code, *arguments, actual=("--actual", "actual"), **options):
        """Runs the test, checks the exit code, and returns the results by name and the run."""
        done = self.run_program("test", "--expected", "expected", *actual, "--json", "report.json", *arguments, **options)
        done.out = done.stdout.decode("utf-8", "replace")
        self.assertEqual(done.returncode, code, (arguments, done.err, done.out))
        done.report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        return {one["name"]: one for one in done.report["scenes"]}, done

    def statuses(self, code, *arguments, **options):
        return {name: one["status"] for name, one in self.suite(code, *arguments, **options)[0].items()}

    def usage(self, words, *arguments):
        self.bad(2, words, "test", *arguments)


class Kinds(PicturesCase):
    def test_every_kind_of_png_is_compared(self):
        def grey(x, y):
            return ((x * 11 + y) % 256,)
        for name, data, other in (
                ("rgb.png", picture(), changed({(3, 4): (0, 0, 0)})),
                ("deep.png", picture(lambda x, y: (x * 2000, y * 3000, 7), depth=16),
                 # These 16-bit pictures differ by 1 of 65535.
                 picture(lambda x, y: (x * 2000 + (x == 3), y * 3000, 7), depth=16)),
                ("grey.png", picture(grey, kind=0), changed({(0, 0): (9,)}, grey, kind=0)),
                ("deep grey.png", picture(lambda x, y: (x * 999,), depth=16, kind=0),
                 picture(lambda x, y: (x * 999 + (y == 1),), depth=16, kind=0)),
                ("palette.png", picture(lambda x, y: ((x + y) % 2,), kind=3), picture(lambda x, y: (x % 2,), kind=3)),
                ("sub folder/alpha.png", picture(lambda x, y: (*ramp(x, y), 255), kind=6),
                 picture(lambda x, y: (*ramp(x, y), 255 - (x == 2)), kind=6)),
                ("grey alpha.png", picture(lambda x, y: (x, 200), kind=4), picture(lambda x, y: (x, 200 - (y == 3)), kind=4)),
                # Colours of transparent pixels are compared as well.
                ("under.png", picture(lambda x, y: (1, 2, 3, 0), kind=6), picture(lambda x, y: (9, 2, 3, 0), kind=6))):
            with self.subTest(name):
                self.both(name, data)
                self.assertEqual(self.statuses(0), {name: "pass"})
                self.write(f"actual/{name}", other)
                results, done = self.suite(1)
                self.assertEqual(results[name]["status"], "fail")
                self.assertRegex(results[name]["messages"][0], r"^\d+ pixels? differs? \(maxDiffPixels is 0\)|^\d+ pixels? differ")
                self.assertIn(f"FAIL  {name}", done.out)
                for folder in ("expected", "actual"):
                    shutil.rmtree(self.folder / folder)

    def test_a_pixel_outside_the_palette_is_refused(self):
        def palette(at):
            return with_chunk(picture(at, kind=3), b"PLTE", bytes((9, 9, 9, 200, 0, 0)))
        self.both("a.png", palette(lambda x, y: (x % 2,)), palette(lambda x, y: (2 if (x, y) == (5, 3) else x % 2,)))
        words = "its pixel at column 5, row 3 has colour 2, and its palette has 2"
        _, done = self.suite(6)
        self.assertIn(words, done.out)
        self.bad(6, words, "diff", "expected/a.png", "actual/a.png")
        self.good("diff", "expected/a.png", "expected/a.png")

    def test_differences_too_small_for_8_bits_are_found(self):
        """A difference of 1 of 65535, invisible in 8 bits, is reported, measured and fails."""
        self.both("a.png", picture(lambda x, y: (x * 2000, 0, 7), depth=16), picture(lambda x, y: (x * 2000 + 1, 0, 7), depth=16))
        results, _ = self.suite(1)
        metrics = results["a.png"]["frames"][0]["metrics"]
        self.assertAlmostEqual(metrics["worst"], 1 / 257, places=4)
        self.assertEqual(metrics["differentPixels"], WIDTH * HEIGHT)
        self.assertAlmostEqual(metrics["psnr"], 20 * math.log10(65535) + 10 * math.log10(3), places=2)
        done = self.run_program("diff", "expected/a.png", "actual/a.png")
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"PSNR            {metrics['psnr']:.3f}", done.stdout.decode())

    def test_quiet_runs_report_failures(self):
        self.both("a.png", picture(), changed({(3, 4): (0, 0, 0)}))
        self.both("b.png", picture())
        _, done = self.suite(1, "-q")
        self.assertEqual(done.out, "")
        self.assertIn("a.png", done.err)
        self.assertIn("1 pixel differs (maxDiffPixels is 0)", done.err)
        self.assertNotIn("b.png", done.err)
        self.write("actual/a.png", picture())
        self.assertEqual(self.suite(0, "-q")[1].err, "")

    def test_pictures_of_8_and_16_bits_are_compared(self):
        self.both("a.png", picture(), picture(lambda x, y: tuple(257 * c for c in ramp(x, y)), depth=16))
        self.assertEqual(self.statuses(0), {"a.png": "pass"})

    def test_radiance(self):
        rows = [[(10 * x, 20, 30, 120 + y) for x in range(8)] for y in range(4)]
        self.both("a.hdr", radiance(rows))
        self.assertEqual(self.statuses(0), {"a.hdr": "pass"})
        rows[2][5] = (51, 20, 30, 122)
        self.write("actual/a.hdr", radiance(rows))
        results, _ = self.suite(1)
        metrics = results["a.hdr"]["frames"][0]["metrics"]
        self.assertEqual((metrics["differentPixels"], metrics["worstX"], metrics["worstY"]), (1, 5, 2))
        # Two files that are truncated at the same byte do not count as equal.
        for folder in ("expected", "actual"):
            self.write(f"{folder}/a.hdr", radiance(rows)[:-3])
        results, _ = self.suite(6)
        self.assertIn("is cut off after", results["a.hdr"]["messages"][0])
        self.bad(6, ["cut off"], "diff", "expected/a.hdr", "actual/a.hdr")

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed (tools/setup does)")
    def test_exr_and_jpeg(self):
        source = self.write("source.png", picture())
        def make(path, *filters):
            self.folder.joinpath(path).parent.mkdir(exist_ok=True)
            subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", source, *filters, self.folder / path], check=True)
        for name, pixels in (("a.exr", ["-pix_fmt", "gbrpf32le"]), ("b.jpg", [])):
            make(f"expected/{name}", *pixels)
            shutil.copy(self.folder / f"expected/{name}", self.folder / f"actual/{name}")
        self.assertEqual(self.statuses(0), {"a.exr": "pass", "b.jpg": "pass"})
        make("actual/a.exr", "-vf", "exposure=0.01", "-pix_fmt", "gbrpf32le")
        make("actual/b.jpg", "-vf", "negate")
        self.assertEqual(self.statuses(1), {"a.exr": "fail", "b.jpg": "fail"})
        for name in ("a.exr", "b.jpg"):
            shutil.copy(self.folder / f"expected/{name}", self.folder / f"actual/{name}")
        for name in ("a.exr", "b.jpg"):
            whole = (self.folder / f"expected/{name}").read_bytes()
            for size in (20, len(whole) // 2, len(whole) - 1):
                for folder in ("expected", "actual"):
                    self.write(f"{folder}/{name}", whole[:size])
                results, _ = self.suite(6)
                self.assertEqual(results[name]["status"], "error", size)
                self.assertIn("cut off", " ".join(results[name]["messages"]))
                self.bad(6, [name], "diff", f"expected/{name}", f"actual/{name}")
            self.both(name, whole)

    def test_infinities_and_nans(self):
        if not shutil.which("ffmpeg"):
            self.skipTest("ffmpeg is not installed (tools/setup does)")
        raw = [0.25] * (4 * 2)
        def exr(path, values):
            self.write("raw", struct.pack("<24f", *values, *raw, *raw))
            subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "gbrpf32le", "-s", "4x2", "-i",
                            self.folder / "raw", "-format", "float", self.folder / path], check=True)
        nan, inf = float("nan"), float("inf")
        for a, b, code in ((nan, 0.25, 1), (0.25, nan, 1), (nan, nan, 0), (inf, 0.25, 1), (inf, inf, 0), (inf, -inf, 1),
                           (0.25, 0.2500001, 1)):
            with self.subTest((a, b)):
                exr("expected/a.exr", [a, *raw[1:]])
                exr("actual/a.exr", [b, *raw[1:]])
                self.suite(code)
        exr("actual/a.exr", [nan, *raw[1:]])
        self.suite(1, "--search-radius", "2", "--ignore-antialiased", "--max-channel-diff", "254")


class Layers(PicturesCase):
    """Channels of OpenEXR files that are not displayed."""
    SIZE = (6, 4)
    COUNT = SIZE[0] * SIZE[1]
    MATTE = {"cryptomatte/0123456/name": "Crypto"}

    def exr(self, changes=None, without=(), more=None, part=None, display=None):
        """Returns an OpenEXR file with values of some channels changed: {"Z": {pixel: value}}."""
        channels = {"R": (1, [0.25] * self.COUNT), "G": (1, [0.5] * self.COUNT), "B": (1, [0.75] * self.COUNT),
                    "Z": (2, [3.0 + i for i in range(self.COUNT)]), "N.X": (2, [0.5] * self.COUNT), "id": (0, list(range(self.COUNT))),
                    "Crypto00.R": (2, [1e-30] * self.COUNT), "Crypto00.G": (2, [1.0] * self.COUNT), **(more or {})}
        for name, values in (changes or {}).items():
            changed_values = list(channels[name][1])
            for pixel, value in values.items():
                changed_values[pixel] = value
            channels[name] = (channels[name][0], changed_values)
        for name in without:
            del channels[name]
        parts = [(*self.SIZE, channels, self.MATTE)]
        if part is not None:
            parts.append((*self.SIZE, {"Z": (2, part)}, {}))
        return write_exr(*parts, display=display)

    def test_a_difference_in_each_layer_is_found(self):
        self.both("a.exr", self.exr())
        results, _ = self.suite(0)
        self.assertEqual(results["a.exr"]["notes"], [])
        for changes, words in (({"Z": {8: 10.5}}, "layers that differ: Z at 1 pixel (11 and 10.5 at x 2, y 1)"),
                               ({"N.X": {0: 0.25, 1: float("nan")}}, "N.X at 2 pixels (0.5 and nan at x 1, y 0)"),
                               ({"id": {23: 22}}, "id at 1 pixel (00000017 and 00000016 at x 5, y 3)"),
                               ({"Crypto00.R": {3: 2e-30}}, "Crypto00.R at 1 pixel"), ({"Crypto00.G": {3: 0.5}}, "Crypto00.G at 1 pixel")):
            with self.subTest(words):
                self.write("actual/a.exr", self.exr(changes))
                results, _ = self.suite(1)
                self.assertEqual(results["a.exr"]["status"], "fail")
                self.assertIn(words, " ".join(results["a.exr"]["notes"]))
                self.assertEqual(results["a.exr"]["frames"][0]["metrics"]["differentPixels"], len(next(iter(changes.values()))))
                done = self.run_program("diff", "expected/a.exr", "actual/a.exr")
                self.assertEqual(done.returncode, 1)
                self.assertIn(words, done.stdout.decode())
        self.suite(0, "--update")
        self.assertEqual((self.folder / "expected/a.exr").read_bytes(), (self.folder / "actual/a.exr").read_bytes())

    def test_bounds_and_masks(self):
        self.both("a.exr", self.exr(), self.exr({"Z": {8: 11.01}}))  # channel Z differs by 2.55 of 255
        for bound, code in (("2", 1), ("3", 0)):
            self.suite(code, "--max-channel-diff", bound)
        self.write("mask.png", picture(lambda x, y: ((255,) if (x, y) == (2, 1) else (0,)), size=self.SIZE, kind=0))
        self.suite(0, "--mask", "mask.png")
        self.write("actual/a.exr", self.exr({"Crypto00.R": {3: 2e-30}}))
        self.suite(1, "--max-channel-diff", "254")  # A tolerance does not apply to object ids.

    def test_different_sets_of_channels_always_fail(self):
        """No tolerance allows different sets of channels."""
        more = {"depth": (2, [1.0] * self.COUNT)}
        for a, b, words in ((self.exr(), self.exr(without=("Z", "id")), "only the baseline has Z, id"),
                            (self.exr(), self.exr(more=more), "only the picture has depth"),
                            (self.exr(display=(3, 2)), self.exr({"Z": {5: 1}}, display=(3, 2)), "pixels outside of the display window differs"),
                            (self.exr(display=(3, 2)), self.exr({"R": {5: 1}}, display=(3, 2)), "pixels outside of the display window differs")):
            with self.subTest(words):
                self.both("a.exr", a, b)
                results, _ = self.suite(1, "--max-diff-ratio", "1")
                self.assertIn(words, results["a.exr"]["messages"])
                self.both("a.exr", a)
                self.suite(0)

    def test_parts_of_an_exr_are_compared(self):
        depth = [1.0] * self.COUNT
        self.both("a.exr", self.exr(part=depth))
        self.suite(0)
        self.write("actual/a.exr", self.exr(part=[2.0, *depth[1:]]))
        results, _ = self.suite(1)
        self.assertIn("layers that differ: part1.Z at 1 pixel (1 and 2 at x 0, y 0)", results["a.exr"]["notes"])

    def test_accept_and_rename_compare_layers(self):
        self.write("expected/a.exr", self.exr())
        self.write("actual/b.exr", self.exr({"Z": {0: 9}}))
        results, _ = self.suite(1)
        self.assertEqual(results["b.exr"]["renamedFrom"], "")
        self.both("a.exr", self.exr(), self.exr({"Z": {0: 9}}))
        (self.folder / "actual/b.exr").unlink()
        self.suite(1)
        self.good("accept", "report.json")
        self.suite(0)


class Differences(PicturesCase):
    def test_different_sizes_are_padded_and_reported(self):
        self.both("a.png", picture(), picture(size=(WIDTH - 4, HEIGHT + 2)))
        results, done = self.suite(1, "--report", "out")
        self.assertIn(f"the picture is {WIDTH - 4}x{HEIGHT + 2}, its baseline {WIDTH}x{HEIGHT}; compared as "
                      f"{WIDTH}x{HEIGHT + 2}, padded", done.out)
        frame = results["a.png"]["frames"][0]
        # The difference counts 4 columns that only the baseline has, and 2 rows that only the picture has.
        self.assertEqual(frame["metrics"]["differentPixels"], 4 * HEIGHT + 2 * (WIDTH - 4))
        self.suite(1, "--max-diff-ratio", "1")  # No tolerance applies to different sizes.

    def test_missing_and_renamed(self):
        self.both("same.png", picture())
        self.write("expected/gone.png", changed({(1, 1): (1, 1, 1)}))
        self.write("actual/new.png", changed({(2, 2): (2, 2, 2)}))
        self.write("expected/was.png", changed({(3, 3): (3, 3, 3)}))
        self.write("actual/sub/is.png", changed({(3, 3): (3, 3, 3)}))
        results, done = self.suite(1, "--report", "out")
        self.assertEqual({n: r["status"] for n, r in results.items()},
                         {"same.png": "pass", "gone.png": "fail", "new.png": "missing", "sub/is.png": "missing"})
        self.assertEqual(results["sub/is.png"]["renamedFrom"], "was.png")
        self.assertIn("there is no picture for the baseline expected/gone.png", done.out)
        done = self.run_program("accept", "out")
        self.assertEqual(done.returncode, 1, done.err)
        self.assert_words("gone.png", done)
        self.assertEqual(sorted(p.relative_to(self.folder / "expected").as_posix()
                                for p in (self.folder / "expected").rglob("*.png")),
                         ["gone.png", "new.png", "same.png", "sub/is.png"])
        self.suite(0, "--update=prune")
        self.assertFalse((self.folder / "expected/gone.png").exists())
        self.assertEqual(set(self.statuses(0).values()), {"pass"})

    def test_pictures_of_reports_are_not_tested(self):
        self.both("a.png", picture(), changed({(1, 1): (1, 1, 1)}))
        for i, more in enumerate((("--report", "actual/report"), ("--json", "actual/b.json"), ("--markdown", "actual/c.md"),
                                  ("--report", "expected/report"))):
            self.good("test", "--expected", "expected", "--actual", "actual", "--update")
            self.write("actual/a.png", changed({(2, 2): (i, 1, 1)}))
            done = self.run_program("test", "--expected", "expected", "--actual", "actual", *more)
            self.assertEqual(done.returncode, 1, done.err)
            self.assertGreater(len(list(self.folder.rglob("difference.png"))), 0)
        self.assertEqual(self.statuses(0, "--update"), {"a.png": "updated"})
        self.assertEqual([p.relative_to(self.folder).as_posix() for p in self.folder.glob("expected/**/*.png") if "report/" not in str(p)],
                         ["expected/a.png"])
        # A folder inside the other one is also refused.
        self.usage(["actual/golden lies below actual"], "--expected", "actual/golden", "--actual", "actual", "--update")
        (self.folder / "expected/new").mkdir()
        self.usage(["expected/new lies below expected"], "--expected", "expected", "--actual", "expected/new")

    def test_skipped_files_are_reported(self):
        self.both("a.png", picture())
        self.write("actual/notes.txt", "no picture")
        self.write("actual/.hidden/b.png", picture())
        self.both("without ending", picture(), changed({(0, 0): (9, 9, 9)}))
        results, done = self.suite(1)
        self.assertEqual(results["without ending"]["status"], "fail")
        self.assertIn("skipped, not pictures: actual/.hidden/, actual/notes.txt", done.out)
        self.write("actual/without ending", picture())
        self.suite(0)
        self.suite(1, "--strict")
        self.write("expected/c.webp", b"RIFF\0\0\0\0WEBPVP8 ")
        results, _ = self.suite(6)
        self.assertIn("is a WebP picture", results["c.webp"]["messages"][0])

    def test_colour_chunks_of_files_are_noted(self):
        self.both("a.png", picture(), with_chunk(picture(), b"gAMA", struct.pack(">I", 100000)))
        results, _ = self.suite(0)
        self.assertIn("gamma 1", results["a.png"]["notes"][0])
        self.assertIn("note: ", self.good("diff", "expected/a.png", "actual/a.png").stdout.decode())
        # This gAMA chunk has the value of sRGB.
        self.write("expected/a.png", with_chunk(picture(), b"gAMA", struct.pack(">I", 45455)))
        self.write("actual/a.png", with_chunk(picture(), b"sRGB", b"\0"))
        results, _ = self.suite(0)
        self.assertEqual(results["a.png"]["notes"], [])

    def test_damaged_files_are_reported_and_never_overwritten(self):
        whole = picture()
        for content, words in ((LFS, "is a Git LFS pointer"), (b"", "is empty; restore it"),
                               (whole[:60], "is cut off after 60 bytes; restore it"),
                               (whole[:50] + bytes([whole[50] ^ 4]) + whole[51:], "is corrupt (wrong checksum"),
                               (b"<<<<<<< HEAD\na\n=======\nb\n>>>>>>> x\n", "holds a merge conflict (line 1)"),
                               (whole.replace(b"\r\n", b"\n", 1), "had its line ends converted"), (b"hello", "is not a picture")):
            with self.subTest(words):
                self.both("a.png", content, whole)
                for more in ([], ["--update"], ["--report", "out"]):
                    results, done = self.suite(6, *more)
                    self.assertIn(f"baseline expected/a.png {words}", results["a.png"]["messages"][0])
                    self.assertNotIn("To accept", done.out)
                self.assertEqual((self.folder / "expected/a.png").read_bytes(), content)
        self.both("a.png", whole, whole[:60])
        results, _ = self.suite(6)
        self.assertEqual(results["a.png"]["messages"], ["picture actual/a.png is cut off after 60 bytes"])

    def test_usage(self):
        self.both("a.png", picture())
        base = ("--expected", "expected", "--actual", "actual")
        self.usage(["--expected needs --actual"], "--expected", "expected")
        self.usage(["--actual is only for pictures"], "--actual", "actual")
        self.usage(["nope is no folder"], "--expected", "expected", "--actual", "nope")
        self.usage(["--update creates it"], "--expected", "nope", "--actual", "actual")
        self.usage(["the same folder"], "--expected", "expected", "--actual", "./expected")
        self.usage(["--run needs {output}"], "--expected", "expected", "--run", "true {scene}", ".")
        self.usage(["does not contain {scene}"], "--expected", "expected", "--run", "true {output}", ".")
        self.usage(["--reason"], *base, "--reason", "x", "--update")
        self.bad(5, ["no picture to test"], "test", *base, "--filter", "nothing")
        shutil.rmtree(self.folder / "expected")
        self.assertEqual(self.statuses(0, "--update"), {"a.png": "updated"})

    def test_full_disk(self):
        self.both("a.png", picture(), changed({(1, 1): (9, 9, 9)}))
        full = self.folder / "full"
        full.symlink_to("/dev/full")
        for flag in ("--json", "--junit"):
            self.bad(6, ["full", "No space left"], "test", "--expected", "expected", "--actual", "actual", flag, "full")
            self.assertTrue(full.is_symlink(), "a device is written to, not replaced")
        self.write("actual/a.png", picture())
        with open("/dev/full", "wb") as full:
            done = self.run_program("test", "--expected", "expected", "--actual", "actual", stdout=full)
        self.assertEqual(done.returncode, 6, done.err)


class Allowances(PicturesCase):
    def test_rules_by_folder_and_name(self):
        self.both("ui/a.png", picture(), changed({(3, 4): (23, 37, 8)}))  # one pixel differs by 2
        self.both("b.png", picture(), changed({(3, 4): (23, 37, 8)}))
        self.write("rules.json", """{ // what holds for all, then for some
            "tolerance": {"maxChannelDiff": 1},
            "pictures": [{"match": "ui/", "tolerance": {"maxChannelDiff": 2}}, {"match": "none*"}]}""")
        results, done = self.suite(1, "--rules", "rules.json")
        self.assertEqual((results["ui/a.png"]["status"], results["b.png"]["status"]), ("pass", "fail"))
        self.assertEqual(results["ui/a.png"]["tolerance"]["maxChannelDiff"]["origin"], 'rules.json, "ui/"')
        self.assertIn('rules.json, "none*" matches no picture', done.out)
        self.suite(0, "--rules", "rules.json", "--max-channel-diff", "2")  # The command line overrides the rules.
        self.write("rules.json", '{"pictures": [{"match": "b.png", "xfail": "known"}, {"match": "ui/a", "xfail": "gone"}]}')
        self.assertEqual(self.statuses(0, "--rules", "rules.json"), {"ui/a.png": "xfail", "b.png": "xfail"})
        self.write("actual/b.png", picture())
        self.assertEqual(self.statuses(1, "--rules", "rules.json")["b.png"], "xpass")

    def test_bad_rules(self):
        self.both("a.png", picture())
        for text, words in (('{"tolerance": {"maxChannelDif": 2}}', "tolerance.maxChannelDif is unknown"),
                            ('{"pictures": [{"match": "a", "masks": [[0, 0]]}]}', "pictures[0].masks[0] must be"),
                            ('{"searchRadius": 99}', "searchRadius must be"), ('{"foo": 1}', "foo is unknown"),
                            ('{"pictures": [{"tolerance": {}}]}', "pictures[0].match is missing"), ("[", "rules.json")):
            self.write("rules.json", text)
            self.usage([words], "--expected", "expected", "--actual", "actual", "--rules", "rules.json")

    def test_quick_measures_what_bounds_need(self):
        self.both("a.png", picture(), changed({(3, 4): (0, 0, 0)}))
        whole, quick = (self.suite(1, *flags)[0]["a.png"]["frames"][0] for flags in ((), ("--quick",)))
        self.assertEqual(quick["metrics"], {**whole["metrics"], "ssim": None, "flipMean": None})
        self.assertEqual(quick["flipImage"], "")
        self.write("rules.json", {"tolerance": {"maxFlipMean": 1e-9}})
        bound = self.suite(1, "--rules", "rules.json", "--quick")[0]["a.png"]["frames"][0]
        self.assertEqual(bound["metrics"]["flipMean"], whole["metrics"]["flipMean"])
        self.usage(["--max-flip-mean", "--quick"], "--expected", "expected", "--actual", "actual", "--quick", "--max-flip-mean", "0.1")

    def test_masks(self):
        self.both("a.png", picture(), changed({(3, 4): (255, 255, 255)}))
        self.write("mask.png", picture(lambda x, y: ((255,) if (x, y) == (3, 4) else (0,)), kind=0))
        results, _ = self.suite(0, "--mask", "mask.png")
        self.assertEqual(results["a.png"]["frames"][0]["metrics"]["maskedPixels"], 1)
        for rectangle, code in (([3, 4, 1, 1], 0), ([0, 0, 3, 16], 1), ([2, 2, 100, 100], 0)):
            self.write("rules.json", json.dumps({"pictures": [{"match": "a.png", "masks": [rectangle]}]}))
            self.suite(code, "--rules", "rules.json")
        self.write("rules.json", '{"pictures": [{"match": "a.png", "masks": [[30, 0, 1, 1]]}]}')
        self.assertIn("lies outside", self.suite(6, "--rules", "rules.json")[0]["a.png"]["messages"][0])
        self.write("small.png", picture(size=(3, 3)))
        self.assertIn("3x3", self.suite(6, "--mask", "small.png")[0]["a.png"]["messages"][0])

    def test_search_radius(self):
        def box(left):
            return picture(lambda x, y: (255, 255, 255) if left <= x < left + 5 and 4 <= y < 9 else (0, 0, 0))
        self.both("a.png", box(6), box(8))
        self.suite(1)
        self.suite(1, "--search-radius", "1")
        results, _ = self.suite(0, "--search-radius", "2")
        self.assertEqual(results["a.png"]["frames"][0]["metrics"]["movedPixels"], 20)
        # The search radius must not excuse content that is missing entirely.
        self.write("actual/a.png", picture(lambda x, y: (0, 0, 0)))
        self.suite(1, "--search-radius", "2")

    def test_antialiased_edges(self):
        def slope(offset, soft):
            def at(x, y):
                inside = min(max((2 * x + y - 30 - offset) / 2 + 0.5, 0), 1) if soft else float(2 * x + y > 30 + offset)
                return (round(40 + 200 * inside),) * 3
            return picture(at)
        self.both("a.png", slope(0, False), slope(0, True))
        self.suite(1)
        results, _ = self.suite(0, "--ignore-antialiased")
        self.assertGreater(results["a.png"]["frames"][0]["metrics"]["antialiasedPixels"], 0)
        self.write("actual/a.png", slope(8, False))  # The edge is at another position.
        self.suite(1, "--ignore-antialiased")


class Commands(PicturesCase):
    def test_a_command_runs_for_each_scene(self):
        self.write("in/one.txt", picture())
        self.write("in/sub/it's two.txt", changed({(1, 1): (1, 1, 1)}))
        run = ("--run", "cp {scene} {output}")
        self.assertEqual(self.statuses(0, "in", "--update", actual=run), {"one.png": "updated", "sub/it's two.png": "updated"})
        self.assertEqual(set(self.statuses(0, "in", actual=run).values()), {"pass"})
        self.write("in/one.txt", changed({(2, 2): (2, 2, 2)}))
        self.assertEqual(self.statuses(1, "in", actual=run), {"one.png": "fail", "sub/it's two.png": "pass"})
        self.assertEqual(self.statuses(0, "in", "--filter", "sub/*", actual=run), {"sub/it's two.png": "pass"})
        listed = self.good("test", "--expected", "expected", *run, "in", "--list").stdout.decode()
        self.assertIn("cp in/one.txt one.png", listed)
        results, _ = self.suite(6, "in", actual=("--run", "echo {scene} {output}; echo no licence >&2; exit 3"))
        self.assertEqual({r["status"] for r in results.values()}, {"error"})
        self.assertIn("no licence", results["one"]["messages"][0])
        results, _ = self.suite(6, "in", actual=("--run", "true {scene} {output}"))
        self.assertIn("made no picture", results["one"]["messages"][0])

    def test_testing_one_scene_leaves_the_others_alone(self):
        """Pictures of scenes that were not named are not tested, removed or treated as renamed."""
        for name in ("one", "two", "three"):
            self.write(f"in/{name}.txt", changed({(1, 1): (len(name), 1, 1)}))
        run = ("--run", "cp {scene} {output}")
        self.statuses(0, "in", "--update", actual=run)
        baselines = self.content("expected")
        self.assertEqual(self.statuses(0, "in/one.txt", actual=run), {"one.png": "pass"})
        self.bad(2, ["--update=prune needs all scenes, and in/one.txt is only one"], "test", "--expected", "expected", *run,
                 "in/one.txt", "--update=prune")
        # The new scene has the pixels of a scene that is not tested in this run.
        self.write("in/new.txt", baselines["two.png"])
        self.assertEqual(self.statuses(0, "in/new.txt", "--update", actual=run), {"new.png": "updated"})
        self.assertEqual(self.content("expected"), {**baselines, "new.png": baselines["two.png"]})
        # The whole folder is tested, so a baseline without a scene counts as stale.
        (self.folder / "in/two.txt").unlink()
        (self.folder / "in/new.txt").unlink()
        self.assertEqual(self.statuses(1, "in", actual=run)["two.png"], "fail")
        self.statuses(0, "in", "--update=prune", actual=run)
        self.assertEqual(sorted(self.content("expected")), ["one.png", "three.png"])

    def test_file_names_are_not_run_as_commands(self):
        """Wherever the placeholder stands, a file's name is passed as one argument or refused."""
        names = ["a$(touch PWNED)", "b`touch PWNED`", "c';touch PWNED;'", 'd";touch PWNED;"', "e f", "g\\", "h&touch PWNED&", "i\nj"]
        for name in names:
            self.write(f"in/{name}.txt", picture())
        for run in ("cp {scene} {output}", 'cp "{scene}" "{output}"', "cp '{scene}' '{output}'",
                    'x="$(cat "{scene}" >/dev/null)" && cp {scene} "$x"{output}  # don\'t', 'cp "./{scene}" ./{output}',
                    'cp "$SIMREEL_SCENE" "$SIMREEL_OUTPUT"; : {scene} {output}'):
            with self.subTest(run):
                shutil.rmtree(self.folder / "expected")
                self.assertEqual(set(self.statuses(0, "in", "--update", actual=("--run", run, "--actual", "made"))), {f"{n}.png" for n in names})
        for run in ("sh -c 'cp {scene} {output}'", 'sh -c "cp {scene} {output}"'):
            with self.subTest(run):
                results, _ = self.suite(2, "in", actual=("--run", run))
                for result in results.values():
                    self.assertIn('write "$SIMREEL_SCENE" there instead of {scene}', result["messages"][0])
        self.assertEqual([str(p) for p in self.folder.rglob("PWNED*")], [])
        # A name without special characters is allowed inside a shell string.
        shutil.rmtree(self.folder / "expected")
        self.write("plain/one.txt", picture())
        self.assertEqual(self.statuses(0, "plain", "--update", actual=("--run", "sh -c 'cp {scene} {output}'")), {"one.png": "updated"})

    def test_hanging_and_flaky_commands(self):
        for name in ("one", "one.more"):
            self.write(f"in/{name}.txt", picture())
        self.statuses(0, "in", "--update", actual=("--run", "cp {scene} {output}"))
        results, _ = self.suite(6, "in/one.txt", "--timeout", "0.2", actual=("--run", "sleep 1000 & echo asleep >&2; wait; : {scene} {output}"))
        self.assertIn("took longer than 0.2 s (--timeout) and was ended: asleep", results["one"]["messages"][0])
        run = ("--run", "case {scene} in *more*) ;; *) if mkdir tried; then %s; fi ;; esac; cp {scene} {output}")
        for first, words in (("echo busy >&2; exit 1", "busy"), ("sleep 1000", "took longer than"), ("exit 0", "made no picture"),
                             ("cp other.png {output}; exit 0", "1 pixel differs")):
            with self.subTest(first):
                self.write("other.png", changed({(1, 1): (1, 1, 1)}))
                arguments = {"actual": (run[0], run[1] % first)}
                retries = ("in", "--retries", "2", "--timeout", "2" if "sleep" in first else "1000")
                results, done = self.suite(1, *retries, **arguments)
                self.assertEqual({n: r["status"] for n, r in results.items()}, {"one.png": "flaky", "one.more.png": "pass"})
                self.assertIn(words, results["one.png"]["attempts"][0]["messages"][0])
                self.assertIn("passed on try 2; before that: ", results["one.png"]["messages"][0])
                shutil.rmtree(self.folder / "tried")
                self.suite(0, *retries, "--allow-flaky", **arguments)
                shutil.rmtree(self.folder / "tried")
                self.suite(1 if "cp" in first else 6, "in", "--timeout", retries[-1], **arguments)
                shutil.rmtree(self.folder / "tried")
        results, _ = self.suite(6, "in", "--retries", "2", actual=("--run", "echo no licence >&2; false {scene} {output}"))
        self.assertEqual([len(r["attempts"]) for r in results.values()], [2, 2])
        self.usage(["--retries and --timeout have no effect with --actual"], "--expected", "expected", "--actual", "actual", "--retries", "1")

    def test_reports_name_no_temporary_folder(self):
        self.write("in/sub/one.txt", picture())
        texts = []
        for _ in range(2):
            self.suite(0, "in", "--update", "--junit", "out.xml", actual=("--run", "cp {scene} {output}"))
            self.suite(0, "in", "--junit", "out.xml", actual=("--run", "cp {scene} {output}"))
            texts.append((self.folder / "out.xml").read_text())
            self.assertIn('classname="in/sub" name="sub/one.png"', texts[-1])
        shutil.rmtree(self.folder / "expected")
        self.suite(0, "--update", "--junit", "out.xml", actual=("--run", "cp in/sub/one.txt {output}/a.png"))
        self.assertIn('classname="expected" name="a.png"', (self.folder / "out.xml").read_text())

    def test_a_command_without_scenes_runs_once(self):
        self.write("one.png", picture())
        run = ("--run", "mkdir -p {output}/sub && cp one.png {output}/sub/a.png")
        self.assertEqual(self.statuses(0, "--update", actual=run), {"sub/a.png": "updated"})
        self.assertEqual(self.statuses(0, actual=run), {"sub/a.png": "pass"})

    def test_no_device_is_needed(self):
        self.both("a.png", picture())
        broken = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent.json", "LIBGL_DRIVERS_PATH": "/nonexistent"}
        self.suite(0, env=broken)


class Reports(PicturesCase):
    def test_report_and_accept(self):
        self.both("a.png", picture(), changed({(3, 4): (255, 0, 0)}))
        self.both("b.png", picture())
        summary = self.write("summary.md", "")
        done = self.run_program("test", "--expected", "expected", "--actual", "actual", "--report", "out", "--junit", "out.xml",
                                "--github", env={"GITHUB_STEP_SUMMARY": str(summary)})
        self.assertEqual(done.returncode, 1, done.err)
        report = json.loads((self.folder / "out/report.json").read_text())
        self.assertEqual((report["unit"], report["expected"]), ("picture", "expected"))
        frame = report["scenes"][0]["frames"][0]
        for key in ("expectedImage", "actualImage", "differenceImage", "flipImage"):
            self.assertTrue((self.folder / "out" / frame[key]).exists(), key)
        self.assertIn("1 of 2 pictures failed", summary.read_text())
        self.assertIn('name="a.png"', (self.folder / "out.xml").read_text())
        self.assertIn("2 pictures: 1 passed, 1 failed (a.png)", done.stdout.decode())
        self.good("accept", "out")
        self.assertEqual((self.folder / "expected/a.png").read_bytes(), (self.folder / "actual/a.png").read_bytes())
        self.assertIn("already accepted", self.good("accept", "out").stdout.decode())
        # The baseline changes after the test.
        self.write("expected/a.png", changed({(9, 9): (255, 0, 0)}))
        done = self.run_program("accept", "out")
        self.assertEqual(done.returncode, 1)
        self.assert_words("has changed since", done)

    def test_accept_stays_inside_the_folder(self):
        self.both("a.png", picture(), changed({(3, 4): (255, 0, 0)}))
        self.suite(1)
        path = self.folder / "report.json"
        report = json.loads(path.read_text())
        for key, value in (("name", "../x.png"), ("name", "/tmp/x.png"), ("renamedFrom", "../../x.png"), ("name", "x.sh")):
            report["scenes"][0] = {**json.loads(path.read_text())["scenes"][0], key: value}
            self.write("other.json", json.dumps(report))
            shutil.copytree(self.folder / "report-files", self.folder / "other-files", dirs_exist_ok=True)
            done = self.run_program("accept", "other.json")
            self.assertEqual(done.returncode, 1, (key, value))
            self.assert_words("names no picture below", done)
        report = json.loads(path.read_text())
        self.write("other.json", json.dumps({**report, "expected": "/tmp"}))
        self.bad(2, ["allow it with --expected"], "accept", "other.json")
        (self.folder / "link").symlink_to(tempfile.gettempdir())
        self.write("other.json", json.dumps({**report, "expected": "link"}))
        self.bad(1, ["is outside of this folder", "--expected"], "accept", "other.json")
        self.good("accept", "report.json", "--expected", str(self.folder / "expected"))


if __name__ == "__main__":
    main()
