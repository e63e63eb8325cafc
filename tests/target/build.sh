#!/bin/sh
# Cross-builds an image for one emulated core: BUILD/IMAGE.elf. Without the tools that this and running it take: exit 77.
# usage: build.sh SOURCE BUILD SCENES SPANLINE CPU IMAGE [TOOLCHAIN]
# SCENES: compiled scenes; SPANLINE: the host tool; TOOLCHAIN: of toolchain/, arm-none-eabi unless clang-arm
set -eu
[ $# -ge 6 ] || { echo "usage: build.sh SOURCE BUILD SCENES SPANLINE CPU IMAGE [TOOLCHAIN]" >&2; exit 2; }
toolchain=${7:-arm-none-eabi}
[ "$toolchain" = arm-none-eabi ] && clang='' || clang='clang++'
for tool in arm-none-eabi-g++ qemu-system-arm $clang; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
mkdir -p "$2"

quiet() { "$@" > "$log" 2>&1 || { cat "$log"; exit 1; }; }
log=$2.log
quiet cmake -G Ninja -S "$1/tests/target/image" -B "$2" --toolchain "$1/toolchain/$toolchain.cmake" \
  -DSPANLINE_BOARD="$1/tests/target/board" -DSPANLINE_CPU="$5" -DCMAKE_BUILD_TYPE=Release \
  -DSPANLINE_SCENES="$3" -DSPANLINE_TOOL="$4"
quiet cmake --build "$2" -j 2 --target "$6"
