"""Progress of loops over frames."""
import sys
import time


class Bar:
    """Progress on a terminal or in a notebook."""

    def __init__(self, total, wanted):
        self.total, self.done, self.begun, self.told = total, 0, time.monotonic(), 0.0
        self.shown = wanted if wanted is not None else sys.stderr.isatty() or "ipykernel" in sys.modules

    def advance(self):
        self.done += 1
        now = time.monotonic()
        if self.shown and (now - self.told > 0.1 or self.done == self.total):
            self.told = now
            rate = self.done / max(now - self.begun, 1e-9)
            filled = 30 * self.done // max(self.total, 1)
            bar = "#" * filled + "." * (30 - filled)
            print(f"\r[{bar}] {self.done}/{self.total} frames, {rate:.1f}/s", end="", file=sys.stderr, flush=True)

    def count(self, frames):
        """Begins with a number of frames, or advances by one frame for 0."""
        if frames > 0:
            self.total = frames
        else:
            self.advance()

    def end(self):
        if self.shown and self.told:
            print(file=sys.stderr)
