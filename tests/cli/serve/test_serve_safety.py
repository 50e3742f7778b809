"""Tests `simreel serve`: access rights, malformed requests, and command-line options."""
import http.client
import json
import resource
import signal
import socket
import time
import unittest

from common import PATIENCE, SCENE
from serve_case import ServeCase
from serve_client import Closed, Refused, Server


class Safety(ServeCase):
    def test_requests_need_the_token(self):
        server = self.serve()
        status, headers, body = server.get(f"/{server.token}/")
        self.assertEqual(status, 200)
        self.assertIn(b"<!doctype html>", body)
        self.assertIn("default-src 'none'", headers["content-security-policy"])
        self.assertNotIn("unsafe", headers["content-security-policy"])
        self.assertEqual(headers["x-content-type-options"], "nosniff")
        self.assertEqual(headers["referrer-policy"], "no-referrer")
        self.assertIn("frame-ancestors 'none'", headers.get_all("content-security-policy"))
        self.assertEqual(headers["x-frame-options"], "DENY")
        wrong = ("0" if server.token[0] != "0" else "1") + server.token[1:]
        for path in ("/", "/index.html", f"/{wrong}/", f"/{server.token}", f"/{server.token[:-1]}/", "/live", "//"):
            self.assertEqual(server.get(path)[0], 403, path)
        for path in (f"/{wrong}/live", "/live", f"/{server.token}/other", f"/{server.token}live"):
            with self.assertRaises(Refused, msg=path):
                server.viewer(path=path)
        self.assertEqual(server.get(f"/{server.token}/app.js", method="POST")[0], 405)
        self.assertNotIn(server.token, repr(server.get(f"/{server.token}/app.js")[2]))

    def test_requests_must_come_from_this_machine_and_page(self):
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

    def test_no_other_files_are_served(self):
        server = self.serve()
        for tail in ("../scene.json", "%2e%2e/scene.json", "..%2fscene.json", "scene.json", "../../../../etc/passwd",
                     "%2fetc%2fpasswd", "//etc/passwd", "app.js/..", "app.js%00.html", "./././../etc/passwd",
                     "..\\scene.json", "%c0%ae%c0%ae/scene.json", "page/app.js", "a" * 3000):
            status, _, body = server.get(f"/{server.token}/{tail}")
            self.assertIn(status, (0, 400, 403, 404, 414), tail)
            self.assertNotIn(b"root:", body)
            self.assertNotIn(b"cloth", body)

    def test_invalid_messages_are_refused(self):
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

    def test_oversized_messages_close_only_their_connection(self):
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
                pass  # The server closed the connection before all data were sent.
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

    def test_slow_and_vanished_viewers_do_not_block_others(self):
        server = self.serve("--size", "320x180")
        quick, slow = server.viewer(), server.viewer(acknowledges=False)
        quick.rest(0)
        for _ in range(5):  # These viewers disconnect in the middle of a picture.
            viewer = server.viewer()
            viewer.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
            viewer.close()
        quick.send(do="play")
        before = len(quick.pictures)
        while len(quick.pictures) - before < 12:
            quick.receive()
        quick.send(do="pause")
        quick.send(do="seek", frame=3)
        last = quick.rest(3)[0]["number"]
        # The slow viewer gets the two pictures in flight. After it confirms them, it gets the latest one.
        slow.send_frame(f"shown {last}".encode())
        slow.until(lambda kind, message: kind == "picture" and message[0]["number"] == last)
        self.assertLessEqual(len(slow.pictures), 3)

    def test_half_open_connections_do_not_block_others(self):
        """Connections that never send a request or the token."""
        server = self.serve()
        held = [socket.create_connection(("127.0.0.1", server.port), timeout=60) for _ in range(200)]
        for one in held:
            try:
                one.sendall(b"GET /")
            except OSError:
                pass  # The server has closed the connection already.
        begin = time.monotonic()
        self.assertEqual(server.get(f"/{server.token}/app.js")[0], 200)
        held.append(server.viewer().socket)
        # The viewer must be served before the other connections time out after 10 s.
        self.assertLess(time.monotonic() - begin, 8)
        for one in held:
            one.close()

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
                held.append(socket.create_connection(("127.0.0.1", server.port), timeout=60))
            except OSError:
                break
        viewer.send(do="seek", frame=1)
        self.assertEqual(viewer.rest(1)[0]["frame"], 1)
        for one in held:
            one.close()
        end = time.monotonic() + PATIENCE
        while True:
            try:
                self.assertEqual(server.get(f"/{server.token}/app.js")[0], 200)
                break
            except (OSError, http.client.HTTPException):
                self.assertLess(time.monotonic(), end)
                time.sleep(0.2)
        for _ in range(300):  # opens many connections, one after another
            self.assertEqual(server.get("/")[0], 403)

    def test_only_one_viewer_edits(self):
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


class CommandLine(ServeCase):
    def test_the_address_is_printed(self):
        server = self.serve("--port", "0")
        self.assertEqual(server.lines[1], f"From another machine, first: ssh -N -L {server.port}:127.0.0.1:{server.port} {socket.gethostname()}\n")
        again = self.run_program("serve", "scene.json", "--port", server.port)
        self.assertEqual(again.returncode, 6)
        self.assertIn("cannot listen at 127.0.0.1", again.err)

    def test_bad_calls(self):
        self.assertEqual(self.run_program("serve", "-").returncode, 2)
        self.assertEqual(self.run_program("serve", "none.json").returncode, 2)
        self.assertEqual(self.run_program("serve", "scene.json", "--bind", "elsewhere").returncode, 2)
        self.bad(2, "--output scene.json: this is a file", "serve", "scene.json", "-o", "scene.json")
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
