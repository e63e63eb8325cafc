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
host=$("$4") || { echo "the host's twin failed: $host"; exit 1; }
status=0
sh "$here/image_checks.sh" "$build/memory.elf" > "$report" || { cat "$report"; exit 1; }
sh "$here/emulate.sh" "$5" "$build/memory.elf" >> "$report" || status=$?
cat "$report"
echo "host $host"
[ "$status" -eq 0 ] || { echo "the image ended with $status"; exit 1; }

awk -v host="$host" '
  function value(line, key) { return match(line, "(^| )" key "=[^ ]*") ? substr(line, RSTART + length(key) + (RSTART > 1) + 1, RLENGTH - length(key) - (RSTART > 1) - 1) : "" }
  function fail(text) { print "FAILED: " text; bad = 1 }
  /^budget=/ {
    ++budgets
    name = value($0, "budget")
    most = name == "16K" ? 16384 : 8192
    if (value($0, "status") != "ok") fail(name ": status " value($0, "status"))
    if (value($0, "sum") + 0 > most) fail(name ": " value($0, "sum") " bytes are " value($0, "sum") - most " too many")
    if (value($0, "stack") + 0 <= value($0, "frame") + 0) fail(name ": the stack was not measured")
    if (value($0, "checksum") != value(host, "checksum")) fail(name ": not the picture of the host")
  }
  END {
    if (budgets != 2) fail("two budgets expected, " budgets + 0 " reported")
    exit bad
  }' "$report"
