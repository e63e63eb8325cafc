#!/bin/sh
# The teapot in patches, culled, at 320 x 240 and half a pixel on a Cortex-M4, everything counted (pools, two line buffers, the
# measured stack with the Frame on it): what it takes flat within 24 KB of RAM, in one band, and in less, in several; and in one
# band with Gouraud shading, and flat from both sides.
# Limits are what patches take and 5 %; in 24 KB that is less than three times what the mesh of 992 triangles takes the edge walker,
# 447 thousand instructions when it took least.
# usage: patches.sh SOURCE WORK FRAMES
set -eu
[ $# -eq 3 ] || { echo "usage: patches.sh SOURCE WORK FRAMES" >&2; exit 2; }
. "$1/tests/bench/images.sh"
begin_images "$1" "$2" "$3"

all=$work/frames/in-24-KB small=$work/frames/in-18-KB smooth=$work/frames/gouraud-in-26-KB
sides=$work/frames/both-sides-in-36-KB
rm -rf "$small"
"$tool" prepare "$source/assets/scenes/S3-patches-culled.json" --shading flat --out "$all"
"$tool" prepare "$source/assets/scenes/S3-patches-culled.json" --shading gouraud --out "$smooth"
"$tool" prepare "$source/assets/scenes/S3-patches.json" --shading flat --out "$sides"
# Of the planes that faces over one another take few are in use on a line.
sed -i 's/\.planes = [0-9]*/.planes = 7/' "$all/budget.hpp" "$smooth/budget.hpp"
cp -r "$all" "$small"
sed 's/\.patch_grid = [0-9]*/.patch_grid = 900/' "$all/budget.hpp" > "$small/budget.hpp"
if cmp -s "$all/budget.hpp" "$small/budget.hpp"; then echo "FAILED: the budget has no patch_grid"; exit 1; fi

build_images m4 in-24-KB in-18-KB gouraud-in-26-KB both-sides-in-36-KB

# check NAME KILOBYTES THOUSANDS
check() {
  "$tool" count "$work" "m4/$1" --out "$work/$1.json"
  tr -d '",' < "$work/$1.json" | awk -v name="$1" -v ram=$(($2 * 1024)) -v most=$(($3 * 1000)) '
    $1 == "instructions:" { instructions = $2 }
    $1 == "ram_bytes:" { bytes = $2 }
    END {
      if (instructions == 0 || instructions > most) { print "FAILED: " name ": " instructions " instructions, limit " most; bad = 1 }
      if (bytes == 0 || bytes > ram) { print "FAILED: " name ": " bytes " bytes of RAM, limit " ram; bad = 1 }
      exit bad
    }'
}
check in-24-KB 24 1268
check in-18-KB 18 2344
check gouraud-in-26-KB 26 2018
check both-sides-in-36-KB 36 4683
