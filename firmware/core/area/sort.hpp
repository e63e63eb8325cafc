// Sorting in place, without a heap and without recursion.
#pragma once

#include <cstdint>
#include <utility>

#include "core/base/pool.hpp"

namespace spanline::area {

// Puts blocks 1 … count of `items` in the order of `less`: heap sort, so that no input is slow.
template <typename T, typename Less>
void sort_blocks(PoolRef<T> items, std::uint16_t count, Less less) {
  const auto sink_down = [&](std::uint32_t at, std::uint32_t last) {
    const T moving = items[at];
    for (std::uint32_t child = 2 * at; child <= last; child = 2 * at) {
      if (child < last && less(items[child], items[child + 1])) ++child;
      if (!less(moving, items[child])) break;
      items[at] = items[child];
      at = child;
    }
    items[at] = moving;
  };
  for (std::uint32_t at = count / 2u; at >= 1; --at) sink_down(at, count);
  for (std::uint32_t last = count; last > 1; --last) {
    std::swap(items[1], items[last]);
    sink_down(1, last - 1);
  }
}

}  // namespace spanline::area
