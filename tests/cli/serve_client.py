"""Shared by tests and benchmark of `simreel serve`: the server as a child process, and a WebSocket client (RFC 6455)
that uses only the standard library."""
import base64
import http.client
import json
import os
import re
import signal
import socket
import struct
import subprocess
import time

from common import PATIENCE, PROGRAM


class Server:
    """Runs `simreel serve` with these arguments, on a port that the server chooses."""

    def __init__(self, *arguments, cwd=None, env=None, program=PROGRAM):
        command = [str(program), "serve", *map(str, arguments)]
        self.child = subprocess.Popen(command, cwd=cwd, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.lines = [self.child.stdout.readline() for _ in range(3)]
        found = re.match(r"Open http://([\d.]+):(\d+)/([0-9a-f]{32})/$", self.lines[0].strip())
        if not found:
            self.child.kill()
            raise AssertionError(f"no address: {self.lines} {self.child.stderr.read()}")
        self.address, self.port, self.token = found[1], int(found[2]), found[3]

    @property
    def page(self):
        return f"http://127.0.0.1:{self.port}/{self.token}/"

    def get(self, path, method="GET", host=None, headers=None, timeout=PATIENCE):
        """Returns status, headers and body of a request for `path`; the path is sent unmodified."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
            connection.putheader("Host", host if host is not None else f"127.0.0.1:{self.port}")
            for name, value in (headers or {}).items():
                connection.putheader(name, value)
            connection.endheaders()
            answer = connection.getresponse()
            return answer.status, answer.headers, answer.read()
        except http.client.RemoteDisconnected:
            return 0, {}, b""  # The server closed the connection without an answer.
        finally:
            connection.close()

    def viewer(self, **options):
        return Viewer(self.port, self.token, **options)

    def stop(self, sent=signal.SIGTERM):
        if self.child.poll() is None:
            self.child.send_signal(sent)
        out, err = self.child.communicate(timeout=PATIENCE)
        return self.child.returncode, out, err


def files_of(picture):
    """Returns the PNG or JPEG files of a picture: one, or those of both sides and possibly their difference."""
    about, data = picture
    files, at = [], 0
    for size in about.get("files", [len(data)]):
        files.append(data[at:at + size])
        at += size
    assert at == len(data), (about, len(data))
    return files


class Refused(Exception):
    """Raised if the server refuses the WebSocket."""


class Closed(Exception):
    """Raised when the connection has ended; holds the code of the close frame, or None."""


class Viewer:
    """A WebSocket connection. `latest` holds the newest message of each kind; `pictures` are (about, bytes)."""

    def __init__(self, port, token, origin="same", host=None, path=None, acknowledges=True, timeout=PATIENCE):
        self.acknowledges = acknowledges
        self.latest, self.pictures, self.heard = {}, [], []
        self.buffer = self.taken = b""
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=timeout)
        # Browsers set this option as well. Otherwise, a second small message waits 40 ms for the acknowledgement of the
        # first one.
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        host = host or f"127.0.0.1:{port}"
        lines = [f"GET {path if path is not None else f'/{token}/live'} HTTP/1.1", f"Host: {host}",
                 "Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13",
                 f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}", "Sec-WebSocket-Protocol: simreel"]
        if origin is not None:
            lines.append(f"Origin: {f'http://{host}' if origin == 'same' else origin}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        head = b""
        while b"\r\n\r\n" not in head:
            try:
                piece = self.socket.recv(4096)
            except OSError as error:
                raise Refused(str(error)) from error
            if not piece:
                raise Refused(head.decode("latin-1"))
            head += piece
        head, self.buffer = head.split(b"\r\n\r\n", 1)
        if not head.startswith(b"HTTP/1.1 101"):
            raise Refused(head.decode("latin-1"))

    def close(self):
        self.socket.close()

    def send_frame(self, payload, opcode=1, final=True):
        mask = os.urandom(4)
        head = bytes([(0x80 if final else 0) | opcode])
        size = len(payload)
        if size < 126:
            head += bytes([0x80 | size])
        elif size < 65536:
            head += bytes([0x80 | 126]) + struct.pack(">H", size)
        else:
            head += bytes([0x80 | 127]) + struct.pack(">Q", size)
        repeated = (mask * (size // 4 + 1))[:size]
        masked = (int.from_bytes(payload, "big") ^ int.from_bytes(repeated, "big")).to_bytes(size, "big") if size else b""
        self.socket.sendall(head + mask + masked)

    def send(self, **request):
        self.send_frame(json.dumps(request).encode())

    def _bytes(self, count):
        while len(self.buffer) < count:
            left = self.end - time.monotonic()  # Received pings do not extend the time limit.
            if left <= 0:
                raise TimeoutError
            self.socket.settimeout(left)
            piece = self.socket.recv(65536)
            if not piece:
                raise Closed()
            self.buffer += piece
        piece, self.buffer = self.buffer[:count], self.buffer[count:]
        self.taken += piece
        return piece

    def receive(self, timeout=PATIENCE):
        """Returns the next whole message, (kind, message); a picture's kind is "picture"."""
        self.end = time.monotonic() + timeout
        self.taken = b""
        try:
            return self._receive()
        except TimeoutError:
            # The time may end in the middle of a message. The next call continues with the received bytes.
            self.buffer = self.taken + self.buffer
            raise

    def _receive(self):
        whole, opcode = b"", None
        while True:
            first, second = self._bytes(2)
            size = second & 127
            if size == 126:
                (size,) = struct.unpack(">H", self._bytes(2))
            elif size == 127:
                (size,) = struct.unpack(">Q", self._bytes(8))
            payload = self._bytes(size)
            kind = first & 15
            if kind == 8:
                raise Closed(struct.unpack(">H", payload[:2])[0] if len(payload) >= 2 else None)
            if kind == 9:
                self.send_frame(payload, 10)
                continue
            opcode = opcode or kind
            whole += payload
            if first & 0x80:
                break
        if opcode == 1:
            message = json.loads(whole)
            self.latest[message["kind"]] = message
            self.heard.append(message)
            return message["kind"], message
        end = whole.index(b"\n")
        picture = (json.loads(whole[:end]), whole[end + 1:])
        self.pictures.append(picture)
        if self.acknowledges:
            self.send_frame(f"shown {picture[0]['number']}".encode())
        return "picture", picture

    def until(self, good, seconds=PATIENCE):
        """Receives until good(kind, message) is true; returns that message."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            try:
                kind, message = self.receive(left)
            except TimeoutError:
                break
            if good(kind, message):
                return message
        raise AssertionError(f"nothing of the kind in {seconds} s; latest {self.latest}")

    def rest(self, frame=None):
        """Waits for the full-quality picture of a frame."""
        return self.until(lambda kind, message: kind == "picture" and not message[0]["draft"] and
                          not message[0]["carried"] and frame in (None, message[0]["frame"]))
