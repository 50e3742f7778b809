"""Scenes and test_gpu cases in a selection of tools/test. Entries on another memory path or rasterizer run the same
cases and are not counted."""
import json
import pathlib
import re
import subprocess

from mutants.changes import ROOT

LABELS = {"quick": ["-L", "^quick$"], "ci": ["-LE", "^long$"], "all": []}
chosen = None  # selection as a tuple (scenes, names of test cases); None selects everything


def cases(program, *arguments):
    done = subprocess.run([program, *arguments, "--list-test-cases", "--no-colors"], capture_output=True, text=True, check=True)
    return {line.strip() for line in done.stdout.splitlines() if line.strip() and not line.startswith(("[doctest]", "==="))}


def take(name):
    """Restricts the scenes and tests that mutants run to this selection from now on."""
    global chosen  # pylint: disable=global-statement
    if name == "all":
        return
    listed = subprocess.run(["ctest", "--test-dir", ROOT / "build", "--show-only=json-v1", *LABELS[name]], capture_output=True,
                            text=True, check=True)
    scenes, names = set(), set()
    for entry in json.loads(listed.stdout)["tests"]:
        command = entry.get("command") or [""]
        environment = [word for given in entry.get("properties", []) if given["name"] == "ENVIRONMENT" for word in given["value"]]
        if any(re.match("SIMREEL_TEST_(MEMORY_PATH|RASTERIZER)=", word) for word in environment):
            continue
        program = pathlib.Path(command[0]).name
        if program == "simreel" and command[1] == "test":
            scenes.update(pathlib.Path(word).stem for word in command[2:] if word.endswith(".json"))
        elif program in ("test_gpu", "test_quick"):
            names |= cases(*command)
    chosen = scenes, names


def scenes(names):
    return names if chosen is None else [name for name in names if name in chosen[0]]


def tests(names):
    return names if chosen is None else [name for name in names if name in chosen[1]]


def without(arguments):
    """Returns an argument that makes test_gpu leave out the cases outside the selection."""
    if chosen is None:
        return []
    other = sorted(cases(ROOT / "build/tests/test_gpu", *arguments) - chosen[1])
    return ["--test-case-exclude=" + ",".join(re.sub("[,*]", "?", name) for name in other)] if other else []
