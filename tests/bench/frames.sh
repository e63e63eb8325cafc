#!/bin/sh
# Counts what frames take: compiles scenes with budgets that fit them, cross-builds an image of each for each core, executes
# them, prints the table and writes WORK/frames.json.
# usage: frames.sh SOURCE WORK FRAMES "CPU…" "SHADING…" SCENE…
# FRAMES: the tool spanline-frames; CPU: m0plus, m3, m4; SHADING: flat, gouraud; SCENE: a file, or FILE:LINES, whose patches are
# drawn as points in bands of so many lines, or FILE@BYTES, which is drawn in so much memory
set -eu
[ $# -ge 6 ] || { echo "usage: frames.sh SOURCE WORK FRAMES \"CPU…\" \"SHADING…\" SCENE…" >&2; exit 2; }
. "$1/tests/bench/images.sh"
begin_images "$1" "$2" "$3"
cpus=$4
shadings=$5
shift 5

names=
for scene in "$@"; do
  for shading in $shadings; do
    file=${scene%@*}
    bytes=${scene#"$file"}
    bytes=${bytes#@}
    file=${file%:*}
    lines=${scene#"$file"}
    lines=${lines%@*}
    lines=${lines#:}
    name=$(basename "$file")
    name=${name%.*}${lines:+-points}${bytes:+-in-$bytes}-$shading
    "$tool" prepare "$file" --shading "$shading" ${lines:+--point-lines "$lines"} ${bytes:+--memory "$bytes"} --out "$work/frames/$name"
    names="$names $name"
  done
done

images=
for cpu in $cpus; do
  # shellcheck disable=SC2086  # a list of frames
  build_images "$cpu" $names
  for name in $names; do images="$images $cpu/$name"; done
done
# shellcheck disable=SC2086  # a list of images
"$tool" count "$work" $images --out "$work/frames.json"
