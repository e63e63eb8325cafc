#!/bin/sh
# Each example as a stranger builds it: a CMake project of its own that is told where Spanline lies; then it runs, and what it
# prints must be a picture. usage: examples.sh SOURCE BUILD SPANLINE   (the host tool, as an absolute or relative path)
set -eu
if [ $# -ne 3 ] || [ ! -x "$3" ]; then
  echo "usage: examples.sh SOURCE BUILD SPANLINE   (build the host tool first)" >&2
  exit 2
fi
source=$(cd "$1" && pwd)
tool=$(cd "$(dirname "$3")" && pwd)/$(basename "$3")
mkdir -p "$2"
build=$(cd "$2" && pwd)

for example in "$source"/examples/*/; do
  name=$(basename "$example")
  # A copy away from the tree, so that nothing is found by lying next to it.
  rm -rf "$build/stranger/$name"
  mkdir -p "$build/stranger"
  cp -R "$example" "$build/stranger/$name"
  { cmake -G Ninja -S "$build/stranger/$name" -B "$build/$name" -DSPANLINE_DIR="$source" -DSPANLINE_TOOL="$tool" \
      -DCMAKE_BUILD_TYPE=Release && cmake --build "$build/$name"; } > "$build/$name.log" 2>&1 ||
    { cat "$build/$name.log"; exit 1; }
  "$build/$name/$name" > "$build/$name.txt"
  cat "$build/$name.txt"
  # Background and at least four shades of something in front of it.
  shades=$(fold -w 1 "$build/$name.txt" | LC_ALL=C sort -u | grep -c '[^ ]' || :)
  [ "$shades" -ge 4 ] || { echo "$name: no picture in what it printed"; exit 1; }
done
