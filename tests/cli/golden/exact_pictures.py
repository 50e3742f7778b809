"""Small, early pictures of the shipped scenes by the exact rasterizer, and their hashes: for tests of the program,
tools/pictures and tools/mutate."""
import concurrent.futures
import hashlib
import os
import pathlib
import subprocess
import tempfile

from common import PATIENCE, SOURCE, png_rows, unfiltered

SIZE = "201x113"
WORKERS = 2


def scenes():
    return sorted(file.stem for file in (SOURCE / "assets/scenes").glob("*.json"))


def render(program, scene, output, *arguments, size=None, env=None, timeout=PATIENCE):
    """Runs `simreel render` on a shipped scene; `output` is a file, or - for RGBA bytes on stdout."""
    environment = {**os.environ, "SIMREEL_ASSETS": str(SOURCE / "assets"), **(env or {})}
    return subprocess.run([program, "render", SOURCE / f"assets/scenes/{scene}.json", "-o", output, "--size", size or SIZE, "-q",
                           "--overwrite", "--no-counts", *map(str, arguments)], env=environment, capture_output=True,
                          timeout=timeout, check=False)


def pixels_hash(file):
    """Returns a hash of width, height and RGB bytes, independent of the file's filters and text chunks."""
    width, height, filtered = png_rows(file.read_bytes())
    if len(filtered) != height * (3 * width + 1):
        raise ValueError(f"{file.name} is not of 8-bit RGB")
    rows = b"".join(unfiltered(filtered, 3 * width, 3))
    return hashlib.sha256(f"{width}x{height}\n".encode() + rows).hexdigest()


def drawn(program, scene, frame, *arguments, env=None, timeout=PATIENCE):
    """Returns the entry of a scene as this program draws it; after a failure, {"failed": last line of the messages}."""
    with tempfile.TemporaryDirectory(prefix="simreel-exact-") as folder:
        file = pathlib.Path(folder) / "picture.png"
        done = render(program, scene, file, "--rasterizer", "exact", "--frames", frame, *arguments, env=env,
                      timeout=timeout)
        if done.returncode == 0:
            return {"frame": frame, "pixels": pixels_hash(file)}
    lines = done.stderr.decode("utf-8", "replace").splitlines()
    return {"frame": frame, "failed": f"exit code {done.returncode}: {lines[-1] if lines else 'no word'}"}


def drawn_all(program, frames, *arguments, env=None):
    """Returns the entries of these scenes, each at its frame."""
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        return dict(zip(frames, pool.map(
            lambda name: drawn(program, name, frames[name], *arguments, env=env), frames)))


def difference(wanted, entry):
    """Returns a short description of the difference between two entries, or None."""
    if wanted == entry:
        return None
    return f"cannot be drawn: {entry['failed']}" if "failed" in entry else "has other pixels"
