#!/bin/sh
# Compares the instructions that `spanline budget` counts with those that QEMU executes, one by one, and the stack's bound with
# what the run reached. usage: counts_as_qemu.sh SOURCES BUILD SPANLINE CPU; exit 77: not possible here.
set -eu
[ $# -eq 4 ] || { echo "usage: counts_as_qemu.sh SOURCES BUILD SPANLINE CPU" >&2; exit 2; }
sources=$1 build=$2 spanline=$3 cpu=$4
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
mkdir -p "$build"
arm-none-eabi-g++ -std=c++20 -mcpu="$cpu" -mthumb -O2 -ffreestanding -fno-exceptions -fno-rtti -fno-tree-loop-distribute-patterns \
  -nostdlib -T "$sources/count/count.ld" "$sources/count/main.cpp" -lgcc -o "$build/count.elf"
timeout 60 qemu-system-arm -M lm3s6965evb -cpu "$cpu" -display none -monitor none -serial none -singlestep \
  -d exec,nochain -D "$build/trace.log" -semihosting-config enable=on,target=native -kernel "$build/count.elf" < /dev/null \
  2> /dev/null
executed=$(grep -c '^Trace' "$build/trace.log")
rm "$build/trace.log"

echo "(anonymous namespace)::fibonacci recurses 12" > "$build/notes.txt"
"$spanline" budget "$build/count.elf" --board "$cpu" --stack-notes "$build/notes.txt" --json "$build/count.json" > "$build/count.txt"
counted=$(sed -n 's/^  "instructions": \([0-9]*\),$/\1/p' "$build/count.json")
reached=$(sed -n 's/^    "reached": \([0-9]*\),$/\1/p' "$build/count.json")
bound=$(sed -n 's/^    "bound": \([0-9]*\),$/\1/p' "$build/count.json")
echo "$cpu: QEMU executed $executed instructions, counted $counted; stack reached $reached, bound $bound"
[ "$executed" -eq "$counted" ] && [ "$bound" -ge "$reached" ]
