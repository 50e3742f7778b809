"""Programs that end, with all that they have started, when this one does or when they take too long."""
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
    """In a child: ends when this program does, however that is ended."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def children(process):
    """All processes below this one."""
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
    """Leaves neither processes nor files."""
    kill_all(children(os.getpid()))
    shutil.rmtree(tempfile.gettempdir(), ignore_errors=True)
    os._exit(128 + number)


def run(command, timeout, stderr=subprocess.DEVNULL, **options):
    """Ends with all its children where it takes longer. Returns (exit code or None then, stdout)."""
    with subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=stderr, text=True, errors="replace",
                          preexec_fn=dies_with_us, **options) as process:  # pylint: disable=subprocess-popen-preexec-fn
        try:
            words = process.communicate(timeout=timeout)[0]
            return process.returncode, words
        except subprocess.TimeoutExpired:
            kill_all([*children(process.pid), process.pid])
            return None, ""
