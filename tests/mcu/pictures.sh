#!/bin/sh
# Runs a board's images on the models of its chip and panel: what the panel shows is the host's picture, pixel for pixel.
# usage: pictures.sh IMAGES SPANLINE BOARD; exit 77: there are no images here.
set -eu
[ $# -eq 3 ] || { echo "usage: pictures.sh IMAGES SPANLINE BOARD" >&2; exit 2; }
images=$1/$3 spanline=$2 board=$3
[ -f "$images/teapot.elf" ] || { echo "skipped: no images of $board"; exit 77; }

for demo in $("$spanline" demo --list); do
  for frames in 1 4; do
    shown=$images/$demo-run
    "$spanline" run "$images/$demo.elf" --board "$board" --frames $frames --out "$shown.ppm" > "$shown.txt"
    "$spanline" demo "$demo" --board "$board" --frame $((frames - 1)) --out "$shown.host.ppm"
    cmp "$shown.ppm" "$shown.host.ppm"
    echo "$demo frame $((frames - 1)): as on the host, $(sed -n 's/^shown .*\(stack=.*\)/\1/p' "$shown.txt")"
  done
done
