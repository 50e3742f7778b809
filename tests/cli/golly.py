"""Compares the program with Golly's bgolly (Debian package golly): the same soup, cell by cell."""
import functools
import json
import os
import random
import re
import shutil
import subprocess

GOLLY = os.environ.get("BGOLLY") or shutil.which("bgolly") or shutil.which("bgolly", path="/usr/games")


@functools.cache
def version():
    """Returns bgolly's version as (3, 3); a build that does not print its version counts as new."""
    said = subprocess.run([GOLLY], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False).stdout.decode()
    told = re.search(r"bgolly (\d+)\.(\d+)", said)
    return tuple(int(n) for n in told.groups()) if told else (5, 0)


def read_rle(text):
    """Returns (width, height, rule, {(x, y): state}) of an RLE file of the program."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    width, height, rule = re.match(r"x = (\d+), y = (\d+), rule = (\S+)", lines[0]).groups()
    cells, x, y = {}, 0, 0
    for count, kind in re.findall(r"(\d*)([p-y][A-X]|[.boA-X$!])", "".join(lines[1:])):
        count = int(count or 1)
        if kind == "$":
            x, y = 0, y + count
        elif kind not in "!":
            state = (0 if kind in ".b" else 1 if kind == "o" else ord(kind) - 64 if len(kind) == 1 else
                     (ord(kind[0]) - 111) * 24 + ord(kind[1]) - 64)
            if state:
                cells.update({(x + i, y): state for i in range(count)})
            x += count
    return int(width), int(height), rule, cells


def read_macrocell(text):
    """Returns {(x, y): state} of a macrocell file, relative to its middle. Of Golly's formats only this one stores
    positions."""
    nodes = [None]
    for line in text.splitlines():
        if line[:1] in ("[", "#", ""):
            continue
        if line[0] in ".*$":
            rows = line.split("$")
            nodes.append((3, [(x, y, 1) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "*"]))
            continue
        level, *children = map(int, line.split())
        nodes.append((1, [(i % 2, i // 2, s) for i, s in enumerate(children) if s]) if level == 1 else (level, tuple(children)))
    cells = {}

    def add(node, left, top):
        level, what = node
        if isinstance(what, list):
            cells.update({(left + x, top + y): s for x, y, s in what})
            return
        half = 1 << (level - 1)
        for child, (dx, dy) in zip(what, ((0, 0), (half, 0), (0, half), (half, half))):
            if child:
                add(nodes[child], left + dx, top + dy)

    if nodes[-1]:
        half = 1 << (nodes[-1][0] - 1)
        add(nodes[-1], -half, -half)
    return cells


def fitted(cells):
    left, top = (min((c[i] for c in cells), default=0) for i in (0, 1))
    return {(x - left, y - top): s for (x, y), s in cells.items()}


def run_golly(folder, file, generations, rules=None):
    """Returns the cells of a pattern after some generations. Larger than Life can only be written as RLE, so its cells
    are relative to the upper left of all living cells."""
    rule = re.search(r"(?:rule *= *|#R +)([^\s:]+)", (folder / file).read_text(encoding="latin-1"))[1]
    algorithm = ("JvN" if rule in SIGNALS else "Larger than Life" if "," in rule else "Generations" if rule.count("/") == 2 else
                 "HashLife" if "/" in rule or re.match(r"MAP|W\d", rule) else "RuleLoader")
    output = "golly.rle" if "," in rule else "golly.mc"
    (folder / output).unlink(missing_ok=True)
    command = [GOLLY, "-a", algorithm, "-q", "-q", "-m", str(generations), "-i", "1", "-o", output]
    command += ["-s", f"{rules}/"] if rules else []
    result = subprocess.run([*command, file], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                            timeout=600)
    if result.returncode:
        raise AssertionError(f"bgolly {file}: {result.stdout.decode(errors='replace')}")
    text = (folder / output).read_text(encoding="ascii")
    return read_macrocell(text) if output == "golly.mc" else fitted(read_rle(text)[3])


# A wall of constant state 2 between top and bottom makes a torus behave like a cylinder.
WALLED_LIFE = """@RULE WalledLife
@TABLE
n_states:3
neighborhood:Moore
symmetries:permute
""" + "".join(f"var {v}={{0,1,2}}\n" for v in "a") + "".join(f"var d{i}={{0,2}}\n" for i in range(8)) + """
0,1,1,1,d0,d1,d2,d3,d4,1
1,1,1,d0,d1,d2,d3,d4,d5,1
1,1,1,1,d0,d1,d2,d3,d4,1
""" + "".join(f"var e{i}={{0,1,2}}\n" for i in range(8)) + "1,e0,e1,e2,e3,e4,e5,e6,e7,0\n"


def hensel(chance, rng):
    """Returns a list of neighbour counts in Hensel notation, each with random letters."""
    letters = {1: "ce", 2: "cekain", 3: "cekainyqjr", 4: "cekainyqjrtwz", 5: "cekainyqjr", 6: "cekain", 7: "ce"}
    text = ""
    for n, all_letters in letters.items():
        some = "".join(c for c in all_letters if rng.random() < chance)
        if some:
            text += f"{n}{'-' if rng.random() < 0.2 and len(some) < len(all_letters) else ''}{some}"
    return text


def digits(most, rng, first=1):
    return "".join(str(n) for n in range(first, most + 1) if rng.random() < 0.35)


SIGNALS = ["JvN29", "Nobili32", "Hutton32"]
BORDERS = ["torus", "dead", "klein", "kleinSideways", "crossSurface", "sphere"]


def random_case(family, rng):
    """Returns the scene entry of a random automaton of a family."""
    size = [rng.randrange(20, 90), rng.randrange(20, 70)]
    case = {"size": size, "fill": rng.choice([0.1, 0.3, 0.5]), "border": rng.choice(BORDERS[:2])}
    if family == "borders":
        case["rule"] = rng.choice(["B3/S23", "B36/S23", "B2-a/S12", "23/3/4", "B2/S34H"])
        case["border"] = rng.choice(BORDERS)
        if case["border"] == "sphere":
            size[1] = size[0]
        if case["border"] == "torus":
            case["shift"] = rng.choice([[rng.randrange(-9, 9), 0], [0, rng.randrange(-9, 9)]])
        elif case["border"] in ("klein", "kleinSideways") and rng.random() < 0.5:
            across = case["border"] == "klein"
            size[0 if across else 1] &= ~1
            case["shift"] = [1, 0] if across else [0, 1]
    elif family == "hensel":
        case["rule"] = f"B{hensel(0.3, rng)}/S{hensel(0.4, rng)}"
    elif family == "shapes":
        most, suffix = rng.choice([(4, "V"), (6, "H")])
        case["rule"] = f"B{digits(most, rng)}/S{digits(most, rng, 0)}{suffix}"
    elif family == "life":
        case["rule"] = f"B{digits(8, rng)}/S{digits(8, rng, 0)}"
    elif family == "map":
        # The rule is a random function of nine cells, of seven (hexagonal) or of five (von Neumann).
        count = rng.choice([512, 128, 32])
        bits = [i not in (0, count - 1) and i < count and rng.random() < 0.4 for i in range((count + 5) // 6 * 6)]
        base = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
        case["rule"] = "MAP" + "".join(base[sum(bits[i + j] << (5 - j) for j in range(6))] for i in range(0, len(bits), 6))
    elif family == "generations":
        kind = rng.choice(["", "V", "H", "letters"])
        most = {"V": 4, "H": 6}.get(kind, 8)
        survive, born = (hensel(0.3, rng), hensel(0.3, rng)) if kind == "letters" else (digits(most, rng, 0), digits(most, rng))
        case["rule"] = f"{survive}/{born}/{rng.choice([3, 4, 7, 30])}{'' if kind == 'letters' else kind}"
    elif family == "wide":
        reach, shape = rng.choice([1, 2, 3, 5, 7, 10]), rng.choice("MNC")
        most = {"M": (2 * reach + 1) ** 2, "N": 2 * reach * (reach + 1) + 1}.get(shape, int(3.14 * (reach + 0.4) ** 2))
        low, high = sorted(rng.sample(range(most // 4, most // 2 + 3), 2))
        born = rng.randrange(max(1, most // 4), most // 2 + 2)
        case["rule"] = (f"R{reach},C{rng.choice([0, 0, 3, 6])},M{rng.randrange(2)},S{low}..{high},"
                        f"B{born}..{min(born + most // 8 + 1, most)},N{shape}")
        case["fill"] = 0.5
    elif family == "signals":
        case["rule"] = rng.choice(SIGNALS)
    elif family == "wolfram":
        case["rule"] = f"W{2 * rng.randrange(128)}"
        case["fill"] = rng.choice([0.003, 0.01, 0.05])
    elif family == "shaped":
        # The rule uses features of Golly 4.0 and later: other neighbourhood shapes, weights, lists of counts.
        case["rule"] = shaped_rule(rng)
        size[:] = (max(s, 24) for s in size)
        case["fill"] = rng.choice([0.3, 0.5])
    elif family in ("far", "farthest"):
        # Neighbourhoods of long range. "far" runs for many generations, so its ranges are small enough for few
        # operations per cell and step in both programs. One case in sixteen has a larger range: its counts do not fit
        # into a byte, or its loops are longer than a software driver runs in one pass. "farthest" runs for few
        # generations, with ranges up to Golly's maximum. Golly requires grids at least twice as wide as the range. Half
        # of the cells live, so the counts for survival and birth are close to half of the neighbourhood.
        shape = rng.choice("MNC")
        if family == "farthest":
            reach = rng.choice([*[rng.randrange(1, 51) for _ in range(8)], rng.randrange(51, 140), rng.randrange(200, 501)])
        elif rng.random() < 0.94:
            reach = rng.randrange(11, 128 if shape == "M" else 27)
        else:
            reach = rng.randrange(128, 161) if shape == "M" else rng.randrange(91, 98)
        size[0], size[1] = (2 * reach + rng.randrange(*((11, 40) if family == "farthest" else (3, 24))) for _ in range(2))
        cells = {"M": (2 * reach + 1) ** 2, "N": 2 * reach * (reach + 1) + 1, "C": 3.1416 * (reach + 0.5) ** 2}[shape]
        near = [int(cells * share) for share in (rng.uniform(0.2, 0.4), rng.uniform(0.42, 0.7), rng.uniform(0.3, 0.45), rng.uniform(0.46, 0.6))]
        case["rule"] = f"R{reach},C{rng.choice([0, 0, 4])},M{rng.randrange(2)},S{near[0]}..{near[1]},B{near[2]}..{near[3]},N{shape}"
        case["fill"] = 0.5
    elif family == "tables":
        name, text = random_table(rng)
        case.update({"ruleFile": name, "fill": 0.5, "border": rng.choice(["torus", "dead", "klein"])})
        case["table"] = text
    return case


def shaped_rule(rng):
    reach, kind = rng.choice([1, 2, 3, 4, 6]), rng.choice("2+X*#BDHA3LG@W")
    states = rng.choice([0, 0, 3, 5])
    side = 2 * reach + 1
    tail = kind
    if kind == "@":
        tail += "".join(rng.choice("0123456789ABCDEF") for _ in range(reach * (reach + 1))) + rng.choice(["", "H", "L"])
    elif kind == "W":
        reach = min(reach, 3)
        side = 2 * reach + 1
        two = rng.random() < 0.4
        weights = [rng.choice([0, 1, 1, 2, 3, 9, 10] if not two else [0, 5, 17, 40, 130, 2]) for _ in range(side * side)]
        tail += "".join(f"{w:02X}" if two else f"{w:X}" for w in weights)
        if rng.random() < 0.4:
            tail += "," + "0" + "".join(rng.choice("0123A") for _ in range(max(states, 2) - 1))
        tail += rng.choice(["", "H", "L"])
    cells = {"2": 3 * reach * reach, "+": 4 * reach, "X": 4 * reach, "*": 8 * reach, "#": 8 * reach, "B": side * side // 2, "D": side * side // 2,
             "H": 3 * reach * (reach + 1), "A": 6 * reach, "3": 3 * reach, "L": 6 * reach * reach, "G": (reach + 1) ** 4}.get(kind)
    if kind == "@":
        cells = sum(bin(int(c, 16)).count("1") for c in tail[1:] if c != "H" and c != "L")
    elif kind == "W":
        cells = sum(w for w in weights if w < (128 if two else 8))
    cells = max(2, cells)

    def some(most):
        low = rng.randrange(1, max(2, most // 2))
        return low, min(low + rng.randrange(0, most // 3 + 1), most)
    (s0, s1), (b0, b1), extra = some(cells), some(cells), rng.randrange(1, cells + 1)
    if rng.random() < 0.5:
        return f"R{reach},C{states},M{rng.randrange(2)},S{s0}..{s1},B{b0}..{b1},N{tail}"
    return f"R{reach},C{states},S{s0}-{s1},{extra},B{b0}-{b1},N{tail}"


def random_table(rng):
    """Returns a rule file of random transitions, some of them with wildcards for neighbours."""
    neighbourhood = rng.choice(["Moore", "vonNeumann", "hexagonal"])
    moore = neighbourhood == "Moore"  # Decision diagrams of the Moore neighbourhood quickly become large.
    states = rng.randrange(2, 4 if moore else 6)
    neighbours = {"Moore": 8, "vonNeumann": 4, "hexagonal": 6}[neighbourhood]
    symmetries = rng.choice({"Moore": ["none", "rotate4", "rotate8", "reflect_horizontal", "rotate4reflect", "rotate8reflect", "permute"],
                             "vonNeumann": ["none", "rotate4", "reflect_horizontal", "rotate4reflect", "permute"],
                             "hexagonal": ["none", "rotate2", "rotate3", "rotate6", "rotate6reflect", "permute"]}[neighbourhood])
    name = f"Soup{rng.randrange(10 ** 12)}"
    lines = [f"@RULE {name}", "@TABLE", f"n_states:{states}", f"neighborhood:{neighbourhood}", f"symmetries:{symmetries}"]
    everything = ",".join(map(str, range(states)))
    lines += [f"var a{i}={{{everything}}}" for i in range(neighbours)] + [f"var b={{{','.join(map(str, range(1, states)))}}}"]
    for _ in range(rng.randrange(6, 12) if moore else rng.randrange(12, 30)):
        middle = rng.randrange(states)
        around = [rng.choice([f"a{i}", f"a{i}", "a0", "b", str(rng.randrange(states))]) for i in range(neighbours)]
        if middle == 0 and "b" not in around and not any(a.isdigit() and a != "0" for a in around):
            around[0] = "b"  # A cell with empty neighbours stays empty.
        lines.append(",".join([str(middle), *around, str(rng.randrange(states))]))
    return f"{name}.rule", "\n".join(lines) + "\n"


FAMILIES = ["life", "hensel", "shapes", "map", "wolfram", "signals", "generations", "borders", "wide", "far", "farthest", "tables"]
NEWER = ["shaped"]  # families that Golly 3 does not support


def compare(folder, simreel, cases, generations, seed=4):
    """Runs the cases as objects of one scene, then each with bgolly; returns [(name, problem or "", living cells)]. A
    case may name a "ruleFile" in `folder`, and contain its text as "table"."""
    for case in cases:
        if "table" in case:
            (folder / case["ruleFile"]).write_text(case["table"], encoding="ascii")
    cases = [{key: value for key, value in case.items() if key != "table"} for case in cases]
    objects = {f"c{i:03}": {"life": {**case, "stepsPerSecond": generations}} for i, case in enumerate(cases)}
    scene = {"version": 1, "seed": seed, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 10, "duration": 1.1},
             "objects": objects}
    (folder / "golly.json").write_text(json.dumps(scene), encoding="ascii")
    subprocess.run([simreel, "bake", "golly.json", "-o", "golly", "--frames", "0,10", "--format", "rle", "--overwrite", "-q"],
                   cwd=folder, check=True)
    results = []
    for (name, case) in zip(objects, cases):
        start, end = (read_rle((folder / f"golly/{name}_{frame:06}.rle").read_text(encoding="ascii")) for frame in (0, 10))
        file = f"golly/{name}_000000.rle"
        first = run_golly(folder, file, 0, folder)
        problem = ""
        if not first or not start[3]:
            problem = "" if not first and not start[3] else "one of the starts is empty"
        elif "," in case.get("rule", ""):
            last = run_golly(folder, file, generations, folder)
            if first != fitted(start[3]) or last != fitted(end[3]):
                problem = f"{len(set(last.items()) ^ set(fitted(end[3]).items()))} cells differ"
        else:
            left, top = (min(c[i] for c in first) - min(c[i] for c in start[3]) for i in (0, 1))

            def put(cells, left=left, top=top):
                return {(x - left, y - top): s for (x, y), s in cells.items()}
            if put(first) != start[3]:
                problem = "the start is read otherwise"
            else:
                last = put(run_golly(folder, file, generations, folder))
                if last != end[3]:
                    wrong = sorted(set(last.items()) ^ set(end[3].items()))
                    problem = f"{len(wrong)} cells differ, {wrong[:3]}"
        results.append((f"{case.get('rule', case.get('ruleFile'))} {start[2]} {case['size']}", problem, len(end[3])))
    return results


def soups(family, count, seed):
    rng = random.Random(f"{family} {seed}")
    return [random_case(family, rng) for _ in range(count)]
