#!/bin/sh
# image_checks.sh finds each thing that it looks for, in images made to contain them.
set -eu
command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# catches WHAT FLAGS SOURCE
catches() {
  # shellcheck disable=SC2086  # a list of flags
  printf 'void* __dso_handle; %s\n' "$3" | arm-none-eabi-g++ -O2 -mthumb -nostartfiles -Wl,-e,start -Wl,--no-warn-rwx-segments --specs=nosys.specs $2 \
    -x c++ - -o "$work/image.elf" 2> "$work/log" || { cat "$work/log"; exit 1; }
  if sh "$here/image_checks.sh" "$work/image.elf" > "$work/out"; then
    echo "not caught: $1"
    exit 1
  fi
  grep -q "^$1: " "$work/out" || { echo "caught as something else than $1:"; cat "$work/out"; exit 1; }
}

catches "float helpers" "-mcpu=cortex-m3" 'volatile float f; extern "C" void start() { f = f * f; }'
catches "float helpers" "-mcpu=cortex-m0" 'volatile double d; volatile int i; extern "C" void start() { i = int(d); }'
catches "float instructions" "-mcpu=cortex-m4 -mfloat-abi=hard" 'volatile float f; extern "C" void start() { f = f * f; }'
catches "heap" "-mcpu=cortex-m3" 'int* volatile p; extern "C" void start() { p = new int; }'
catches "exceptions" "-mcpu=cortex-m3" 'extern "C" void start() { throw 1; }'
catches "exception tables" "-mcpu=cortex-m3" 'extern "C" void start() { throw 1; }'
catches "frame marks not called" "-mcpu=cortex-m3" \
  'extern "C" { void frame_begin_mark() { asm volatile(""); } void start() { frame_begin_mark(); } }'
