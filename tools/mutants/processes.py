"""Runs programs that end, with all their child processes, when this program ends or when they exceed a time limit."""
import ctypes
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile

LIBC = ctypes.CDLL(None)
PR_SET_PDEATHSIG = 1


def dies_with_us():
    """Runs in a child process: makes the child end when this program ends for any reason."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def children(process):
    """Returns all descendants of a process."""
    below = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parent = int(stat.read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[1])
        except OSError:
            continue
        below.setdefault(parent, []).append(int(stat.parent.name))
    found, left = [], [process]
    while left:
        found += (more := below.get(left.pop(), []))
        left += more
    return found


def kill_all(processes):
    for process in processes:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


def interrupted(number, _frame):
    """Signal handler: ends all child processes and removes temporary files."""
    kill_all(children(os.getpid()))
    shutil.rmtree(tempfile.gettempdir(), ignore_errors=True)
    os._exit(128 + number)


def run(command, timeout, stderr=subprocess.DEVNULL, **options):
    """Runs a command and ends it with all its children after `timeout` seconds. Returns (exit code, or None after a
    timeout; stdout)."""
    with subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=stderr, text=True, errors="replace",
                          preexec_fn=dies_with_us, **options) as process:  # pylint: disable=subprocess-popen-preexec-fn
        try:
            words = process.communicate(timeout=timeout)[0]
            return process.returncode, words
        except subprocess.TimeoutExpired:
            kill_all([*children(process.pid), process.pid])
            return None, ""
