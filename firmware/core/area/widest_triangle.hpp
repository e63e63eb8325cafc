// Three corners of a polygon that span nearly its largest triangle, found while the corners come: what its plane, and
// where its points lie in another grid, is told from with the least error.
#pragma once

#include "core/area/predicates.hpp"

namespace spanline::area {

class WidestTriangle {
 public:
  static constexpr unsigned kNone = 3;

  void clear() { count_ = 0; }

  // Which of the three the next corner becomes, maybe in the place of an earlier one; kNone where it is none of them.
  unsigned take(GridPoint corner) {
    if (count_ < 3) {
      // Three different corners: of them, and a fourth off their line, some three span an area.
      for (unsigned i = 0; i < count_; ++i) {
        if (at_[i] == corner) return kNone;
      }
      at_[count_] = corner;
      return count_++;
    }
    std::int64_t most = size(orientation(at_[0], at_[1], at_[2]));
    unsigned best = kNone;
    for (unsigned i = 0; i < 3; ++i) {
      const std::int64_t area = size(orientation(at_[(i + 1) % 3], at_[(i + 2) % 3], corner));
      if (area <= most) continue;
      most = area;
      best = i;
    }
    if (best != kNone) at_[best] = corner;
    return best;
  }

  // Whether the polygon has no area.
  bool flat() const { return count_ < 3 || orientation(at_[0], at_[1], at_[2]) == 0; }
  const GridPoint (&corners() const)[3] { return at_; }

 private:
  static std::int64_t size(std::int64_t area) { return area < 0 ? -area : area; }

  GridPoint at_[3];
  unsigned count_ = 0;
};

}  // namespace spanline::area
