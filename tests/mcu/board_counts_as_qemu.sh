#!/bin/sh
# The image that a board is flashed with: within its first frame each function executes as many instructions as in QEMU under
# -icount shift=0, where an instruction takes a nanosecond and the wire nothing. (The timer cannot tell: QEMU lets an
# instruction's time pass again where it takes it up anew because it touches a register; counts_ticks_as_qemu.sh has that.)
# usage: board_counts_as_qemu.sh SOURCE IMAGE.elf SPANLINE WORK; exit 77: not possible here.
set -eu
[ $# -eq 4 ] || { echo "usage: board_counts_as_qemu.sh SOURCE IMAGE.elf SPANLINE WORK" >&2; exit 2; }
source=$1 image=$2 spanline=$3 work=$4
for tool in arm-none-eabi-nm qemu-system-arm gdb-multiarch; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
[ -f "$image" ] || { echo "skipped: no $image"; exit 77; }
mkdir -p "$work"
"$spanline" budget "$image" --board ek-lm3s6965 --icount --frames 1 --no-stack --json "$work/counted.json" > "$work/counted.txt"
# One field a line; a name's next line has its instructions. The timer's handler comes when time has come.
awk -F '": ' '
  /^  "functions": \[/ { inside = 1 }
  /^  \]/ { inside = 0 }
  inside && /"name": / { name = $2; sub(/^"/, "", name); sub(/",$/, "", name) }
  inside && /"instructions": / { count[name] += $2 }
  END { for (name in count) if (count[name] != 0 && name != "tick") print count[name] "\t" name }' "$work/counted.json" |
  sort > "$work/counted"

address() { arm-none-eabi-nm "$image" | awk -v name="$1" '$3 == name { print "0x" $1 }'; }
cat > "$work/commands" <<TEXT
set confirm off
target remote | exec qemu-system-arm -M lm3s6965evb -icount shift=0 -display none -monitor none -serial none -S -gdb stdio \
-semihosting-config enable=on,target=native,chardev=console -chardev file,id=console,path=$work/said -D $work/trace \
-device $(sh "$source/firmware/boards/request.sh" "$image" 0) -kernel $image
tbreak *$(address frame_begin_mark)
continue
monitor singlestep on
monitor log exec,nochain
tbreak *$(address frame_end_mark)
continue
kill
quit
TEXT
# QEMU may be gone before it has answered to `kill`.
timeout 120 gdb-multiarch -nx -batch -x "$work/commands" > "$work/answers" 2>&1 < /dev/null ||
  grep -q '^Temporary breakpoint 2, ' "$work/answers" || { cat "$work/answers"; exit 1; }

# A line is an instruction, and one with "execution of TB" takes back the line before it.
arm-none-eabi-nm -CS "$image" | awk '$3 ~ /^[tTwW]$/' > "$work/functions"
awk '
  function number(hex,   value, i) {
    for (i = 1; i <= length(hex); ++i) value = 16 * value + index("0123456789abcdef", substr(hex, i, 1)) - 1
    return value
  }
  NR == FNR {
    name = $4
    for (i = 5; i <= NF; ++i) name = name " " $i
    from = number($1)
    for (i = from - from % 2; i < from + number($2); i += 2) function_at[sprintf("%08x", i)] = name
    next
  }
  / execution of TB / { --count[last]; next }
  {
    split($0, part, "/")
    last = part[2] in function_at ? function_at[part[2]] : $NF  # what has no size
    ++count[last]
  }
  END { for (name in count) if (name != "tick") print count[name] "\t" name }' "$work/functions" "$work/trace" |
  sort > "$work/executed"
rm "$work/trace"

cmp "$work/counted" "$work/executed"
echo "$(awk '{ sum += $1 } END { print sum }' "$work/executed") instructions in $(wc -l < "$work/executed") functions, as QEMU executes them"
