#!/bin/sh
# Pictures with known checksums on one emulated core: cross-builds their image, checks what it contains, runs it: the checksum
# of each of the COUNT pictures is the one that the host's test expects too.
# usage: golden.sh SOURCE BUILD SCENES SPANLINE CPU IMAGE COUNT [TOOLCHAIN]    (as build.sh)
set -eu
[ $# -ge 7 ] || { echo "usage: golden.sh SOURCE BUILD SCENES SPANLINE CPU IMAGE COUNT [TOOLCHAIN]" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/build.sh" "$1" "$2" "$3" "$4" "$5" "$6" "${8:-arm-none-eabi}"

report=$2/$6.txt
status=0
sh "$here/image_checks.sh" "$2/$6.elf"
sh "$here/emulate.sh" "$5" "$2/$6.elf" > "$report" || status=$?
cat "$report"
[ "$status" -eq 0 ] || { echo "the image ended with $status"; exit 1; }
[ "$(grep -c "^$6=.* same$" "$report")" -eq "$7" ] || { echo "$7 pictures expected"; exit 1; }
