"""Tests simreel trace and simreel bisect. Changed shaders ($SIMREEL_GLSL), or a script that calls the program with
further arguments, stand in for another build."""
import array
import json
import os
import pathlib
import shlex
import signal
import struct
import subprocess
import time

from common import PATIENCE, PROGRAM, SCENE, main, with_values
from golden_common import GoldenCase

GRAVITY = ("cloth/model.glsl", "force * here.w + vec3(stepData.gravity);",
           "force * here.w + vec3(stepData.gravity) * 1.01f;")
PUSH = ("collide/model.glsl", "precise vec3 pushed = m.position + normal * touch.depth - slid * held;",
        "precise vec3 pushed = m.position + normal * (touch.depth * 1.01f);")
# A sheet falls flat except for its jitter, so particles reach the ground one after another.
HEIGHT, MARGIN = 0.5, 0.01
FALLING = with_values({"ground": {"height": HEIGHT}, "time.duration": 0.6, "objects.flag.cloth.pins": [],
                       "objects.flag.cloth.position": [0, 0.8, 0], "objects.flag.cloth.rotation": [0, 0, 0],
                       "objects.flag.cloth.margin": MARGIN})
PROGRAM_WORD = shlex.quote(str(pathlib.Path(PROGRAM).resolve()) if os.sep in PROGRAM else PROGRAM)


def read_dump(data):
    """Returns the header, and the 32-bit words of each array by name."""
    head, _, body = data.partition(b"\n")
    header = json.loads(head)
    arrays = {}
    for one in header["arrays"]:
        words = array.array("I", body[:one["elements"] * 16])
        arrays[f"{one['object']}.{one['array']}"] = words
        body = body[one["elements"] * 16:]
    assert not body
    return header, arrays


def as_float(word):
    return struct.unpack("<f", struct.pack("<I", word))[0]


def place(word):
    """Maps the bits of a float to an integer in numerical order, for distances in ulps."""
    return -(word & 0x7fffffff) if word >> 31 else word


class BisectCase(GoldenCase):
    def lines(self, *arguments, **options):
        return [json.loads(line) for line in self.good("trace", "scene.json", *arguments, **options).stdout.splitlines()]

    def dump(self, frame, step, **options):
        return read_dump(self.good("trace", "scene.json", f"--dump={frame}:{step}", "-o", "-", **options).stdout)[1]

    def mutated(self, mutation):
        """Returns the environment and the command of another build."""
        env = self.mutated_glsl(*mutation)
        return env, f"env SIMREEL_GLSL={shlex.quote(env['SIMREEL_GLSL'])} {PROGRAM_WORD}"

    def script(self, text):
        """Returns a command that stands in for another simreel."""
        path = self.write("other simreel", "#!/bin/sh\n" + text + "\n")
        path.chmod(0o755)
        return shlex.quote(str(path))

    def bisect(self, code, *arguments):
        done = self.run_program("bisect", "scene.json", "--json", *arguments)
        self.assertEqual(done.returncode, code, done.err)
        return json.loads(done.stdout)

    def check_against_dumps(self, found, env):
        """Checks that the reported difference agrees with dumps of both sides, and that the dumps of the previous step
        are equal."""
        frame, step = found["frame"], found["step"]
        before = (frame, step - 1) if step > 1 else (frame - 1, found["steps"])
        if before[0] == 0:
            before = (0, 0)
        self.assertEqual(self.dump(*before), self.dump(*before, env=env))
        here, there = self.dump(frame, step), self.dump(frame, step, env=env)
        name = f"{found['object']}.{found['array']}"
        ours, theirs = here[name], there[name]
        differing = [i for i in range(len(ours) // 4) if ours[4 * i:4 * i + 4] != theirs[4 * i:4 * i + 4]]
        self.assertEqual(found["element"], differing[0])
        first = slice(4 * differing[0], 4 * differing[0] + 4)
        for side, words in (("here", ours), ("there", theirs)):
            self.assertEqual(found[side]["bits"], [f"0x{word:08x}" for word in words[first]])
            self.assertEqual(found[side]["values"], [as_float(word) for word in words[first]])
        listed = {f"{one['object']}.{one['array']}": one for one in found["arrays"]}
        for key, words in here.items():
            other = there[key]
            count = sum(words[i:i + 4] != other[i:i + 4] for i in range(0, len(words), 4))
            self.assertEqual(listed.get(key, {"differing": 0})["differing"], count)
            if count:
                apart = max(abs(place(a) - place(b)) for a, b in zip(words, other))
                self.assertEqual(listed[key]["mostUlps"], apart)
        return here


class Trace(BisectCase):
    def test_frames(self):
        self.write("scene.json", with_values({"time.start": 0.1}))
        header, *frames = self.lines()
        self.assertEqual([line["frame"] for line in frames], list(range(-3, 6)))
        self.assertEqual(header["firstFrame"], -3)
        self.assertEqual([(a["object"], a["array"], a["elements"], a["stepsPerFrame"]) for a in header["arrays"]],
                         [("flag", "positions", 63, 4), ("flag", "velocities", 63, 4)])
        self.assertTrue(header["driver"] and header["version"] and header["fingerprint"])
        self.assertEqual(len({line["arrays"]["flag.positions"] for line in frames}), 9)
        for words, expected in (("--frames=-2-1", [-2, -1, 0, 1]), ("--frames=start--2", [-3, -2]), ("--frames=4", [4]),
                                ("--frames=-3--3", [-3]), ("--frames=5-7", [5, 6, 7])):
            part = self.lines(words)[1:]
            self.assertEqual([line["frame"] for line in part], expected)
            self.assertEqual([line for line in part if line["frame"] < 6],
                             [line for line in frames if line["frame"] in expected])

    def test_steps_and_dumps_agree_with_frames(self):
        frame = self.lines("--frames=3")[1]
        steps = self.lines("--steps-of=3")[1:]
        self.assertEqual([(s["frame"], s["object"], s["step"], s["steps"]) for s in steps],
                         [(3, "flag", k, 4) for k in (1, 2, 3, 4)])
        self.assertEqual(steps[-1]["arrays"], frame["arrays"])
        self.assertEqual(len({s["arrays"]["flag.velocities"] for s in steps}), 4)
        dumps = [self.dump(3, step)["flag.positions"].tobytes() for step in (1, 2, 3, 4)]
        self.assertEqual(len(set(dumps)), 4)
        self.good("trace", "scene.json", "--dump", "3:4", "-o", "state.bin")
        header, arrays = read_dump((self.folder / "state.bin").read_bytes())
        self.assertEqual((header["frame"], header["step"]), (3, 4))
        self.assertEqual(arrays["flag.positions"].tobytes(), dumps[3])

    def test_scene_options_change_the_trace(self):
        plain = self.lines("--frames=5")[1]
        self.assertEqual(self.lines("--frames=5")[1], plain)
        for change in (["--seed", "9"], ["--fps", "31"], ["-D", "objects.flag.cloth.mass=1.01"]):
            self.assertNotEqual(self.lines("--frames=5", *change)[1], plain, change)
        for path in ("storage", "texel"):
            header, line = self.lines("--frames=5", "--memory-path", path)
            self.assertEqual((header["memoryPath"], line), (path, plain))

    def test_mistakes(self):
        trace = ("trace", "scene.json")
        for words, arguments in {
            "exclude each other": ["--frames=1", "--steps-of=1"],
            "say where": ["--dump=1:1"],
            "add --dump": ["-o", "x"],
            "--frames takes": ["--frames=some"],
            "runs backwards": ["--frames=5-2"],
            "starts at frame 0": ["--frames=-1-2"],
            "FRAME:STEP": ["--dump=1", "-o", "x"],
            "steps 1 to 4, not 5": ["--dump=1:5", "-o", "x"],
            "steps 1 to 4, not 0": ["--dump=1:0", "-o", "x"],
            "dump it with 0:0": ["--dump=0:1", "-o", "x"],
            "is the initial state": ["--steps-of=0"],
        }.items():
            self.bad(2, words, *trace, *arguments)
        self.assertFalse((self.folder / "x").exists())
        self.bad(6, "nowhere/x", *trace, "--dump=1:1", "-o", "nowhere/x")

    def test_a_closed_reader_ends_the_trace(self):
        """The simulation would take a day; the reader closes the pipe after two lines."""
        with subprocess.Popen([PROGRAM, "trace", "scene.json", "--frames=0-2000000"], cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.assertIn(b'"trace"', process.stdout.readline())
            self.assertIn(b'"frame":0', process.stdout.readline())
            process.stdout.close()
            self.assertEqual(process.wait(timeout=PATIENCE), 128 + signal.SIGPIPE)
            self.assertRegex(process.stderr.read(), rb"\Asimreel: warning: frame 2000000 is beyond [^\n]*\n\Z")

    def test_a_full_disk(self):
        with open("/dev/full", "wb") as full:
            self.bad(6, "standard output", "trace", "scene.json", stdout=full)

    def test_a_diverged_simulation_ends_the_trace(self):
        """The frames before the lost state are printed, then the device error."""
        lost = ["-D", "objects.flag.cloth.stiffness=1e7", "-D", "objects.flag.cloth.mass=0.01"]
        done = self.bad(4, "blew up", "trace", "scene.json", *lost)
        self.assertIn(b'"frame":0', done.stdout)


class Bisect(BisectCase):
    def test_equal_sides_have_no_difference(self):
        found = self.bisect(0)
        self.assertFalse(found["different"])
        self.assertIsNone(found["difference"])
        self.assertEqual((found["firstFrame"], found["lastFrame"]), (0, 5))
        done = self.good("bisect", "scene.json")
        self.assertIn(b"The same state, bit for bit, over 6 frames (0 to 5).", done.stdout)
        self.assertIn("with itself", done.err)
        for against in (["--against", PROGRAM_WORD], ["--against-memory-path", "storage"],
                        ["--memory-path", "storage", "--against-memory-path", "texel"]):
            done = self.good("bisect", "scene.json", *against)
            self.assertIn(b"The same state", done.stdout)
            self.assertNotIn("with itself", done.err)

    def test_a_changed_constant_is_found_in_the_first_step(self):
        env, against = self.mutated(GRAVITY)
        found = self.bisect(1, "--against", against)
        self.assertTrue(found["different"])
        found = found["difference"]
        self.assertEqual((found["frame"], found["step"], found["steps"]), (1, 1, 4))
        self.assertEqual(found["object"], "flag")
        self.check_against_dumps(found, env)
        done = self.run_program("bisect", "scene.json", "--against", against)
        self.assertEqual(done.returncode, 1)
        text = done.stdout.decode()
        x, y = found["element"] % 9, found["element"] // 9
        self.assertIn(f"First difference: frame 1, step 1 of 4: flag.{found['array']}, particle ({x}, {y})", text)
        self.assertEqual(found["elementName"], f"particle ({x}, {y})")
        for side in ("here", "there"):
            for bits in found[side]["bits"]:
                self.assertIn(bits, text)
        self.assertIn(f"{found['arrays'][0]['differing']} of 63 elements differ", text)

    def test_a_changed_contact_is_found_at_the_first_contact(self):
        self.write("scene.json", FALLING)
        env, against = self.mutated(PUSH)
        found = self.bisect(1, "--against", against)["difference"]
        self.assertGreater(found["frame"], 2)
        self.assertEqual(found["array"], "positions")
        self.assertLess(found["arrays"][0]["differing"], 63)  # Only some particles have reached the ground.
        here = self.check_against_dumps(found, env)
        step = (found["frame"], found["step"] - 1) if found["step"] > 1 else (found["frame"] - 1, 4)
        before = self.dump(*step)
        lowest = HEIGHT + MARGIN - 1e-6
        self.assertTrue(all(as_float(y) > lowest for y in before["flag.positions"][1::4]))
        self.assertAlmostEqual(as_float(here["flag.positions"][4 * found["element"] + 1]), HEIGHT + MARGIN, 6)
        # With only the frames before the difference, both sides are equal.
        self.bisect(0, "--against", against, "--frames", str(found["frame"]))
        self.bisect(1, "--against", against, "--frames", str(found["frame"] + 1))

    def test_a_difference_in_the_pre_roll_is_found(self):
        self.write("scene.json", with_values({"time.start": 0.2}))
        _, against = self.mutated(GRAVITY)
        found = self.bisect(1, "--against", against)["difference"]
        self.assertEqual((found["frame"], found["step"]), (-5, 1))

    def test_a_difference_in_the_first_state_is_found(self):
        found = self.bisect(1, "--against", self.script(f'exec {PROGRAM_WORD} "$@" -D objects.flag.cloth.jitter=0.011'))
        self.assertEqual((found["difference"]["frame"], found["difference"]["step"]), (0, 0))
        done = self.run_program("bisect", "scene.json", "--against", shlex.quote(str(self.folder / "other simreel")))
        self.assertIn(b"the first state, before any step: flag.positions, particle (", done.stdout)

    def test_the_differing_object_of_two_is_found(self):
        """The scene's second object differs; its first does not."""
        cloth = SCENE["objects"]["flag"]["cloth"]
        self.write("scene.json", with_values({"objects.sail": {"cloth": {**cloth, "substeps": 7, "mass": 2}}}))
        against = self.script(f'exec {PROGRAM_WORD} "$@" -D objects.sail.cloth.damping=4.9')
        found = self.bisect(1, "--against", against)["difference"]
        self.assertEqual((found["object"], found["frame"], found["step"], found["steps"]), ("sail", 1, 1, 7))
        self.assertTrue(all(one["object"] == "sail" for one in found["arrays"]))

    def test_options_and_names_reach_the_other_side(self):
        name = "it's a \"scene\" $HOME;.json"
        self.write(name, SCENE)
        arguments = ("-D", "objects.flag.cloth.mass=1.5", "--seed", "7", "--fps", "24")
        self.write("args.py", "import json, sys\njson.dump(sys.argv[1:], open('args.json', 'w'))\n")
        against = self.script(f'[ -f args.json ] || python3 args.py "$@"\nexec {PROGRAM_WORD} "$@"')
        self.good("bisect", name, *arguments, "--against", against)
        given = json.loads((self.folder / "args.json").read_text(encoding="utf-8"))
        self.assertEqual(given[0], "trace")
        for word in (name, "objects.flag.cloth.mass=1.5", "--seed=7", "--fps=24"):
            self.assertIn(word, given)

    def test_a_nondeterministic_side_is_reported(self):
        env, _ = self.mutated(GRAVITY)
        changed = f"SIMREEL_GLSL={shlex.quote(env['SIMREEL_GLSL'])} exec {PROGRAM_WORD} \"$@\""
        for phase, words in (("--frames", "frame 1 differed at first"), ("--steps-of", "step 1 of frame 1 differed")):
            phases = "*--frames*" if phase == "--frames" else "*--frames*|*--steps-of*"
            against = self.script(f'case "$*" in {phases}) {changed};; esac\nexec {PROGRAM_WORD} "$@"')
            done = self.run_program("bisect", "scene.json", "--against", against)
            self.assertEqual(done.returncode, 1, done.err)
            self.assertIn(words, done.stdout.decode())
            self.assertIn("does not repeat itself", done.stdout.decode())


class Failures(BisectCase):
    def bad_side(self, code, words, text):
        self.bad(code, words, "bisect", "scene.json", "--against", self.script(text))

    def test_usage(self):
        self.bad(2, ["--against is empty", "./old/simreel"], "bisect", "scene.json", "--against", " ")
        self.bad(2, "--frames", "bisect", "scene.json", "--frames", "0")
        self.write("still.json", {"version": 1, "objects": {"ball": {"sphere": {}}}})
        self.bad(2, "nothing that is simulated", "bisect", "still.json")
        self.write("broken.json", "{")
        self.bad_scene("broken.json", "bisect", "broken.json")

    def test_sides_with_different_arrays_are_refused(self):
        self.bad_side(2, ["do not simulate the same", "63 elements", "77 elements"],
                      f'exec {PROGRAM_WORD} "$@" -D "objects.flag.cloth.size=[11,7]"')
        self.bad_side(2, ["do not simulate the same", "4 steps", "5 steps"],
                      f'exec {PROGRAM_WORD} "$@" -D objects.flag.cloth.substeps=5')
        self.bad_side(2, ["starts at frame 0", "at frame -3"], f'exec {PROGRAM_WORD} "$@" -D time.start=0.1')

    def test_the_message_of_the_failing_side_is_passed_on(self):
        self.bad_side(2, ["the other side", "status 2", "objects.flag.cloth.nonsense"],
                      f'exec {PROGRAM_WORD} "$@" -D objects.flag.cloth.nonsense=5')
        self.bad_side(4, ["the other side", "status 4", "no device matches"],
                      f'exec {PROGRAM_WORD} "$@" --device nonsense')
        self.bad(4, ["this side", "no device matches"], "bisect", "scene.json", "--device", "nonsense",
                 "--against", PROGRAM_WORD)
        self.bad(4, ["the other side", "no device matches"], "bisect", "scene.json", "--against-device", "nonsense")
        self.bad(6, ["the other side", "status 127", "not found"], "bisect", "scene.json", "--against",
                 "nonexistent-simreel")
        self.bad_side(6, ["the other side", "status 3", "went wrong"], "echo something went wrong >&2; exit 3")

    def test_a_diverged_simulation_is_an_error_of_this_side(self):
        """Both sides lose the state at the same step: the error is reported for this side."""
        lost = ["-D", "objects.flag.cloth.stiffness=1e7", "-D", "objects.flag.cloth.mass=0.01"]
        self.bad(4, ["this side", "blew up"], "bisect", "scene.json", *lost)

    def test_output_that_is_not_a_trace_is_refused(self):
        self.bad_side(6, ["prints no trace", "hello"], "echo hello")
        self.bad_side(6, ["ended before its header"], "exit 0")
        self.bad_side(6, ["prints no trace", "format 9"], f'{PROGRAM_WORD} "$@" | sed \'s/"trace":1/"trace":9/\'')
        self.bad_side(6, ["ended before frame 5"], f'{PROGRAM_WORD} "$@" | head -n 3')
        self.bad_side(6, ["list different steps"], f'{PROGRAM_WORD} "$@" | sed \'s/"frame":2/"frame":7/\'')
        self.bad_side(6, ["the other side ended with status 137"], "kill -9 $$")
        env, _ = self.mutated(GRAVITY)
        change = f"export SIMREEL_GLSL={shlex.quote(env['SIMREEL_GLSL'])}"
        self.bad_side(6, ["the dump is cut off"],
                      f'{change}\ncase "$*" in *--dump*) {PROGRAM_WORD} "$@" | head -c 999;; *) {PROGRAM_WORD} "$@";; esac')

    def gone(self, pid):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                os.kill(pid, 0)
            except ProcessLookupError:
                return True
            time.sleep(0.02)
        return False

    def waiting_pid(self, *names):
        """Returns process ids that the scripts wrote into files."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            texts = [(self.folder / name).read_text() if (self.folder / name).exists() else "" for name in names]
            if all(text.endswith("\n") for text in texts):
                return [int(text) for text in texts]
            time.sleep(0.02)
        self.fail("the script did not start")

    def test_no_child_is_left_after_an_error(self):
        """The other side starts a child process that would keep sleeping."""
        against = self.script("sleep 100000 &\necho $! > sleeping\necho hello\nwait")
        self.bad(6, "prints no trace", "bisect", "scene.json", "--against", against)
        self.assertTrue(self.gone(*self.waiting_pid("sleeping")))

    def test_interrupted(self):
        against = self.script("sleep 100000 &\necho $! > sleeping\nwait")
        for number in (signal.SIGINT, signal.SIGTERM):
            (self.folder / "sleeping").unlink(missing_ok=True)
            process = self.start("bisect", "scene.json", "--against", against)
            pids = self.waiting_pid("sleeping")
            process.send_signal(number)
            messages = process.communicate(timeout=PATIENCE)[1].decode()
            self.assertEqual(process.returncode, 128 + number, messages)
            self.assertTrue(self.gone(*pids))


if __name__ == "__main__":
    main()
