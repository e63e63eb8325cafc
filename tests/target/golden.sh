#!/bin/sh
# The golden pictures on one emulated core: cross-builds their image, checks what it contains, runs it: the checksum of each
# is the one that the host's test expects too.
# usage: golden.sh SOURCE BUILD SCENES SPANLINE CPU [TOOLCHAIN]    (as build.sh)
set -eu
[ $# -ge 5 ] || { echo "usage: golden.sh SOURCE BUILD SCENES SPANLINE CPU [TOOLCHAIN]" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/build.sh" "$1" "$2" "$3" "$4" "$5" golden "${6:-arm-none-eabi}"

report=$2/golden.txt
status=0
sh "$here/image_checks.sh" "$2/golden.elf"
sh "$here/emulate.sh" "$5" "$2/golden.elf" > "$report" || status=$?
cat "$report"
[ "$status" -eq 0 ] || { echo "the image ended with $status"; exit 1; }
[ "$(grep -c '^golden=.* same$' "$report")" -eq 18 ] || { echo "eighteen pictures expected"; exit 1; }
