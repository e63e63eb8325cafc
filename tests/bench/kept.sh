#!/bin/sh
# What a frame takes on a Cortex-M4 that knows the one before (Budget::kept_instances), of what frames.sh has prepared in
# WORK: a table in Markdown. Fails where less is gained than is said.
# usage: kept.sh SOURCE WORK SPANLINE
set -eu
[ $# -eq 3 ] || { echo "usage: kept.sh SOURCE WORK SPANLINE" >&2; exit 2; }
. "$1/tests/bench/images.sh"
begin_images "$1" "$2" "$3"
names="S3-flat S3-gouraud S4-flat"
# shellcheck disable=SC2086  # a list of frames
quiet cmake --build "$work/m4" -j 2 --target $(for name in $names; do echo "$name-kept"; done)

echo "| scene | whole | nothing has moved, all lines drawn | eight lines drawn | none |"
echo "|---|--:|--:|--:|--:|"
for name in $names; do
  quiet "$tool" budget "$work/m4/$name-kept.elf" --board cortex-m4 --frames 4 --no-stack --json "$work/kept.json"
  awk -v name="$name" '
    /"passages"/ { on = 1 }
    on && /"instructions"/ { gsub(/[^0-9]/, ""); n[++frames] = $0 + 0 }
    on && /\]/ { exit }
    END {
      if (frames != 4 || n[1] == 0) { print "FAILED: " name ": four frames expected, " frames + 0 " counted"; exit 1 }
      printf "| %s | %d | %d | %d | %d |\n", name, n[1], n[2], n[3], n[4]
      if (n[2] > 0.92 * n[1] || n[3] > 0.35 * n[1] || n[4] > 8000) { print "FAILED: " name ": too much of the first frame"; exit 1 }
    }' "$work/kept.json"
done
