"""Live views: `simreel serve` beside Python, for notebooks and browsers."""
from __future__ import annotations

import html
import pathlib
import re
import subprocess
import threading
import weakref
from typing import TYPE_CHECKING, Any

from ._device import device_words
from ._errors import Error
from ._folder import folder_of
from ._sweep import program

if TYPE_CHECKING:
    from ._scene import Scene

# The shell ends the server when Python closes the pipe, also by being killed.
_WATCHED = 'exec 3<&0; "$@" </dev/null 3<&- & child=$!; { read -r _; kill $child; } <&3 2>/dev/null >/dev/null & ' \
           'watch=$!; exec 3<&-; wait $child; code=$?; kill $watch 2>/dev/null; exit $code'


class View:
    """Live view of a scene: a page of `simreel serve`, which a notebook embeds. It ends with the scene, or by close().

    The page begins at the frame and the state that the scene had. update() shows the scene's present state.
    """

    def __init__(self, scene: Scene, words: list[str], height: int) -> None:
        self._scene, self._height = weakref.ref(scene), height
        self._state = pathlib.Path(folder_of(self, "view")) / "state"
        self._lock = threading.Lock()
        self.update()
        command = [program(), "serve", *words, *device_words(), "--embed", "--from", str(self._state)]
        self._server = subprocess.Popen(["sh", "-c", _WATCHED, "sh", *command], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
        assert self._server.stdout is not None
        found = re.match(r"Open (http://\S+)", self._server.stdout.readline())
        if found is None:
            said = self._server.communicate()[1].strip().removeprefix("simreel: error: ")
            raise Error(f"the live view did not start: {said}", "device" if self._server.returncode == 4 else "usage")
        self.url: str = found[1]  #: address of the page, with its secret token
        for stream in (self._server.stdout, self._server.stderr):
            threading.Thread(target=_drain, args=(stream,), daemon=True).start()
        self._end = weakref.finalize(self, _stop, self._server)
        weakref.finalize(scene, _stop, self._server)

    def update(self) -> None:
        """Shows the scene's present frame and state, also after it was stepped or written."""
        scene = self._scene()
        if scene is None:
            raise Error("the scene of this view is closed")
        with self._lock:
            scene._native.save_state(str(self._state))

    @property
    def running(self) -> bool:
        """True until the server ends."""
        return self._server.poll() is None

    def close(self) -> None:
        """Ends the server."""
        self._end()

    def __enter__(self) -> View:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<simreel.View {self.url}>" if self.running else "<simreel.View: ended>"

    def _repr_html_(self) -> str:
        if not self.running:
            return "<p>The live view has ended.</p>"
        return f'<iframe src="{html.escape(self.url)}" width="100%" height="{self._height}" frameborder="0"></iframe>'


def _drain(stream):
    with stream:
        for _ in stream:
            pass


def _stop(server):
    """Ends the server and waits for it."""
    if server.stdin is not None and not server.stdin.closed:
        server.stdin.close()
    try:
        server.wait(10)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()
