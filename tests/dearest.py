#!/usr/bin/env python3
"""Runs the tests of ctest in the same way as ctest and lists the tests with the most processor time, which dominate the
test time on a machine with few processors. ctest itself reports wall-clock time only.

    tests/dearest.py                       all tests of build/, one worker per processor
    tests/dearest.py -L gpu -R cloth -j 1  the tests that ctest selects with these options, one at a time
    tests/dearest.py --most 50             lists the top 50
    tests/dearest.py --table FILE          writes all tests to FILE: processor seconds, wall seconds, exit code, name
    tests/dearest.py --selection ci --phases     seconds by phase and test: a run with an empty shader cache and a second run with the
                                           filled cache; compile times are those of each file's last build

To start with an empty shader cache, as on a fresh machine: MESA_SHADER_CACHE_DIR=$(mktemp -d)."""
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
SELECTIONS = {"quick": ["-L", "^quick$"], "ci": ["-LE", "^long$"], "all": []}


def properties(test):
    return {p["name"]: p["value"] for p in test.get("properties", [])}


def run(test):
    """Runs a test; returns (processor seconds, wall seconds, exit code, name)."""
    own = properties(test)
    environment = os.environ | dict(pair.split("=", 1) for pair in own.get("ENVIRONMENT", []))
    start = time.monotonic()
    with tempfile.TemporaryFile() as output:
        child = subprocess.Popen(test["command"], cwd=own.get("WORKING_DIRECTORY"), env=environment, stdout=output,
                                 stderr=output)
        _, status, used = os.wait4(child.pid, 0)  # The usage includes the children for which the child has waited.
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode not in (0, own.get("SKIP_RETURN_CODE", 0)):
            output.seek(0)
            print(f"{test['name']} failed:\n{output.read().decode(errors='replace')[-4000:]}", file=sys.stderr, flush=True)
    return used.ru_utime + used.ru_stime, time.monotonic() - start, child.returncode, test["name"]


def compiled(build):
    """Returns the compile seconds of the program and of the tests: sums over all jobs in ninja's log."""
    seconds = {}
    for line in (build / ".ninja_log").read_text().splitlines()[1:]:
        begin, end, _, output, _ = line.split("\t")
        seconds[output] = (int(end) - int(begin)) / 1000
    tests = sum(taken for output, taken in seconds.items() if output.startswith("tests/") and ".dir/" in output)
    return sum(taken for output, taken in seconds.items() if ".dir/" in output) - tests, tests


def all_of(tests, jobs):
    """Runs all tests; returns their results by name, and the wall-clock seconds."""
    start = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = {result[3]: result for result in pool.map(run, tests)}
    return results, time.monotonic() - start


def phases(options, tests):
    """Prints the --phases tables. Shader time: cold minus warm processor time. Wait time: wall-clock minus processor time."""
    with tempfile.TemporaryDirectory(prefix="simreel-shaders-") as cache:
        os.environ["MESA_SHADER_CACHE_DIR"] = cache
        (cold, cold_wall), (warm, warm_wall) = all_of(tests, options.jobs), all_of(tests, options.jobs)
    rows = sorted((cold[name][0], max(0, cold[name][0] - warm[name][0]), warm[name][0], max(0, warm[name][1] - warm[name][0]), name)
                  for name in cold)[::-1]
    program, own = compiled(options.build)
    print("| phase | processor s |\n|---|---|")
    for phase, seconds in (("compile the program", program), ("compile tests", own), ("compile shaders", sum(row[1] for row in rows)),
                           ("run", sum(row[2] for row in rows)), ("wait, a test at a time (no processor)", sum(row[3] for row in rows))):
        print(f"| {phase} | {seconds:.0f} |")
    print("\n| test | cold | of it shaders | warm | waits |\n|---|---|---|---|---|")
    print("".join(f"| {name} | {c:.1f} | {s:.1f} | {w:.1f} | {t:.1f} |\n" for c, s, w, t, name in rows[:options.most]))
    print(f"{len(rows)} tests, {options.jobs} at a time: {cold_wall:.0f} s by the clock cold, {warm_wall:.0f} s warm")
    return 1 if any(code not in (0, 77) for results in (cold, warm) for _, _, code, _ in results.values()) else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path)
    parser.add_argument("-L", dest="label", help="as ctest's")
    parser.add_argument("-R", dest="only", help="as ctest's")
    parser.add_argument("-E", dest="without", help="as ctest's")
    parser.add_argument("-j", dest="jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--most", type=int, default=30)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--selection", choices=SELECTIONS, default="all", help="of tools/test's")
    parser.add_argument("--phases", action="store_true")
    options = parser.parse_args()
    chosen = [(flag, text) for flag, text in (("-L", options.label), ("-R", options.only), ("-E", options.without)) if text]
    listed = subprocess.run(["ctest", "--test-dir", options.build, "--show-only=json-v1", *SELECTIONS[options.selection],
                             *(w for pair in chosen for w in pair)],
                            check=True, capture_output=True, text=True)
    tests = json.loads(listed.stdout)["tests"]
    # Tests with DEPENDS run last, as in ctest.
    tests.sort(key=lambda test: (bool(properties(test).get("DEPENDS")), -properties(test).get("COST", 0)))
    if options.phases:
        return phases(options, tests)
    results, wall = all_of(tests, options.jobs)
    results = sorted(results.values(), reverse=True)
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
