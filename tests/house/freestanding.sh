#!/bin/sh
# The engine on a bare Cortex-M: cross-builds core and a probe that instantiates its templates, checks what they ask of the
# platform, and prints the code size of each room and of a linked image.
# usage: freestanding.sh SOURCE BUILD PRESET…      (PRESET: m0 m0plus m3 m4 m7 m33; everything is written below BUILD)
set -eu
[ $# -ge 3 ] || { echo "usage: freestanding.sh SOURCE BUILD PRESET…" >&2; exit 2; }
command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
mkdir -p "$2"
source=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
shift 2

for preset in "$@"; do
  log=$build/$preset.log
  (cd "$source" && cmake --preset "$preset" -B "$build/$preset" > "$log" 2>&1) || { cat "$log"; exit 1; }
  cmake --build "$build/$preset" > "$log" 2>&1 || { cat "$log"; exit 1; }
  cpu=$(sed -n 's/^SPANLINE_CPU:[A-Z]*=//p' "$build/$preset/CMakeCache.txt")
  flags="-mcpu=$cpu -mthumb -mfloat-abi=soft"
  probe=$build/$preset/probe
  # shellcheck disable=SC2086  # flags is a list
  arm-none-eabi-g++ $flags -O2 -std=c++20 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections \
    -fdata-sections -Wall -Wextra -Werror -I "$source/firmware" -c "$here/probe.cpp" -o "$probe.o"
  archives=$(find "$build/$preset" -name 'libspanline_*.a' | LC_ALL=C sort)

  echo "$cpu, -O2:"
  # shellcheck disable=SC2086
  sh "$here/undefined_symbols.sh" $archives "$probe.o" > "$build/$preset.symbols" || { cat "$build/$preset.symbols"; exit 1; }
  sed 's/^/  /' "$build/$preset.symbols"
  for archive in $archives; do
    arm-none-eabi-size -t "$archive" | awk -v room="$(basename "$archive" .a | sed 's/^libspanline_//')" \
      '/TOTALS/ { printf "  %-10s %7d bytes of code and tables\n", room, $1 }'
  done
  # shellcheck disable=SC2086
  arm-none-eabi-g++ $flags -nostdlib -Wl,--gc-sections -Wl,-e,draw_frame -Wl,--no-warn-rwx-segments "$probe.o" \
    -Wl,--start-group $archives -lgcc -lc_nano -Wl,--end-group -o "$probe.elf" 2> "$log" || { cat "$log"; exit 1; }
  arm-none-eabi-size "$probe.elf" | awk 'NR == 2 {
    printf "  linked     %7d bytes of code and tables\n", $1
    printf "  memory     %7d bytes: the default Budget, 320 x 240 RGB565, and one line buffer\n", $2 + $3 }'
done
