# What the scripts that count images share; they read this file.

# begin_images SOURCE WORK TOOL: sets source, work and tool; skips where images cannot be built.
begin_images() {
  command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
  source=$(cd "$1" && pwd)
  mkdir -p "$2"
  work=$(cd "$2" && pwd)
  tool=$3
}

# Shows what a command says only where it fails.
quiet() { "$@" > "$work/build.log" 2>&1 || { cat "$work/build.log" >&2; exit 1; }; }

# build_images CPU NAME…: the images of $work/frames/NAME, as $work/CPU/NAME.elf.
build_images() {
  cpu=$1
  shift
  folders=
  for name in "$@"; do folders="$folders;$work/frames/$name"; done
  quiet cmake -G Ninja -S "$source/tests/bench/image" -B "$work/$cpu" --toolchain "$source/toolchain/arm-none-eabi.cmake" \
    -DSPANLINE_BOARD="$source/tests/bench/board" -DSPANLINE_CPU="cortex-$cpu" -DCMAKE_BUILD_TYPE=Release \
    -DSPANLINE_FRAMES="${folders#;}"
  quiet cmake --build "$work/$cpu" -j 2 --target "$@"
}
