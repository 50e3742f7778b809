#!/usr/bin/env python3
"""Runs the tests that ctest knows, as it would, and lists those that take most processor time: what a machine with few
processors waits for. ctest itself knows the time by the clock only.

    tests/dearest.py                       all tests of build/, on as many workers as there are processors
    tests/dearest.py -L gpu -R cloth -j 1  those that ctest would choose so, one at a time
    tests/dearest.py --most 50             so many of them
    tests/dearest.py --table FILE          all of them into FILE: processor seconds, seconds, exit code, name

An empty cache of shaders, as on a machine that has run nothing: MESA_SHADER_CACHE_DIR=$(mktemp -d)."""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]


def properties(test):
    return {p["name"]: p["value"] for p in test.get("properties", [])}


def run(test):
    """(processor seconds, seconds, exit code, name)"""
    own = properties(test)
    environment = os.environ | dict(pair.split("=", 1) for pair in own.get("ENVIRONMENT", []))
    start = time.monotonic()
    with tempfile.TemporaryFile() as output:
        child = subprocess.Popen(test["command"], cwd=own.get("WORKING_DIRECTORY"), env=environment, stdout=output,
                                 stderr=output)
        _, status, used = os.wait4(child.pid, 0)  # with the children that it waited for
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode not in (0, own.get("SKIP_RETURN_CODE", 0)):
            output.seek(0)
            print(f"{test['name']} failed:\n{output.read().decode(errors='replace')[-4000:]}", file=sys.stderr, flush=True)
    return used.ru_utime + used.ru_stime, time.monotonic() - start, child.returncode, test["name"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path)
    parser.add_argument("-L", dest="label", help="as ctest's")
    parser.add_argument("-R", dest="only", help="as ctest's")
    parser.add_argument("-E", dest="without", help="as ctest's")
    parser.add_argument("-j", dest="jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--most", type=int, default=30)
    parser.add_argument("--table", type=pathlib.Path)
    options = parser.parse_args()
    chosen = [(flag, text) for flag, text in (("-L", options.label), ("-R", options.only), ("-E", options.without)) if text]
    listed = subprocess.run(["ctest", "--test-dir", options.build, "--show-only=json-v1", *(w for pair in chosen for w in pair)],
                            check=True, capture_output=True, text=True)
    tests = json.loads(listed.stdout)["tests"]
    # What ctest runs after others goes last.
    tests.sort(key=lambda test: (bool(properties(test).get("DEPENDS")), -properties(test).get("COST", 0)))
    start = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = sorted(pool.map(run, tests), reverse=True)
    wall = time.monotonic() - start
    groups = collections.Counter()
    for processor, _, _, name in results:
        groups[name.split(":")[0]] += processor
    if options.table:
        options.table.write_text("".join(f"{p:8.2f} {w:8.2f} {code:3} {name}\n" for p, w, code, name in results))
    print("".join(f"{p:8.2f} s  {name}\n" for p, _, _, name in results[:options.most]))
    print("".join(f"{p:8.1f} s  {name}\n" for name, p in groups.most_common()))
    print(f"{sum(groups.values()):.0f} s of processors in {len(results)} tests, {wall:.0f} s by the clock with {options.jobs} "
          f"at a time")
    return 1 if any(code not in (0, 77) for _, _, code, _ in results) else 0


if __name__ == "__main__":
    sys.exit(main())
