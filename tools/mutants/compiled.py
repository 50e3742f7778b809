"""Finds the lines of the shaders that a driver compiles: the lines that remain after preprocessing of the sources that
Mesa writes to MESA_SHADER_DUMP_PATH. Other drivers, and machines without cpp, give no lines."""
import pathlib
import re
import shutil
import subprocess

from mutants import code
from mutants.changes import GLSL


def pasted(text):
    """Splits a dumped source. Returns {number: {line: words}} for the files by their number in #line; the origin of
    each line of the source as (number, line); and the source for cpp."""
    found, places, for_cpp = {}, [], []
    number, line = None, 0
    for words in text.split("\n"):
        match = re.match(r"#line (\d+) (\d+)$", words)
        line, number = (int(match[1]) - 1, match[2]) if match else (line + 1, number)
        places.append((number, line))
        if not match and number is not None and not re.match(r"#(ifndef|define) PASTED_\d+$", words):
            found.setdefault(number, {})[line] = words
        for_cpp.append("" if re.match(r"\s*#\s*(line|version|extension|pragma)\b", words) else words)
    return found, places, "\n".join(for_cpp)


def unused_macros(source):
    """Returns macros that are unused, or used only by unused macros; their contents are not compiled."""
    named, bodies = set(), {}
    for line in re.sub(r"\\\n|//.*", " ", source).split("\n"):
        if match := re.match(r"\s*#\s*define\s+(\w+)(.*)", line):
            bodies.setdefault(match[1], set()).update(re.findall(r"\w+", match[2]))
        else:
            named.update(re.findall(r"\w+", line))
    left = list(named)
    while left:
        words = bodies.get(left.pop(), set()) - named
        named |= words
        left += words
    return set(bodies) - named


def kept(source):
    """Returns the lines of the source that remain after preprocessing, including the first line of each used macro."""
    unused = unused_macros(source)
    done = subprocess.run(["cpp", "-undef", "-nostdinc", "-w", "-dD", "-x", "c", "-std=gnu99", "-"], input=source, text=True,
                          capture_output=True, check=True)
    found, line, ours = set(), 0, False
    for words in done.stdout.split("\n"):
        if match := re.match(r'# (\d+) "([^"]*)"', words):
            line, ours = int(match[1]), match[2] == "<stdin>"
            continue
        macro = re.match(r"\s*#\s*define\s+(\w+)", words)
        if ours and words.strip() and not (macro and macro[1] in unused):
            found.add(line)
        line += 1
    return found


class Files:
    """The shader files, found by lines pasted from them."""

    def __init__(self):
        self.lines = {str(file.relative_to(GLSL)): file.read_text(encoding="utf-8").split("\n")
                      for file in GLSL.rglob("*") if file.is_file()}
        self.having = {}
        for name, lines in self.lines.items():
            for line in enumerate(lines, 1):
                self.having.setdefault(line, []).append(name)

    def named(self, there):
        """Returns the name of the file that has these lines, {line: words}; None for text that the program adds."""
        there = {line for line in there.items() if not re.match(r"#endif$|\s*$", line[1])}
        some = min(there, key=lambda line: len(self.having.get(line, ())), default=None)
        return next((name for name in self.having.get(some, ()) if all(name in self.having.get(line, ()) for line in there)), None)


def lines_of(folder, files, known):
    """Returns {(file, line)} of the chosen code that the sources in `folder` compile. `known` caches the result of each
    source."""
    found = set()
    for source in pathlib.Path(folder).glob("*.glsl") if shutil.which("cpp") else ():
        if source.name not in known:
            chunks, places, for_cpp = pasted(source.read_text(encoding="utf-8"))
            names = {number: files.named(lines) for number, lines in chunks.items()}
            here = {(names.get(places[at - 1][0]), places[at - 1][1]) for at in kept(for_cpp)}
            for name, line in list(here):  # also adds the continuation lines of a macro
                lines = files.lines.get(name, ())
                while line < len(lines) and lines[line - 1].endswith("\\"):
                    line += 1
                    here.add((name, line))
            known[source.name] = {(name, line) for name, line in here if name and code.chosen.has(name)}
        found |= known[source.name]
    return found
