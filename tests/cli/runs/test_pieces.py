"""Tests sequences rendered in pieces, and kept checkpoints: the bytes equal those of one run."""
import json
import signal
import time

from common import PATIENCE, SLOW, Case, main, with_values, without_hash

TOWN = {"version": 1, "render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30, "duration": 0.5, "start": 0.2},
        "objects": {"town": {"epidemic": {"size": [65, 33], "infected": 0.05, "stepsPerSecond": 90}},
                    "flag": with_values({})["objects"]["flag"]}}


class Pieces(Case):
    whole = {}

    def setUp(self):
        super().setUp()
        self.write("town.json", TOWN)

    def assert_whole(self, folder, *more):
        if more not in self.whole:
            self.good("render", "town.json", "-o", "whole/", *more)
            self.whole[more] = self.content("whole")
        self.assertEqual(sorted(self.content(folder)), sorted(self.whole[more]))
        self.assertEqual(self.content(folder), self.whole[more])

    def test_pieces_give_the_bytes_of_one_run(self):
        """Covers pictures, fields, counts with a pre-roll, and the manifest; no other files remain."""
        done = self.good("render", "town.json", "-o", "out/", "--pieces", "4", "--device", "0,none", "--fields", "npy")
        # This is the message of the second process, whose device does not exist.
        self.assertIn("no device matches --device none", done.err)
        self.assert_whole("out", "--fields", "npy")
        runs = self.runs("out")
        self.assertEqual(sorted(run["frames"] for run in runs), ["0-2", "11-14", "3-6", "7-10"])

    def test_pieces_with_a_pattern_some_frames_and_one_piece(self):
        self.good("render", "town.json", "-o", "out/a_###.png", "--pieces", "3", "--frames", "0-14x2")
        self.good("render", "town.json", "-o", "one/a_###.png", "--pieces", "1", "--frames", "0-14x2")
        self.good("render", "town.json", "-o", "whole/a_###.png", "--frames", "0-14x2")
        out, one, whole = ({name: data for name, data in self.content(folder).items() if name != "a.run.json"}
                           for folder in ("out", "one", "whole"))
        self.assertEqual(out, whole)
        self.assertEqual(one, whole)

    def test_video(self):
        self.good("render", "town.json", "-o", "a.mp4", "--pieces", "3", "--jobs", "2")
        self.good("render", "town.json", "-o", "b/a.mp4")
        mine = {p.name: p.read_bytes() for p in self.folder.glob("a.mp4*") if p.name != "a.mp4.run.json"}
        theirs = {p.name: p.read_bytes() for p in (self.folder / "b").iterdir() if p.name != "a.mp4.run.json"}
        self.assertEqual(sorted(mine), ["a.mp4", "a.mp4.as-run.json", "a.mp4.counts.csv", "a.mp4.manifest.json"])
        self.assertEqual(mine, theirs)

    def test_steps_by_hand_and_damaged_pieces(self):
        self.write("slow.json", with_values(SLOW))
        code, _ = self.signal_when((self.folder / "out/pieces/plan.json").exists, "out", signal.SIGTERM, "render", "slow.json", "-o", "out/", "--pieces", "3")
        self.assertEqual(code, 128 + signal.SIGTERM)
        folder = "out/pieces"
        self.bad(6, "use --resume or --overwrite", "render", "slow.json", "-o", "out/", "--pieces", "3")
        self.bad(2, "cannot resume", "render", "slow.json", "-o", "out/", "--pieces", "4", "--resume")
        self.bad(3, "piece 0", "pieces", "join", folder)
        # The simulation is stopped early and continued. A piece is stopped or killed and continued.
        self.good("pieces", "simulate", folder)
        self.assertEqual(sorted(p.name for p in (self.folder / folder).glob("checkpoint*")), ["checkpoint.000020", "checkpoint.000040"])
        code, _ = self.signal_after(3, "out/pieces/0001", signal.SIGTERM, "pieces", "draw", folder, "1")
        self.assertEqual(code, 128 + signal.SIGTERM)
        self.assertTrue((self.folder / folder / "0001/checkpoint").exists())
        self.signal_after(9, "out/pieces/0001", signal.SIGKILL, "pieces", "draw", folder, "1")
        done = self.run_program("pieces", "status", folder)
        self.assertEqual(done.returncode, 3)
        self.assertIn("3 pieces: 0 done, states there", done.stdout.decode())
        self.good("pieces", "draw", folder, "2", "1", "0")
        # Files that changed between the steps are detected before any file is moved.
        picture = self.folder / folder / "0001/000023.png"
        bytes_of = picture.read_bytes()
        picture.write_bytes(bytes_of[:-20] + b"x" * 20)
        self.bad(1, ["000023.png", "draw its piece again"], "pieces", "join", folder)
        picture.write_bytes(bytes_of)
        manifest = self.folder / folder / "0001/manifest.json"
        text = manifest.read_text()
        state = json.loads(text)["frames"][0]["state"]
        manifest.write_text(without_hash(text.replace(state, "0" * 32)))
        self.bad(1, ["frame 20", "pieces 0 and 1", "its state differs"], "pieces", "join", folder)
        manifest.write_text(without_hash(text.replace('"rasterizer": "exact"', '"rasterizer": "driver"')))
        self.bad(2, ["piece 1 does not match piece 0", "rasterizer"], "pieces", "join", folder)
        manifest.write_text(text)
        self.assertEqual([p for p in self.folder.glob("out/*.png")], [])
        self.good("pieces", "join", folder)
        self.good("render", "slow.json", "-o", "whole/")
        self.assertEqual(self.content("out"), self.content("whole"))
        # No work is left, which a message must state.
        self.assertIn("joined: out/manifest.json", self.good("pieces", "status", folder).stdout.decode())
        made = (self.folder / "out/000030.png").stat().st_ino
        self.assertIn("all 60 frames are there", self.good("render", "slow.json", "-o", "out/", "--pieces", "3", "--resume").err)
        self.assertEqual((self.folder / "out/000030.png").stat().st_ino, made)

    def test_checks_are_reported_once_and_equal_those_of_one_run(self):
        checks = [{"what": "not-blank"}, {"what": "not-blank", "frames": [2, 7, 14]}, {"what": "no-nan", "frames": [0, 6, 7, 12, 14]},
                  {"what": "energy", "drift": 0.001, "frames": [1, 3, 14]}, {"what": "mean", "of": "positions.y", "min": 9}]
        self.write("checked.json", {**TOWN, "test": {"frames": [2, 7, 10, 14]}, "checks": checks})
        def told(*more):
            done = self.good("render", "checked.json", "-o", "out/", "--overwrite", "--progress", "ndjson", *more)
            events = [json.loads(line) for line in done.err.splitlines()]
            return sorted((e["what"], e["frame"], e["value"], e["passed"]) for e in events if e["event"] == "check"), done.err
        one = told()[0]
        self.assertIn(False, [passed for *_, passed in one])
        self.assertGreater(len(one), 12)
        for pieces in ("1", "2", "4"):
            found, text = told("--pieces", pieces)
            self.assertEqual(found, one, pieces)
            self.assertNotIn("was not checked", text)
        # The reference of a drift check is before this run's first frame. The program must report that it cannot judge
        # the drift.
        self.good("render", "checked.json", "-o", "kept/", "--frames", "none", "--checkpoint-at", "6")
        done = self.good("render", "checked.json", "-o", "late/", "--frames", "6-14", "--from", "kept/checkpoint.000006", "--progress", "ndjson")
        self.assertIn("drift of energy of flag was not checked: this run did not begin before frame 1", done.err)
        self.assertEqual([line for line in done.err.splitlines() if '"check"' in line and "energy" in line], [])

    def test_pieces_beside_other_frames_and_with_a_damaged_state(self):
        """Frames of the same run keep their entries in its manifest and log."""
        self.good("render", "town.json", "-o", "out/", "--frames", "0-5")
        beside = ("render", "town.json", "-o", "out/", "--frames", "6-14", "--pieces", "3")
        folder = self.folder / "out/pieces"
        self.signal_when(lambda: list(folder.glob("0000/*.png")), "out", signal.SIGTERM, *beside)
        self.good("pieces", "simulate", "out/pieces")
        state = folder / "checkpoint.000009"
        whole = state.read_bytes()
        state.write_bytes(whole[:100] + b"?" + whole[101:])
        self.bad(6, ["checkpoint.000009 cannot be used: it is damaged", "`simreel pieces simulate out/pieces` makes it again"], "pieces", "draw", "out/pieces", "1")
        self.good("pieces", "simulate", "out/pieces")
        self.assertEqual(state.read_bytes(), whole)
        # Two processes draw the same piece. One of them uses a scratch disk.
        process = self.start("pieces", "draw", "out/pieces", "1", "--scratch", str(self.folder / "disk"))
        while not list(self.folder.glob("disk/*")) and process.poll() is None:
            time.sleep(0.002)
        process.send_signal(signal.SIGSTOP)
        if process.poll() is None:
            self.bad(6, "piece 1 is in use by another simreel process", "pieces", "draw", "out/pieces", "1")
        process.send_signal(signal.SIGCONT)
        self.assertEqual(process.wait(PATIENCE), 0)
        done = self.good(*beside, "--resume", "--progress", "ndjson")
        self.assertIn("piece 2", [json.loads(line).get("job") for line in done.err.splitlines()])
        self.assert_whole("out")
        self.assertLessEqual({"0-5", "9-11", "12-14"}, {run["frames"] for run in self.runs("out")})

    def test_pieces_of_several_machines(self):
        """Exact pictures may come from several machines; pictures of a driver must come from one."""
        for rasterizer in ("exact", "driver"):
            out = f"{rasterizer}/"
            made = self.start("render", "town.json", "-o", out, "--pieces", "2", "--rasterizer", rasterizer)
            self.assertEqual(made.wait(PATIENCE), 0)
            process = self.start("render", "town.json", "-o", out, "--pieces", "2", "--rasterizer", rasterizer, "--overwrite")
            run = self.folder / rasterizer / "pieces/0001/run.json"
            while not run.exists() and process.poll() is None:
                time.sleep(0.005)
            process.send_signal(signal.SIGSTOP)
            if not run.exists():  # The process ended before it could be stopped.
                process.send_signal(signal.SIGCONT)
                process.wait()
                continue
            process.kill()
            process.wait()
            folder = f"{rasterizer}/pieces"
            # The child of the killed run ends shortly after the run, and until then it locks its piece.
            while (code := self.start("pieces", "draw", folder, "0", "1").wait(PATIENCE)) == 6:
                time.sleep(0.05)
            self.assertEqual(code, 0)
            processor = self.runs(f"{folder}/0001")[0]["processor"]
            run.write_text(run.read_text().replace(processor, "Testium 3"))
            if rasterizer == "exact":
                self.good("pieces", "join", folder)
            else:
                self.bad(2, ["piece 1 was drawn by Testium 3", "piece 0 by", "pictures that a driver draws depend"], "pieces", "join", folder)

    def test_kept_checkpoints(self):
        self.good("render", "town.json", "-o", "keep/", "--frames", "none", "--checkpoint-at", "0,5,10")
        self.assertEqual(sorted(self.content("keep")), ["checkpoint.000000", "checkpoint.000005", "checkpoint.000010"])
        for first in (0, 5, 10):
            self.good("render", "town.json", "-o", f"from{first}/", "--from", f"keep/checkpoint.{first:06}")
        self.assert_whole("from0")
        five, whole = self.content("from5"), self.content("from0")
        self.assertEqual(set(whole) - set(five), {f"{i:06}.png" for i in range(5)})
        self.assertEqual([name for name in five if name != "manifest.json" and five[name] != whole[name]], [])
        # Checkpoints must not depend on whether pictures are drawn, nor on camera and size.
        self.good("render", "town.json", "-o", "beside/", "--checkpoint-at", "5", "--frames", "0-3")
        self.assertEqual(self.content("beside")["checkpoint.000005"], self.content("keep")["checkpoint.000005"])
        small = ("--size", "32x18", "-D", "camera.position=[0,1,4]")
        self.good("render", "town.json", "-o", "small/", "--from", "keep/checkpoint.000010", *small)
        self.good("render", "town.json", "-o", "plain/", "--frames", "10-14", *small)
        self.assertEqual(self.content("small"), self.content("plain"))

    def test_mistakes(self):
        self.good("render", "town.json", "-o", "keep/", "--frames", "none", "--checkpoint-at", "5")
        at = "keep/checkpoint.000005"
        self.bad(2, [at, "another simulation"], "render", "town.json", "-o", "out/", "--from", at, "--seed", "9")
        self.bad(2, [at, "frame 2 lies before it", "--frames 5-"], "render", "town.json", "-o", "out/", "--from", at, "--frames", "2-9")
        self.bad(2, "nowhere", "render", "town.json", "-o", "out/", "--from", "nowhere")
        self.bad(2, ["town.json cannot be used: it is not a checkpoint"], "render", "town.json", "-o", "out/", "--from", "town.json")
        self.bad(2, ["none draws nothing", "--checkpoint-at"], "render", "town.json", "-o", "out/", "--frames", "none")
        self.bad(2, ["--checkpoint-at", "character 3"], "render", "town.json", "-o", "out/", "--checkpoint-at", "5,x")
        self.bad(2, ["--checkpoint-at", "cannot be resumed"], "render", "town.json", "-o", "a.mp4", "--checkpoint-at", "5")
        self.bad(6, [at, "exists"], "render", "town.json", "-o", "keep/", "--checkpoint-at", "5")
        self.bad(2, ["--pieces 99", "15 frames"], "render", "town.json", "-o", "out/", "--pieces", "99")
        self.bad(2, ["--pieces", "not -"], "render", "town.json", "-o", "-", "--pieces", "2")
        self.bad(2, ["--pieces", "--from"], "render", "town.json", "-o", "out/", "--pieces", "2", "--from", at)
        self.bad(2, ["--pieces", "--checkpoint"], "render", "town.json", "-o", "out/", "--pieces", "2", "--checkpoint", "5")
        self.bad(2, ["--slurm", "--pieces"], "render", "town.json", "-o", "out/", "--slurm")
        self.bad(2, ["nowhere contains no pieces"], "pieces", "join", "nowhere")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
