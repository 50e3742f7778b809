"""Tests interrupts, --resume, --skip-existing, --overwrite, and determinism."""
import json
import os
import random
import resource
import signal
import struct
import subprocess
import time
import zlib

from common import FRAMES, PATIENCE, PROGRAM, SLOW, Case, main, with_values, without_hash


class Interrupted(Case):
    """Killed runs continue with --resume, and then equal an undisturbed run byte for byte."""

    def setUp(self):
        super().setUp()
        self.write("slow.json", with_values(SLOW))
        self.arguments = ("render", "slow.json", "-o", "out/")

    def assert_resumed_equals_undisturbed(self):
        self.good(*self.arguments, "--resume")
        resumed, whole = self.content("out"), self.content("whole")
        self.assertEqual(sorted(resumed), sorted(whole))
        self.assertEqual([name for name in whole if resumed[name] != whole[name]], [])

    def test_interrupt(self):
        self.once("render", "slow.json", "-o", "whole/")
        for number in (signal.SIGINT, signal.SIGTERM):
            for picture in self.folder.glob("out/*"):
                picture.unlink()
            code, messages = self.signal_after(4, "out", number, *self.arguments, "--overwrite")
            self.assertEqual(code, 128 + number, messages)
            self.assertIn("--resume", messages)
            frames = self.assert_manifest_is_whole("out")
            self.assertEqual(len(list(self.folder.glob("out/*.png"))), len(frames))
            self.assertEqual(list(self.folder.glob("out/*.part")), [])
        self.assertTrue(4 <= len(frames) < 60, frames)
        self.assert_resumed_equals_undisturbed()

    def test_kill(self):
        self.once("render", "slow.json", "-o", "whole/")
        for _ in range(2):
            self.signal_after(random.randint(1, 20), "out", signal.SIGKILL, *self.arguments, "--resume")
        self.assert_resumed_equals_undisturbed()

    def test_pictures_without_a_manifest_are_drawn_anew_with_a_warning(self):
        # This test takes 1 s.
        self.good("render", "scene.json", "-o", "out/", "--frames", "0-2", "--no-manifest")
        done = self.good("render", "scene.json", "-o", "out/", "--frames", "0-2", "--resume")
        self.assertIn("000000.png and 2 more exist without out/manifest.json, which says how frames were made; all are drawn anew", done.err)
        self.assertNotIn("drawn anew", self.good("render", "scene.json", "-o", "out/", "--frames", "0-2", "--resume").err)

    def test_an_interrupted_video_leaves_no_parts(self):
        code, messages = self.interrupt_at_once("a.mp4")
        self.assertIn(code, (0, 130), messages)
        self.assertEqual(list(self.folder.glob("*part*")), [])

    def interrupt_at_once(self, output):
        process = self.start("render", "slow.json", "-o", output)
        try:
            process.wait(0.7)
        except Exception:  # subprocess.TimeoutExpired means that the process is still running, as expected.
            process.send_signal(signal.SIGINT)
        messages = process.communicate(timeout=PATIENCE)[1].decode()
        return process.returncode, messages


class Signals(Case):
    """A single signal ends a run, whatever the run is doing."""

    def setUp(self):
        super().setUp()
        self.write("slow.json", with_values(SLOW))

    def test_sighup_and_sigxfsz_keep_a_checkpoint(self):
        for number in (signal.SIGHUP, signal.SIGXFSZ):
            for picture in self.folder.glob("out/*"):
                picture.unlink()
            code, messages = self.signal_after(4, "out", number, "render", "slow.json", "-o", "out/", "--overwrite")
            self.assertEqual(code, 128 + number, messages)
            self.assertTrue((self.folder / "out/checkpoint").exists())

    def test_an_ignored_sighup_does_not_end_the_run(self):
        process = self.start("render", "slow.json", "-o", "out/", "--frames", "0-19",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        while process.poll() is None and not list(self.folder.glob("out/*.png")):
            time.sleep(0.002)
        process.send_signal(signal.SIGHUP)
        messages = process.communicate(timeout=PATIENCE)[1].decode()
        self.assertEqual(process.returncode, 0, messages)

    def test_a_file_above_the_size_limit_is_an_error(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (9000, 9000))
        self.bad(6, ["File too large"], "render", "slow.json", "-o", "out/", preexec_fn=limit)

    def ended(self, process, number=signal.SIGTERM):
        """Sends the signal to a process that would run for hours, and checks that it ends."""
        process.send_signal(number)
        messages = process.communicate(timeout=PATIENCE)[1].decode()
        self.assertEqual(process.returncode, 128 + number, messages)

    def test_signals_before_the_first_frame_end_the_run(self):
        dish = {"size": [400, 400], "presteps": 9000000}
        self.write("presteps.json", {"version": 1, "objects": {"dish": {"grayScott": dish}}})
        self.write("preroll.json", with_values(SLOW | {"time.start": 9000}))
        for scene, more in (("presteps.json", ()), ("preroll.json", ()), ("slow.json", ("--frames", "900000"))):
            process = self.start("render", scene, "-o", "out/", "--progress", "ndjson", *more)
            events = []
            while "prepare" not in events and (not more or len(events) < 1):
                events.append(json.loads(process.stderr.readline())["event"])
            time.sleep(0.5)
            self.ended(process)

    def test_a_run_with_a_stalled_ffmpeg_can_be_interrupted(self):
        fake = self.write("bin/ffmpeg", f"#!/bin/sh\necho $$ > {self.folder}/pid\nexec sleep 100000\n")
        fake.chmod(0o755)
        process = self.start("render", "slow.json", "-o", "a.mp4", env={"PATH": f"{fake.parent}:/usr/bin:/bin"})
        while not (self.folder / "pid").exists() or not (self.folder / "pid").read_text():
            time.sleep(0.01)
        time.sleep(1)
        self.ended(process)
        with self.assertRaises(ProcessLookupError):
            os.kill(int((self.folder / "pid").read_text()), 0)
        self.assertEqual([p.name for p in self.folder.glob("a.*")], [])

    def test_a_run_with_a_stalled_reader_can_be_interrupted(self):
        reader, writer = os.pipe()
        process = subprocess.Popen([PROGRAM, "render", "slow.json", "-o", "-"], cwd=self.folder, stdout=writer,
                                   stderr=subprocess.PIPE)
        time.sleep(2)
        self.ended(process)
        os.close(reader)
        os.close(writer)


class Resume(Case):
    def setUp(self):
        super().setUp()
        self.once("render", "scene.json", "-o", "out/")
        self.whole = self.content("out")

    def path(self, frame):
        return self.folder / f"out/{frame:06}.png"

    def damage(self):
        """Makes a truncated, a modified, a foreign, an empty and a missing frame."""
        self.path(0).write_bytes(self.whole["000000.png"][:-40])
        changed = bytearray(self.whole["000001.png"])
        changed[len(changed) // 2] ^= 0xFF
        self.path(1).write_bytes(changed)
        self.path(2).write_bytes(self.whole["000003.png"])
        self.path(3).write_bytes(b"")
        self.path(4).unlink()

    def test_damaged_frames_are_rendered_again(self):
        self.damage()
        self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.content("out"), self.whole)

    def test_complete_frames_are_not_written_again(self):
        times = {i: self.path(i).stat().st_mtime_ns for i in range(FRAMES)}
        self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual({i: self.path(i).stat().st_mtime_ns for i in range(FRAMES)}, times)
        self.assertEqual(self.content("out"), self.whole)

    def test_resume_without_earlier_frames(self):
        self.good("render", "scene.json", "-o", "fresh/", "--resume")
        self.assertEqual(self.content("fresh"), self.whole)

    def test_resume_without_a_manifest(self):
        (self.folder / "out/manifest.json").unlink()
        self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.content("out"), self.whole)

    def test_resume_keeps_files_of_others(self):
        """Text, a retouched picture, and a picture of another run are not overwritten, listed or not. A picture of this
        run that the manifest does not list is drawn anew, and a line says so."""
        again = ("render", "scene.json", "-o", "out/", "--resume")
        own = self.whole["000003.png"]
        for content in (b"my notes", own[:33] + own[own.index(b"IDAT") - 4:]):
            self.path(3).write_bytes(content)
            self.bad(2, ["cannot resume: out/000003.png is no picture of simreel; use --overwrite, or another folder"], *again)
            self.assertEqual(self.path(3).read_bytes(), content)
        self.path(3).write_bytes(self.whole["000002.png"])
        self.assert_words(["out/000003.png exists without being listed as whole in out/manifest.json; drawn anew"], self.good(*again))
        self.assertEqual(self.content("out"), self.whole)
        (self.folder / "out/manifest.json").unlink()
        self.bad(2, ["cannot resume: what is changed in the scene is -D seed=7 in this run and nothing in out/000000.png"], *again,
                 "--seed", "7")

    def test_a_manifest_of_another_program_is_kept(self):
        text = '{"name": "An app", "start_url": "/"}'
        self.write("app/manifest.json", text)
        for more in ((), ("--resume",), ("--overwrite",)):
            self.bad(6, ["app/manifest.json is not simreel's", "--no-manifest"], "render", "scene.json", "-o", "app/", *more)
        self.good("render", "scene.json", "-o", "app/", "--frames", "0", "--no-manifest")
        self.assertEqual((self.folder / "app/manifest.json").read_text(encoding="utf-8"), text)
        self.assertEqual({p.name for p in self.folder.glob("app/*")}, {"manifest.json", "000000.png"})

    def test_resume_refuses_another_scene(self):
        self.bad(2, ["cannot resume", "-D seed=7 in this run and nothing in the earlier one", "--overwrite"], "render", "scene.json", "-o", "out/", "--resume",
                 "--seed", "7")
        self.write("scene.json", with_values({"title": "other"}))
        self.bad(2, ["cannot resume", "out/manifest.json"], "render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.content("out"), self.whole)

    def change_manifest(self, old, new, name="manifest.json"):
        text = (self.folder / "out" / name).read_text(encoding="utf-8")
        self.assertIn(old, text)
        self.write(f"out/{name}", without_hash(text.replace(old, new)))

    def change_run(self, old, new):
        self.change_manifest(old, new, "run.json")

    def test_exact_pictures_are_resumed_on_another_machine(self):
        """Exact pictures are equal on every machine, so a run may continue on another one."""
        self.assertEqual(self.manifest("out")["rasterizer"], "exact")
        for word in ("fingerprint", "driver", "processor", "machine"):
            self.assertNotIn(word, self.manifest("out"))
        self.change_run(self.runs("out")[0]["processor"], "Testium 3")
        self.change_run('"fingerprint":"', '"fingerprint":"0')
        (self.folder / "out/000004.png").unlink()
        done = self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertNotIn("another machine", done.err)
        self.assertEqual(self.content("out"), self.whole)
        self.assertEqual([(r["processor"] == "Testium 3", r["frames"]) for r in self.runs("out")],
                         [(True, "0-3,5"), (False, "4")])

    def test_resume_refuses_another_rasterizer(self):
        self.change_manifest('"rasterizer": "exact"', '"rasterizer": "driver"')
        self.bad(2, ["cannot resume", "rasterizer is exact in this run and driver in the earlier one"], "render",
                 "scene.json", "-o", "out/", "--resume")

    def test_driver_pictures_are_resumed_on_another_machine(self):
        """Pictures of a driver stay when a run continues on another machine, and run.json lists both machines."""
        self.write("scene.json", with_values({"render.rasterizer": "driver"}))
        self.good("render", "scene.json", "-o", "out/", "--overwrite")
        self.whole = self.content("out")
        processor = self.runs("out")[0]["processor"]
        self.change_run(processor, "Testium 3")
        (self.folder / "out/000004.png").unlink()
        done = self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertIn("5 of 5 kept frames were drawn on another machine (Testium 3; ", done.err)
        self.assertEqual([(r["processor"], r["frames"]) for r in self.runs("out")],
                         [("Testium 3", "0-3,5"), (processor, "4")])
        self.assertEqual(self.content("out"), self.whole)
        # On the first machine again, its pictures are no longer reported as pictures of another machine.
        self.change_run("Testium 3", processor)
        (self.folder / "out/000004.png").unlink()
        done = self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertNotIn("another machine", done.err)
        self.assertEqual(self.content("out"), self.whole)
        # run.json is unreadable, so no machine is known.
        self.write("out/run.json", "{")
        done = self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertNotIn("another machine", done.err)
        # Different numerics make resuming an error.
        self.change_manifest('"fingerprint": "', '"fingerprint": "0')
        self.bad(2, ["cannot resume", "fingerprint"], "render", "scene.json", "-o", "out/", "--resume")

    def test_a_malformed_manifest_starts_over(self):
        """A malformed manifest makes the run start over, with a message."""
        whole = self.whole["manifest.json"].decode()
        for text in ("", "{", "[]", "null", "{}", "\0\0", whole[:-30], whole.replace('"version": 4', '"version": 99'),
                     whole.replace('"frame":0', '"frame":"a"'), whole.replace('"frame":0', '"frame":1e99'),
                     whole.replace('"fps": 30.0', '"fps": 1e999'), "[" * 100000):
            self.write("out/manifest.json", text)
            self.path(2).write_bytes(self.whole["000003.png"])
            done = self.good("render", "scene.json", "-o", "out/", "--resume")
            self.assert_words(["simreel: warning: manifest out/manifest.json cannot be read", "all frames are drawn again"], done)
            self.assertEqual(self.content("out"), self.whole)

    def test_files_with_extra_chunks_are_rewritten(self):
        """The picture was written by another program: equal pixels, different file."""
        body = b"tEXtComment\0by another program"
        chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
        data = self.whole["000002.png"]
        self.path(2).write_bytes(data[:33] + chunk + data[33:])
        self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.content("out"), self.whole)

    def test_file_names_of_the_manifest_are_not_trusted(self):
        text = without_hash(self.whole["manifest.json"].decode().replace("000001.png", "../scene.json"))
        self.write("out/manifest.json", text)
        self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.content("out"), self.whole)

    def test_a_wrong_state_is_detected(self):
        text = self.whole["manifest.json"].decode()
        state = self.manifest("out")["frames"][3]["state"]
        self.write("out/manifest.json", without_hash(text.replace(state, "0" * len(state))))
        self.bad(1, ["frame 3", "--overwrite"], "render", "scene.json", "-o", "out/", "--resume")

    def test_a_changed_digit_starts_over(self):
        """Covers a digit in the hash of a state before the checkpoint, which is not simulated again, and a digit in the
        hash of pixels."""
        text = self.whole["manifest.json"].decode()
        for item in ("state", "pixels"):
            value = self.manifest("out")["frames"][1][item]
            self.write("out/manifest.json", text.replace(value, ("1" if value[0] == "0" else "0") + value[1:]))
            done = self.good("render", "scene.json", "-o", "out/", "--resume")
            self.assert_words(["out/manifest.json cannot be read: it was changed after it was written", "all frames are drawn again"], done)
            self.assertEqual(self.content("out"), self.whole)

    def test_skip_existing_keeps_readable_frames(self):
        self.damage()
        own = self.whole["000005.png"]
        foreign = own[:33] + own[own.index(b"IDAT") - 4:]  # foreign picture without simreel's text chunks
        self.path(1).write_bytes(foreign)
        self.path(2).write_bytes(self.whole["000002.png"])
        done = self.good("render", "scene.json", "-o", "out/", "--skip-existing")
        self.assert_words(["out/000000.png and 1 more are empty or damaged; drawn again",
                           "1 of 3 kept frames do not name the run that drew them; the manifest does not list them"], done)
        after = self.content("out")
        self.assertEqual(after["000001.png"], foreign)
        self.assertEqual([frame["frame"] for frame in self.manifest("out")["frames"]], [0, 2, 3, 4, 5])
        self.bad(2, ["cannot resume: out/000001.png is no picture of simreel", "--overwrite"], "render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.path(1).read_bytes(), foreign)
        self.path(1).unlink()
        self.good("render", "scene.json", "-o", "out/", "--resume")
        self.assertEqual(self.content("out"), self.whole)

    def test_skip_existing_redraws_damaged_frames(self):
        """Covers a changed byte, text in place of a picture, and a folder in place of a picture."""
        changed = bytearray(self.whole["000001.png"])
        changed[len(changed) // 2] ^= 0xFF
        again = ("render", "scene.json", "-o", "out/", "--skip-existing")
        for listed in (True, False):
            self.path(1).write_bytes(changed)
            self.path(3).write_bytes(b"no picture")
            if not listed:
                (self.folder / "out/manifest.json").unlink()
            done = self.good(*again)
            self.assert_words("out/000001.png and 1 more are empty or damaged; drawn again", done)
            self.assertEqual(self.content("out"), self.whole)
        self.path(1).unlink()
        self.path(1).mkdir()
        self.bad(6, ["out/000001.png: a folder has this name", "remove it"], *again)

    def test_skip_existing_refuses_another_run(self):
        again = ("render", "scene.json", "-o", "out/", "--skip-existing")
        words = ["cannot skip existing frames: ", "--overwrite"]
        self.bad(2, words + ["-D seed=7 in this run and nothing in the earlier one"], *again, "--seed", "7")
        (self.folder / "out/manifest.json").unlink()
        self.bad(2, words + ["size is 32x18 in this run and 64x36 in out/000000.png"], *again, "--size", "32x18")
        self.write("scene.json", with_values({"title": "other"}))
        self.bad(2, words + ["scene hash is"], *again)
        self.whole.pop("manifest.json")
        self.assertEqual(self.content("out"), self.whole)

    def test_overwrite_replaces_all_frames(self):
        self.damage()
        self.good("render", "scene.json", "-o", "out/", "--overwrite")
        self.assertEqual(self.content("out"), self.whole)
        self.good("render", "scene.json", "-o", "out/", "--overwrite", "--frames", "2")
        self.assertEqual(self.content("out"), self.whole)


class Determinism(Case):
    def test_two_runs_write_the_same_bytes(self):
        self.good("render", "scene.json", "-o", "a/", env={"LP_NUM_THREADS": "5"})
        self.good("render", "scene.json", "-o", "b/", "--progress", "ndjson", env={"LP_NUM_THREADS": "1"})
        self.assertEqual(self.content("a"), self.content("b"))

    def test_frames_do_not_depend_on_the_selection(self):
        self.good("render", "scene.json", "-o", "a/")
        self.good("render", "scene.json", "-o", "b/", "--frames", "5")
        self.assertEqual(set(self.content("b")), {"000005.png", "as-run.json", "manifest.json"})
        self.assertEqual(self.content("b")["000005.png"], self.content("a")["000005.png"])
        self.assertEqual(self.manifest("b")["frames"], self.manifest("a")["frames"][5:])
        self.good("render", "scene.json", "-o", "b/", "--frames", "0-4")
        self.assertEqual(self.content("b"), self.content("a"))

    def test_seed(self):
        self.good("render", "scene.json", "-o", "a/", "--seed", "2")
        self.good("render", "scene.json", "-o", "b/", "--seed", "3")
        a, b = self.manifest("a"), self.manifest("b")
        self.assertEqual((a["seed"], b["seed"]), (2, 3))
        for first, second in zip(a["frames"], b["frames"]):
            self.assertNotEqual(first["state"], second["state"])
            self.assertNotEqual(first["pixels"], second["pixels"])
        still = ("-D", "objects.flag.cloth.jitter=0", "--frames", "0")
        self.good("render", "scene.json", "-o", "c/", "--seed", "2", *still)
        self.good("render", "scene.json", "-o", "d/", "--seed", "3", *still)
        c, d = (self.manifest(folder)["frames"][0] for folder in "cd")
        self.assertEqual((c["state"], c["pixels"]), (d["state"], d["pixels"]))


if __name__ == "__main__":
    main()
