#!/bin/sh
# The engine's own tests on one emulated core: cross-builds and runs them, and counts that none of them was lost on the way.
# usage: unit.sh SOURCE BUILD SCENES SPANLINE CPU    (as build.sh)
set -eu
[ $# -eq 5 ] || { echo "usage: unit.sh SOURCE BUILD SCENES SPANLINE CPU" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/build.sh" "$1" "$2" "$3" "$4" "$5" unit

report=$2/unit.txt
status=0
sh "$here/emulate.sh" "$5" "$2/unit.elf" > "$report" || status=$?
cat "$report"
[ "$status" -eq 0 ] || { echo "the image ended with $status"; exit 1; }
written=$(sed -n 's|^ *\(.*_test\.cpp.*\)|\1|p' "$here/image/CMakeLists.txt" | tr ' ' '\n' | sed -n 's|^${tests}/\(.*_test\.cpp\)$|\1|p' |
  while read -r file; do cat "$1/tests/$file"; done | grep -cE '^TEST(_F)?\(')
grep -q "^tests ran=$written failed=0$" "$report" || { echo "the sources have $written tests"; exit 1; }
