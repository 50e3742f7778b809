#!/usr/bin/env python3
"""Tests tools/mutate: the lines of a source that are compiled, and the mutants known to be equivalent."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from common import SOURCE, main

sys.dont_write_bytecode = True
sys.path[:0] = [str(SOURCE / "tools")]
from mutants import changes, compiled, equivalent  # noqa: E402  pylint: disable=wrong-import-position

SOURCE_TEXT = """#define ONE(x) TWO(x) + \\
    1
#define TWO(x) (2 * x)
#define THREE(x) FOUR(x)
#define FOUR(x) 4  // FIVE
#define FIVE 5
int a = ONE(2);  // THREE
#if SIX
int b;
#else
int c;
#endif
"""


class Compiled(unittest.TestCase):
    def test_unreferenced_macros_are_found(self):
        self.assertEqual({"THREE", "FOUR", "FIVE"}, compiled.unused_macros(SOURCE_TEXT))
        self.assertEqual(set(), compiled.unused_macros(SOURCE_TEXT + "int d = THREE(FIVE);\n"))

    @unittest.skipIf(shutil.which("cpp") is None, "there is no cpp")
    def test_compiled_lines_are_found(self):
        self.assertEqual({1, 3, 7, 11}, compiled.kept(SOURCE_TEXT))


class Program(unittest.TestCase):
    def test_the_program_starts(self):
        done = subprocess.run([SOURCE / "tools/mutate", "--of", "simulations", "--help"], capture_output=True, text=True, check=True)
        self.assertIn("--again REPORT", done.stdout)


class Reported(unittest.TestCase):
    def test_each_mutant_of_a_report_is_read_once(self):
        drawn = changes.drawn_lots(["draw/half.glsl", "draw/ordered_key.glsl"], 17)
        lines = [f"survived                          {mutant.place()}  {mutant.words()}" for mutant in drawn]
        lines[0] = f"caught       test_gpu             {drawn[0].place()}  {drawn[0].words()}\n{'':13}a test"
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "report.txt"
            report.write_text("\n".join([*lines, "", *lines[1:]]), encoding="utf-8")
            found = changes.reported(report)
        self.assertEqual([mutant.name() for mutant in drawn], [mutant.name() for mutant in found])
        self.assertEqual([mutant.after for mutant in drawn], [mutant.after for mutant in found])
        self.assertEqual([("caught", "test_gpu", "a test")] + [("survived", "", "")] * (len(drawn) - 1), list(found.values()))


class Equivalent(unittest.TestCase):
    def test_every_listed_equivalent_mutant_exists(self):
        left = set(equivalent.EQUIVALENT)
        seed = 0
        while left and seed < 64:  # Any of the eight bits of a hexadecimal number may be changed.
            for file in sorted({file for file, _ in left}):
                left -= {(file, mutant.after.strip()) for _, mutant in changes.mutants_of(file, seed, every=True)}
            seed += 1
        self.assertEqual(set(), left)


if __name__ == "__main__":
    main()
