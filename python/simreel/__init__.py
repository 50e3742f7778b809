"""simreel from Python: scenes on the GPU, their state in numpy, and their pictures.

    import simreel
    scene = simreel.load("flag.json", {"objects.flag.cloth.fabric": "silk"})
    for frame in scene.frames(0, 120):
        x = frame["flag"].positions     # (rows, columns, 3) float32, metres
        picture = frame.image()         # (height, width, 3) uint8
    scene.save("flag.mp4")

One device serves all scenes of a process. A forked process cannot use it: start processes with "spawn". Functions
release the interpreter's lock while they work, and Ctrl-C ends them between two frames.
"""
from __future__ import annotations

import atexit as _atexit
import os as _os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from . import _arguments, _native
from ._device import choose as _choose_device
from ._errors import Error, Mistake, Warning
from ._export import Export
from ._frame import Frame, Object
from ._pictures import Image, Video
from ._scene import Scene
from ._serve import View
from ._sweep import Sweep, program, sweep

if TYPE_CHECKING:
    from ._types import SceneDict
else:
    SceneDict = dict

__version__: str = _native.version()
__all__ = ["Error", "Export", "Frame", "Image", "Mistake", "Object", "Scene", "SceneDict", "Sweep", "Video", "View", "Warning", "device", "load",
           "program", "schema", "sweep"]

_native.prepare()  # sets the driver's environment variables before other threads start
_atexit.register(_native.close)


def load(source: SceneDict | str | _os.PathLike[str], changes: Mapping[str, Any] | None = None, *,
         assets: Iterable[str | _os.PathLike[str]] = (), motion: bool = False) -> Scene:
    """Loads a scene: a file or the name of a shipped scene, as `simreel render` takes it, or a dict of sections.

    `changes`: values by dotted path, as -D. `assets`: further folders for the scene's files. `motion`: keeps what the
    layers "velocity" and "vector" need.
    """
    return Scene._from(source, changes, assets, motion)


def device(name: str = "", *, memory_path: str = "") -> tuple[str, str, bool]:
    """Opens the device of the process: by number or part of its name. Without a name: the default one.

    Returns its name, the driver's version, and whether the CPU draws. Without a call, the first scene opens the
    default device.
    """
    opened = _native.open(str(name), _arguments.text("memory_path", memory_path))
    _choose_device(str(name), memory_path)
    return opened


def schema() -> dict[str, Any]:
    """Returns the JSON schema of scenes as a dict."""
    import json
    return json.loads(_native.schema())
