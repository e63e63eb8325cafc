#!/bin/sh
# A board's images keep to their budgets, and where chip and panel are modelled the panel shows the host's picture, pixel for
# pixel. Where Chromium is installed, a report's page draws itself.
# usage: budgets.sh SOURCE IMAGES SPANLINE BOARD REPORTS; exit 77: there are no images here.
set -eu
[ $# -eq 5 ] || { echo "usage: budgets.sh SOURCE IMAGES SPANLINE BOARD REPORTS" >&2; exit 2; }
source=$1 images=$2/$4 spanline=$3 board=$4 reports=$5
[ -f "$images/teapot.elf" ] || { echo "skipped: no images of $board"; exit 77; }

sh "$source/firmware/boards/budget.sh" "$spanline" "$images" "$board" "$reports"
for demo in $("$spanline" demo --list); do
  shown=$reports/$board-$demo
  [ -f "$shown.ppm" ] || continue
  "$spanline" demo "$demo" --board "$board" --frame 3 --out "$shown.host.ppm"
  cmp "$shown.ppm" "$shown.host.ppm"
  echo "$demo frame 3: as on the host"
  # Who draws without Frame::next_line() has no lines.
  grep -q '^        "compute":' "$shown.json" || { [ "$demo" = plot ] && continue; echo "FAILED: no lines"; exit 1; }
  # While DMA sends one line the next is computed: nearly nothing is left that neither of the two would need alone.
  case $board in stm32f4* | nucleo-f4*)
    awk '/^    "pace":/ { pace = $2 + 0 } END { if (pace < 1 || pace > 1.03) { print "FAILED: pace " pace; exit 1 } }' "$shown.json"
  esac
  # Every line of the picture is in the report, and no more bytes are theirs than crossed the wire.
  height=$(sed -n '2{s/.* //p;q;}' "$shown.ppm")
  awk -v height="$height" '
    /^    "bytes":/ { wire = $2 + 0 }
    after_compute && /^        "bytes":/ { sent += $2 }
    { after_compute = /^        "compute":/ }
    after_compute { ++lines; idle += $2 + 0 == 0 }
    END {
      if (lines != height || idle != 0 || sent == 0 || sent > wire) {
        print "FAILED: " lines + 0 " lines, " idle + 0 " without work, " sent + 0 " bytes of " wire + 0; exit 1
      }
    }' "$shown.json"
done

[ "$board" = stm32f429i-disc1 ] && command -v chromium > /dev/null || exit 0
timeout 60 chromium --headless --no-sandbox --disable-gpu --dump-dom "$reports/$board-gears.html" 2> /dev/null > "$reports/dom.html"
grep -q 'data-ready="yes"' "$reports/dom.html" || { echo "the page did not draw itself"; exit 1; }
grep -q '<img [^>]*src="data:image/bmp;base64,Qk' "$reports/dom.html" || { echo "the page lacks the panel's picture"; exit 1; }
bars=$(grep -o '<rect' "$reports/dom.html" | wc -l)
lines=$(grep -c '"slack"' "$reports/$board-gears.json")
[ "$bars" -eq "$lines" ] && [ "$bars" -gt 0 ] || { echo "$bars lines drawn, wanted $lines"; exit 1; }
echo "the page draws itself"
