#!/bin/sh
# Each example as a stranger builds it: a copy away from the tree, a CMake project of its own that is told where Spanline
# lies; then it runs, and what it shows must be a picture.
# usage: examples.sh SOURCE BUILD SPANLINE   (the host tool, as an absolute or relative path)
set -eu
if [ $# -ne 3 ] || [ ! -x "$3" ]; then
  echo "usage: examples.sh SOURCE BUILD SPANLINE   (build the host tool first)" >&2
  exit 2
fi
source=$(cd "$1" && pwd)
tool=$(cd "$(dirname "$3")" && pwd)/$(basename "$3")
mkdir -p "$2"
build=$(cd "$2" && pwd)

# as_stranger EXAMPLE BUILD OPTION…: builds it in the folder BUILD; with our warnings as errors the objects are those that the
# tests' images have made before.
as_stranger() {
  copy=$build/stranger/$1
  folder=$build/$2
  rm -rf "$copy"
  mkdir -p "$build/stranger"
  cp -R "$source/examples/$1" "$copy"
  shift 2
  { cmake -G Ninja -S "$copy" -B "$folder" -DSPANLINE_DIR="$source" -DSPANLINE_TOOL="$tool" -DSPANLINE_WERROR=ON \
      -DCMAKE_BUILD_TYPE=Release "$@" &&
      cmake --build "$folder"; } > "$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
  ! grep 'warning:' "$folder.log" || { echo "$folder: warnings"; exit 1; }
}

# at_least COUNT WHAT: of that many different lines on the standard input.
at_least() {
  found=$(LC_ALL=C sort -u | grep -c . || :)
  [ "$found" -ge "$1" ] || { echo "$2: no picture, $found shades only"; exit 1; }
}

as_stranger minimal minimal
"$build/minimal/minimal" > "$build/minimal.txt"
cat "$build/minimal.txt"
# At least four shades of something in front of the background.
fold -w 1 "$build/minimal.txt" | tr -d ' ' | at_least 4 minimal

command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
for board in pico stm32f429i-disc1 ek-lm3s6965; do
  as_stranger board "board-$board" --toolchain "$source/toolchain/arm-none-eabi.cmake" -DSPANLINE_BOARD="$board"
  printf 'board, for %s: ' "$board"
  sh "$source/tests/target/image_checks.sh" "$build/board-$board/lantern.elf"
done
[ -s "$build/board-pico/lantern.uf2" ] || { echo "board: no lantern.uf2 for the Pico"; exit 1; }

command -v qemu-system-arm > /dev/null || { echo "skipped: no qemu-system-arm"; exit 77; }
for frame in 0 40; do
  sh "$source/firmware/boards/emulate.sh" "$build/board-ek-lm3s6965" lantern "$frame" "$build/lantern-$frame.ppm"
  tail -c +16 "$build/lantern-$frame.ppm" | od -An -v -tx1 -w3 | at_least 4 "lantern, frame $frame"
done
! cmp -s "$build/lantern-0.ppm" "$build/lantern-40.ppm" || { echo "lantern: it does not turn"; exit 1; }
