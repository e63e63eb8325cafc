#!/bin/sh
# Writes the measured part of docs/memory.md from what the memory tests (ctest -L target) left behind.
# usage: memory_page.sh IMAGES PAGE    (IMAGES: tests/target/images of a build tree)
set -eu
[ $# -eq 2 ] || { echo "usage: memory_page.sh IMAGES PAGE" >&2; exit 2; }
made=$(mktemp)
trap 'rm -f "$made"' EXIT

{
  echo
  echo '| core | scene | budget | `FrameMemory` | two lines | stack | of it `Frame` | sum | limit | bands | code and scene |'
  echo '|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|'
  for cpu in cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33; do
    awk -v cpu="$cpu" '
      { split("", v); for (i = 1; i <= NF; ++i) { split($i, pair, "="); v[pair[1]] = pair[2] } }
      $1 == "image" { code = v["code"] }
      "budget" in v {
        printf "| %s | %s | %s | %d | %d | %d | %d | **%d** | %d | %d | %d |\n", cpu, v["scene"], v["budget"], v["memory"], v["lines"], v["stack"],
          v["frame"], v["sum"], v["budget"] * 1024, v["bands"], code
      }' "$1/$cpu/memory.txt"
  done
  echo
  echo 'Bytes. Code is the whole image: engine, both scenes and the little around them.'
  echo
  echo 'What each pool costs; besides its blocks every pool has one more, the sink of its lists.'
  echo
  echo '| pool | bytes a block | 16K: blocks | bytes | 8K: blocks | bytes |'
  echo '|---|--:|--:|--:|--:|--:|'
  awk '
    { split("", v); for (i = 1; i <= NF; ++i) { split($i, pair, "="); v[pair[1]] = pair[2] } }
    "pool" in v {
      whole = v["block"] * (v["16K"] + 1)
      half = v["block"] * (v["8K"] + 1)
      printf "| %s | %d | %d | %d | %d | %d |\n", v["pool"], v["block"], v["16K"], whole, v["8K"], half
    }' "$1/cortex-m0/memory.txt"
  echo
} > "$made"

awk -v made="$made" '
  /^<!-- measured:/ { print; while ((getline line < made) > 0) print line; inside = 1; next }
  /^<!-- end -->/ { inside = 0 }
  !inside' "$2" > "$made.page"
mv "$made.page" "$2"
