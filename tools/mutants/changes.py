"""Mutants of the shaders: changes of one constant or operator."""
import collections
import os
import pathlib
import random
import re
import shutil
import struct

from mutants import code
from mutants.equivalent import EQUIVALENT

ROOT = pathlib.Path(__file__).resolve().parents[2]
GLSL = ROOT / "glsl"
# files with binding numbers or memory layouts, which are not mutated
NOT_MUTATED = re.compile(r"(bindings|types)\.glsl$")
SWAPS = {
    "+": ["-"], "-": ["+"], "*": ["+"], "<": [">", "<="], ">": ["<", ">="], "<=": ["<", ">="], ">=": [">", "<="],
    "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"], "<<": [">>"], ">>": ["<<"], "&": ["|"], "|": ["&"],
    "+=": ["-="], "-=": ["+="], "min": ["max"], "max": ["min"], "floor": ["ceil"], "any": ["all"], "all": ["any"],
}
TOKEN = re.compile(r"0x[0-9a-fA-F]+u?|(?<![\w.])(?:\d+\.\d*|\.\d+|\d+)(?:[eE][-+]?\d+)?[fu]?(?![\w.])|\b(?:min|max|floor|any|all)(?=\()"
                   r"|<<=|>>=|\+\+|--|->|[-+*/&|^<>=!]=|<<|>>|&&|\|\||[-+*<>&|]|\w+|\S")
SKIPPED_LINE = re.compile(r"\s*(#|layout\b|struct\b|\}|uniform\b|shared\b|precision\b)")


class Mutant:
    def __init__(self, file, number, line, at, old, new):
        self.file, self.number, self.at, self.old, self.new = file, number, at, old, new
        self.before = line
        self.after = line[:at] + new + line[at + len(old):]

    def place(self):
        return f"glsl/{self.file}:{self.number}"

    def name(self):
        return self.file, self.number, self.after

    def words(self):
        return f"{self.before.strip()}   ->   {self.after.strip()}"

    def changes_nothing(self):
        """True if the mutant is known to be equivalent."""
        return (self.file, self.after.strip()) in EQUIVALENT or is_same_float(self.old, self.new)

    def written(self, folder, text=None):
        """Writes a copy of the shaders with the change (or with `text` in its place) and returns its folder."""
        copy = pathlib.Path(folder) / "glsl"
        copy.parent.mkdir(exist_ok=True)
        if not copy.exists():
            shutil.copytree(GLSL, copy)
        lines = (GLSL / self.file).read_text(encoding="utf-8").split("\n")
        line = self.before
        lines[self.number - 1] = self.after if text is None else line[:self.at] + text + line[self.at + len(self.old):]
        (copy / self.file).write_text("\n".join(lines), encoding="utf-8")
        return copy


def changed_number(word, rng):
    """Returns other numbers to replace a literal."""
    if word.startswith("0x"):
        return [f"0x{int(word.rstrip('u'), 16) ^ 1 << rng.randrange(8):x}{'u' if word.endswith('u') else ''}"]
    if "." in word or "e" in word.lower():
        suffix = "f" if word.endswith("f") else ""
        value = float(word.rstrip("f"))
        others = [value * 1.01, value + 1, 0.0] if value != 0 else [1.0, 0.01]
        return [f"{other:.9g}" + ("" if re.search(r"[.e]", f"{other:.9g}") else ".0") + suffix for other in others]
    suffix = "u" if word.endswith("u") else ""
    value = int(word.rstrip("u"))
    return [f"{other}{suffix}" for other in (value + 1, value - 1, 0) if other != value and other >= 0]


def is_same_float(a, b):
    """True if two literals are the same 32-bit float."""
    try:
        return struct.pack("f", float(a.rstrip("f"))) == struct.pack("f", float(b.rstrip("f")))
    except ValueError:
        return False


def is_unary(line, at):
    """True if the + or - at this position is a sign."""
    before = line[:at].rstrip()
    return not before or before[-1] in "(,=<>*/+-&|?:;{[" or before.endswith("return")


def mutants_of(file, seed, every=False):
    """Returns (lot, mutant) for each position of the file that can be changed: one random mutant, or every one. The lot
    is a random number that orders the mutants. It depends only on the line and the seed, so changes elsewhere, or a
    move of the file to another folder, keep the order."""
    found = []
    met = collections.Counter()  # number of earlier lines with the same text
    inside = False  # true inside a struct or layout block, whose lines are not mutated
    for number, line in enumerate((GLSL / file).read_text(encoding="utf-8").split("\n"), 1):
        code = line.split("//")[0]
        if inside:
            inside = "}" not in code
            continue
        if SKIPPED_LINE.match(code):
            inside = bool(re.match(r"\s*(struct|layout)\b", code)) and "{" in code and "}" not in code
            continue
        met[code.strip()] += 1
        header = re.match(r"\s*(FUNCTION\s+)?\w+ \w+\([^=]*\) \{", code)
        begin = header.end() if header else 0
        for match in TOKEN.finditer(code, begin):
            word = match[0]
            rng = random.Random("|".join(map(str, (seed, pathlib.Path(file).name, code.strip(), met[code.strip()],
                                                   match.start() - len(code) + len(code.lstrip())))))
            if word[0].isdigit():
                others = changed_number(word, rng)
            elif word in "+-" and is_unary(code, match.start()):
                others = [""] if word == "-" else []
            else:
                others = SWAPS.get(word, [])
            if others:
                lot = rng.random()
                others = others if every else [rng.choice(others)]
                found += [(lot, Mutant(file, number, line, match.start(), word, other)) for other in others]
    return found


def all_files():
    """Returns the files that can be changed."""
    names = sorted(str(file.relative_to(GLSL)) for file in GLSL.rglob("*") if file.suffix in (".glsl", ".comp", ".vert", ".frag"))
    return [file for file in names if code.chosen.has(file) and not NOT_MUTATED.search(file)]


def drawn_lots(files, seed, every=False):
    """Returns the mutants of the files in the order of their lots, except files that match NOT_MUTATED."""
    lots = [lot for file in files if not NOT_MUTATED.search(file) for lot in mutants_of(file, seed, every)]
    return [mutant for _, mutant in sorted(lots, key=lambda lot: lot[0])]


def reported(report):
    """Returns the mutants of a report as {mutant: (kind, caught by, test)}, without those whose line is gone."""
    found, names, last = {}, set(), None
    for line in pathlib.Path(report).read_text(encoding="utf-8").splitlines():
        match = re.match(r"(caught|survived|equivalent) {2,}(\S*)( \w+| \(test\)|) +glsl/(\S+):(\d+)  (.*)   ->   (.*)", line)
        if not match:
            if last and line.startswith(13 * " "):
                found[last] = (*found[last][:2], line.strip())
            continue
        kind, by, what, file, number, before, after = match.groups()
        lines = (GLSL / file).read_text(encoding="utf-8").split("\n")
        same = [at for at, text in enumerate(lines, 1) if text.strip() == before]
        last = None
        if not same:
            continue
        number = min(same, key=lambda at, wanted=int(number): abs(at - wanted))
        text = lines[number - 1]
        at = text.index(before)
        head = len(os.path.commonprefix([before, after]))
        tail = len(os.path.commonprefix([before[head:][::-1], after[head:][::-1]]))
        mutant = Mutant(file, number, text, at + head, before[head:len(before) - tail], after[head:len(after) - tail])
        if mutant.name() not in names:  # A report may list a survivor twice, because it repeats survivors after its
                                        # last line.
            names.add(mutant.name())
            last = mutant
            found[last] = (kind, by + what, "")
    return found
