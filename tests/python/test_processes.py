"""Tests the Python module with signals, threads, forks and many scenes."""
import json
import multiprocessing
import os
import pathlib
import resource
import signal
import subprocess
import sys
import threading
import time
import unittest

from module_case import CLOTH, ModuleCase, PROGRAM, numpy, simreel

SLOW = {"objects.flag.cloth.size": [96, 96], "objects.flag.cloth.substeps": 64}


def resident():
    """Returns the resident memory in bytes."""
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


class Processes(ModuleCase):
    def test_a_fork_is_refused(self):
        scene = self.scene()
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:
            answers = []
            for work in (scene.step, lambda: simreel.Scene(objects={"flag": {"cloth": CLOTH}})):
                try:
                    work()
                except simreel.Error as error:
                    answers.append(f"{error.kind}: {error}")
            os.write(writer, json.dumps(answers).encode())
            os._exit(0)
        os.close(writer)
        answers = json.loads(os.read(reader, 10000))
        os.close(reader)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        self.assertEqual(len(answers), 2)
        for answer in answers:
            self.assertRegex(answer, "^process: this process is a fork .*spawn")
        scene.step()

    def test_a_fork_may_open_the_device_that_its_parent_did_not(self):
        code = ("import os, simreel\nchild = os.fork()\n"
                "scene = simreel.load('scene.json') if child == 0 else None\n"
                "if child: raise SystemExit(os.waitpid(child, 0)[1])\nprint(scene.step().number, flush=True)")
        done = subprocess.run([sys.executable, "-c", code], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, "1\n"), done.stderr)

    def test_threads_take_turns(self):
        alone = [frame.state_hash for frame in self.scene().frames()]
        scenes, found = [self.scene() for _ in range(3)], {}

        def work(i):
            found[i] = [frame.state_hash for frame in scenes[i].frames(progress=False)]
        threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, {i: alone for i in range(3)})

    def test_python_goes_on_while_the_device_works(self):
        scene, turns = self.scene(SLOW), [0]
        ended = threading.Event()

        def count():
            while not ended.is_set():
                turns[0] += 1
                time.sleep(0.001)
        counter = threading.Thread(target=count)
        counter.start()
        scene.step(2)
        ended.set()
        counter.join()
        self.assertGreater(turns[0], 5)

    def test_an_interrupt_ends_a_call_between_two_frames(self):
        scene = self.scene(SLOW)
        scene.step()
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            scene.step(1_000_000)
        reached = scene.frame.number
        self.assertLess(reached, 1_000_000)
        self.assertEqual(scene.step().number, reached + 1)
        other = self.scene(SLOW)
        self.assertEqual(other.advance_to(reached + 1).state_hash, scene.state_hash)

    def test_a_python_that_ends_waits_for_its_daemon_threads(self):
        code = ("import sys, threading, time, simreel\nscene = simreel.load('scene.json', {'time.duration': 1e4})\n"
                "work = {'step': lambda: scene.step(10**6), 'steps': lambda: [scene.step() for _ in range(10**6)],\n"
                "        'load': lambda: [simreel.load('scene.json') for _ in range(10**6)]}[sys.argv[1]]\n"
                "threading.Thread(target=work, daemon=True).start()\ntime.sleep(0.3)")
        for work in ("step", "steps", "load"):
            done = subprocess.run([sys.executable, "-c", code, work], cwd=self.folder, capture_output=True, text=True,
                                  check=False, timeout=60)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""), work)

    def test_an_interrupt_ends_loading(self):
        code = ("import os, signal, threading, simreel\nscene = simreel.load('scene.json')\n"
                "threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
                "try:\n    simreel.load('scene.json', {'time.start': 1e5})\n"
                "except KeyboardInterrupt:\n    print(scene.step().number, simreel.load('scene.json').frame.number)\n")
        done = subprocess.run([sys.executable, "-c", code], cwd=self.folder, capture_output=True, text=True, check=False,
                              timeout=60)
        self.assertEqual((done.returncode, done.stdout), (0, "1 0\n"), done.stderr)

    def test_a_signal_handler_cannot_call_a_scene_while_a_call_runs(self):
        scene, said = self.scene(), []

        def handle(*_):
            try:
                scene.step()
            except simreel.Error as error:
                said.append(str(error))
                raise KeyboardInterrupt from None
        before = signal.signal(signal.SIGUSR1, handle)
        self.addCleanup(signal.signal, signal.SIGUSR1, before)
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGUSR1)).start()
        with self.assertRaises(KeyboardInterrupt):
            scene.step(1_000_000)
        self.assertRegex(said[0], "^a call of simreel is running in this thread")
        scene.step()

    def test_steps_of_several_threads_add_up(self):
        scene = self.scene()
        threads = [threading.Thread(target=lambda: [scene.step() for _ in range(20)]) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(scene.frame.number, 80)

    def test_opened_and_closed_scenes_leave_no_memory(self):
        many = 1000 if os.environ.get("SIMREEL_LONG") else 200

        def use():
            with simreel.load(self.folder / "scene.json") as scene:
                scene.step()
                scene["flag"].positions
                scene.image()
        for _ in range(20):
            use()
        before = resident()
        for _ in range(many):
            use()
        self.assertLess(resident() - before, 8 << 20)

    def test_a_script_ends_with_an_open_scene(self):
        code = "import simreel\nscene = simreel.load('scene.json')\nfor frame in scene.frames(0, 2): pass"
        done = subprocess.run([sys.executable, "-c", code], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))


class Sweeps(ModuleCase):
    def test_a_sweep_has_a_row_for_each_job(self):
        sweep = simreel.sweep(self.folder / "scene.json", {"seed": range(3)}, jobs=2, frames=1)
        rows = sweep.rows()
        self.assertEqual([row["seed"] for row in rows], [0, 1, 2])
        self.assertEqual(sweep._repr_png_()[:4], b"\x89PNG")
        with self.assertRaisesRegex(simreel.Error, "sed"):
            simreel.sweep(self.folder / "scene.json", {"sed": [1]}, frames=1)


if __name__ == "__main__":
    unittest.main()
