#!/bin/sh
# The checker itself: a good tree passes, and each kind of violation, alone in that tree, is reported with file and line.
set -eu
checker=$(dirname "$0")/include_order.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/firmware/core/base" "$tree/firmware/core/geom" "$tree/firmware/core/vsg" "$tree/firmware/core/area" \
  "$tree/firmware/core/frame" "$tree/firmware/hal" "$tree/firmware/boards/some" "$tree/host_sim/sim" "$tree/tests/oracle"
printf '#pragma once\n#include <cstdint>\n' > "$tree/firmware/core/base/a.hpp"
printf '#include "core/geom/a.hpp"\n#include "core/vsg/b.hpp"\n' > "$tree/firmware/core/vsg/a.hpp"
printf '#include "core/vsg/a.hpp"\n#include "core/area/a.hpp"\n' > "$tree/firmware/core/frame/a.hpp"
printf '#include "core/base/a.hpp"\n' > "$tree/firmware/hal/a.hpp"
printf '#include "core/frame/a.hpp"\n#include "hal/a.hpp"\n#include "board.hpp"\n' > "$tree/firmware/boards/some/main.cpp"
printf '#include <vector>\n#include "core/frame/a.hpp"\n' > "$tree/host_sim/sim/a.cpp"
printf '#include <vector>\n#include "core/scene/format.hpp"\n' > "$tree/tests/oracle/a.cpp"

sh "$checker" "$tree" > "$tree/out" || { echo "a good tree was refused:"; cat "$tree/out"; exit 1; }

failed=0
# caught FILE INCLUDE: with that include as its second line, FILE:2 is reported and nothing else is.
caught() {
  cp -R "$tree/firmware" "$tree/host_sim" "$tree/tests" "$tree/bad/"
  printf '// a line\n  #  include %s  // why\n' "$2" > "$tree/bad/$1"
  if sh "$checker" "$tree/bad" > "$tree/out" || [ "$(wc -l < "$tree/out")" -ne 1 ] || ! grep -q "^$1:2: " "$tree/out"; then
    echo "not caught as it should be: $2 in $1"; cat "$tree/out"
    failed=1
  fi
  rm -rf "$tree/bad"; mkdir "$tree/bad"
}
mkdir "$tree/bad"
caught firmware/core/base/bad.hpp '"core/fx/fixed.hpp"'
caught firmware/core/geom/bad.cpp '"core/vsg/a.hpp"'
caught firmware/core/vsg/bad.hpp '"core/area/a.hpp"'
caught firmware/core/area/bad.hpp '"core/vsg/a.hpp"'
caught firmware/core/vsg/bad.hpp '"core/frame/a.hpp"'
caught firmware/core/frame/bad.hpp '"hal/a.hpp"'
caught firmware/core/frame/bad.hpp '<vector>'
caught firmware/core/base/bad.hpp '<cmath>'
caught firmware/core/base/bad.hpp '"../geom/a.hpp"'
caught firmware/hal/bad.hpp '"core/geom/a.hpp"'
caught firmware/hal/bad.hpp '"core/frame/a.hpp"'
caught firmware/boards/some/bad.cpp '<png.h>'
caught firmware/boards/some/bad.cpp '"assetc/obj.hpp"'
caught host_sim/sim/bad.cpp '"oracle/a.hpp"'
caught tests/oracle/bad.cpp '"core/vsg/a.hpp"'
[ "$failed" -eq 0 ] && echo "every kind of violation is caught"
exit "$failed"
