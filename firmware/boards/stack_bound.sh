#!/bin/sh
# Prints the bytes of stack that an image can use at most, by its machine code, one exception included.
# usage: stack_bound.sh SPANLINE IMAGE.elf BOARD    (SPANLINE: the host tool; where it cannot look at images: exit 77)
set -eu
[ $# -eq 3 ] || { echo "usage: stack_bound.sh SPANLINE IMAGE.elf BOARD" >&2; exit 2; }
"$1" budget --help > /dev/null 2>&1 || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sh "$(dirname "$0")/stack_notes.sh" "$2" > "$work/notes"
"$1" budget "$2" --board "$3" --until main --stack-notes "$work/notes" --json "$work/report.json" > "$work/report.txt" ||
  { cat "$work/report.txt" >&2; exit 1; }
sed -n 's/^    "bound": \([0-9]*\),$/\1/p' "$work/report.json"
