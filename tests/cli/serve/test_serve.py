"""`simreel serve`: who may talk to it, what it does with those who talk badly, and that its pictures are those of
`simreel render`."""
import http.client
import json
import os
import resource
import signal
import socket
import time
import unittest

from common import PROGRAM, SCENE, Case, with_values
from serve_client import Closed, Refused, Server

os.environ.setdefault("SIMREEL", PROGRAM)


class ServeCase(Case):
    def serve(self, *arguments, scene="scene.json"):
        server = Server(self.folder / scene, *arguments, cwd=self.folder)
        self.addCleanup(self.end, server)
        return server

    def end(self, server, expected=(128 + signal.SIGTERM,)):
        code, _, err = server.stop()
        self.assertIn(code, expected, err)
        self.assertNotIn("error", err)

    def rendered(self, frame, *arguments, file="scene.json", frames=None):
        """What render makes of a frame. `frames`, "2-8": those that the test asks for, too, by one process; each is rendered
        once."""
        text = (self.folder / file).read_bytes()
        known = self.__dict__.setdefault("pictures", {})
        if (text, arguments, frame) not in known:
            self.good("render", file, "-o", self.folder / "rendered_####.png", "--frames", frames or frame, "--overwrite", *arguments)
            for picture in self.folder.glob("rendered_*.png"):
                known[text, arguments, int(picture.stem[-4:])] = self.pixels(picture.read_bytes())
                picture.unlink()
        return known[text, arguments, frame]

    def pixels(self, png):
        from common import png_rows, unfiltered
        width, height, rows = png_rows(png)
        step = (len(rows) // height - 1) // width
        return width, height, b"".join(unfiltered(rows, step * width, step))


class Safety(ServeCase):
    def test_only_who_has_the_token(self):
        server = self.serve()
        status, headers, body = server.get(f"/{server.token}/")
        self.assertEqual(status, 200)
        self.assertIn(b"<!doctype html>", body)
        self.assertIn("default-src 'none'", headers["content-security-policy"])
        self.assertNotIn("unsafe", headers["content-security-policy"])
        self.assertEqual(headers["x-content-type-options"], "nosniff")
        self.assertEqual(headers["referrer-policy"], "no-referrer")
        wrong = ("0" if server.token[0] != "0" else "1") + server.token[1:]
        for path in ("/", "/index.html", f"/{wrong}/", f"/{server.token}", f"/{server.token[:-1]}/", "/live", "//"):
            self.assertEqual(server.get(path)[0], 403, path)
        for path in (f"/{wrong}/live", "/live", f"/{server.token}/other", f"/{server.token}live"):
            with self.assertRaises(Refused, msg=path):
                server.viewer(path=path)
        self.assertEqual(server.get(f"/{server.token}/app.js", method="POST")[0], 405)
        self.assertNotIn(server.token, repr(server.get(f"/{server.token}/app.js")[2]))

    def test_only_this_machine_and_this_page(self):
        server = self.serve()
        page = f"/{server.token}/"
        for host in ("evil.example", f"evil.example:{server.port}", "127.0.0.1.evil.example", "10.0.0.1", "",
                     f"localhost:{server.port}x", "127.0.0.1:"):
            self.assertIn(server.get(page, host=host)[0], (0, 400, 403), host)
        for host in ("localhost", f"localhost:{server.port}", "127.0.0.1:9", "[::1]:80"):
            self.assertEqual(server.get(page, host=host)[0], 200, host)
        good = f"127.0.0.1:{server.port}"
        for origin in ("http://evil.example", "null", f"https://{good}", f"http://{good}.evil.example", None,
                       "http://127.0.0.1:1"):
            with self.assertRaises(Refused, msg=origin):
                server.viewer(origin=origin)
        with self.assertRaises(Refused):
            server.viewer(host="evil.example", origin="http://evil.example")
        server.viewer().close()

    def test_nothing_of_the_file_system(self):
        server = self.serve()
        for tail in ("../scene.json", "%2e%2e/scene.json", "..%2fscene.json", "scene.json", "../../../../etc/passwd",
                     "%2fetc%2fpasswd", "//etc/passwd", "app.js/..", "app.js%00.html", "./././../etc/passwd",
                     "..\\scene.json", "%c0%ae%c0%ae/scene.json", "page/app.js", "a" * 3000):
            status, _, body = server.get(f"/{server.token}/{tail}")
            self.assertIn(status, (0, 400, 403, 404, 414), tail)
            self.assertNotIn(b"root:", body)
            self.assertNotIn(b"cloth", body)

    def test_messages_that_are_none(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        for text in ("", "{", "[]", "3", "null", '"x"', '{"do":3}', '{"do":"burn"}', '{"do":"seek"}',
                     '{"do":"seek","frame":1e99}', '{"do":"seek","frame":0.5}', '{"do":"set","path":"a"}', '{"do":"set","path":"..","value":1}',
                     '{"do":"camera","position":[1],"target":[0,0,0]}', '{"asks":"x"}', "[" * 3000, '{"do":"set","path":"objects.ghost.cloth.size","value":[3,3]}',
                     '{"do":"set","path":"render.samples","value":3000}', "shown 99999999999999999999999", "\x00\xff"):
            viewer.send_frame(text.encode("latin-1"))
        viewer.send(do="seek", frame=2)
        self.assertEqual(viewer.rest(2)[0]["frame"], 2)
        self.assertGreater(len([m for m in viewer.heard if m["kind"] == "refused"]), 14)
        self.assertEqual(json.loads((self.folder / "scene.json").read_text()), SCENE)

    def test_oversized_messages_end_their_connection_alone(self):
        server = self.serve()
        other = server.viewer()
        for pieces in (1, 9):
            viewer = server.viewer()
            try:
                for i in range(pieces):
                    viewer.send_frame(b"x" * (200_000 // pieces), 1 if i == 0 else 0, i + 1 == pieces)
                with self.assertRaises((Closed, OSError)):
                    while True:
                        viewer.receive(10)
            except OSError:
                pass  # it hung up before all was sent
            viewer.close()
        raw = socket.create_connection(("127.0.0.1", server.port))
        raw.settimeout(20)
        try:
            raw.sendall(b"GET /" + b"a" * 500_000)
            raw.recv(100)
        except OSError:
            pass
        raw.close()
        other.rest(0)

    def test_viewers_that_are_slow_or_vanish(self):
        server = self.serve("--size", "320x180")
        quick, slow = server.viewer(), server.viewer(acknowledges=False)
        quick.rest(0)
        for _ in range(5):  # gone in the middle of a picture
            viewer = server.viewer()
            viewer.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
            viewer.close()
        quick.send(do="play")
        before = len(quick.pictures)
        end = time.monotonic() + 30
        while len(quick.pictures) - before < 12:
            self.assertLess(time.monotonic(), end)
            quick.receive()
        quick.send(do="pause")
        quick.send(do="seek", frame=3)
        last = quick.rest(3)[0]["number"]
        # Of all those pictures the slow one gets the two that were under way, and once it says so the latest.
        pictures = 0
        try:
            while True:
                kind, message = slow.receive(2)
                pictures += kind == "picture"
        except TimeoutError:
            pass
        self.assertLessEqual(pictures, 2)
        slow.send_frame(f"shown {last}".encode())
        self.assertEqual(slow.until(lambda kind, _: kind == "picture")[0]["number"], last)

    def test_a_thousand_connections(self):
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 4096), hard))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        held = []
        for _ in range(1000):
            try:
                held.append(socket.create_connection(("127.0.0.1", server.port), timeout=5))
            except OSError:
                break
        viewer.send(do="seek", frame=1)
        self.assertEqual(viewer.rest(1)[0]["frame"], 1)
        for one in held:
            one.close()
        end = time.monotonic() + 20
        while True:
            try:
                self.assertEqual(server.get(f"/{server.token}/app.js")[0], 200)
                break
            except (OSError, http.client.HTTPException):
                self.assertLess(time.monotonic(), end)
                time.sleep(0.2)
        for _ in range(300):  # one after the other
            self.assertEqual(server.get("/")[0], 403)

    def test_one_editor(self):
        server = self.serve()
        first, second = server.viewer(), server.viewer()
        first.rest(0)
        second.rest(0)
        second.send(do="seek", frame=2)
        second.until(lambda kind, _: kind == "refused")
        second.send_frame(b"edit")
        second.until(lambda kind, message: kind == "viewers" and message["editor"] == second.latest["you"]["viewer"])
        second.send(do="seek", frame=2)
        second.rest(2)
        self.assertEqual(first.rest(2)[0]["frame"], 2)
        second.close()
        first.until(lambda kind, message: kind == "viewers" and message["editor"] == first.latest["you"]["viewer"])
        first.send(do="seek", frame=1)
        first.rest(1)


class Pictures(ServeCase):
    def test_every_frame_is_that_of_render(self):
        server = self.serve()
        viewer = server.viewer()
        for frame in (0, 5, 2, 4, 0):
            viewer.send(do="seek", frame=frame)
            self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, frames="0-5"))
        viewer.send(do="play")
        viewer.until(lambda kind, message: kind == "status" and message.get("frame", 0) == 5)
        viewer.send(do="pause")
        viewer.send(do="seek", frame=3)
        self.assertEqual(self.pixels(viewer.rest(3)[1]), self.rendered(3))

    def test_with_little_memory_and_a_start(self):
        scene = with_values({"time.start": 0.2, "time.duration": 1, "objects.flag.cloth.size": [300, 200],
                             "objects.flag.cloth.spacing": 0.01, "objects.flag.cloth.substeps": "auto"})
        self.write("scene.json", scene)
        server = self.serve("--memory", "8")
        viewer = server.viewer()
        viewer.send(do="seek", frame=12)
        viewer.rest(12, 240)
        if viewer.latest["status"].get("kept", {}).get("every", 1) <= 1:  # or it was told already
            viewer.until(lambda kind, m: kind == "status" and m.get("kept", {}).get("every", 1) > 1)
        self.assertLessEqual(viewer.latest["status"]["kept"]["bytes"], 8 << 20)
        viewer.send(do="seek", frame=7)
        self.assertEqual(self.pixels(viewer.rest(7)[1]), self.rendered(7))

    def test_motion_blur(self):
        self.write("scene.json", with_values({"camera.shutter": {"angle": 300, "samples": 4}}))
        server = self.serve()
        viewer = server.viewer()
        for frame in (3, 0, 1, 0, 4):
            viewer.send(do="seek", frame=frame)
            self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, frames="0-4"), frame)

    def test_values_that_change(self):
        """In place, with another renderer, another world or from the start: always what render makes of them."""
        server = self.serve()
        viewer = server.viewer()
        viewer.send(do="seek", frame=3)
        viewer.rest(3)
        changes = [("camera.position", [0.5, 1.2, 2.5]), ("camera.fieldOfView", 30), ("camera.roll", 12),
                   ("sun.direction", [1, 0.4, 0.2]), ("sun.color", [1, 0.2, 0.1]), ("sun.intensity", 9),
                   ("sky.zenith", [0.4, 0, 0.1]), ("sky.ambient", 2), ("render.exposure", 1),
                   ("render.vignette", 0.5), ("sun.shadow", False), ("render.samples", 4), ("render.tone", "agx"),
                   ("ground", {"height": 0.2}), ("ground.color", [0.5, 0.1, 0.1]),
                   ("objects.flag.material", {"color": [0.1, 0.2, 0.9]}), ("lights", {"lamp": {"position": [0, 2, 1], "intensity": 5}}),
                   ("time.duration", 0.4), ("objects.flag.cloth.damping", 3), ("seed", 5)]
        given = []
        for path, value in changes:
            with self.subTest(path):
                for moving in (True, False):
                    viewer.send(do="set", path=path, value=value, moving=moving)
                given += ["-D", f"{path}={json.dumps(value)}"]
                viewer.until(lambda kind, message, p=path, v=value: kind == "refused" or (
                    kind == "scene" and any(at == p and json.loads(text) == v for at, text in message["edits"])))
                self.assertNotIn("refused", viewer.latest, viewer.latest.get("refused"))
                end, right = time.monotonic() + 15, self.rendered(3, *given)
                while self.pixels(viewer.rest(3, 15)[1]) != right:
                    self.assertLess(time.monotonic(), end, path)
        self.assertEqual(json.loads((self.folder / "scene.json").read_text()), SCENE)


class Files(ServeCase):
    def test_what_is_saved_is_shown_and_mistakes_stand_at_their_place(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        self.write("scene.json", json.dumps(with_values({"sun.intensity": "bright"}), indent=1))
        scene = viewer.until(lambda kind, message: kind == "scene" and message["mistakes"])
        self.assertRegex(scene["mistakes"], r'scene\.json:\d+:\d+: error: .*')
        self.assertIn("^", scene["mistakes"])
        viewer.send(do="seek", frame=2)  # the last good one goes on
        self.assertEqual(self.pixels(viewer.rest(2)[1])[:2], (64, 36))
        self.write("scene.json", with_values({"sun.intensity": 1}))
        viewer.until(lambda kind, message: kind == "scene" and not message["mistakes"])
        self.assertEqual(self.pixels(viewer.rest(2)[1]), self.rendered(2))
        os.replace(self.write("other.json", with_values({"sun.intensity": 7})), self.folder / "scene.json")
        self.assertEqual(self.pixels(viewer.rest(2)[1]), self.rendered(2))

    def test_a_scene_that_is_wrong_from_the_start(self):
        self.write("scene.json", "{")
        server = self.serve()
        viewer = server.viewer()
        viewer.until(lambda kind, message: kind == "scene" and "scene.json:1" in message["mistakes"])
        self.write("scene.json", SCENE)
        self.assertEqual(self.pixels(viewer.rest(0)[1]), self.rendered(0))

    def test_edit_writes_the_value_alone(self):
        text = ('{\r\n  "version": 1, // the format\n\t"render": {"size": [64, 36], "samples": 1}, "time": {"fps": 30,   "duration": 0.2},\n'
                '  "camera": {"position": [0, 1, 3], /* from the front */ "target": [0, 1, 0]},\n'
                '  "sun": {\n    "shadowSize": 64 // small\n  },\n'
                '  "objects": {"flag": {"cloth": {"size": [9, 7], "spacing": 0.1, "position": [0, 1, 0]}}}\n}\n')
        path = self.write("scene.json", text)
        path.chmod(0o640)
        server = self.serve("--edit")
        viewer = server.viewer()
        viewer.rest(0)

        def saved(request, wanted):
            viewer.send(**request)
            end = time.monotonic() + 20
            while path.read_bytes().decode() != wanted and time.monotonic() < end:
                time.sleep(0.02)
            self.assertEqual(path.read_bytes().decode(), wanted)

        change = {"do": "set", "moving": False}
        text = text.replace("0.2}", "0.4}")
        saved({**change, "path": "time.duration", "value": 0.4}, text)
        text = text.replace('64 // small\n', '64, // small\n    "intensity": 3\n')
        saved({**change, "path": "sun.intensity", "value": 3}, text)
        text = text.replace('"samples": 1}', '"samples": 1, "exposure": -1}')
        saved({**change, "path": "render.exposure", "value": -1}, text)
        text = text.replace('"position": [0, 1, 0]}}}', '"position": [0, 1, 0], "air": {"drag": 2}}}}')
        saved({**change, "path": "objects.flag.cloth.air.drag", "value": 2}, text)
        text = text.replace("[0, 1, 3]", "[0,1,2]")
        saved({"do": "camera", "position": [0, 1, 2], "target": [0, 1, 0], "moving": False},
              text.replace('"target": [0, 1, 0]}', '"target": [0,1,0], "fieldOfView": 40}'))
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)
        viewer.send(**change, path="sun.intensity", value=-5)
        viewer.until(lambda kind, message: kind == "refused")
        self.assertIn('"intensity": 3', path.read_text())
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["scene.json"])

    def test_the_height_of_an_orthographic_camera_is_set_and_saved(self):
        """What the mouse wheel sends of one: its height, and places that stay."""
        camera = {"position": [0, 1, 3], "target": [0, 1, 0], "projection": "orthographic", "height": 2}
        self.write("scene.json", with_values({"camera": camera}))
        server = self.serve("--edit")
        viewer = server.viewer()
        self.assertEqual(self.pixels(viewer.rest(0)[1]), self.rendered(0))
        wide = self.rendered(0, "-D", "camera.height=3.5")
        self.assertNotEqual(wide, self.rendered(0))
        viewer.send(do="camera", position=camera["position"], target=camera["target"], height=3.5, moving=False)
        end = time.monotonic() + 15
        while self.pixels(viewer.rest(0, 15)[1]) != wide:
            self.assertLess(time.monotonic(), end)
        while json.loads((self.folder / "scene.json").read_text())["camera"] == camera:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)
        self.assertEqual(json.loads((self.folder / "scene.json").read_text())["camera"], {**camera, "height": 3.5})

    def test_a_kill_while_saving_leaves_a_whole_file(self):
        filler = "".join(f"// {i:06} {'x' * 60}\n" for i in range(20_000))
        for round_ in range(4):
            path = self.write("scene.json", filler + json.dumps(SCENE))
            server = Server(path, "--edit", cwd=self.folder)
            viewer = server.viewer()
            viewer.rest(0)
            for i in range(12):
                viewer.send(do="set", path="sun.intensity", value=1 + i, moving=False)
            time.sleep(0.05 + 0.1 * round_)
            server.stop(signal.SIGKILL)
            text = path.read_text()
            self.assertTrue(text.startswith(filler))
            found = json.loads(text[len(filler):])
            self.assertIn(found["sun"], [{"shadowSize": 64}] + [{"shadowSize": 64, "intensity": 1 + i} for i in range(12)])

    def test_links_stay_links(self):
        (self.folder / "real.json").write_text(json.dumps(SCENE))
        (self.folder / "scene.json").unlink()
        (self.folder / "scene.json").symlink_to("real.json")
        server = self.serve("--edit")
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(do="set", path="sun.intensity", value=2, moving=False)
        viewer.until(lambda kind, message: kind == "scene" and message["scene"]["sun"].get("intensity") == 2 and not message["edits"])
        self.assertTrue((self.folder / "scene.json").is_symlink())
        self.assertEqual(json.loads((self.folder / "real.json").read_text())["sun"]["intensity"], 2)


class Questions(ServeCase):
    def test_what_a_pixel_shows(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(asks="pixel", x=0.5, y=0.6)
        answer = viewer.until(lambda kind, _: kind == "answer")
        self.assertRegex(answer["title"], r"^triangle \d+ of flag$")
        rows = {name: (value, bits) for name, value, bits in answer["rows"]}
        self.assertRegex(rows["nearest element"][0], r"^particle \(\d, \d\)$")
        for axis in "xyz":
            self.assertLess(abs(rows[f"world {axis}, m"][0] - rows[f"positions.{axis}"][0]), 0.1)
            self.assertRegex(rows[f"positions.{axis}"][1], r"^[0-9a-f]{8}$")
        viewer.send(asks="pixel", x=0.01, y=0.01)
        self.assertEqual(viewer.until(lambda kind, _: kind == "answer")["title"], "the sky")


FIELD = {
    "version": 1,
    "render": {"size": [64, 64], "samples": 1},
    "time": {"fps": 30, "duration": 0.4},
    "objects": {"dish": {"grayScott": {"size": [64, 64], "steps": 4}}},
}


class Painting(ServeCase):
    def test_paint_save_render(self):
        for arguments in ((), ("--edit",)):
            path = self.write("scene.json", FIELD)
            server = self.serve(*arguments)
            viewer = server.viewer()
            viewer.send(do="seek", frame=4)
            before = self.pixels(viewer.rest(4)[1])
            for i in range(3):
                viewer.send(do="paint", **{"from": [0.2 + 0.2 * i, 0.3], "to": [0.4 + 0.2 * i, 0.3]}, radius=3)
            viewer.until(lambda kind, m: kind == "scene" and
                         len(m["scene"]["objects"]["dish"]["grayScott"].get("strokes", [])) == 3 and
                         bool(m["edits"]) != bool(arguments))
            painted = self.pixels(viewer.rest(4)[1])
            given = []
            if arguments:
                self.assertEqual(len(json.loads(path.read_text())["objects"]["dish"]["grayScott"]["strokes"]), 3)
            else:
                self.assertEqual(json.loads(path.read_text()), FIELD)
                given = [word for at, text in viewer.latest["scene"]["edits"] for word in ("-D", f"{at}={text}")]
            self.assertNotEqual(painted, before)
            self.assertEqual(painted, self.rendered(4, *given, frames="2-8"))
            for frame in (8, 2, 6):
                viewer.send(do="seek", frame=frame)
                self.assertEqual(self.pixels(viewer.rest(frame)[1]), self.rendered(frame, *given), frame)

    def test_nothing_to_paint(self):
        server = self.serve()
        viewer = server.viewer()
        viewer.rest(0)
        viewer.send(do="paint", **{"from": [0.5, 0.5], "to": [0.5, 0.5]}, radius=3)
        viewer.until(lambda kind, _: kind == "refused")


class CommandLine(ServeCase):
    def test_it_says_where(self):
        server = self.serve("--port", "0")
        self.assertEqual(server.lines[1], f"From another machine, first: ssh -N -L {server.port}:127.0.0.1:{server.port} {socket.gethostname()}\n")
        again = self.run_program("serve", "scene.json", "--port", server.port)
        self.assertEqual(again.returncode, 6)
        self.assertIn("cannot listen at 127.0.0.1", again.err)

    def test_bad_calls(self):
        self.assertEqual(self.run_program("serve", "-").returncode, 2)
        self.assertEqual(self.run_program("serve", "none.json").returncode, 2)
        self.assertEqual(self.run_program("serve", "scene.json", "--bind", "elsewhere").returncode, 2)
        self.write("glider.rle", "x = 3, y = 3\nbob$2bo$3o!\n")
        self.assertEqual(self.run_program("serve", "glider.rle", "--edit").returncode, 2)

    def test_interrupts(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            server = Server(self.folder / "scene.json")
            server.viewer().rest(0)
            code, _, err = server.stop(sent)
            self.assertEqual((code, err), (128 + sent, ""))


if __name__ == "__main__":
    unittest.main()
