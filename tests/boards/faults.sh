#!/bin/sh
# Images that fail on purpose say what happened, and a board's clock goes at its pace. Boards whose emulator faults on an
# access to nothing, as the parts do (others ignore it): one with ARMv6-M, one with ARMv8-M.
# usage: faults.sh SOURCE BUILD
set -eu
[ $# -eq 2 ] || { echo "usage: faults.sh SOURCE BUILD" >&2; exit 2; }
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
mkdir -p "$2"
source=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)

# said BOARD IMAGE: what the image prints.
said() {
  log=$build/$1.log
  cmake -G Ninja -S "$source/tests/boards/image" -B "$build/$1" --toolchain "$source/toolchain/arm-none-eabi.cmake" \
    -DSPANLINE_BOARD="$1" -DCMAKE_BUILD_TYPE=Release > "$log" 2>&1 &&
    cmake --build "$build/$1" -j 2 --target "$2" >> "$log" 2>&1 || { cat "$log"; exit 1; }
  machine=$(sed -n 's/.*SPANLINE_MACHINE \([^)]*\)).*/\1/p' "$source/firmware/boards/$1/board.cmake")
  printf 'machine=%s\nscreendump=\n' "$machine" > "$build/$1/board.sh"
  sh "$source/firmware/boards/emulate.sh" "$build/$1" "$2" 0 "$build/none.ppm" 2> "$build/$1/errors" || :
}

# says BOARD IMAGE PATTERN
says() {
  text=$(said "$1" "$2")
  echo "$1 $2: $text"
  printf '%s\n' "$text" | grep -Eq "$3" || { echo "expected: $3"; cat "$build/$1/errors"; exit 1; }
}

says microbit overflow '^fault: stack overflow, status=0x0 '
says microbit wild '^fault: hard fault, status=0x0 at=0x[1-9a-f]'
says mps2-an505 overflow '^fault: stack overflow, status=0x'
says mps2-an505 wild '^fault: hard fault, status=0x8200 at=0x1'
says ek-lm3s6965 time '^slept 5[0-9]{3} us'
