#!/bin/sh
# What flashing calls, and what it says where something is missing: with programmers that only keep what they were told.
# usage: flash.sh SOURCE
set -eu
[ $# -eq 1 ] || { echo "usage: flash.sh SOURCE" >&2; exit 2; }
flash=$(cd "$1" && pwd)/firmware/boards/flash.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tools" "$work/none" "$work/drive" "$work/disc" "$work/pico" "$work/mps2"
for tool in sh basename cp sync echo; do ln -s "$(command -v "$tool")" "$work/none/$tool"; done
printf 'openocd=board/disc.cfg\nuf2=\n' > "$work/disc/board.sh"
printf 'openocd=\nuf2=yes\n' > "$work/pico/board.sh"
printf 'openocd=\nuf2=\n' > "$work/mps2/board.sh"
echo image > "$work/pico/gears.uf2"

# tool NAME STATUS [SAYS]: a programmer that keeps its arguments.
tool() {
  printf '#!/bin/sh\nprintf "%%s\\n" "$@" > "%s/told"\n%s\nexit %s\n' "$work" "${3:-}" "$2" > "$work/tools/$1"
  chmod +x "$work/tools/$1"
}

# flashing BOARD STATUS PATTERN: gears, with the tools there are.
flashing() {
  status=0
  said=$(PATH=$work/tools:$work/none sh "$flash" "$work/$1" gears 2>&1) || status=$?
  if [ "$status" -ne "$2" ] || ! printf '%s\n' "$said" | grep -q -e "$3"; then
    printf '%s: ended with %s, said:\n%s\nexpected %s and: %s\n' "$1" "$status" "$said" "$2" "$3"
    exit 1
  fi
}

told() { printf '%s\n' "$@" | cmp - "$work/told" || { echo "told:"; cat "$work/told"; exit 1; }; }

tool findmnt 1
flashing disc 1 'no openocd: install it with'
flashing pico 1 'no picotool and no drive RPI-RP2: hold BOOTSEL'
flashing mps2 2 'exists in the emulator only: ./dev emulate mps2'

tool openocd 0
flashing disc 0 '^disc shows gears$'
told -f board/disc.cfg -c "program $work/disc/gears.elf verify reset exit"
tool openocd 1
flashing disc 1 'is the disc connected'

tool findmnt 0 "echo $work/drive"
flashing pico 0 '^pico shows gears$'
cmp "$work/pico/gears.uf2" "$work/drive/gears.uf2"
tool picotool 0
flashing pico 0 '^pico shows gears$'
told load -x "$work/pico/gears.uf2"
tool picotool 1
flashing pico 1 'picotool found no board in boot mode'
