#!/bin/sh
# Prints what an image's code does not tell about the stack, for `spanline budget --stack-notes`: the constructors that
# start-up calls, the poses that a demo may have, and what draws curves where it is linked. usage: stack_notes.sh IMAGE.elf
set -eu
[ $# -eq 1 ] || { echo "usage: stack_notes.sh IMAGE.elf" >&2; exit 2; }
constructors=$(arm-none-eabi-nm "$1" | awk '$3 ~ /^_GLOBAL__sub_I_/ { print "reset calls " $3 }')
echo "${constructors:-reset calls nothing}"
show=$(arm-none-eabi-nm -C "$1" | sed -n 's/^[0-9a-f]* [Tt] \(spanline::demos::Stage::show(.*\)/\1/p')
arm-none-eabi-nm -C "$1" | sed -n "s/^[0-9a-f]* [Tt] \(spanline::demos::pose_.*\)/$show calls \1/p"
plotter=$(arm-none-eabi-nm "$1" | awk '$3 ~ /CurveOverlay5kPlot.*(_FUN|__invoke)/ { print "others call " $3 }')
echo "${plotter:-others call nothing}"
