#!/bin/sh
# The engine's own tests on one emulated core: cross-builds and runs them, and counts that none of them was lost on the way.
# usage: unit.sh SOURCE BUILD SCENES SPANLINE CPU    (as build.sh)
set -eu
[ $# -eq 5 ] || { echo "usage: unit.sh SOURCE BUILD SCENES SPANLINE CPU" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/build.sh" "$1" "$2" "$3" "$4" "$5" unit

report=$2/unit.txt
for image in "$2"/unit-*.elf; do
  status=0
  sh "$here/emulate.sh" "$5" "$image" || status=$?
  [ "$status" -eq 0 ] || echo "$(basename "$image") ended with $status"
done > "$report"
cat "$report"
! grep -q ' ended with ' "$report" || exit 1
written=$(grep -o '{tests}/[a-z]*/[a-z_]*_test\.cpp' "$here/image/CMakeLists.txt" | sed 's|^{tests}/||' |
  while read -r file; do cat "$1/tests/$file"; done | grep -cE '^TEST(_F)?\(')
ran=$(sed -n 's/^tests ran=\([0-9]*\) failed=0$/\1/p' "$report" | awk '{ sum += $1 } END { print sum + 0 }')
[ "$ran" -eq "$written" ] || { echo "ran $ran, but the sources have $written tests"; exit 1; }
