"""Pictures of the shipped scenes that the exact rasterizer draws, small and early: the same bytes on every machine, whose
hashes stand in exact_pictures.json. test_exact.py compares them here, tools/drivers on every driver variant."""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import subprocess
import tempfile

from common import SOURCE, png_rows, unfiltered

LIST = pathlib.Path(__file__).with_name("exact_pictures.json")
RENEWAL = "SIMREEL_RENEW_EXACT=1 SIMREEL=$PWD/build/simreel PYTHONPATH=tests/cli python3 tests/cli/golden/test_exact.py"
SIZE = "201x113"
FIRST_FRAME = 0  # of a scene that is not listed yet
WORKERS = 2


def listed():
    """What is drawn of each scene: {"frame": 0, "pixels": hash}, or with "refused" the sentence instead of the hash."""
    return json.loads(LIST.read_text(encoding="utf-8")) if LIST.exists() else {}


def scenes():
    return sorted(file.stem for file in (SOURCE / "assets/scenes").glob("*.json"))


def render(program, scene, output, *arguments, size=None, env=None, timeout=600):
    """`simreel render` of a shipped scene; `output` is a file, or - for bytes of RGBA in stdout."""
    environment = {**os.environ, "SIMREEL_ASSETS": str(SOURCE / "assets"), **(env or {})}
    return subprocess.run([program, "render", SOURCE / f"assets/scenes/{scene}.json", "-o", output, "--size", size or SIZE, "-q",
                           "--overwrite", "--no-counts", *map(str, arguments)], env=environment, capture_output=True,
                          timeout=timeout, check=False)


def pixels_hash(file):
    """Of width, height and RGB bytes, whatever the file's filters and texts are."""
    width, height, filtered = png_rows(file.read_bytes())
    if len(filtered) != height * (3 * width + 1):
        raise ValueError(f"{file.name} is not of 8-bit RGB")
    rows = b"".join(unfiltered(filtered, 3 * width, 3))
    return hashlib.sha256(f"{width}x{height}\n".encode() + rows).hexdigest()


def drawn(program, scene, frame, *arguments, env=None, timeout=600):
    """The entry of a scene as this program makes it; with "failed" the last line where it says nothing for the list."""
    with tempfile.TemporaryDirectory(prefix="simreel-exact-") as folder:
        file = pathlib.Path(folder) / "picture.png"
        done = render(program, scene, file, "--rasterizer", "exact", "--frames", frame, *arguments, env=env,
                      timeout=timeout)
        if done.returncode == 0:
            return {"frame": frame, "pixels": pixels_hash(file)}
    lines = done.stderr.decode("utf-8", "replace").splitlines()
    start = "simreel: error: the exact rasterizer does not draw "
    if done.returncode == 2 and len(lines) == 1 and lines[0].startswith(start):
        return {"frame": frame, "refused": lines[0].removeprefix("simreel: error: ")}
    return {"frame": frame, "failed": f"exit code {done.returncode}: {lines[-1] if lines else 'no word'}"}


def drawn_all(program, names, *arguments, env=None):
    """Entries of these scenes, at the frames that are listed, or those that `names` gives as a dictionary."""
    frames = names if isinstance(names, dict) else {name: entry["frame"] for name, entry in listed().items()}
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        return dict(zip(names, pool.map(
            lambda name: drawn(program, name, frames.get(name, FIRST_FRAME), *arguments, env=env), names)))


def difference(wanted, entry):
    """What is wrong with the entry in a few words, or nothing."""
    if wanted == entry:
        return None
    if "failed" in entry:
        return f"cannot be drawn: {entry['failed']}"
    if wanted is None:
        return "is not listed"
    if "refused" in entry:
        return f"is refused: {entry['refused']}"
    return "is drawn now, and listed as refused" if "refused" in wanted else "has other pixels"


def differences(program, names, *arguments, env=None):
    """Of each scene whose picture is not as listed, what is wrong with it."""
    wanted = listed()
    entries = drawn_all(program, names, *arguments, env=env)
    wrong = {name: difference(wanted.get(name), entry) for name, entry in entries.items()}
    return {name: words for name, words in wrong.items() if words}
