"""Tests simreel diff: metrics compared with other programs and definitions, tolerances, sequences, broken files."""
import json
import math
import random
import re
import shutil
import struct
import subprocess
import unittest
import zlib

try:
    import numpy
    from skimage import metrics as skimage
except ImportError:
    skimage = None

from common import Case, main, png_rows
from flip_reference import flip_mean
from ssim_reference import ffmpeg_ssim, gaussian_ssim


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png(rows, depth=8, colour=2, interlace=0, extra=b"", level=6, size=None, raw=None):
    """Returns rows of pixels (numbers or tuples) as an unfiltered PNG file."""
    if raw is None:
        raw = b"".join(b"\0" + bytes(c for pixel in row for c in (pixel if isinstance(pixel, tuple) else (pixel,)))
                       for row in rows)
    width, height = size or (len(rows[0]), len(rows))
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, interlace)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(raw, level))
            + chunk(b"IEND", b""))


def picture(width, height, function):
    return [[tuple(min(255, max(0, round(c))) for c in function(x, y)) for x in range(width)] for y in range(height)]


def ramp(x, y):
    return 40 + 5 * x, 30 + 7 * y, 200 - 2 * x - 3 * y


def noisy(size, amount, seed=1):
    noise = random.Random(seed)
    return picture(*size, lambda x, y: [c + noise.uniform(-amount, amount) for c in ramp(x, y)])


def edge(shift):
    return lambda x, y: (220, 60, 40) if 2 * x + y > 38 + 2 * shift else (30, 90, 160)


def disk(softness):
    def at(x, y):
        inside = 1 / (1 + math.exp((math.hypot(x - 16, y - 10) - 7) / softness))
        return [a * inside + b * (1 - inside) for a, b in zip((250, 220, 90), (20, 25, 60))]
    return at


SIZE = (33, 21)
PAIRS = {
    "noise": (picture(*SIZE, ramp), noisy(SIZE, 40)),
    "shifted edge": (picture(*SIZE, edge(0)), picture(*SIZE, edge(2))),
    "blurred disk": (picture(*SIZE, disk(0.05)), picture(*SIZE, disk(2))),
    "one pixel": (picture(*SIZE, ramp), picture(*SIZE, lambda x, y: (255, 0, 255) if (x, y) == (3, 17) else ramp(x, y))),
}
BASE = picture(20, 12, ramp)


def changed(pixels, rows=None):
    """Returns a copy with some pixels ((x, y): colour) changed."""
    return [[pixels.get((x, y), pixel) for x, pixel in enumerate(row)] for y, row in enumerate(rows or BASE)]


class DiffCase(Case):
    def diff(self, code, *arguments):
        done = self.run_program("diff", *arguments)
        self.assertEqual(done.returncode, code, (arguments, done.stdout, done.err))
        done.out = done.stdout.decode()
        return done

    def json(self, code, *arguments):
        return json.loads(self.diff(code, *arguments, "--json").out)

    def write_pair(self, a, b):
        self.write("a.png", png(a))
        self.write("b.png", png(b))


class Metrics(DiffCase):
    def metrics(self, a, b):
        self.write_pair(a, b)
        return self.json(1, "a.png", "b.png")["metrics"]

    def test_flip_equals_its_definition(self):
        for name, (a, b) in PAIRS.items():
            with self.subTest(name):
                self.assertAlmostEqual(self.metrics(a, b)["flipMean"], flip_mean(a, b), delta=1e-4)

    def ffmpeg(self, name, pattern):
        """Returns the value that an ffmpeg filter prints for a.png and b.png, compared as RGB."""
        graph = f"[0:v]format=gbrp[a];[1:v]format=gbrp[b];[a][b]{name}"
        done = subprocess.run(["ffmpeg", "-nostdin", "-i", "a.png", "-i", "b.png", "-lavfi", graph, "-f", "null", "-"],
                              cwd=self.folder, stderr=subprocess.PIPE, check=True)
        return float(re.search(pattern, done.stderr.decode()).group(1))

    def test_ssim_equals_its_definition(self):
        for name, (a, b) in PAIRS.items():
            with self.subTest(name):
                self.assertAlmostEqual(self.metrics(a, b)["ssim"], gaussian_ssim(a, b), delta=1e-5)

    def test_ssim_of_small_pictures(self):
        for width, height in ((7, 9), (1, 3), (10, 11), (11, 11), (12, 31), (33, 17), (40, 10)):
            with self.subTest(f"{width}x{height}"):
                a, b = picture(width, height, ramp), noisy((width, height), 50, seed=width)
                self.assertAlmostEqual(self.metrics(a, b)["ssim"], gaussian_ssim(a, b), delta=1e-5)

    @unittest.skipUnless(skimage, "scikit-image is not installed (tools/setup does)")
    def test_the_definition_of_ssim_equals_scikit_image(self):
        for width, height in ((11, 11), (12, 31), (33, 17), (64, 48)):
            with self.subTest(f"{width}x{height}"):
                a, b = picture(width, height, ramp), noisy((width, height), 50, seed=width)
                channels = [skimage.structural_similarity(
                    *(numpy.array([[p[c] for p in row] for row in rows], dtype=float) for rows in (a, b)),
                    data_range=255, gaussian_weights=True, sigma=1.5, use_sample_covariance=False) for c in range(3)]
                self.assertAlmostEqual(gaussian_ssim(a, b), sum(channels) / 3, delta=1e-9)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed (tools/setup does)")
    def test_the_definition_of_ssim_equals_ffmpeg_except_for_the_window(self):
        for name, (a, b) in PAIRS.items():
            with self.subTest(name):
                self.write_pair(a, b)
                # ffmpeg rounds C1 and C2 to integers.
                self.assertAlmostEqual(ffmpeg_ssim(a, b), self.ffmpeg("ssim", r" All:([0-9.]+)"), delta=1e-4)

    @unittest.skipUnless(shutil.which("compare"), "ImageMagick's compare is not installed (tools/setup does)")
    def test_psnr_equals_imagemagick(self):
        for name, (a, b) in PAIRS.items():
            with self.subTest(name):
                ours = self.metrics(a, b)["psnr"]
                done = subprocess.run(["compare", "-metric", "PSNR", "a.png", "b.png", "null:"], cwd=self.folder,
                                      stderr=subprocess.PIPE, check=False)
                self.assertAlmostEqual(ours, float(done.stderr.split()[0]), delta=1e-3)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed (tools/setup does)")
    def test_psnr_equals_ffmpeg(self):
        for name, (a, b) in PAIRS.items():
            with self.subTest(name):
                ours = self.metrics(a, b)["psnr"]
                self.assertAlmostEqual(ours, self.ffmpeg("psnr", r"average:([0-9.]+)"), delta=1e-3)

    def test_counts(self):
        metrics = self.metrics(BASE, changed({(3, 4): (0, 0, 0), (5, 4): (66, 58, 178)}))
        self.assertEqual(BASE[4][5], (65, 58, 178))
        self.assertEqual((metrics["worst"], metrics["worstX"], metrics["worstY"]), (182, 3, 4))
        self.assertEqual(metrics["differentPixels"], 2)
        self.assertEqual(metrics["windowRatio"], 2 / (16 * 12))


class Pictures(DiffCase):
    def test_equal(self):
        self.write_pair(BASE, BASE)
        done = self.diff(0, "a.png", "b.png")
        self.assertTrue(done.out.endswith("\nequal\n"), done.out)
        for word in ("0 differ", "PSNR            infinite", "SSIM            1.000000", "FLIP mean       0.000000"):
            self.assertIn(word, done.out)
        # The files come from different encoders and have different text chunks, but the same pixels.
        self.write("b.png", png(BASE, level=0, extra=chunk(b"tEXt", b"Software\0another")))
        self.diff(0, "a.png", "b.png")
        result = self.json(0, "a.png", "b.png")
        self.assertEqual((result["result"], result["metrics"]["psnr"]), ("equal", None))
        self.assertEqual(self.diff(0, "a.png", "b.png", "-q").out, "")

    def test_quick_leaves_out_ssim_and_flip(self):
        self.write_pair(BASE, changed({(9, 6): (0, 0, 0)}))
        whole, quick = (self.json(1, "a.png", "b.png", *flags)["metrics"] for flags in ((), ("--quick",)))
        self.assertEqual(quick, {**whole, "ssim": None, "flipMean": None})
        self.assertLess(whole["ssim"], 1)
        text = self.diff(1, "a.png", "b.png", "--quick").out
        self.assertIn("PSNR", text)
        for left_out in ("SSIM", "FLIP"):
            self.assertNotIn(left_out, text)
        self.bad(2, ["--max-flip-mean", "--quick"], "diff", "a.png", "b.png", "--quick", "--max-flip-mean", "0.1")
        for name in "ab":
            self.write(f"{name}/x.png", (self.folder / f"{name}.png").read_bytes())
        self.assertRegex(self.diff(1, "a", "b", "--quick").out, r"x.png: different: .* PSNR [0-9.]+ dB\]\n")

    def test_exact_without_bounds(self):
        self.write_pair(BASE, changed({(0, 0): (41, 30, 200)}))
        done = self.diff(1, "a.png", "b.png")
        self.assertIn("worst pixel     1 of 255 at x 0, y 0", done.out)
        self.assertIn("\ndifferent: 1 pixel differs (maxDiffPixels is 0)\n", done.out)
        self.assertEqual(self.diff(1, "a.png", "b.png", "-q").out, "")

    def test_bounds(self):
        # two pixels differ, by 5 and by 3
        self.write_pair(BASE, changed({(2, 2): (55, 44, 190), (9, 9): (88, 93, 155)}))
        for code, flags in ((0, ["--max-channel-diff", "5"]), (1, ["--max-channel-diff", "4"]),
                            (0, ["--max-diff-pixels", "2"]), (1, ["--max-diff-pixels", "1"]),
                            (0, ["--max-channel-diff", "4", "--max-diff-pixels", "1"]),
                            (0, ["--max-diff-ratio", "0.009"]), (1, ["--max-diff-ratio", "0.008"]),
                            (0, ["--window-size", "2", "--max-window-ratio", "0.25"]),
                            (1, ["--window-size", "2", "--max-window-ratio", "0.24"]),
                            (0, ["--max-flip-mean", "0.5"]), (1, ["--max-flip-mean", "0"]),
                            (0, ["--hard-fail", "5"]), (1, ["--hard-fail", "4"]),
                            (1, ["--max-diff-ratio", "1", "--hard-fail", "4"]),
                            (1, ["--max-channel-diff", "255", "--hard-fail", "4"])):
            with self.subTest(flags):
                done = self.diff(code, "a.png", "b.png", *flags)
                self.assertRegex(done.out, "\nwithin tolerance\n$" if code == 0 else "\ndifferent: [^\n]+\n$")

    def test_sizes(self):
        self.write_pair(BASE, [row[:-1] for row in BASE])
        done = self.diff(1, "a.png", "b.png", "-o", "out.png")
        self.assertEqual(done.out.splitlines()[-1], "different: sizes differ: a.png is 20x12, b.png is 19x12; compared as "
                                                    "20x12, padded; 12 pixels differ (maxDiffPixels is 0)")
        self.assertIn("255 of 255 at x 19, y 0", done.out)
        self.assertTrue((self.folder / "out.png").exists())
        self.assertIn("20x12", self.json(1, "a.png", "b.png")["broken"][0])

    def test_difference_image(self):
        self.write_pair(BASE, changed({(3, 4): (56, 58, 182)}))
        self.diff(1, "a.png", "b.png", "-o", "out.png")
        width, height, _ = png_rows((self.folder / "out.png").read_bytes())
        self.assertEqual((width, height), (20, 12))
        self.diff(0, "a.png", "a.png", "-o", "same.png")
        self.assertEqual(self.json(1, "out.png", "same.png")["metrics"]["differentPixels"], 1)
        self.bad(2, ["one of the two that are compared"], "diff", "a.png", "b.png", "-o", "./a.png")
        self.bad(6, ["none/out.png", "No such file"], "diff", "a.png", "b.png", "-o", "none/out.png")
        self.assertEqual(sorted(p.name for p in self.folder.glob("*.p*")), ["a.png", "b.png", "out.png", "same.png"])

    def test_usage(self):
        self.write_pair(BASE, BASE)
        (self.folder / "folder").mkdir()
        for words, *arguments in ((["B"], "a.png"), (["a.png is a picture, folder is a folder"], "a.png", "folder"),
                                  (["--max-channel-diff", "0 to 255", "256"], "a.png", "b.png", "--max-channel-diff", "256"),
                                  (["--max-channel-diff", "whole"], "a.png", "b.png", "--max-channel-diff", "1.5"),
                                  (["--max-diff-ratio", "0 to 1"], "a.png", "b.png", "--max-diff-ratio", "2"),
                                  (["--max-flip-mean", "nan"], "a.png", "b.png", "--max-flip-mean", "nan"),
                                  (["--window-size", "1 to"], "a.png", "b.png", "--window-size", "0"),
                                  (["-o folder is a folder"], "a.png", "b.png", "-o", "folder"),
                                  (["the difference is a PNG picture", ".exr"], "a.png", "b.png", "-o", "d.exr"),
                                  (["the difference is a PNG picture", ".jpg"], "a.png", "b.png", "-o", "d.JPG"),
                                  (["may occur only once"], "##_##.png", "##_##.png")):
            with self.subTest(arguments):
                self.bad(2, words, "diff", *arguments)


class Sizes(DiffCase):
    def test_fractions_refer_to_the_padded_size(self):
        self.write("a.png", png(picture(8, 4, lambda x, y: (255, 255, 255))))
        self.write("b.png", png(picture(8, 8, lambda x, y: (128, 0, 128))))
        done = self.diff(1, "a.png", "b.png")
        self.assertIn("size            8x8\n", done.out)
        self.assertIn("64 differ (100%)", done.out)
        found = self.json(1, "b.png", "a.png")
        self.assertEqual((found["width"], found["height"], found["metrics"]["ratioBeyond"]), (8, 8, 1))

    def test_long_pictures(self):
        """Pictures with a side above 16384, with 8 and 16 bits."""
        for depth, pixel in ((8, b"\1\2\3"), (16, b"\0\1\0\2\0\3")):
            row = b"\0" + 2 * pixel
            self.write("a.png", png(None, depth=depth, size=(2, 20000), raw=20000 * row))
            self.write("b.png", png(None, depth=depth, size=(2, 20000), raw=19999 * row + b"\0" + pixel + b"\7" * len(pixel)))
            self.assertEqual(self.json(0, "a.png", "a.png")["height"], 20000)
            metrics = self.json(1, "a.png", "b.png", "--quick")["metrics"]
            self.assertEqual((metrics["differentPixels"], metrics["worstX"], metrics["worstY"]), (1, 1, 19999))
        # The limit applies to the number of pixels, because a small file can declare a size that would use up all
        # memory.
        self.write("a.png", png(None, size=(100000, 100000), raw=bytes(10000)))
        self.bad(6, ["100000x100000", "million pixels"], "diff", "a.png", "b.png")


class BrokenFiles(DiffCase):
    def refused(self, words, content):
        self.write("a.png", png(BASE))
        self.write("b.png", content)
        for order in (("a.png", "b.png"), ("b.png", "a.png"), ("b.png", "b.png")):
            done = self.bad(6, ["picture b.png", *words], "diff", *order, "-o", "out.png")
            self.assertEqual(done.stdout, b"")
            self.assertEqual(len(done.err.splitlines()), 1, done.err)
        self.assertFalse((self.folder / "out.png").exists())

    def test_incomplete_pngs_are_refused(self):
        whole = png(BASE)
        self.refused(["is empty"], b"")
        for size in (3, 8, 20, 33, 50, len(whole) - 12, len(whole) - 1):
            self.refused([f"cut off after {size} bytes"], whole[:size])
        for at in (18, 45, len(whole) - 20, len(whole) - 2):
            self.refused(["is corrupt (wrong checksum"], whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1:])
        self.refused(["no header"], whole[:8] + whole[33:])
        self.refused(["no pixels"], whole[:33] + chunk(b"IEND", b""))

    def test_other_formats(self):
        self.refused(["cut off"], b"\xff\xd8\xff\xe0" + bytes(100))
        self.refused(["not a picture"], b"P9 1 1 255 abc")
        for deep in (png(None, depth=16, size=(1, 1), raw=bytes(7)),
                     png(None, colour=3, size=(1, 1), raw=bytes(2), extra=chunk(b"PLTE", bytes(3))),
                     png(None, depth=1, colour=0, size=(1, 1), raw=bytes(2))):
            self.write("deep.png", deep)
            self.assertIn("deep.png is 1x1", self.diff(1, "a.png", "deep.png").out)
        self.refused(["animated"], png(BASE, extra=chunk(b"acTL", bytes(8))))

    def test_missing_pixel_data_is_refused(self):
        """Refused even if both files are equal byte for byte."""
        self.write("a.png", png(BASE))
        self.write("b.png", png(None, size=(20, 12), raw=bytes(100)))
        self.bad(6, ["b.png"], "diff", "a.png", "b.png")
        self.bad(6, ["b.png"], "diff", "b.png", "b.png")
        shutil.copy(self.folder / "b.png", self.folder / "c.png")
        self.bad(6, ["b.png"], "diff", "b.png", "c.png", "--quick")

    def test_bytes_after_a_png_are_ignored(self):
        whole = png(BASE)
        self.write("a.png", whole)
        for more in (b"abc", bytes(1000), whole):
            self.write("b.png", whole + more)
            for order in (("a.png", "b.png"), ("b.png", "a.png"), ("b.png", "b.png")):
                self.assertEqual(self.json(0, *order)["result"], "equal")
        self.write("b.png", png(picture(20, 12, lambda x, y: (1, 2, 3))) + b"abc")
        self.assertEqual(self.json(1, "a.png", "b.png")["metrics"]["differentPixels"], 240)

    def test_missing_files_are_reported(self):
        self.write("a.png", png(BASE))
        self.bad(6, ["picture none.png", "No such file"], "diff", "a.png", "none.png")
        self.bad(6, ["picture none.png", "No such file"], "diff", "none.png", "a.png")

    def test_grey_alpha_and_interlaced_pngs_are_read(self):
        grey = [[10 * x for x in range(8)] for _ in range(3)]
        self.write("a.png", png([[(g, g, g) for g in row] for row in grey]))
        for content in (png(grey, colour=0), png([[(g, 255) for g in row] for row in grey], colour=4),
                        png([[(g, g, g, 255) for g in row] for row in grey], colour=6)):
            self.write("b.png", content)
            self.assertEqual(self.json(0, "a.png", "b.png")["result"], "equal")
        self.write("b.png", png([[(g, g, g, 254) for g in row] for row in grey], colour=6))
        self.assertEqual(self.json(1, "a.png", "b.png")["metrics"]["differentPixels"], 24)
        # Adam7 interlacing of a single pixel is that pixel.
        self.write("a.png", png([[(1, 2, 3)]]))
        self.write("b.png", png([[(1, 2, 3)]], interlace=1))
        self.diff(0, "a.png", "b.png")


class Sequences(DiffCase):
    def frames(self, folder, count=5, name="{:04}.png"):
        for frame in range(count):
            self.write(f"{folder}/{name.format(frame)}", png(changed({(frame % 20, frame // 20): (0, 0, 0)})))

    def test_folders(self):
        self.frames("a")
        self.frames("b")
        self.assertEqual(self.diff(0, "a", "b").out, "5 pairs: 5 equal\n")
        self.write("b/0003.png", png(changed({(3, 0): (1, 0, 0)})))
        self.write("b/0001.png", png(BASE))
        self.write("b/more.png", png(BASE))
        self.write("a/notes.txt", "not a picture")
        done = self.diff(1, "a", "b/", "-o", "out")
        lines = done.out.splitlines()
        self.assertRegex(lines[0], r"^0001.png: different: 1 pixel differs .*worst 198 at x 1, y 0")
        self.assertRegex(lines[1], r"^0003.png: different: ")
        self.assertEqual(lines[2:], ["only in b/: more.png", "skipped, not pictures: a/notes.txt",
                                     "5 pairs: 3 equal, 2 different, 1 without a partner"])
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), ["0001.png", "0003.png"])
        result = self.json(1, "a", "b")
        self.assertEqual([f["result"] for f in result["frames"]], ["equal", "different", "equal", "different", "equal"])
        self.assertEqual((result["onlyInA"], result["onlyInB"], result["different"]), ([], ["more.png"], 2))
        (self.folder / "b/more.png").unlink()
        shutil.copy(self.folder / "a/0001.png", self.folder / "b/0001.png")
        self.assertIn("0003.png: within tolerance", self.diff(0, "a", "b", "--hard-fail", "1").out)

    def test_a_file_in_only_one_folder_is_a_difference(self):
        self.frames("a", 3)
        self.frames("b", 2)
        self.assertEqual(self.diff(1, "a", "b", "--max-diff-ratio", "1").out.splitlines(),
                         ["only in a: 0002.png", "2 pairs: 2 equal, 1 without a partner"])

    def test_patterns_pair_by_number(self):
        self.frames("a", 12)
        self.frames(".", 12, "new_{}.png")
        self.write("a/readme_0001.png", b"not of the pattern")
        self.write("a/00001.png", b"not of the pattern")
        self.assertEqual(self.diff(0, "a/####.png", "new_%d.png").out, "12 pairs: 12 equal\n")
        self.write("new_7.png", png(BASE))
        self.assertTrue(self.diff(1, "a/####.png", "new_%d.png").out.startswith("frame 7: different"))
        self.bad(2, ["is a folder", "is a pattern"], "diff", "a", "new_%d.png")

    def test_order_is_kept_and_unreadable_pairs_do_not_stop_it(self):
        self.frames("a", 60)
        for frame in range(60):
            self.write(f"b/{frame:04}.png", png(BASE))
        self.write("b/0020.png", b"")
        self.write("a/0040.png", b"GIF")
        done = self.diff(6, "a", "b")
        names = [line.split(":")[0] for line in done.out.splitlines()[:-1]]
        self.assertEqual(names, [f"{frame:04}.png" for frame in range(60)])
        self.assertEqual(done.out.splitlines()[20], "0020.png: unreadable: picture b/0020.png is empty")
        self.assertEqual(done.out.splitlines()[-1], "60 pairs: 0 equal, 58 different, 2 unreadable")
        self.assert_words("2 of 60 pairs", done)
        self.assertEqual(self.json(6, "a", "b")["unreadable"], 2)

    def test_nothing_to_compare(self):
        (self.folder / "a").mkdir()
        (self.folder / "b").mkdir()
        self.bad(5, ["neither a nor b"], "diff", "a", "b")
        self.bad(6, ["none"], "diff", "none/####.png", "none/####.png")
        self.bad(2, ["-o a", "choose another name"], "diff", *self.two_folders(), "-o", "a")

    def two_folders(self):
        self.frames("a", 1)
        self.frames("b", 1)
        return "a", "b"


if __name__ == "__main__":
    main()
