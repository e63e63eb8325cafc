#!/bin/sh
# The checker itself: integer code passes; float, heap, a libc call and a guarded static are each named.
set -eu
command -v arm-none-eabi-g++ > /dev/null || { echo "skipped: no arm-none-eabi-g++"; exit 77; }
checker=$(dirname "$0")/undefined_symbols.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compile() { printf '%s\n' "$1" | arm-none-eabi-g++ -mcpu=cortex-m0 -mthumb -O2 -ffreestanding -x c++ -c - -o "$work/a.o"; }

compile 'struct S { int a[64]; };
  void f(S* t, const S* s, long long* q, unsigned d) { *t = *s; *q = *q / d * (*q >> d) * __builtin_clzll(*q); }'
sh "$checker" "$work/a.o" > "$work/out" || { echo "integer code was refused:"; cat "$work/out"; exit 1; }

failed=0
caught() {
  compile "$2"
  if sh "$checker" "$work/a.o" > "$work/out" || ! grep -q "wants $1" "$work/out"; then
    echo "not caught: $1"; cat "$work/out"; failed=1
  fi
}
caught __aeabi_fmul 'float f(float a, float b) { return a * b; }'
caught __aeabi_i2d 'double f(int a) { return a; }'
caught _Znwj 'int* f() { return new int; }'
caught puts 'extern "C" int puts(const char*); void f() { puts("x"); }'
caught __cxa_guard_acquire 'int g(); int f() { static int kept = g(); return kept; }'
caught __cxa_throw 'void f() { throw 1; }'
[ "$failed" -eq 0 ] && echo "float, heap, libc, guards and exceptions are caught"
exit "$failed"
