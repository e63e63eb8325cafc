#!/bin/sh
# The benchmark's frames: each core's image shows the host's picture, takes no more than limits.txt says, and QEMU counts the
# same instructions.
# usage: frames_test.sh SOURCE WORK FRAMES SPANLINE    (the tools spanline-frames and spanline)
set -eu
[ $# -eq 4 ] || { echo "usage: frames_test.sh SOURCE WORK FRAMES SPANLINE" >&2; exit 2; }
here=$1/tests/bench
scenes=$1/assets/scenes
sh "$here/frames.sh" "$1" "$2" "$3" "m0plus m3 m4" "flat gouraud" "$scenes/S1.json" "$scenes/S3.json" "$scenes/S4.json"
mv "$2/frames.json" "$2/meshes.json"
"$3" pieces "$2" m4 m0plus
sh "$here/kept.sh" "$1" "$2" "$4"
sh "$here/half.sh" "$1" "$2" "$3" "$2/meshes.json"
# Patches as points.
sh "$here/frames.sh" "$1" "$2" "$3" "m0plus m3 m4" gouraud "$scenes/S3-patches.json:40"

# JSON of one field a line, as the tool writes it.
cat "$2/meshes.json" "$2/frames.json" | tr -d '",' | awk '
  $1 ~ /:$/ { v[substr($1, 1, length($1) - 1)] = $2 }
  $1 == "}" { print v["scene"], v["cpu"], v["shading"], v["instructions"], v["ram_bytes"], v["text_bytes"] }' > "$2/frames.txt"
awk '
  function most(what, figure, limit) {
    if (figure + 0 > limit + 0) { print "FAILED: " name ": " what " " figure ", limit " limit; bad = 1 }
  }
  /^#/ { next }
  NR == FNR { limit[$1 " " $2 " " $3] = $4 " " $5 " " $6; next }
  {
    name = $1 " " $2 " " $3
    if (split(limit[name], l, " ") != 3) { print "FAILED: no limit for " name; bad = 1; next }
    most("instructions", $4, l[1])
    most("bytes of RAM", $5, l[2])
    most("bytes of code", $6, l[3])
    ++frames
  }
  END {
    if (frames != 21) { print "FAILED: 21 frames expected, " frames + 0 " counted"; bad = 1 }
    exit bad
  }' "$here/limits.txt" "$2/frames.txt"

work=$2
counted() { awk -v name="$1" '$1 " " $2 " " $3 == name { print $4 }' "$work/frames.txt"; }
sh "$here/one_count.sh" "$1" "$2/m4/S1-flat.elf" cortex-m4 "$(counted "S1 m4 flat")"
sh "$here/one_count.sh" "$1" "$2/m0plus/S1-flat.elf" cortex-m0 "$(counted "S1 m0plus flat")"
