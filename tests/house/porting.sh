#!/bin/sh
# docs/porting.md, followed to the letter in a copy of the tree: a new board is one folder, a new panel is one file, and with
# both of them an image builds. What the page shows is what is compiled.
# usage: porting.sh SOURCE SPANLINE
set -eu
[ $# -eq 2 ] || { echo "usage: porting.sh SOURCE SPANLINE" >&2; exit 2; }
command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
source=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cp -R "$source/CMakeLists.txt" "$source/firmware" "$source/linker" "$source/toolchain" "$source/assets" "$source/docs" .

# A board: the page's own command.
copy=$(sed -n 's/^1\. Copy the template: `\(.*\)`$/\1/p' docs/porting.md)
[ -n "$copy" ] || { echo "the page tells no command to copy the template"; exit 1; }
sh -c "$copy"

# A panel: the page's own file, and the line that names it.
file=$(sed -n 's/.*`\(firmware\/hal\/panel\/my_panel\.hpp\)`.*/\1/p' docs/porting.md)
awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' docs/porting.md > "$file"
uses=$(tr '\n' ' ' < docs/porting.md | sed -n 's/.*`\(using Panel = hal::MyPanel<[^`]*;\)`.*/\1/p')
[ -s "$file" ] && [ -n "$uses" ] || { echo "the page shows no panel"; exit 1; }
sed -i -e 's|"hal/panel/st7789.hpp"|"hal/panel/my_panel.hpp"|' -e "s|using Panel = .*;|$uses|" firmware/boards/my-board/board.hpp
grep -q 'hal::MyPanel' firmware/boards/my-board/board.hpp

cmake -G Ninja -S . -B build --toolchain toolchain/arm-none-eabi.cmake -DSPANLINE_BOARD=my-board -DCMAKE_BUILD_TYPE=Release \
  -DSPANLINE_HOST=OFF -DSPANLINE_TESTS=OFF -DSPANLINE_BENCHMARKS=OFF -DSPANLINE_IMAGES=cubes \
  -DSPANLINE_TOOL="$2" > log 2>&1 || { cat log; exit 1; }
cmake --build build > log 2>&1 || { cat log; exit 1; }
for made in elf bin hex map uf2; do [ -s "build/cubes.$made" ] || { echo "no cubes.$made"; exit 1; }; done
sh "$source/tests/target/image_checks.sh" build/cubes.elf
