#!/bin/sh
# Counts what frames take: compiles scenes with budgets that fit them, cross-builds an image of each for each core, executes
# them, prints the table and writes WORK/frames.json.
# usage: frames.sh SOURCE WORK FRAMES "CPU…" "SHADING…" SCENE…
# FRAMES: the tool spanline-frames; CPU: m0plus, m3, m4; SHADING: flat, gouraud; SCENE: a file, or FILE:LINES, whose patches are
# drawn as points in bands of so many lines
set -eu
[ $# -ge 6 ] || { echo "usage: frames.sh SOURCE WORK FRAMES \"CPU…\" \"SHADING…\" SCENE…" >&2; exit 2; }
command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
source=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
tool=$3
cpus=$4
shadings=$5
shift 5

folders=
names=
for scene in "$@"; do
  for shading in $shadings; do
    file=${scene%:*}
    lines=${scene#"$file"}
    lines=${lines#:}
    name=$(basename "$file")
    name=${name%.*}${lines:+-points}-$shading
    "$tool" prepare "$file" --shading "$shading" ${lines:+--point-lines "$lines"} --out "$work/frames/$name"
    folders="$folders;$work/frames/$name"
    names="$names $name"
  done
done

quiet() { "$@" > "$work/build.log" 2>&1 || { cat "$work/build.log" >&2; exit 1; }; }
images=
for cpu in $cpus; do
  quiet cmake -G Ninja -S "$source/tests/bench/image" -B "$work/$cpu" --toolchain "$source/toolchain/arm-none-eabi.cmake" \
    -DSPANLINE_BOARD="$source/tests/bench/board" -DSPANLINE_CPU="cortex-$cpu" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DSPANLINE_FRAMES="${folders#;}"
  # shellcheck disable=SC2086  # a list of targets
  quiet cmake --build "$work/$cpu" -j 2 --target $names
  for name in $names; do images="$images $cpu/$name"; done
done
# shellcheck disable=SC2086  # a list of images
"$tool" count "$work" $images --out "$work/frames.json"
