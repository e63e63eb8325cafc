#!/bin/sh
# A board's images: builds all of them, checks what they contain, runs those that an emulator knows, and compares what
# they show with the host, pixel for pixel where the emulator has the panel, else by the sums of lines and frames.
# usage: images.sh SOURCE BUILD HOST_TOOLS HOST_SUMS BOARD
# HOST_TOOLS: the folder with spanline and spanline-screendump
set -eu
[ $# -eq 5 ] || { echo "usage: images.sh SOURCE BUILD HOST_TOOLS HOST_SUMS BOARD" >&2; exit 2; }
command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
mkdir -p "$2"
source=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)/$5
tools=$3
sums=$4
board=$5
demos=
[ "$board" = template ] && known=pico || known=$board  # to the host tool: the template is a Pico's

quiet() { "$@" > "$build.log" 2>&1 || { cat "$build.log"; exit 1; }; }
quiet cmake -G Ninja -S "$source" -B "$build" --toolchain "$source/toolchain/arm-none-eabi.cmake" \
  -DSPANLINE_BOARD="$board" -DCMAKE_BUILD_TYPE=Release -DSPANLINE_HOST=OFF \
  -DSPANLINE_TESTS=OFF -DSPANLINE_BENCHMARKS=OFF -DSPANLINE_TOOL="$tools/spanline"
quiet cmake --build "$build" -j 2

for image in "$build"/*.elf; do
  demo=$(basename "$image" .elf)
  demos="$demos $demo"
  printf '%s ' "$demo"
  sh "$source/tests/target/image_checks.sh" "$build/$demo.elf"
  # Where the host tool can look into images, it bounds the stack, which what runs must keep to.
  reserved=$(arm-none-eabi-nm "$build/$demo.elf" | awk '$3 == "stack_bottom" || $3 == "stack_top" { print "0x" $1 }' | sort | tr '\n' ' ')
  # shellcheck disable=SC2086  # two addresses
  set -- $reserved
  bound=$(sh "$source/firmware/boards/stack_bound.sh" "$tools/spanline" "$build/$demo.elf" "$known") || [ $? -eq 77 ]
  echo "$demo stack=$(($2 - $1)) bound=${bound:-unknown}"
  [ "${bound:-0}" -le $(($2 - $1)) ] || { echo "the stack is too small"; exit 1; }
  echo "${bound:-$(($2 - $1))}" > "$build/$demo.bound"
  for made in bin hex map; do [ -s "$build/$demo.$made" ] || { echo "no $demo.$made"; exit 1; }; done
done

. "$build/board.sh"
[ -n "$machine" ] || exit 0
command -v qemu-system-arm > /dev/null || { echo "skipped: no qemu-system-arm"; exit 77; }

# same DEMO FRAME: fails where the emulated panel and the host differ.
same() {
  shown=$build/$1-$2
  sh "$source/firmware/boards/emulate.sh" "$build" "$1" "$2" "$shown.dump.ppm" > "$shown.txt" ||
    { cat "$shown.txt"; exit 1; }
  if [ -n "$screendump" ]; then
    "$tools/spanline-screendump" "$shown.dump.ppm" 4 "$shown.ppm"
    "$tools/spanline" demo "$1" --board "$board" --frame "$2" --out "$shown.host.ppm" > /dev/null
    cmp "$shown.ppm" "$shown.host.ppm"
  else
    # The host's sums: every line of the last frame, every frame.
    "$sums" "$1" "$board" "$2" > "$shown.host.txt"
    grep -v '^shown' "$shown.txt" | cmp - "$shown.host.txt"
  fi
  used=$(sed -n 's/^shown .*stack=\([0-9]*\)$/\1/p' "$shown.txt")
  echo "$1 frame $2: as on the host, stack used $used of at most $(cat "$build/$1.bound")"
  [ "$used" -le "$(cat "$build/$1.bound")" ] || { echo "deeper than its bound"; exit 1; }
}

for demo in $demos; do
  same "$demo" 0
  same "$demo" 7
done
