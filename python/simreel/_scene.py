"""Scenes: loading, stepping, state, pictures."""
from __future__ import annotations

import json
import operator
import os
import pathlib
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy

from . import _arguments, _native
from ._errors import Error, UnknownName, with_keywords
from ._folder import folder_of
from ._frame import Frame, Object
from ._messages import Reporting, report, warn
from ._pictures import Image, Video
from ._progress import Bar

if TYPE_CHECKING:
    from ._serve import View
    from ._types import SceneDict
    Source = SceneDict | str | os.PathLike[str]
    Numbers = str | int | Iterable[int] | None


def _plain(value):
    """Converts numpy's numbers and paths for JSON."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a scene cannot hold a {type(value).__name__}")


def _pairs(changes):
    if changes is not None and not isinstance(changes, Mapping):
        raise TypeError(f"changes are a dict of values by dotted path, not {changes!r}")
    return [(_arguments.text("a path of changes", path), _value_text(f"the change of {path}", value))
            for path, value in (changes or {}).items()]


def _value_text(name, value):
    """Returns a value as JSON."""
    try:
        return json.dumps(value, default=_plain, allow_nan=False)
    except ValueError:
        raise Error(f"{name} is {value!r}; a scene holds only finite numbers") from None


def _frames_text(frames):
    """Returns frames as --frames takes them; None: all."""
    if frames is None or isinstance(frames, str):
        return frames
    if hasattr(frames, "__index__"):
        return str(_arguments.frame_number("frames", frames))
    numbers = _arguments.values("frames", frames, _arguments.frame_number)
    if not numbers:
        raise Error("frames is empty, so there is nothing to render")
    return ",".join(map(str, numbers))


def _file_suffix(source):
    return ".glsl" if "gl_GlobalInvocationID" in source or "#version" in source else ".compute"


class _Kernels:
    """Folder with the kernels that a scene gives as text."""

    def __init__(self):
        self.folder = None
        self.paths = {}  # maps the file name of a kernel to the path of its text in the scene

    def write(self, sections):
        """Returns the scene with a file in place of each "source"."""
        objects = sections.get("objects")
        if not isinstance(objects, dict):
            return sections
        changed = {}
        for name, thing in objects.items():
            kernels = thing.get("kernels") if isinstance(thing, dict) else None
            if isinstance(kernels, dict) and "source" in kernels:
                if "file" in kernels:
                    raise Error(f'objects.{name}.kernels: give "file" or "source", not both')
                if self.folder is None:
                    self.folder = folder_of(self, "kernels")
                source = _arguments.text(f"objects.{name}.kernels.source", kernels["source"])
                file = pathlib.Path(self.folder) / f"{len(self.paths)}{_file_suffix(source)}"
                file.write_text(source, encoding="utf-8")
                self.paths[str(file)] = f"objects.{name}.kernels.source"
                kernels = {**{key: value for key, value in kernels.items() if key != "source"}, "file": file.name}
                changed[name] = {**thing, "kernels": kernels}
        return {**sections, "objects": {**objects, **changed}} if changed else sections

    def renamed(self, error):
        """Returns an error with the paths in the scene in place of the files."""
        message = str(error)
        for file, path in self.paths.items():
            message = message.replace(file, path)
        mistakes = [one._replace(file=None, path=self.paths[one.file]) if one.file in self.paths else one
                    for one in error.mistakes]
        return Error(message, error.kind, mistakes)


class Scene:
    """A scene on the device, at frame 0 at first.

    Built from keyword arguments, which are the sections of a scene file: `Scene(objects={...}, time={...})`. load()
    reads files. All functions may be called from any thread; one runs at a time. Arrays and pictures are read-only
    copies in host memory, so numpy, PyTorch (`torch.from_numpy`) and JAX read them through the CPU.
    """

    def __init__(self, *, changes: Mapping[str, Any] | None = None, assets: Iterable[str | os.PathLike[str]] = (),
                 motion: bool = False, **sections: Any) -> None:
        self._start(sections, changes, assets, motion)

    @classmethod
    def _from(cls, source: Source, changes: Mapping[str, Any] | None, assets: Iterable[str | os.PathLike[str]],
              motion: bool) -> Scene:
        scene = cls.__new__(cls)
        scene._start(source, changes, assets, motion)
        return scene

    def _start(self, source, changes, assets, motion):
        self._kernels = _Kernels()
        self._changes = _pairs(changes)
        if isinstance(assets, (str, os.PathLike)):
            assets = [assets]
        self._assets = _arguments.values("assets", assets, _arguments.folder)
        motion = bool(motion)
        if isinstance(source, dict):
            given = self._kernels.write({"version": 2, **source})
            if self._kernels.folder is not None:
                self._assets.append(self._kernels.folder)
            self._source, self._text = None, json.dumps(given, default=_plain, indent=1)
            try:
                loaded = _native.parse(self._text, "<scene>", self._changes, self._assets, motion)
            except Error as error:
                raise self._kernels.renamed(error) from None
            finally:
                report()
        else:
            self._source, self._text = _arguments.path("a scene that is no dict", source), None
            try:
                loaded = _native.load(self._source, self._changes, self._assets, motion)
            finally:
                report()
        self._native = Reporting(loaded)
        self._kinds = self._native.objects()
        self._arrays = None
        self._views: list[View] = []
        self._steps = 0  # counts what makes earlier frames invalid
        for remark in self._native.remarks():
            warn(remark)

    # Description

    @property
    def title(self) -> str:
        """Title of the scene."""
        return self._native.title()

    @property
    def fps(self) -> float:
        """Frames per second of scene time."""
        return self._native.fps()

    @property
    def frame_count(self) -> int:
        """Number of frames of the scene's duration. A scene can be stepped beyond."""
        return self._native.frame_count()

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of pictures in pixels."""
        return self._native.size()

    @property
    def objects(self) -> dict[str, str]:
        """The objects' kinds by name."""
        return dict(self._kinds)

    def __repr__(self):
        if not hasattr(self, "_steps"):
            return "<simreel.Scene: not loaded>"
        inside = ", ".join(f"{name} ({kind})" for name, kind in self._kinds.items())
        try:
            return f"<simreel.Scene {self.title or self._source or ''!r}: {inside}>"
        except Error:
            return f"<simreel.Scene {self._source or ''!r}: closed>"

    # Stepping

    @property
    def frame(self) -> Frame:
        """The present frame."""
        number, seconds = self._native.frame()
        return Frame(self, number, seconds)

    def step(self, frames: int = 1) -> Frame:
        """Simulates a number of frames, at least 0, and returns the present one."""
        if _arguments.integer("frames", frames) < 0:
            raise Error(f"step({frames}) would go back; restart() the scene, or restore() a snapshot")
        self._steps += 1
        number, seconds = self._native.advance_by(frames)
        return Frame(self, number, seconds)

    def advance_to(self, number: int) -> Frame:
        """Simulates up to a frame, which must not be an earlier one, and returns it."""
        number = _arguments.frame_number("the frame", number)
        self._steps += 1
        number, seconds = self._native.advance_to(number)
        return Frame(self, number, seconds)

    def restart(self) -> None:
        """Goes back to frame 0 of the scene as it was read."""
        self._steps += 1
        self._native.restart()

    def frames(self, first: int = 0, last: int | None = None, step: int = 1,
               progress: bool | None = None) -> Iterator[Frame]:
        """Yields the frames first, first + step, ... below `last` (default: the scene's end).

        Frames count from 0. There are none if `last` is not beyond `first`, and the scene then stays as it is. A frame
        is valid until the next one. The scene is restarted if it is beyond `first`. `progress`: shows a bar; None: on a
        terminal and in a notebook.
        """
        first = _arguments.frame_number("first", first)
        last = self.frame_count if last is None else _arguments.frame_number("last", last)
        if _arguments.integer("step", step) < 1:
            raise Error(f"frames go forward; step is {step}")
        return self._walk(range(first, last, step), progress)

    def _walk(self, numbers, progress):
        if not numbers:
            return
        first = numbers[0]
        present = self._native.frame()[0]
        if present > first:
            if self._native.is_changed():
                raise Error(f"the state was written at or before frame {present}, but frame {first} is earlier; begin "
                            f"at {present}, or restart() the scene")
            self.restart()
        bar = Bar(len(numbers), progress)
        try:
            for number in numbers:
                yield self.advance_to(number)
                bar.advance()
        finally:
            bar.end()

    @property
    def state_hash(self) -> str:
        """Hash of all state arrays, as `simreel trace` and manifest.json have it."""
        return self._native.state_hash()

    def snapshot(self) -> Any:
        """Returns a copy of the state between frames, for restore()."""
        return self._native.snapshot()

    def restore(self, snapshot: Any) -> None:
        """Goes on from the state of a scene with the same simulations."""
        if not isinstance(snapshot, _native.Snapshot):
            raise TypeError(f"restore() takes what snapshot() returned, not {snapshot!r}")
        self._steps += 1
        self._native.restore(snapshot)

    # State and pictures of the current frame

    def _table(self):
        if self._arrays is None:
            self._arrays = {}
            for name, array, unit, dtype, shape, writable in self._native.arrays():
                self._arrays.setdefault(name, {})[array] = (unit, dtype, shape, writable)
        return self._arrays

    def __getitem__(self, name: str) -> Object:
        if not isinstance(name, str):
            raise TypeError(f"objects are found by their names, not by {name!r}")
        if name not in self._kinds:
            raise UnknownName(f'the scene has no object "{name}"; it has', name, self._kinds)
        return Object(self, name)

    def __iter__(self):
        return iter(self._kinds)

    def __len__(self):
        return len(self._kinds)

    def image(self) -> Image:
        """Draws the present frame: the bytes of `simreel render`."""
        return self._native.picture().view(Image)

    def layers(self, names: str | Iterable[str]) -> dict[str, numpy.ndarray]:
        """Draws layers of the present frame: a dict of arrays.

        Names: depth (m), position (m), normal, albedo, uv, velocity (m/s), vector (pixels), object (index into
        layer_objects), primitive, and light (linear RGBA). velocity and vector need load(..., motion=True).
        """
        names = [names] if isinstance(names, str) else _arguments.values("names", names, _arguments.text)
        return self._native.layers(names)

    @property
    def layer_objects(self) -> list[str]:
        """Names of the objects that the layer "object" numbers."""
        return self._native.layer_objects()

    @property
    def fields(self) -> list[str]:
        """Names of the scene's fields."""
        return self._native.fields()

    def field(self, name: str) -> numpy.ndarray:
        """Returns the values of a field: (rows, columns), float32."""
        return self._native.field(_arguments.text("the name of a field", name))

    # Runs from the first frame

    def check(self, frames: Iterable[int] = (0,)) -> list[dict[str, Any]]:
        """Runs the scene from its start and returns the results of its checks, one dict for each check and frame."""
        keys = ("what", "frame", "value", "passed", "problem")
        return [dict(zip(keys, one)) for one in self._native.check(_arguments.values("frames", frames, _arguments.frame_number))]

    def save(self, output: str | os.PathLike[str], frames: Numbers = None, *, overwrite: bool = True,
             resume: bool = False, manifest: bool | None = None, layers: Iterable[str] = (), bits: int | None = None,
             fields: str | None = None, progress: bool | None = None) -> str:
        """Renders the scene from its start to a folder ("out/"), pictures ("out/####.png") or a video ("run.mp4").

        The files are those of `simreel render`. `resume`: keeps whole frames of an earlier run, and goes on from its last
        checkpoint. `manifest`: writes manifest.json and run.json beside the pictures; None: for folders. `layers`: layers
        of OpenEXR pictures. `bits`: 16 in PNG, 32 in OpenEXR. `fields`: raw values beside the pictures, such as "npy".
        `progress`: shows a bar; None: on a terminal and in a notebook.
        """
        if output == "-":
            raise Error("save() writes files, and \"-\" is none; take the pictures with frames() and image()")
        place = _arguments.path("output", output) + ("/" if isinstance(output, pathlib.Path) and not output.suffix else "")
        if manifest is None:
            manifest = place.endswith("/")
        layers = [layers] if isinstance(layers, str) else _arguments.values("layers", layers, _arguments.text)
        options = {"frames": _frames_text(frames), "overwrite": _arguments.flag("overwrite", overwrite),
                   "resume": _arguments.flag("resume", resume), "manifest": _arguments.flag("manifest", manifest), "layers": layers,
                   "bits": None if bits is None else _arguments.integer("bits", bits),
                   "fields": None if fields is None else _arguments.text("fields", fields)}
        bar = Bar(0, None if progress is None else _arguments.flag("progress", progress))
        try:
            return self._native.render(place, options, bar.count if bar.shown else None)
        except Error as error:
            raise with_keywords(error) from None
        finally:
            bar.end()

    def serve(self, *, height: int = 720, port: int = 0, bind: str = "127.0.0.1") -> View:
        """Shows the scene live: a notebook embeds the page, and a terminal prints its address.

        The page begins at the present frame with the present state, also if that was written, and can play on, turn the
        camera and change values. View.update() shows the scene's present state later. The page belongs to another process
        on the same machine, and never changes this scene or its file. It ends with the scene. `height`: of the page in a
        notebook, in pixels. `port`: 0 for any free one. `bind`: IP address to listen at.
        """
        from ._serve import View
        words = [self._source] if self._source is not None else [str(self._scene_file())]
        for path, value in self._changes:
            words += ["-D", f"{path}={value}"]
        for folder in self._assets + ([os.getcwd()] if self._source is None else []):
            words += ["--assets", folder]
        if not 0 <= _arguments.integer("port", port) < 65536:
            raise Error(f"port is 0 to 65535, not {port}")
        words += ["--port", str(port), "--bind", _arguments.text("bind", bind)]
        view = View(self, words, _arguments.integer("height", height))
        self._views.append(view)
        if sys.stdout.isatty():
            print(f"Open {view.url}")
        return view

    def _scene_file(self) -> pathlib.Path:
        """Returns a file with the text of a scene that was no file."""
        file = pathlib.Path(folder_of(self, "scene")) / "scene.json"
        assert self._text is not None
        file.write_text(self._text, encoding="utf-8")
        return file

    def video(self, frames: Numbers = None) -> Video:
        """Renders a video that a notebook shows. Needs ffmpeg."""
        with tempfile.TemporaryDirectory(prefix="simreel-video-") as folder:
            file = pathlib.Path(folder) / "run.mp4"
            self.save(file, frames, manifest=False)
            return Video(file)

    def close(self) -> None:
        """Releases the memory on the device now, instead of when Python forgets the scene."""
        self._steps += 1
        for view in self._views:
            view.close()
        self._views.clear()
        self._native.close()

    def __enter__(self) -> Scene:
        return self

    def __exit__(self, *_):
        self.close()

    def _repr_html_(self):
        return self.video()._repr_html_()
