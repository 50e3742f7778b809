"""Tests `simreel serve`: files that a scene names are reloaded when written; a dragged slider's values apply to the
continuing simulation; the right side's own file, charts and baselines."""
import json
import os
import pathlib
import struct
import sys
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from common import PROGRAM, with_values
from serve_case import FIELD, ServeCase

os.environ.setdefault("SIMREEL", PROGRAM)
FEED = "objects.dish.grayScott.feed"
RATE = "objects.dish.reaction.parameters.b"
BRUSSELATOR = {**FIELD, "objects": {"dish": {"reaction": {"preset": "brusselator", "size": [32, 32], "steps": 4, "parameters": {}}}}}


def grey_png(value, size=8):
    """Returns a PNG of one grey value except for its first pixel."""
    def part(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes([value] * size) for _ in range(size - 1))
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 0, 0, 0, 0)) + part(
        b"IDAT", zlib.compress(b"\0" + bytes([255 - value] + [value] * (size - 1)) + rows)) + part(b"IEND", b"")


class ViewerCase(ServeCase):
    def viewer(self, server=None):
        viewer = (server or self.serve()).viewer()
        self.addCleanup(viewer.close)
        return viewer


class Checkpoints(ViewerCase):
    def checkpoint(self, frame, *changes):
        self.good("render", "scene.json", "-o", "states/", "--frames", "none", "--checkpoint-at", frame, "--overwrite", *changes)
        (self.folder / f"states/checkpoint.{frame:06}").replace(self.folder / "state")

    def test_the_run_begins_at_a_checkpoint_and_follows_the_file(self):
        """Takes 2 s."""
        self.write("scene.json", FIELD)
        self.checkpoint(5)
        server = self.serve("--from", self.folder / "state", "--embed")
        headers = server.get(f"/{server.token}/")[1]
        self.assertNotIn("frame-ancestors", str(headers))
        self.assertNotIn("x-frame-options", headers)
        viewer = self.viewer(server)
        self.assertEqual(self.pixels(viewer.rest(5)[1]), self.rendered(5))
        viewer.send(do="seek", frame=7)
        self.assertEqual(self.pixels(viewer.rest(7)[1]), self.rendered(7))
        viewer.send(do="seek", frame=0)  # there is no state before the checkpoint's
        self.assertEqual(self.pixels(viewer.rest(5)[1]), self.rendered(5))
        self.checkpoint(9)
        self.assertEqual(self.pixels(viewer.rest(9)[1]), self.rendered(9))
        viewer.send(do="set", path="objects.dish.grayScott.size", value=[32, 32])
        self.assertIn("does not fit", viewer.until(lambda kind, message: kind == "scene" and message["mistakes"])["mistakes"])

    def test_a_checkpoint_of_another_simulation_is_named(self):
        self.write("scene.json", FIELD)
        self.checkpoint(5, "-D", "seed=4")
        viewer = self.viewer(self.serve("--from", self.folder / "state"))
        self.assertIn("it belongs to another simulation",
                      viewer.until(lambda kind, message: kind == "scene" and message["mistakes"])["mistakes"])
        self.bad(2, ["missing", "checkpoint"], "serve", "scene.json", "--from", "missing")


class NamedFiles(ViewerCase):
    def picture(self, name, value):
        (self.folder / "new.png").write_bytes(grey_png(value))
        os.replace(self.folder / "new.png", self.folder / name)

    def becomes_rendered(self, viewer, frame, file="scene.json"):
        # Cached pictures are discarded, because the cache distinguishes scenes only by their text.
        self.__dict__.pop("pictures", None)
        wanted = self.rendered(frame, file=file)
        while self.pixels(viewer.rest(frame)[1]) != wanted:
            pass
        return wanted

    def test_a_changed_start_picture_restarts_the_simulation(self):
        self.picture("start.png", 200)
        self.write("scene.json", with_values({"objects.dish.grayScott.image": "start.png"}, FIELD))
        viewer = self.viewer()
        viewer.send(do="seek", frame=3)
        first = self.becomes_rendered(viewer, 3)
        self.picture("start.png", 90)
        second = self.becomes_rendered(viewer, 3)
        self.assertNotEqual(second, first)
        self.assertGreaterEqual(viewer.pictures[-1][0]["stepped"], 8)
        # An unreadable file is reported, and the last picture remains.
        before = len(viewer.pictures)
        (self.folder / "start.png").write_bytes(b"no picture")
        self.assertIn("start.png", viewer.until(lambda kind, m: kind == "scene" and m["mistakes"])["mistakes"])
        self.assertEqual(len(viewer.pictures), before)
        (self.folder / "start.png").unlink()
        viewer.until(lambda kind, m: kind == "scene" and 'error: no file "start.png"' in m["mistakes"])
        self.picture("start.png", 30)
        viewer.until(lambda kind, m: kind == "scene" and not m["mistakes"])
        self.assertNotIn(self.becomes_rendered(viewer, 3), (first, second))

    def test_a_changed_texture_does_not_restart_the_simulation(self):
        self.picture("cloth.png", 200)
        self.write("scene.json", with_values({"objects.flag.material": {"texture": "cloth.png"}}))
        viewer = self.viewer()
        viewer.send(do="seek", frame=4)
        first = self.becomes_rendered(viewer, 4)
        stepped = viewer.pictures[-1][0]["stepped"]
        self.picture("cloth.png", 40)
        self.assertNotEqual(self.becomes_rendered(viewer, 4), first)
        self.assertEqual(viewer.pictures[-1][0]["stepped"], stepped)

    def test_a_missing_file_may_be_added_later(self):
        self.mistake = 'no file "start.png"'
        self.write("scene.json", with_values({"objects.dish.grayScott.image": "start.png"}, FIELD))
        viewer = self.viewer()
        viewer.until(lambda kind, m: kind == "scene" and "start.png" in m["mistakes"])
        self.picture("start.png", 200)
        viewer.until(lambda kind, m: kind == "scene" and not m["mistakes"])
        self.becomes_rendered(viewer, 0)


class Dragged(ViewerCase):
    def test_a_dragged_value_acts_on_the_running_simulation(self):
        """The state after five frames with the old value and one with the new: equal to a scene with such keyframes."""
        for scene, path, before, value in ((FIELD, FEED, 0.03, 0.05), (BRUSSELATOR, RATE, 7.5, 8.5)):
            self.write("scene.json", with_values({path: before}, scene))
            viewer = self.viewer()
            viewer.send(do="seek", frame=5)
            viewer.rest(5)
            carried = self.dragged(viewer, path, value)
            self.assertTrue(carried["draft"])
            # At the end of the drag, the simulation runs again from the start.
            viewer.send(do="set", path=path, value=value, moving=False)
            let_go = viewer.rest(5)
            self.assertEqual(self.pixels(let_go[1]), self.rendered(5, "-D", f"{path}={value}"))
            viewer.send(do="set", path=path, value={"keys": [[0, before], [4.5 / 30, before], [4.9 / 30, value]]})
            viewer.send(do="seek", frame=6)
            self.assertEqual(viewer.rest(6)[0]["state"], carried["state"], path)
            self.assertNotEqual(let_go[0]["state"], carried["state"])


    def dragged(self, viewer, path, value):
        """Returns the picture of frame 6 during the drag; a quarter of a second after it, the full-quality picture
        replaces it."""
        for _ in range(10):
            viewer.send(do="set", path=path, value=value, moving=True)
            try:
                return viewer.until(lambda kind, m: kind == "picture" and m[0]["carried"] and m[0]["frame"] == 6, 6)[0]
            except AssertionError:  # This machine was too busy to read the picture in time.
                viewer.send(do="forget")
                viewer.rest(5)
        self.fail("no picture of a drag came")


class RightSide(ViewerCase):
    def begin(self, *arguments):
        tested = with_values({"test": {"frames": [0, 2], "size": [48, 32]}})
        self.write("scene.json", json.dumps(tested))
        self.write("other.json", json.dumps(with_values({"sun.intensity": 1}, tested), indent=1) + "// the end\n")
        self.server = self.serve("other.json", *arguments)
        viewer = self.viewer(self.server)
        viewer.rest(0)
        return viewer

    def test_the_right_side_writes_its_own_file(self):
        viewer = self.begin("--edit")
        left, text = (self.folder / "scene.json").read_text(), (self.folder / "other.json").read_text()
        viewer.send(do="set", path="sun.intensity", value=4, beside=True)
        viewer.until(lambda kind, m: kind == "scene" and m["beside"]["scene"]["sun"]["intensity"] == 4 and not m["beside"]["edits"])
        self.assertEqual((self.folder / "other.json").read_text(), text.replace('"intensity": 1', '"intensity": 4'))
        viewer.send(do="set", path="sun.intensity", value=-4, beside=True)
        viewer.until(lambda kind, _: kind == "refused")
        camera = {"position": [0, 1, 2], "target": [0, 1, 0]}
        viewer.send(do="camera", position=[1, 1, 2], target=[0, 1, 0], beside=camera, right=True)
        viewer.until(lambda kind, m: kind == "scene" and m["beside"]["scene"]["camera"]["position"] == [0, 1, 2] and not m["beside"]["edits"])
        written = json.loads((self.folder / "other.json").read_text().split("//")[0])
        self.assertEqual((written["camera"]["position"], written["sun"]["intensity"]), ([0, 1, 2], 4))
        # The camera that the mouse moves is stored as an edit of the right side's file.
        self.assertEqual((self.folder / "scene.json").read_text(), left)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["other.json", "scene.json"])
        # A removed file is not created again.
        (self.folder / "other.json").unlink()
        viewer.until(lambda kind, m: kind == "scene" and m["beside"]["mistakes"])
        viewer.send(do="set", path="sun.intensity", value=5, beside=True)
        self.assertIn("other.json", viewer.until(lambda kind, _: kind == "refused")["text"])
        self.assertFalse((self.folder / "other.json").exists())

    def test_nothing_is_written_without_edit(self):
        viewer = self.begin()
        text = (self.folder / "other.json").read_text()
        viewer.send(do="set", path="sun.intensity", value=4, beside=True)
        viewer.until(lambda kind, m: kind == "scene" and m["beside"]["edits"] == [["sun.intensity", "4"]])
        viewer.rest(0)
        self.assertEqual((self.folder / "other.json").read_text(), text)

    def test_the_right_side_has_its_own_charts_and_baselines(self):
        viewer = self.begin("--edit")
        if not viewer.latest.get("series", {}).get("beside"):  # The message may have arrived already.
            viewer.until(lambda kind, m: kind == "series" and m.get("beside"))
        self.assertEqual([one["name"] for one in viewer.latest["series"]["beside"]], [one["name"] for one in viewer.latest["series"]["series"]])
        viewer.send(do="compare", on=True, beside=True)
        said = viewer.until(lambda kind, m: kind == "golden" and m.get("verdict") == "missing")
        self.assertTrue(said["right"])
        viewer.send(do="accept")
        viewer.until(lambda kind, m: kind == "golden" and m.get("verdict") == "pass")
        self.assertFalse((self.folder / "golden" / "scene").exists())
        self.good("test", "other.json")
        viewer.send(do="set", path="sun.intensity", value=9, beside=True)
        self.assertTrue(viewer.until(lambda kind, m: kind == "golden" and m.get("verdict") == "fail")["right"])
        viewer.send(do="seek", frame=1)
        viewer.until(lambda kind, m: kind == "golden" and m.get("verdict") == "untested")
        viewer.send(do="testThis")
        viewer.until(lambda kind, m: kind == "golden" and m.get("tested") == [0, 1, 2])
        self.assertIn('"frames": [0, 1, 2]', (self.folder / "other.json").read_text())
        viewer.send(do="compare", on=True)
        said = viewer.until(lambda kind, m: kind == "golden" and not m["right"] and "words" in m)
        self.assertIn("Frame 1 is not a tested frame", said["words"])


if __name__ == "__main__":
    unittest.main()
