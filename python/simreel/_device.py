"""The device that the user chose, for programs that the module starts."""
from __future__ import annotations

_chosen: list[str] = []


def choose(name: str, memory_path: str) -> None:
    """Notes the options of simreel.device()."""
    _chosen[:] = (["--device", name] if name else []) + (["--memory-path", memory_path] if memory_path else [])


def device_words() -> list[str]:
    """Returns the options by which the program uses the same device."""
    return list(_chosen)
