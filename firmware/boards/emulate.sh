#!/bin/sh
# Runs an image under QEMU until it has shown frame K, and keeps what its panel shows, or, on a board without one, prints
# what the image says. usage: emulate.sh BUILD DEMO K DUMP.ppm [CPU]
# BUILD: the board's build folder (build/firmware/BOARD); CPU: another core than the board's own, where the emulator
# can take one.
set -eu
[ $# -ge 4 ] || { echo "usage: emulate.sh BUILD DEMO K DUMP.ppm [CPU]" >&2; exit 2; }
image=$1/$2.elf
last=$3
dump=$4
. "$1/board.sh"
[ -n "$machine" ] || { echo "emulate: no emulator has this board" >&2; exit 2; }
another_core=${5:+-cpu $5}
patience=${SPANLINE_EMULATE_SECONDS:-60}

request=$(sh "$(dirname "$0")/request.sh" "$image" "$last")

work=$(mktemp -d)
emulator=
finish() {
  [ -z "$emulator" ] || kill "$emulator" 2> /dev/null || :
  rm -rf "$work"
}
trap finish EXIT
trap 'exit 1' HUP INT TERM
mkfifo "$work/monitor"
: > "$work/said"

# shellcheck disable=SC2086  # two words or none
timeout "$patience" qemu-system-arm -M "$machine" $another_core -display none -serial none -monitor none -qmp stdio \
  -chardev "file,id=console,path=$work/said" -semihosting-config enable=on,target=native,chardev=console \
  -device "$request" -kernel "$image" \
  < "$work/monitor" > "$work/answers" 2> "$work/errors" &
emulator=$!
trap '' PIPE  # an emulator that is gone hears no monitor command
exec 3> "$work/monitor"

if [ -n "$screendump" ]; then
  # The picture stays on the panel when the image has come to rest.
  while kill -0 "$emulator" 2> /dev/null && ! grep -q '^shown ' "$work/said"; do sleep 0.05; done
  { echo '{"execute": "qmp_capabilities"}'
    printf '{"execute": "screendump", "arguments": {"filename": "%s"}}\n' "$work/dump.ppm"
    echo '{"execute": "quit"}'; } >&3 2> /dev/null || :
fi
status=0
wait "$emulator" || status=$?
emulator=

cat "$work/said"
# A panel's protocol error does not stop the emulator.
if grep -q error "$work/errors" || [ "$status" -ne 0 ] || ! grep -q '^shown ' "$work/said"; then
  head -n 5 "$work/errors" >&2
  [ "$status" -ne 124 ] || echo "emulate: frame $last was not shown within $patience s" >&2
  echo "emulate: the image failed ($status)" >&2
  exit 1
fi
[ -z "$screendump" ] || mv "$work/dump.ppm" "$dump"
