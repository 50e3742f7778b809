"""A fluid's memory layout is different on a graphics card. Results must not differ: pictures, raw fields, traces and
the state in checkpoints of both memory paths are equal in every byte, and each path can continue from the other's
checkpoint."""
import json

from common import Case, main

# The number of dye dispatches per frame is odd, so the dye ends alternately in the first and the second buffer.
BATH = {
    "version": 1, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 1},
    "objects": {
        "bath": {"fluid": {
            "size": [67, 45], "speed": 75, "substeps": 1, "lift": 20, "dyeWeight": 9, "cooling": 0.5,
            "sides": {"right": {"kind": "open"}},
            "obstacles": [{"center": {"keys": [[0, [30, 20, 0]], [0.5, [42, 23, 0]]]}, "radius": 5.3}],
            "tracers": {"count": 99},
            "strokes": [{"until": 9, "radius": 4, "from": [12, 22, 0], "velocity": [70, 10, 0],
                         "dye": [1, 0.3, 0.1], "temperature": 1}]}},
        "heath": {"wildfire": {"size": [65, 41], "wind": {"fluid": "bath"}, "strokes": [{"from": [20, 20, 0]}]}},
    },
}
OTHER = {"texel": "storage", "storage": "texel"}


def parts_of(checkpoint):
    """Returns the parts of a checkpoint by object and name, without the solver's parts that depend on a path's
    workgroups."""
    header, payload = checkpoint.split(b"\n", 1)
    header = json.loads(header)
    at, parts = header["counts"], {}
    for of, name, size in header["parts"]:
        parts[of, name] = payload[at:at + size]
        at += size
    return {"state": header["state"], **{key: part for key, part in parts.items() if key[1] != "solver"}}


class FluidPaths(Case):
    def setUp(self):
        super().setUp()
        self.write("bath.json", BATH)

    def assert_same(self, one, other, names):
        self.assertEqual([name for name in names if one[name] != other[name]], [])

    def test_outputs_are_equal_on_both_memory_paths(self):
        out = {}
        for path in OTHER:
            self.good("render", "bath.json", "-o", f"{path}/", "--frames", "0-7", "--memory-path", path, "--fields", "npy",
                      "--checkpoint-at", "3,4")
            out[path] = self.content(path)
        self.assertEqual(sorted(out["texel"]), sorted(out["storage"]))
        names = [name for name in out["texel"] if not name.endswith(".json")]
        for kind, count in (("png", 8), ("npy", 8 * 9), ("checkpoint", 2)):
            self.assertEqual(len([name for name in names if kind in name]), count, sorted(names))
        self.assert_same(out["texel"], out["storage"], [name for name in names if "checkpoint" not in name])
        for frame in (3, 4):
            one, another = (parts_of(out[path][f"checkpoint.{frame:06}"]) for path in OTHER)
            self.assertIn(("bath", "dye"), one)
            self.assertEqual(len(one["bath", "dye"]), 16 * 69 * 47)
            self.assertEqual(sorted(one, key=str), sorted(another, key=str))
            self.assert_same(one, another, one)
        for path, other in OTHER.items():
            for frame in (3, 4):
                on = f"{path}-{frame}"
                self.good("render", "bath.json", "-o", f"{on}/", "--frames", f"{frame + 1}-7", "--memory-path", other,
                          "--fields", "npy", "--from", f"{path}/checkpoint.{frame:06}")
                rest = self.content(on)
                later = [name for name in rest if name.endswith((".png", ".npy"))]
                self.assertEqual(len(later), (7 - frame) * 10)
                self.assert_same(rest, out["texel"], later)

    def test_traces_are_equal_on_both_memory_paths(self):
        lines = {}
        for path in OTHER:
            lines[path] = [self.good("trace", "bath.json", "--memory-path", path, *what).stdout
                           for what in (["--frames=start-3"], ["--steps-of=3"], ["--dump=3:1", "-o", "-"])]
        for texel, storage in zip(lines["texel"], lines["storage"]):
            self.assertGreater(len(texel), 100)
            # The comparison excludes the headers, because they name the driver.
            self.assertEqual(texel.split(b"\n", 1)[1], storage.split(b"\n", 1)[1])


if __name__ == "__main__":
    main()
