#!/bin/sh
# The oracle's pictures on one emulated core: cross-builds their image, checks what it contains, runs it: each comparator and
# the edge walker come to the oracle's picture in every pixel, in as many drawings as on the host.
# usage: pictures.sh SOURCE BUILD SCENES SPANLINE CPU HOST    (as build.sh; HOST: the host's twin of the image)
set -eu
[ $# -eq 6 ] || { echo "usage: pictures.sh SOURCE BUILD SCENES SPANLINE CPU HOST" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/build.sh" "$1" "$2" "$3" "$4" "$5" pictures

report=$2/pictures.txt
status=0
sh "$here/image_checks.sh" "$2/pictures.elf"
sh "$here/emulate.sh" "$5" "$2/pictures.elf" > "$report" || status=$?
cat "$report"
[ "$status" -eq 0 ] || { echo "the image ended with $status"; exit 1; }
"$6" | diff - "$report" || { echo "not what the host came to"; exit 1; }
