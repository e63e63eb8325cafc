#!/bin/sh
# What the benchmark's frames take in about half the memory (Budget::band_vertices), and how many times as long as whole, as
# counted in WHOLE.json by frames.sh: a table in Markdown. Fails where it is more than is said, or more RAM than asked for.
# usage: half.sh SOURCE WORK FRAMES WHOLE.json    (FRAMES: the tool spanline-frames)
set -eu
[ $# -eq 4 ] || { echo "usage: half.sh SOURCE WORK FRAMES WHOLE.json" >&2; exit 2; }
scenes=$1/assets/scenes
work=$2                     # that of the whole frames, so that the engine is not built again
cp "$4" "$work/whole.json"  # which frames.sh may overwrite

# scene shading bytes, and how many hundredths of the whole frame's instructions at most on the M4 and on the M0+
cat > "$work/half-asked.txt" <<'TEXT'
S1 flat    2304 140 125
S1 gouraud 2464 149 141
S3 flat    5888 146 143
S3 gouraud 6656 144 144
S4 flat    9984 158 158
S4 gouraud 9984 159 160
TEXT
while read -r scene shading bytes _; do
  sh "$1/tests/bench/frames.sh" "$1" "$work" "$3" "m4 m0plus" "$shading" "$scenes/$scene.json@$bytes" > "$work/half-table.txt"
  mv "$work/frames.json" "$work/half-$scene-$shading.json"
done < "$work/half-asked.txt"
cp "$work/whole.json" "$4"

echo '| scene | core | shading | RAM asked for | RAM | instructions | times the whole |'
echo '|---|---|---|--:|--:|--:|--:|'
cat "$work"/whole.json "$work"/half-S*.json | tr -d '",' | awk '
  NR == FNR { asked[$1 " " $2] = $3; most[$1 " " $2 " m4"] = $4; most[$1 " " $2 " m0plus"] = $5; next }
  $1 ~ /:$/ { v[substr($1, 1, length($1) - 1)] = $2 }
  $1 != "}" { next }
  {
    cpu = v["cpu"]; shading = v["shading"]; scene = v["scene"]
    if (!sub(/-in-.*/, "", scene)) { whole[scene " " shading " " cpu] = v["instructions"]; next }
    name = scene " " shading " " cpu
    bytes = asked[scene " " shading]
    ++frames
    times = v["instructions"] / whole[name]
    printf "| %s | %s | %s | %d | %d | %d | %.2f |\n", scene, cpu, shading, bytes, v["ram_bytes"], v["instructions"], times
    if (100 * times > most[name] || v["ram_bytes"] > bytes) {
      print "FAILED: " name ": more than is said"
      bad = 1
    }
  }
  END {
    if (frames != 12) { print "FAILED: 12 frames expected, " frames + 0 " counted"; bad = 1 }
    exit bad
  }' "$work/half-asked.txt" -
