#!/bin/sh
# What an object or archive of the engine asks its platform for. usage: undefined_symbols.sh FILE…
# Allowed: memcpy, memset, memmove (also under their ARM names) and libgcc's integer helpers. Everything else that no FILE
# defines (float helpers, heap, exceptions, guards, libc) is printed with the object that wants it, and the exit is 1.
set -eu
[ $# -ge 1 ] || { echo "usage: undefined_symbols.sh FILE…" >&2; exit 2; }

arm-none-eabi-nm -A -g "$@" | awk '
  BEGIN {
    memory = "^(mem(cpy|set|move)|__aeabi_mem(cpy|set|move|clr)[48]?)$"
    integer = "^__(aeabi_(u?idiv(mod)?|u?ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp)|(u?div|u?mod)(si|di)3|muldi3" \
              "|(c[lt]z|popcount)(si|di)2|(ashl|ashr|lshr)di3|gnu_thumb1_case_(s|u)(q|h)i|gnu_thumb1_case_si)$"
  }
  NF < 2 { next }
  $(NF - 1) == "U" || $(NF - 1) == "w" { wanted[$NF] = wanted[$NF] " " $1; next }
  { defined[$NF] = 1 }
  END {
    for (name in wanted) {
      if (name in defined) continue
      if (name ~ memory || name ~ integer) { helpers = helpers " " name; continue }
      count = split(wanted[name], users, " ")
      sub(/:$/, "", users[1])
      printf "%s: wants %s%s\n", users[1], name, (count > 1 ? " (and " count - 1 " more)" : "")
      bad = 1
    }
    printf "asks for:%s\n", helpers == "" ? " nothing" : helpers
    exit bad
  }'
