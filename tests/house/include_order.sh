#!/bin/sh
# Who may know whom (the order is the table below). usage: include_order.sh TREE
# Prints "file:line: reason" for every include that breaks the order and exits 1 if there was one.
set -eu
if [ $# -ne 1 ] || [ ! -d "$1/firmware" ]; then
  echo "usage: include_order.sh TREE   (a folder that holds firmware/)" >&2
  exit 2
fi
cd "$1"

folders=
for folder in firmware host_sim tests/oracle; do
  [ -d "$folder" ] && folders="$folders $folder"
done

# shellcheck disable=SC2086  # a list of folders
find $folders -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' \) | LC_ALL=C sort | awk '
  BEGIN {
    # base <- fx <- scene <- geom <- {vsg, curve, area} <- shade <- frame: room -> rooms that it may include, itself aside.
    knows["base"] = ""
    knows["fx"] = "base"
    knows["scene"] = "base fx"
    knows["geom"] = "base fx scene"
    knows["vsg"] = "base fx scene geom curve"
    knows["curve"] = "base fx scene geom"
    knows["area"] = "base fx scene geom curve"
    knows["shade"] = "base fx scene geom vsg curve area"
    knows["frame"] = "base fx scene geom vsg curve area shade"
    # Standard headers of a freestanding C++20 implementation that need neither heap nor exceptions. <array> and <utility>
    # are header-only in every library and become freestanding with C++26 and C++23; <new> is for what is made in its place.
    count = split("array bit climits compare concepts cstddef cstdint limits new type_traits utility version", names, " ")
    for (i = 1; i <= count; i++) freestanding[names[i]] = 1
  }
  function complain(reason) { printf "%s:%d: %s\n", file, line, reason; bad = 1 }
  function listed(name, list) { return index(" " list " ", " " name " ") > 0 }
  function in_core(room, header, parts, other) {
    if (!(room in knows)) { complain("core has no room \"" room "\""); return }
    if (split(header, parts, "/") < 3 || parts[1] != "core") {
      complain("core/" room " includes \"" header "\", which is not core")
      return
    }
    other = parts[2]
    if (other != room && !listed(other, knows[room])) complain("core/" room " may not include core/" other " (\"" header "\")")
  }
  function in_hal(header, parts) {
    split(header, parts, "/")
    if (parts[1] == "hal" || (parts[1] == "core" && parts[2] == "base")) return
    complain("hal may include hal and core/base only, not \"" header "\"")
  }
  function in_outer_firmware(header, parts) {
    split(header, parts, "/")
    if (parts[1] != "core" && parts[1] != "hal" && parts[1] != "boards" && parts[1] != "demos" && index(header, "/"))
      complain("firmware includes \"" header "\", which a board does not have")
  }
  {
    file = $0; line = 0
    split(file, path, "/")
    top = path[1]; wing = path[2]; room = path[3]
    while ((getline text < file) > 0) {
      line++
      if (text !~ /^[ \t]*#[ \t]*include[ \t]*[<"]/) continue
      quoted = text ~ /include[ \t]*"/
      header = text
      sub(/^[^<"]*[<"]/, "", header); sub(/[>"].*$/, "", header)
      if (header ~ /(^|\/)\.\.(\/|$)/) { complain("include by a path from the root, not \"" header "\""); continue }
      if (top == "firmware") {
        if (!quoted) {
          if (!(header in freestanding)) complain("<" header "> is not a freestanding header of the house")
        } else if (wing == "core") in_core(room, header)
        else if (wing == "hal") in_hal(header)
        else in_outer_firmware(header)
      } else if (top == "host_sim") {
        if (quoted && header ~ /^(tests|oracle)\//) complain("the simulator may not include tests (\"" header "\")")
      } else if (quoted && header ~ /^core\// && header !~ /^core\/(base|scene)\// && header !~ /^core\/(fx\/fixed)\.hpp$/) {
        complain("the oracle shares no code with the core (\"" header "\")")
      }
    }
    close(file)
    files++
  }
  END {
    if (!files) { print "no sources found"; exit 1 }
    if (!bad) printf "include order holds in %d files\n", files
    exit bad
  }'
