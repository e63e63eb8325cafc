#!/bin/sh
# No endless wait in firmware/: a loop there counts, or it is one of the few that end a run on purpose. Registers are waited for
# through wait_for() (hal/mcu/mmio.hpp), which gives up.
# usage: bounded_waits.sh SOURCE
set -eu
[ $# -eq 1 ] || { echo "usage: bounded_waits.sh SOURCE" >&2; exit 2; }
cd "$1/firmware"

# The ends of a run: asleep with the picture shown, leaving the emulator, blinking a fault's cause, frame after frame.
ends='boards/common/clocked.hpp.*wfi
hal/mcu/semihosting.hpp.*kExitExtended
boards/common/report.cpp:[0-9]*:  for (;;) {
boards/common/main.cpp:[0-9]*:  for (std::uint32_t shown = 0;; ++shown) {'

# Loops without a condition, and those that do nothing but ask.
found=$(grep -rnE 'for \([^;]*; *;|while \((true|1)\)|^[[:space:]]*while \([^;]*\) *;|while \(.*(get|any|all)\(|for \(.*(get|any|all)\(.*; *\)' \
  hal boards demos \
  --include='*.hpp' --include='*.cpp' | grep -v -e "$ends" || :)
[ -z "$found" ] || { printf 'waits without end:\n%s\n' "$found"; exit 1; }
