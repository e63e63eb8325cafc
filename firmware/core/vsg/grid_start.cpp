#include "core/vsg/grid_start.hpp"

namespace spanline {

namespace {

// Whether two edges of equal x run alike all the way, one beginning a face and the other one ending one.
bool are_a_joint(const ActiveEdge& a, const ActiveEdge& b) {
  if (a.dx != b.dx || (a.rest ^ b.rest) >> 16 != 0 || (a.rest & ActiveEdge::kTall) != 0) return false;
  return (a.ending() == 0 && b.beginning() == 0) || (b.ending() == 0 && a.beginning() == 0);
}

}  // namespace

bool take_in(ActiveEdge* end) {
  const ActiveEdge edge = *end;
  ActiveEdge* at = end;
  for (; at[-1].x >= edge.x; --at) {
    if (at[-1].x == edge.x && are_a_joint(at[-1], edge)) {
      at[-1].toggle += edge.toggle;
      at[-1].rest |= edge.rest;
      return true;
    }
  }
  for (ActiveEdge* to = end; to != at; --to) *to = to[-1];
  *at = edge;
  return false;
}

}  // namespace spanline
