#!/bin/sh
# Instructions against the timer of QEMU under -icount shift=0, where an instruction takes a nanosecond: the same image tells
# the same ticks here and there, and as many instructions are counted, to one tick (20 instructions at 50 MHz).
# usage: counts_ticks_as_qemu.sh SOURCES BUILD SPANLINE; exit 77: not possible here.
set -eu
[ $# -eq 3 ] || { echo "usage: counts_ticks_as_qemu.sh SOURCES BUILD SPANLINE" >&2; exit 2; }
sources=$1 build=$2 spanline=$3
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
mkdir -p "$build"
arm-none-eabi-g++ -std=c++20 -mcpu=cortex-m3 -mthumb -O2 -ffreestanding -fno-exceptions -fno-rtti -fno-tree-loop-distribute-patterns \
  -nostdlib -T "$sources/count/count.ld" "$sources/count/timed.cpp" -lgcc -o "$build/timed.elf"
timeout 60 qemu-system-arm -M lm3s6965evb -icount shift=0 -display none -monitor none -serial none \
  -semihosting-config enable=on,target=native -kernel "$build/timed.elf" < /dev/null 2> "$build/said"
executed=$((0x$(grep -x '[0-9a-f]*' "$build/said")))
here=$((0x$("$spanline" run "$build/timed.elf" --board ek-lm3s6965 --icount 2> "$build/run.txt")))
"$spanline" budget "$build/timed.elf" --board ek-lm3s6965 --from work_begin --until work_end --no-stack --json "$build/timed.json" \
  > "$build/timed.txt"
counted=$(sed -n 's/^  "instructions": \([0-9]*\),$/\1/p' "$build/timed.json")
echo "QEMU's timer: $executed ticks of 20 instructions, here $here; counted $counted instructions"
near() { [ $(($1 - $2)) -le "$3" ] && [ $(($2 - $1)) -le "$3" ]; }
near "$executed" "$here" 1
near $((executed * 20)) "$counted" 20
