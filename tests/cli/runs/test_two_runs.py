"""Tests two programs that write into one folder at the same time."""
import signal

from common import PATIENCE, SLOW, Case, main, with_values


class TwoRuns(Case):
    def setUp(self):
        super().setUp()
        self.write("slow.json", with_values(SLOW | {"time.duration": 1}))
        self.run_of_slow = ("render", "slow.json", "-o", "out/")

    def begin(self, *more):
        """Starts a run in the background and waits for its first frame."""
        process = self.start(*self.run_of_slow, *more)
        self.assertTrue(self.wait_until(lambda: list(self.folder.glob("out/*.png")), process))
        return process

    def finish(self, process, code=0):
        messages = process.communicate(timeout=PATIENCE)[1].decode()
        self.assertEqual(process.returncode, code, messages)

    def assert_out_is_whole(self):
        self.good("render", "slow.json", "-o", "whole/")
        self.assertEqual(self.content("out"), self.content("whole"))

    def test_two_runs_of_the_same_frames_are_refused(self):
        long = ("-D", "time.duration=3000")  # With this duration, rendering would take hours.
        first = self.begin("--frames", "0-19,25-89999", *long)
        for more in (("--frames", "20-25"), ("--frames", "29", "--overwrite"), ("--resume",), ("--skip-existing",)):
            self.bad(6, ["being rendered into out by another simreel", "--frames"], *self.run_of_slow, *long, *more)
        for more in (("--seed", "7"), ("--size", "32x18")):
            self.bad(6, ["another simreel is rendering another scene, seed or size into out"], *self.run_of_slow, *long,
                     "--frames", "20-24", *more)
        self.good("render", "slow.json", "-o", "out/still_####.png", "--frames", "0", "--seed", "7")
        self.good(*self.run_of_slow, *long, "--frames", "20-24")
        first.kill()
        first.communicate()

    def test_two_runs_of_different_frames_work_side_by_side(self):
        runs = [self.start(*self.run_of_slow, "--frames", frames) for frames in ("0-29x2", "1-29x2")]
        for process in runs:
            self.finish(process)
        self.assert_out_is_whole()

    def test_two_runs_do_not_disturb_each_others_checkpoint(self):
        first = self.begin("--frames", "0-14", "--checkpoint", "0.000001")
        second = self.start(*self.run_of_slow, "--frames", "15-29", "--checkpoint", "0.000001")
        self.finish(first)
        self.finish(second)
        self.assert_out_is_whole()

    def test_another_sweep_in_the_folder_of_a_running_one_is_refused(self):
        """Takes 2 s."""
        sweep = ("sweep", "slow.json", "--vary", "seed=1,2", "-o", "sw/", "-D", "time.duration=3000")
        first = self.start(*sweep)
        self.assertTrue(self.wait_until(lambda: list(self.folder.glob("sw/jobs/*/*.png")), first))
        for more in ((), ("--overwrite",), ("--plan-only",)):
            self.bad(6, ["another simreel is running another sweep in sw", "choose another folder"], *sweep, "--frames", "1", *more)
        self.good(*sweep, "--plan-only")
        first.kill()
        first.communicate()
        self.good(*sweep, "--frames", "1", "--overwrite")

    def test_a_killed_run_holds_no_lock(self):
        self.signal_after(1, "out", signal.SIGKILL, *self.run_of_slow)
        self.assertTrue((self.folder / "out/manifest.json.lock").exists())
        self.good(*self.run_of_slow, "--resume")
        self.assert_out_is_whole()

    def test_many_runs_at_once(self):
        """Removing the lock file races with opening it."""
        self.write("tiny.json", with_values({"render.size": [8, 8], "time.duration": 0}))
        runs = [self.start("render", "tiny.json", "-o", "out/", "--frames", str(i)) for i in range(6)]
        for process in runs:
            self.finish(process)
        self.assertEqual(self.assert_manifest_is_whole("out"), list(range(6)))
        self.assertEqual(len(self.content("out")), 8)

    def test_two_runs_of_one_video_are_refused(self):
        fake = self.write("bin/ffmpeg", "#!/bin/sh\nwhile [ ! -e go ]; do sleep 0.05; done\ncat >/dev/null\nfor last; do :; done\necho video > \"${last#file:}\"\n")
        fake.chmod(0o755)
        path = {"PATH": f"{fake.parent}:/usr/bin:/bin"}
        first = self.start("render", "slow.json", "-o", "a.mp4", env=path)
        self.wait_until((self.folder / "a.mp4.manifest.json.lock").exists, first)
        self.bad(6, ["error: a.mp4 is being rendered by another simreel"], "render", "slow.json", "-o", "a.mp4", "--frames", "0-3", env=path)
        self.bad(6, ["another scene, seed or size into a.mp4; ", "choose another file"], "render", "slow.json", "-o", "a.mp4", "--seed", "7", env=path)
        self.write("go", "")
        self.finish(first)
        self.assertFalse((self.folder / "a.mp4.manifest.json.lock").exists())


if __name__ == "__main__":
    main()
