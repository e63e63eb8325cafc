#!/bin/sh
# Cross-builds an image for one emulated core: BUILD/IMAGE.elf. Without the tools that this and running it take: exit 77.
# usage: build.sh SOURCE BUILD SCENES SPANLINE CPU IMAGE    (SCENES: compiled scenes; SPANLINE: the host tool)
set -eu
[ $# -eq 6 ] || { echo "usage: build.sh SOURCE BUILD SCENES SPANLINE CPU IMAGE" >&2; exit 2; }
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
mkdir -p "$2"

quiet() { "$@" > "$log" 2>&1 || { cat "$log"; exit 1; }; }
log=$2.log
quiet cmake -G Ninja -S "$1/tests/target/image" -B "$2" --toolchain "$1/toolchain/arm-none-eabi.cmake" \
  -DSPANLINE_BOARD="$1/tests/target/board" -DSPANLINE_CPU="$5" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 \
  -DSPANLINE_SCENES="$3" -DSPANLINE_TOOL="$4"
quiet cmake --build "$2" -j 2 --target "$6"
