#!/bin/sh
# The memory image on one emulated core: cross-builds it, checks what it contains, runs it, and holds its figures to the goal:
# sums within 16 KB and 8 KB, status ok, the host's picture in both budgets.
# usage: memory.sh SOURCE BUILD SCENES HOST CPU    (SCENES: compiled scenes; HOST: the host's twin of the image; CPU: cortex-m3 …)
set -eu
[ $# -eq 5 ] || { echo "usage: memory.sh SOURCE BUILD SCENES HOST CPU" >&2; exit 2; }
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
mkdir -p "$2"
source=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)/$5
scenes=$(cd "$3" && pwd)
here=$(cd "$(dirname "$0")" && pwd)

quiet() { "$@" > "$build.log" 2>&1 || { cat "$build.log"; exit 1; }; }
quiet cmake -G Ninja -S "$here/image" -B "$build" --toolchain "$source/toolchain/arm-none-eabi.cmake" -DSPANLINE_CPU="$5" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DSPANLINE_SCENES="$scenes"
quiet cmake --build "$build" -j 2 --target memory

report=$build/memory.txt
"$4" > "$build/host.txt" || { echo "the host's twin failed:"; cat "$build/host.txt"; exit 1; }
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
