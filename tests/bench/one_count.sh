#!/bin/sh
# QEMU counts the same instructions as we do: it translates them one by one, names each as it executes it, and those between
# the marks are counted.
# usage: one_count.sh SOURCE IMAGE.elf CPU EXPECTED
set -eu
[ $# -eq 4 ] || { echo "usage: one_count.sh SOURCE IMAGE.elf CPU EXPECTED" >&2; exit 2; }
command -v qemu-system-arm > /dev/null || { echo "skipped: no qemu-system-arm"; exit 77; }
address_of() { arm-none-eabi-nm "$2" | awk -v name="$1" '$3 == name { print $1 }'; }
request=$(sh "$1/firmware/boards/request.sh" "$2" 0)
counted=$(timeout 120 qemu-system-arm -M lm3s6965evb -cpu "$3" -display none -monitor none -serial none -chardev null,id=console \
  -semihosting-config enable=on,target=native,chardev=console -device "$request" -kernel "$2" -singlestep -d exec,nochain \
  -D /dev/stderr < /dev/null 2>&1 > /dev/null |
  awk -F / -v begin="$(address_of frame_begin_mark "$2")" -v end="$(address_of frame_end_mark "$2")" '
    $2 == begin { counting = 1 }
    $2 == end { print count + 0; exit }
    counting { ++count }')
echo "QEMU counts $counted instructions, expected $4"
[ "$counted" = "$4" ]
