#!/bin/sh
# Writes the measured parts of docs/performance.md from what frames.sh left in WORK; counts the growth and the screen sizes.
# usage: performance_page.sh SOURCE WORK HOST_TOOLS PAGE    (HOST_TOOLS: the folder with spanline and spanline-frames)
set -eu
[ $# -eq 4 ] || { echo "usage: performance_page.sh SOURCE WORK HOST_TOOLS PAGE" >&2; exit 2; }
source=$(cd "$1" && pwd)
work=$(cd "$2" && pwd)
tools=$3
page=$4

# rows FRAMES.json: a line "scene cpu shading instructions ram text" for each frame.
rows() {
  tr -d '",' < "$1" | awk '
    $1 ~ /:$/ { v[substr($1, 1, length($1) - 1)] = $2 }
    $1 == "}" { print v["scene"], v["cpu"], v["shading"], v["instructions"], v["ram_bytes"], v["text_bytes"] }'
}

{
  echo '| scene | core | shading | instructions | RAM | code |'
  echo '|---|---|---|--:|--:|--:|'
  rows "$work/frames.json" | awk '{ printf "| %s | %s | %s | %d | %d | %d |\n", $1, $2, $3, $4, $5, $6 }'
} > "$work/figures.md"

# The ten functions that take most, of S3 flat.
{
  for cpu in m4 m0plus; do
    printf '\n%s:\n\n| function | instructions | cycles |\n|---|--:|--:|\n' "$cpu"
    "$tools/spanline" budget "$work/$cpu/S3-flat.elf" --board cortex-$cpu --from frame_begin_mark --until frame_end_mark --no-stack |
      awk '/^ *instructions +cycles +function/ { on = 1; next }
        on && ++n <= 10 { name = $0; sub(/^ *[0-9]+ +[0-9]+ +/, "", name); sub(/^(bool|void) /, "", name); while (sub(/<[^<>]*>/, "", name)); sub(/[<(].*/, "", name)
          printf "| `%s` | %d | %d |\n", name, $1, $2 }'
  done
} > "$work/functions.md"

"$tools/spanline-frames" pieces "$work" m4 m3 m0plus > "$work/pieces.md"

"$tools/spanline-frames" parts "$work/m4/S3-flat.map" "$work/m4/S3-gouraud.map" > "$work/parts.md"

sh "$source/tests/bench/kept.sh" "$source" "$work" "$tools/spanline" > "$work/kept.md"

sh "$source/tests/bench/half.sh" "$source" "$work" "$tools/spanline-frames" "$work/frames.json" > "$work/half.md" ||
  { grep FAILED "$work/half.md" >&2; exit 1; }

sh "$source/tests/bench/growth.sh" "$source" "$work" "$tools/spanline-frames" > "$work/growth.md"

mkdir -p "$work/sizes"
set --
for size in 160x120 320x240 640x480; do
  sed -e "s|\[320, 240\]|[${size%x*}, ${size#*x}]|" -e "s|\.\./bench/|$source/assets/bench/|" "$source/assets/scenes/S3.json" \
    > "$work/sizes/$size.json"
  set -- "$@" "$work/sizes/$size.json"
done
sh "$source/tests/bench/frames.sh" "$source" "$work/sizes" "$tools/spanline-frames" m4 "flat gouraud" "$@" > "$work/sizes/table.txt"
{
  echo '| screen | shading | instructions | a pixel |'
  echo '|---|---|--:|--:|'
  rows "$work/sizes/frames.json" | awk '{ split($1, s, "x"); printf "| %s | %s | %d | %.1f |\n", $1, $3, $4, $4 / s[1] / s[2] }'
} > "$work/sizes.md"

# What stands between "<!-- measured: NAME -->" and "<!-- end -->" comes from WORK/NAME.md.
awk -v work="$work" '
  /^<!-- measured: / { print; print ""; while ((getline line < (work "/" $3 ".md")) > 0) print line; print ""; inside = 1; next }
  /^<!-- end -->/ { inside = 0 }
  !inside' "$page" > "$page.new"
mv "$page.new" "$page"
