# The verbs of ./dev that concern boards: firmware, emulate, flash. Sourced by ./dev at the repository's root.
# shellcheck shell=sh

board_names() {
  for folder in firmware/boards/*/board.cmake; do
    folder=$(dirname "$folder")
    [ "$(basename "$folder")" = template ] || basename "$folder"
  done
}

# check_board NAME: exits where there is no such board.
check_board() {
  [ -f "firmware/boards/$1/board.cmake" ] && return
  echo "dev: no board \"$1\"; there are: $(board_names | tr '\n' ' ')" >&2
  exit 2
}

need_firmware_tools() {
  need_host_tools
  need_cross_tools
}

# build_board BOARD [DEMO]: all images of a board, or one, in build/firmware/BOARD.
build_board() {
  folder=build/firmware/$1
  mkdir -p "$folder"
  cmake -S . -B "$folder" -G Ninja --toolchain toolchain/arm-none-eabi.cmake -DSPANLINE_BOARD="$1" \
    -DCMAKE_BUILD_TYPE=Release -DSPANLINE_HOST=OFF -DSPANLINE_TESTS=OFF -DSPANLINE_BENCHMARKS=OFF \
    -DSPANLINE_TOOL="$(pwd)/build/host/spanline" > "$folder.log" 2>&1 || { cat "$folder.log"; return 1; }
  [ -t 1 ] && quiet='' || quiet=--quiet
  # shellcheck disable=SC2086  # one option or none
  cmake --build "$folder" ${2:+--target "$2"} -- $quiet
}

# sizes BOARD: what each image takes of flash and RAM. The stack is part of the RAM, and how much of it can be used at most
# is told where the host tool can look into images; what remains is free.
sizes() {
  for image in build/firmware/"$1"/*.elf; do
    used=$(sh firmware/boards/stack_bound.sh build/host/spanline "$image" "$1") || used=
    arm-none-eabi-readelf -SW "$image" | awk -v name="$1/$(basename "$image" .elf)" -v used="$used" '
      function number(hex, digits, i, value) {
        for (i = 1; i <= length(hex); i++) value = value * 16 + index("0123456789abcdef", substr(hex, i, 1)) - 1
        return value
      }
      { sub(/^ *\[ *[0-9]+\] */, "") }
      $7 ~ /A/ {
        size = number($5)
        if ($2 != "NOBITS") flash += size
        if ($1 ~ /^\.(stack|data|bss|request)$/) ram += size
        if ($1 == ".stack") stack = size
      }
      END {
        printf "%-28s flash %7d B   RAM %7d B, the stack %d B of it", name, flash, ram, stack
        print used == "" ? "" : ", used " used " B at most"
      }'
  done
}

firmware() {
  for board in "$@"; do check_board "$board"; done
  # shellcheck disable=SC2046  # a list of names
  [ $# -gt 0 ] || set -- $(board_names)
  need_firmware_tools
  say "building the host tool that compiles the scenes"
  build host spanline
  for board in "$@"; do
    say "$board"
    build_board "$board"
    sizes "$board"
  done
  echo "images: build/firmware/BOARD/DEMO.elf (.bin .hex .map, and .uf2 for the Pico)"
}

emulate() {
  [ $# -ge 1 ] || { echo "usage: ./dev emulate BOARD [--demo D] [--frame K] [--out F.png]" >&2; exit 2; }
  board=$1
  shift
  check_board "$board"
  demo=teapot frame=0 out=
  while [ $# -ge 2 ]; do
    case "$1" in
      --demo) demo=$2 ;;
      --frame) frame=$2 ;;
      --out) out=$2 ;;
      *) break ;;
    esac
    shift 2
  done
  [ $# -eq 0 ] || { echo "dev emulate: what is \"$1\"?" >&2; exit 2; }
  case "$frame" in
    '' | *[!0-9]*) echo "dev emulate: --frame is a number from 0 on, not \"$frame\"" >&2; exit 2 ;;
  esac
  need_firmware_tools
  need qemu-system-arm
  build host spanline spanline_screendump
  build_board "$board" "$demo"
  out=${out:-build/firmware/$board/$demo-$frame.png}
  dump=build/firmware/$board/$demo-$frame.ppm
  sh firmware/boards/emulate.sh "build/firmware/$board" "$demo" "$frame" "$dump"
  [ -f "$dump" ] || return 0
  build/host/spanline-screendump "$dump" 4 "$out"
  rm "$dump"
  echo "$out"
}

flash() {
  [ $# -ge 1 ] || { echo "usage: ./dev flash BOARD [--demo D]" >&2; exit 2; }
  board=$1
  check_board "$board"
  demo=teapot
  case "${2:-}" in
    '') ;;
    --demo) demo=${3:?"a demo after --demo"} ;;
    *) echo "dev flash: what is \"$2\"?" >&2; exit 2 ;;
  esac
  need_firmware_tools
  build host spanline
  build_board "$board" "$demo"
  # shellcheck disable=SC1090  # written by the build
  . "build/firmware/$board/board.sh"
  [ -z "$openocd" ] || command -v openocd > /dev/null || need openocd
  sh firmware/boards/flash.sh "build/firmware/$board" "$demo"
}
