#pragma once

#include <cstdint>

#include "core/vsg/comparator.hpp"

namespace spanline {

// How segments are kept in order of X from line to line: the seed's last step (VSG6) or the one before it (VSG5).
enum class XSort : std::uint8_t { list, buckets };

// What is compiled in. A structural type: used as a template argument.
struct VsgOptions {
  Comparator comparator = Comparator::plane;
  XSort x_sort = XSort::list;
  bool statistics = false;  // count what Fig. 33 counts
  bool taps = false;        // spans carry their depth ramp
  bool patches = false;     // Bezier patches are drawn: 10 KB of code and the pools of Budget::patch_facets
};

}  // namespace spanline
