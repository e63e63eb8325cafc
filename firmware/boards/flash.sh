#!/bin/sh
# Programs a connected board with an image: by openocd, by picotool, or as a copy to the drive that a Pico in boot mode shows.
# Exits with 2 where the board cannot be programmed at all, with 1 where something is missing: it says what.
# usage: flash.sh BUILD DEMO    (BUILD: the board's build folder, build/firmware/BOARD)
set -eu
[ $# -eq 2 ] || { echo "usage: flash.sh BUILD DEMO" >&2; exit 2; }
board=$(basename "$1")
image=$1/$2
. "$1/board.sh"

give_up() { echo "dev flash: $2" >&2; exit "$1"; }

by_openocd() {
  command -v openocd > /dev/null || give_up 1 "no openocd: install it with sudo apt-get install openocd"
  openocd -f "$openocd" -c "program $image.elf verify reset exit" ||
    give_up 1 "openocd did not program it: is the $board connected, and may you use its probe ($openocd)?"
}

by_uf2() {
  if command -v picotool > /dev/null; then
    picotool load -x "$image.uf2" ||
      give_up 1 "picotool found no board in boot mode: hold BOOTSEL while plugging in the $board"
    return
  fi
  drive=$(findmnt -rn -o TARGET -S LABEL=RPI-RP2 || :)
  [ -n "$drive" ] ||
    give_up 1 "no picotool and no drive RPI-RP2: hold BOOTSEL while plugging in the $board, mount the drive"
  cp "$image.uf2" "$drive/"
  sync
}

if [ -n "$openocd" ]; then
  by_openocd
elif [ -n "$uf2" ]; then
  by_uf2
else
  give_up 2 "$board exists in the emulator only: ./dev emulate $board"
fi
echo "$board shows $2"
