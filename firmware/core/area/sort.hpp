// Sorting in place, without a heap and without recursion.
#pragma once

#include <cstdint>
#include <utility>

#include "core/base/pool.hpp"

namespace spanline::area {

// Few blocks, or any that are nearly in order: each goes back to its place.
template <typename T, typename Less>
void insertion_sort(PoolRef<T> items, std::uint16_t count, Less less) {
  for (std::uint32_t next = 2; next <= count; ++next) {
    if (!less(items[next], items[next - 1])) continue;
    const T moving = items[next];
    std::uint32_t at = next;
    do {
      items[at] = items[at - 1];
      --at;
    } while (at > 1 && less(moving, items[at - 1]));
    items[at] = moving;
  }
}

// Puts blocks 1 … count of `items` in the order of `less`: heap sort where they are many, so that no input is slow.
template <typename T, typename Less>
void sort_blocks(PoolRef<T> items, std::uint16_t count, Less less) {
  constexpr std::uint16_t kFew = 32;
  if (count <= kFew) return insertion_sort(items, count, less);
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
