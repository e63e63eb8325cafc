#!/bin/sh
# Counts frames of the benchmark and balls on each core, and fits to them what `spanline budget --sweep` expects of the edge
# walker: host_sim/budget/edge_prices.inc, tests/mcu/edge_frames.inc.
# usage: prices.sh SOURCE WORK FRAMES    (FRAMES: the tool spanline-frames)
set -eu
[ $# -eq 3 ] || { echo "usage: prices.sh SOURCE WORK FRAMES" >&2; exit 2; }
. "$1/tests/bench/images.sh"
begin_images "$1" "$2/prices" "$3"
. "$source/tests/bench/balls.sh"

names='S1 S3 S4'
set --
for name in $names; do set -- "$@" "$source/assets/scenes/$name.json"; done
for rings in 6 16 28; do
  ball $rings "$work"
  names="$names ball$rings"
  set -- "$@" "$work/ball$rings.json"
done
sh "$source/tests/bench/frames.sh" "$source" "$work" "$tool" "m0plus m3 m4" "flat gouraud" "$@" > "$work/table.txt"
# shellcheck disable=SC2086  # a list of scenes
"$tool" prices "$work" $names --prices "$source/host_sim/budget/edge_prices.inc" --frames "$source/tests/mcu/edge_frames.inc"
