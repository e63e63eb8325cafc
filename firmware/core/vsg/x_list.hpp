// Lists of vertices in order of x, by links.
#pragma once

#include <cstdint>

namespace spanline {

// Brings a list in order, from left to right, and returns its new first. links.next(vertex) is the one after it,
// kEnd behind the last, links.link(vertex, next) sets it; links.x(vertex) is where it stands. Vertices that lie
// side by side have mostly been filed in this order, so that the list has them reversed, or in the other, for which a
// hint is kept.
template <std::uint16_t kEnd, typename Links>
inline std::uint16_t sorted_by_x(Links links, std::uint16_t first) {
  std::uint16_t last = first, hint = first;
  if (first == kEnd) return first;
  std::int32_t first_x = links.x(first), last_x = first_x;
  for (std::uint16_t vertex; (vertex = links.next(last)) != kEnd; hint = vertex) {
    const std::int32_t x = links.x(vertex);
    if (x >= last_x) {
      last = vertex;
      last_x = x;
      continue;
    }
    links.link(last, links.next(vertex));
    if (x <= first_x) {
      links.link(vertex, first);
      first = vertex;
      first_x = x;
      continue;
    }
    std::uint16_t before = links.x(hint) <= x ? hint : first, after = links.next(before);
    while (links.x(after) < x) {  // the last one is not
      before = after;
      after = links.next(after);
    }
    links.link(vertex, after);
    links.link(before, vertex);
  }
  return first;
}

}  // namespace spanline
