"""Tests the Python module with signals, threads, forks and many scenes."""
import json
import multiprocessing
import os
import pathlib
import re
import resource
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest
import urllib.parse
import urllib.request

from module_case import CLOTH, ModuleCase, PROGRAM, numpy, picture_of, simreel

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

    def test_a_sweep_has_a_row_for_each_job_and_frame(self):
        scene = {"version": 2, "objects": {"flag": {"cloth": CLOTH}}, "render": {"size": [64, 36]}, "time": {"fps": 30, "duration": 0.2}}
        sweep = simreel.sweep(scene, {"objects.flag.cloth.gravity": [[0, -9.8, 0], [0, 0, 0]]}, frames=0, pair=True)
        rows = sweep.rows(frames=[0, 3])
        self.assertEqual([(row["job"], row["frame"]) for row in rows], [(0, 0), (0, 3), (1, 0), (1, 3)])
        with simreel.load(scene) as alone:
            alone.advance_to(3)
            wanted = {f"flag.{name}": value for name, value in alone["flag"].measure().items()}
        self.assertTrue(wanted)
        self.assertEqual({name: rows[1][name] for name in wanted}, wanted)
        (last,) = sweep.rows("last")[:1]
        self.assertEqual((last["job"], last["frame"]), (0, 5))

    def test_errors_of_sweeps_have_their_place(self):
        file = self.folder / "scene.json"
        with self.assertRaises(simreel.Error) as raised:
            simreel.sweep(file, {"objects.flag.cloth.fabrik": ["silk"]}, frames=1)
        self.assertEqual((raised.exception.kind, raised.exception.path, raised.exception.suggestion),
                         ("scene", "objects.flag.cloth.fabrik", "fabric"))
        with self.assertRaises(simreel.Error) as raised:
            simreel.sweep(file, {"seed": [1, 2], "objects.flag.cloth.fabric": ["silk", "slk"]}, frames=1)
        self.assertEqual(raised.exception.path, "objects.flag.cloth.fabric")
        file.write_text(file.read_text().replace('"cloth"', '"clth"'))
        with self.assertRaises(simreel.Error) as raised:
            simreel.sweep(file, {"seed": [1]}, frames=1)
        self.assertEqual((raised.exception.file, raised.exception.suggestion), (str(file), "cloth"))
        self.assertGreater(raised.exception.line, 0)
        for values, message in (({}, "nothing varies; give a list"), ({"seed": []}, "there are no values of seed"), ({"seed": "12"}, "the values of seed are a list")):
            with self.assertRaisesRegex((simreel.Error, TypeError), message):
                simreel.sweep(file, values)
        with self.assertRaisesRegex(simreel.Error, "jobs is at least 1"):
            simreel.sweep(file, {"seed": [1]}, jobs=0)

    def test_sweeps_of_several_threads_do_not_meet(self):
        found = {}

        def work(i):
            found[i] = simreel.sweep(self.folder / "scene.json", {"seed": [i, i + 10]}, jobs=2, frames=1)
        scene = self.scene()
        threads = [threading.Thread(target=work, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        scene.step(5)
        for thread in threads:
            thread.join()
        self.assertEqual({i: [row["seed"] for row in one.rows()] for i, one in found.items()}, {0: [0, 10], 1: [1, 11]})


class Views(ModuleCase):
    def viewer(self, view):
        from serve_client import Viewer
        port, token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/(\w+)/", view.url).groups()
        viewer = Viewer(int(port), token)
        self.addCleanup(viewer.close)
        return viewer

    def test_a_view_shows_the_written_state_and_ends_with_the_scene(self):
        scene = self.scene()
        scene.step(2)
        scene["flag"].positions += 0.25
        with scene.serve() as view:
            self.assertIn(f'<iframe src="{view.url}"', view._repr_html_())
            with urllib.request.urlopen(view.url) as page:
                self.assertNotIn("frame-ancestors", str(page.headers))
            viewer = self.viewer(view)
            about, picture = viewer.rest(2)
            self.assertEqual((about["frame"], about["state"]), (2, scene.state_hash))
            self.assert_same(picture_of(picture)[..., :3], numpy.asarray(scene.image()))
            viewer.send(do="seek", frame=0)  # not before the state that the view began with
            viewer.send(do="seek", frame=4)
            self.assertEqual(viewer.rest(4)[0]["state"], scene.advance_to(4).state_hash)
            scene["flag"].velocities = 1
            view.update()
            written = scene.state_hash
            viewer.until(lambda kind, message: kind == "picture" and message[0]["state"] == written)
        self.assertFalse(view.running)
        other = scene.serve()
        scene.close()
        self.assertFalse(other.running)
        self.assertIn("ended", other._repr_html_())

    def test_a_view_ends_with_python_also_if_that_is_killed(self):
        code = ("import os, signal, simreel\nscene = simreel.Scene(objects={'flag': {'cloth': {'size': [9, 7]}}})\n"
                "print(scene.serve().url, flush=True)\nos.kill(os.getpid(), signal.SIGKILL)")
        done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, check=False)
        address = urllib.parse.urlparse(done.stdout.strip())
        for _ in range(200):
            with socket.socket() as probe:
                if probe.connect_ex((address.hostname, address.port)) != 0:
                    return
            time.sleep(0.05)
        self.fail("the server still listens")


if __name__ == "__main__":
    unittest.main()
