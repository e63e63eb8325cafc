#!/bin/sh
# Runs an image under QEMU and prints what it says; the exit status is the image's. One emulated board serves every core.
# The board's model ignores accesses outside its memory where silicon faults: a stack overflow is a run that does not end (124).
# usage: emulate.sh CPU IMAGE.elf
set -eu
[ $# -eq 2 ] || { echo "usage: emulate.sh CPU IMAGE.elf" >&2; exit 2; }
request=$(sh "$(dirname "$0")/../../firmware/boards/request.sh" "$2" 0)
exec timeout "${SPANLINE_TARGET_SECONDS:-120}" qemu-system-arm -M lm3s6965evb -cpu "$1" -display none -monitor none -serial none -chardev stdio,id=console \
  -semihosting-config enable=on,target=native,chardev=console -device "$request" -kernel "$2" < /dev/null
