#!/bin/sh
# The kept meshes are what their generator writes, byte for byte. usage: meshes.sh ASSETS SPANLINE-MESHGEN
set -eu
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$2" "$1/teapot.bpt" "$made"
failed=0
for mesh in "$made"/*; do
  cmp "$mesh" "$1/$(basename "$mesh")" || failed=1
done
for mesh in "$1"/*.obj; do
  [ -e "$made/$(basename "$mesh")" ] || { echo "$mesh is not made by the generator"; failed=1; }
done
exit "$failed"
