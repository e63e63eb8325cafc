#!/bin/sh
# Prints the argument of QEMU's -device that makes the request of firmware/boards/common/run_request.hpp: to stop after
# frame K, written into the image's RAM before the reset. usage: request.sh IMAGE.elf K
set -eu
[ $# -eq 2 ] || { echo "usage: request.sh IMAGE.elf K" >&2; exit 2; }
address=$(arm-none-eabi-nm "$1" | awk '$3 == "run_request" { print "0x" $1 }')
[ -n "$address" ] || { echo "request: $1 has no run_request" >&2; exit 1; }
printf 'loader,addr=%s,data=0x%08x%08x,data-len=8\n' "$address" $(($2 ^ 0x5350414E)) "$2"
