#!/bin/sh
# The budgets of a board's images: runs four frames of each (one on the micro:bit, whose few pools make it slow), writes a report in text, JSON and HTML, and holds it to the
# limits in the board's budgets.json. usage: budget.sh SPANLINE IMAGES BOARD REPORTS [--accept]
# IMAGES: the folder of the ELF files; REPORTS: gets BOARD-DEMO.txt, .json, .html and, where the board has a panel, .ppm;
# --accept: what the images take now, and a margin, becomes the limit
set -eu
[ $# -ge 4 ] || { echo "usage: budget.sh SPANLINE IMAGES BOARD REPORTS [--accept]" >&2; exit 2; }
spanline=$1 images=$2 board=$3 reports=$4
here=$(cd "$(dirname "$0")" && pwd)
[ "${5:-}" = --accept ] && hold=--accept || hold=--limits
mkdir -p "$reports"
"$spanline" budget --help | grep -q -e --limits || { echo "skipped: this build cannot run images"; exit 77; }

[ "$board" = microbit ] && frames=1 || frames=4
status=0
for demo in $("$spanline" demo --list); do
  [ -f "$images/$demo.elf" ] || continue  # the board has no room for it
  # Nothing is held against a demo whose limits have not been accepted yet.
  [ "$hold" = --accept ] || grep -q "^ \"$demo\": " "$here/$board/budgets.json" || continue
  report=$reports/$board-$demo
  # Emulator-only boards have no panel that is modelled.
  case $board in mps2-* | microbit) shown= ;; *) shown="--out $report.ppm" ;; esac
  sh "$here/stack_notes.sh" "$images/$demo.elf" > "$report.notes"
  # shellcheck disable=SC2086  # an option and its value, or nothing
  if "$spanline" budget "$images/$demo.elf" --board "$board" --frames $frames --stack-notes "$report.notes" $shown \
    --json "$report.json" --html "$report.html" "$hold" "$here/$board/budgets.json" > "$report.txt" 2> "$report.err"; then
    sed -n '/^run:/{n;s/^ */'"$demo"': /p;}' "$report.txt"
  else
    status=1
    sed -n '/^over budget/p' "$report.txt"
    cat "$report.err" >&2
  fi
  rm -f "$report.err" "$report.notes"
done
exit "$status"
