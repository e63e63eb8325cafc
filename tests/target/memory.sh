#!/bin/sh
# The memory image on one emulated core: cross-builds it, checks what it contains, runs it, and holds its figures to the goal:
# sums within 16 KB and 8 KB, status ok, the host's picture in both budgets.
# usage: memory.sh SOURCE BUILD SCENES SPANLINE CPU HOST    (as build.sh; HOST: the host's twin of the image)
set -eu
[ $# -eq 6 ] || { echo "usage: memory.sh SOURCE BUILD SCENES SPANLINE CPU HOST" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
build=$2
sh "$here/build.sh" "$1" "$2" "$3" "$4" "$5" memory

report=$build/memory.txt
"$6" > "$build/host.txt" || { echo "the host's twin failed:"; cat "$build/host.txt"; exit 1; }
status=0
sh "$here/image_checks.sh" "$build/memory.elf" > "$report" || { cat "$report"; exit 1; }
sh "$here/emulate.sh" "$5" "$build/memory.elf" >> "$report" || status=$?
cat "$report"
sed 's/^/host /' "$build/host.txt"
[ "$status" -eq 0 ] || { echo "the image ended with $status"; exit 1; }

awk '
  { split("", v); for (i = 1; i <= NF; ++i) { split($i, pair, "="); v[pair[1]] = pair[2] } }
  function fail(text) { print "FAILED: " text; bad = 1 }
  NR == FNR { host[v["scene"]] = v["checksum"]; next }
  "budget" in v {
    ++budgets
    name = v["budget"] " " v["scene"]
    most = v["budget"] == "16K" ? 16384 : 8192
    if (v["status"] != "ok") fail(name ": status " v["status"])
    if (v["sum"] + 0 > most) fail(name ": " v["sum"] " bytes are " v["sum"] - most " too many")
    if (v["stack"] + 0 <= v["frame"] + 0) fail(name ": the stack was not measured")
    if (v["checksum"] != host[v["scene"]]) fail(name ": not the picture of the host")
  }
  END {
    if (budgets != 4) fail("two scenes in two budgets expected, " budgets + 0 " reported")
    exit bad
  }' "$build/host.txt" "$report"
