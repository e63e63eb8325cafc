#!/bin/sh
# How the area sort's work grows with the polygons: builds an image for each size, executes them and writes the table of
# docs/growth.md.
# usage: growth.sh SOURCE WORK OUT.md
set -eu
[ $# -eq 3 ] || { echo "usage: growth.sh SOURCE WORK OUT.md" >&2; exit 2; }
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
source=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
out=$3
windowed="100-16 300-16 1000-16 3000-16 10000-16"
whole="100-0 300-0 1000-0"

quiet() { "$@" > "$work/build.log" 2>&1 || { cat "$work/build.log" >&2; exit 1; }; }
list=$(echo "$windowed $whole" | tr ' ' ';')
quiet cmake -G Ninja -S "$source/tests/bench/growth/image" -B "$work/images" --toolchain "$source/toolchain/arm-none-eabi.cmake" \
  -DSPANLINE_BOARD="$source/tests/bench/board" -DSPANLINE_CPU=cortex-m4 -DCMAKE_BUILD_TYPE=Release \
  -DSPANLINE_GROWTHS="$list"
# shellcheck disable=SC2046  # a list of targets
quiet cmake --build "$work/images" -j 2 --target $(for size in $windowed $whole; do echo "growth-$size"; done)

# "polygons most pairs clips windows pieces memory thousands" of one image.
count() {
  request=$(sh "$source/firmware/boards/request.sh" "$work/images/growth-$1.elf" 0)
  timeout 900 qemu-system-arm -M mps2-an386 -icount shift=0 -display none -monitor none -serial none -chardev stdio,id=console \
    -semihosting-config enable=on,target=native,chardev=console -device "$request" -kernel "$work/images/growth-$1.elf" < /dev/null > "$work/$1.out" ||
    { cat "$work/$1.out" >&2; exit 1; }
  awk -F = -v size="$1" '
    NF == 2 { value[$1] = $2 + 0 }
    END {
      split(size, part, "-")
      print part[1], part[2], value["pairs"], value["clips"], value["windows"], value["pieces"], value["memory"], value["thousands"]
    }' "$work/$1.out"
}

for size in $windowed $whole; do count "$size"; done > "$work/counts"
awk '
  function power(a, b, na, nb) { return sprintf("%.2f", log(b / a) / log(nb / na)) }
  function heading(text) {
    print ""
    print text
    print ""
    print "| polygons | lateral comparisons | clips | windows | pieces | million instructions | grows as n to the (comparisons, clips, instructions) |"
    print "|---|---|---|---|---|---|---|"
  }
  BEGIN {
    print "# How the area sort grows"
    print ""
    print "Made by `sh tests/bench/growth/growth.sh . build/growth docs/growth.md`: the image of each line is"
    print "executed by an emulated Cortex-M4 that counts instructions. Kites of random size and slant at random levels; more polygons"
    print "are smaller ones, so that as many lie over a place, and nearly all are partly visible. A lateral comparison holds a"
    print "piece against a clip polygon; unless their boxes or the line of an edge part them, or the piece lies within all edges of"
    print "the other, it takes a run of the clipper."
  }
  {
    if ($2 != most || NR == 1) {
      heading($2 == 0 ? "One window, the sort of the seed:" : "Windows of at most " $2 " polygons, in " $7 " bytes of pools:")
      line = "| %s | %s | %s | %s | %s | %s | |\n"
      first = 1
    }
    grows = first ? "" : power(pairs, $3, n, $1) ", " power(clips, $4, n, $1) ", " power(count, $8, n, $1)
    printf "| %s | %s | %s | %s | %s | %s | %s |\n", $1, $3, $4, $5, $6, sprintf("%.1f", $8 / 1000), grows
    if (first) { n0 = $1; pairs0 = $3; clips0 = $4; count0 = $8 }
    first = 0
    most = $2; n = $1; pairs = $3; clips = $4; count = $8
    if (most > 0) whole_range = "Over the whole range of the first table: comparisons n^" power(pairs0, pairs, n0, n) ", clips n^" power(clips0, clips, n0, n) ", instructions n^" power(count0, count, n0, n) "."
  }
  END { print ""; print whole_range }' "$work/counts" > "$out.part"
mv "$out.part" "$out"
