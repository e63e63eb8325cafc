#!/bin/sh
# bounded_waits.sh finds loops that may wait for ever.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/firmware/hal" "$work/firmware/boards" "$work/firmware/demos"

# catches LINE
catches() {
  printf '%s\n' "$1" > "$work/firmware/hal/wait.hpp"
  ! sh "$here/bounded_waits.sh" "$work" > /dev/null || { echo "not caught: $1"; exit 1; }
}

catches '  while (State::any(kBusy)) {'
catches '  while (!ready());'
catches '  while (!ready()) ;'
catches '  for (;;) {'
catches '  for (; !State::all(1);) {}'
catches '  while (true) {'

printf '%s\n' '  for (unsigned i = 0; i < 8; ++i) step();' '  } while (number != 0);' '  while (power < 7) ++power;' > "$work/firmware/hal/wait.hpp"
sh "$here/bounded_waits.sh" "$work"
