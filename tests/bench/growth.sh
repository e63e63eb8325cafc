#!/bin/sh
# How the cost of a frame grows with the triangles of one shape on one screen: balls of 120 to 19,880 triangles on a Cortex-M4.
# Fits a + b triangles + c crossings and fails where a ball is more than 10 % off, or where from 1,000 triangles on the cost
# grows faster than their number to the power of 1.1. Prints a table in Markdown, and what the largest takes on a Cortex-M7.
# usage: growth.sh SOURCE WORK FRAMES    (FRAMES: the tool spanline-frames)
set -eu
[ $# -eq 3 ] || { echo "usage: growth.sh SOURCE WORK FRAMES" >&2; exit 2; }
. "$1/tests/bench/images.sh"
begin_images "$1" "$2/growth" "$3"
. "$source/tests/bench/balls.sh"
set --
for rings in 6 9 16 28 50 71; do
  ball $rings "$work"
  set -- "$@" "$work/ball$rings.json"
done
sh "$source/tests/bench/frames.sh" "$source" "$work" "$tool" m4 flat "$@" > "$work/table.txt"

# instructions SCENE: of the frames counted last.
instructions() {
  tr -d '",' < "$work/frames.json" | awk -v name="$1" '$1 == "scene:" { scene = $2 } $1 == "instructions:" && scene == name { print $2 }'
}

# One line a ball: triangles, crossings, instructions.
for rings in 6 9 16 28 50 71; do
  tr -d '",' < "$work/frames/ball$rings-flat/expected.json" |
    awk '$1 == "faces:" { faces = $2 } $1 == "edge_crossings:" { crossings = $2 } END { printf "%d %d ", faces, crossings }'
  instructions "ball$rings"
done > "$work/counted.txt"

awk '
  { n[NR] = $1; x[NR] = $2; y[NR] = $3 }
  # Least squares of the relative error: rows (1, n, x) / y against 1.
  END {
    for (r = 1; r <= NR; ++r) {
      v[1] = 1 / y[r]; v[2] = n[r] / y[r]; v[3] = x[r] / y[r]
      for (i = 1; i <= 3; ++i) { for (j = 1; j <= 3; ++j) m[i, j] += v[i] * v[j]; m[i, 4] += v[i] }
    }
    for (i = 1; i <= 3; ++i) for (k = 1; k <= 3; ++k) if (k != i) {
      f = m[k, i] / m[i, i]
      for (j = i; j <= 4; ++j) m[k, j] -= f * m[i, j]
    }
    for (i = 1; i <= 3; ++i) p[i] = m[i, 4] / m[i, i]
    print "| triangles | crossings | instructions | a triangle | the fit is off by |\n|--:|--:|--:|--:|--:|"
    for (r = 1; r <= NR; ++r) {
      off = (p[1] + p[2] * n[r] + p[3] * x[r]) / y[r] - 1
      if (off * off > 0.01) bad = 1
      printf "| %d | %d | %d | %.0f | %.1f %% |\n", n[r], x[r], y[r], y[r] / n[r], 100 * off
    }
    power = log(y[NR] / y[3]) / log(n[NR] / n[3])
    printf "\nInstructions = %.0f + %.0f triangles + %.1f crossings; from %d to %d triangles the cost grows as n^%.2f.\n", p[1], p[2], p[3], n[3], n[NR], power
    exit bad || power > 1.1
  }' "$work/counted.txt"

# The largest on a Cortex-M7, of which 20,000 triangles at 30 frames a second and 600 MHz have been published.
sh "$source/tests/bench/frames.sh" "$source" "$work" "$tool" m7 flat "$work/ball71.json" > "$work/table.txt"
instructions ball71 | awk '{
  printf "\nOn a Cortex-M7 the last one takes %d instructions, %.0f million a second at 30 frames: one in each %.1f cycles of 600 MHz, at which\n", $1, 30 * $1 / 1e6, 600e6 / 30 / $1
  print "20,000 triangles at that rate are the published peak." }'
