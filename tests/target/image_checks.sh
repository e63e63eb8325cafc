#!/bin/sh
# What an image must not contain: float instructions or helpers, a heap, exception tables; and the marks around a frame, which
# it must. Prints its size.
# usage: image_checks.sh IMAGE.elf
set -eu
[ $# -eq 1 ] || { echo "usage: image_checks.sh IMAGE.elf" >&2; exit 2; }
bad=0

# refuse WHAT FOUND: reports and fails where anything was found.
refuse() {
  [ -n "$2" ] || return 0
  printf '%s: %s\n' "$1" "$(printf '%s' "$2" | tr '\n' ' ')"
  bad=1
}

names=$(arm-none-eabi-nm "$1" | awk '{ print $NF }')
refuse "float helpers" "$(printf '%s\n' "$names" |
  grep -E '^__(aeabi_(c?[fd](add|rsub|sub|mul|div|neg|cmp|2)|c[fd]r?cmp|u?[il]2[fd]|ul2[fd])|[a-z]+[sdt]f[a-z0-9]*$)' || :)"
refuse "heap" "$(printf '%s\n' "$names" | grep -E '^(_*(malloc|calloc|realloc|free|sbrk)(_r)?|_Zn[wa].*|_Zd[la].*)$' || :)"
refuse "exceptions" "$(printf '%s\n' "$names" | grep -E '^(__cxa_.*|__gxx_personality.*|__aeabi_unwind.*|_Unwind.*)$' || :)"
refuse "exception tables" "$(arm-none-eabi-readelf -SW "$1" | grep -oE '\.(ARM\.exidx|ARM\.extab|eh_frame|gcc_except_table)[^ ]*' || :)"
refuse "float instructions" "$(arm-none-eabi-objdump -d "$1" | awk -F '\t' '$3 ~ /^v[a-z]+/ { print $3 }' | sort -u)"

calls=$(arm-none-eabi-objdump -d "$1" | grep -oE '\bbl?(\.n|\.w)?\b.*<frame_(begin|end)_mark>$' || :)
refuse "frame marks not called" "$(for mark in frame_begin_mark frame_end_mark; do
  case $calls in *"<$mark>"*) ;; *) echo "$mark" ;; esac
done)"

arm-none-eabi-size "$1" | awk 'NR == 2 { printf "image code=%d data=%d bss=%d\n", $1, $2, $3 }'
exit "$bad"
