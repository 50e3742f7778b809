#!/bin/sh
# What the examples beside this file have a CI server do; any other server can call the same.
#
#   tools/ci/steps.sh test k/n     tests the k-th of n parts, and leaves its report in $REPORTS/k
#   tools/ci/steps.sh merge        makes one report of all parts in $REPORTS/all; fails where one test of all would
#
# In the environment, each with a default:
#   SIMREEL     the program                                     simreel
#   SCENES      what to test                                    assets/scenes
#   REPORTS     where reports go                                simreel-reports
#   JOBS        scenes at once                                  auto
#   REPORT_URL  where $REPORTS/all will be served, for pictures in summaries and comments    none: within the text
set -eu

simreel=${SIMREEL:-simreel}
reports=${REPORTS:-simreel-reports}
# A summary for the server's page, where it has one.
server() { [ -z "${GITHUB_ACTIONS:-}" ] || echo --github; }

case "${1:-}" in
  test)
    part=${2:?"which part? for example 1/4"}
    # shellcheck disable=SC2046,SC2086  # several scenes; no word where no server
    "$simreel" test ${SCENES:-assets/scenes} --shard "$part" --jobs "${JOBS:-auto}" --report "$reports/${part%/*}"
    ;;
  merge)
    # Whatever the parts came to: each has left a report, and the one of a machine that was lost is missed.
    rm -rf "$reports/all"
    # shellcheck disable=SC2046
    "$simreel" report merge "$reports"/*/ -o "$reports/all" --junit "$reports/junit.xml" \
      --markdown "$reports/summary.md" --markdown-pictures "${REPORT_URL:-data}" $(server)
    ;;
  *)
    echo "usage: $0 test k/n | merge" >&2
    exit 2
    ;;
esac
