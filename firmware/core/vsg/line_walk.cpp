#include "core/vsg/line_walk.hpp"

namespace spanline {

void insert_back(const ActiveEdge* begin, ActiveEdge* end, const ActiveEdge& edge) {
  ActiveEdge* at = end;
  do {
    *at = at[-1];
    --at;
  } while (at != begin && at[-1].x > edge.x);
  *at = edge;
}

}  // namespace spanline
