"""Tests checkpoints: a run that ends early continues from its last checkpoint, and its folder equals that of an
undisturbed run."""
import json
import re
import signal

from common import SLOW, Case, main, with_values

FIELDS = {
    "version": 1, "render": {"size": [96, 54], "samples": 1}, "time": {"fps": 30, "duration": 2, "start": 0.1},
    "objects": {
        "people": {"epidemic": {"size": [331, 257], "infected": 0.01, "stepsPerSecond": 200, "chart": True}},
        "skin": {"grayScott": {"size": [255, 131], "steps": 30}},
        "cells": {"life": {"size": [257, 130], "fill": 0.3, "trail": 20}},
    },
}


class Checkpoints(Case):
    undisturbed = {}  # files of a run without interruption, by command; rendered once for all tests

    def setUp(self):
        super().setUp()
        self.write("slow.json", with_values(SLOW | {"time.duration": 1.5}))
        self.checkpoint = self.folder / "out/checkpoint"

    def kill(self, number, count, *arguments):
        code, messages = self.signal_after(count, "out", number, "render", *arguments)
        self.assertEqual(code, -9 if number == signal.SIGKILL else 128 + number, messages)
        return messages

    def stored_frame(self):
        """Returns the frame of the checkpoint, -1 without a checkpoint."""
        found = self.checkpoint.exists() and re.search(rb'"frame":(\d+)', self.checkpoint.read_bytes()[:1000])
        return int(found[1]) if found else -1

    def resumed(self, *arguments):
        """Resumes a run and returns the frame of the checkpoint that it continued from, or None."""
        done = self.good("render", *arguments, "--resume")
        found = re.search(r"resuming from the checkpoint of frame (\d+)", done.err)
        return int(found[1]) if found else None

    def assert_out_equals(self, *arguments):
        if arguments not in self.undisturbed:
            self.good("render", *arguments, "-o", "whole/")
            self.undisturbed[arguments] = self.content("whole")
        out, whole = self.content("out"), self.undisturbed[arguments]
        self.assertEqual(sorted(out), sorted(whole))  # A finished run removes its checkpoint.
        self.assertEqual([name for name in whole if out[name] != whole[name]], [])

    def test_a_killed_run_is_resumed(self):
        run = ("slow.json", "-o", "out/", "--checkpoint", "0.000001")
        for frame, more in ((3, ()), (12, ("--resume",))):
            code, _ = self.signal_when(lambda: self.stored_frame() >= frame, "out", signal.SIGKILL, "render", *run, *more)
            self.assertEqual(code, -9)
        self.assertGreaterEqual(self.resumed(*run), 12)
        self.assert_out_equals("slow.json")

    def test_an_interrupt_keeps_a_checkpoint_even_of_a_short_run(self):
        self.kill(signal.SIGINT, 5, "slow.json", "-o", "out/")
        frames = self.assert_manifest_is_whole("out")
        self.assertEqual(self.resumed("slow.json", "-o", "out/"), max(frames))
        self.assert_out_equals("slow.json")

    def test_a_partly_written_checkpoint_is_ignored(self):
        self.kill(signal.SIGKILL, 5, "slow.json", "-o", "out/")
        (self.folder / "out/checkpoint.part").write_bytes(b"half of one")
        self.resumed("slow.json", "-o", "out/")
        self.assert_out_equals("slow.json")

    def test_no_checkpoints_are_written_if_turned_off(self):
        self.kill(signal.SIGINT, 5, "slow.json", "-o", "out/", "--checkpoint", "0")
        self.assertFalse(self.checkpoint.exists())
        self.assertIsNone(self.resumed("slow.json", "-o", "out/"))
        self.assert_out_equals("slow.json")

    def test_fields_counts_and_charts(self):
        self.write("fields.json", json.dumps(FIELDS))
        run = ("fields.json", "-o", "out/", "--fields", "npy")
        self.kill(signal.SIGINT, 7, *run)
        self.assertGreater(self.resumed(*run), 3)
        self.assert_out_equals("fields.json", "--fields", "npy")

    def test_missing_frames_before_the_checkpoint_are_rendered(self):
        self.kill(signal.SIGINT, 8, "slow.json", "-o", "out/")
        (self.folder / "out/000002.png").unlink()
        done = self.good("render", "slow.json", "-o", "out/", "--resume")
        self.assertIn("frame 2 is missing", done.err)
        self.assert_out_equals("slow.json")

    def test_a_run_of_earlier_frames_keeps_the_checkpoint(self):
        self.kill(signal.SIGINT, 8, "slow.json", "-o", "out/")
        self.assertGreaterEqual(self.resumed("slow.json", "-o", "out/", "--frames", "0-4"), 7)
        self.assertTrue(self.checkpoint.exists())
        self.assertGreaterEqual(self.resumed("slow.json", "-o", "out/"), 7)
        self.assert_out_equals("slow.json")

    def test_a_still_keeps_the_checkpoint_of_an_interrupted_run(self):
        self.kill(signal.SIGINT, 8, "slow.json", "-o", "out/")
        self.good("render", "slow.json", "-o", "out/", "--frames", "3", "--overwrite")
        self.assertGreaterEqual(self.resumed("slow.json", "-o", "out/"), 7)
        self.assert_out_equals("slow.json")

    def test_no_checkpoint_is_written_before_the_first_frame(self):
        self.write("fields.json", json.dumps(FIELDS | {"time": {"fps": 30, "duration": 1, "start": 6}}))
        self.signal_when(self.checkpoint.exists, "out", signal.SIGKILL, "render", "fields.json", "-o", "out/", "--checkpoint", "0.000001")
        self.assertRegex(self.checkpoint.read_bytes()[:4000].split(b"\n")[0], rb'"frame":\d')
        self.assertIsNotNone(self.resumed("fields.json", "-o", "out/"))

    def test_a_run_of_distant_frames_is_resumed(self):
        # The frames that are skipped do not displace the mesh, but their stored state must be complete.
        self.write("sea.json", with_values(SLOW | {"objects.sea": {"mesh": {
            "shape": "plane", "resolution": [61, 47], "deform": [{"waves": [{"length": 1.5, "amplitude": 0.05}]}]}}}))
        run = ("sea.json", "-o", "out/", "--frames", "0,59", "--checkpoint", "0.000001")
        self.signal_when(lambda: self.stored_frame() >= 1, "out", signal.SIGKILL, "render", *run)
        self.assertGreater(self.resumed(*run), 0)
        self.assert_out_equals("sea.json", "--frames", "0,59")

    def test_damaged_and_foreign_checkpoints_are_not_used(self):
        self.kill(signal.SIGINT, 5, "slow.json", "-o", "out/")
        whole = self.checkpoint.read_bytes()
        frame = re.search(rb'"frame":(\d+)', whole)[0]
        for data in (b"", b"\0" * 99, whole[:-1], whole[:200], whole[:-50] + b"x" + whole[-49:], whole[:-9] + b"x" * 9,
                     whole.replace(frame, frame[:-1] + (b"0" if frame[-1:] == b"1" else b"1")), whole + b"x"):
            self.checkpoint.write_bytes(data)
            done = self.good("render", "slow.json", "-o", "out/", "--resume", "--frames", "0-5")
            self.assertIn("simreel: warning: checkpoint out/checkpoint is not used", done.err)
        self.good("render", "slow.json", "-o", "out/", "--resume")
        self.assert_out_equals("slow.json")

    def test_a_new_run_does_not_use_an_old_checkpoint(self):
        self.kill(signal.SIGINT, 5, "slow.json", "-o", "out/")
        self.good("render", "slow.json", "-o", "out/", "--overwrite", "--seed", "7")
        self.assertFalse(self.checkpoint.exists())

    def test_the_run_continues_if_checkpoints_cannot_be_written(self):
        (self.folder / "out/checkpoint.part").mkdir(parents=True)
        done = self.good("render", "slow.json", "-o", "out/", "--checkpoint", "0.000001", "--frames", "0-20")
        self.assertEqual(done.err.count("no more checkpoints: cannot create out/checkpoint"), 1)
        (self.folder / "out/checkpoint.part").rmdir()
        self.assert_out_equals("slow.json", "--frames", "0-20")

    def test_usage(self):
        self.bad(2, ["--checkpoint", "cannot be resumed"], "render", "slow.json", "-o", "a.mp4", "--checkpoint", "5")
        self.bad(2, ["--checkpoint", "cannot be resumed"], "render", "slow.json", "-o", "-", "--checkpoint", "5")
        self.bad(2, ["--checkpoint"], "render", "slow.json", "-o", "out/", "--checkpoint", "-1")


if __name__ == "__main__":
    main()
