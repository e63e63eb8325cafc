// Clipping of one contour to the view, a vertex at a time: Sutherland and Hodgman's re-entrant pipeline (1974), so that
// a polygon of any number of sides needs no scratch memory.
#pragma once

#include <cstdint>

#include "core/geom/projection.hpp"

namespace spanline {

struct ClipVertex {
  ClipPoint at;
  Rgb8 color;
};

// Feeds one contour through the planes in `planes`, a stage a plane: for each corner in order feed(), then finish()
// once; after each of these take what comes out with next() until it returns false.
class ContourClipper {
 public:
  ContourClipper(const Projection& projection, std::uint8_t planes) : projection_(projection), planes_(planes) {}

  void feed(const ClipVertex& v) { push(0, v); }
  void finish() { closing_ = 0; }
  bool next(ClipVertex& out);

 private:
  static constexpr unsigned kPlanes = 6;
  struct Stage {
    ClipVertex first, previous;
    std::int64_t first_distance, previous_distance;
    bool any = false;
  };
  struct Work {
    ClipVertex vertex;
    std::uint8_t stage;
  };

  void push(unsigned stage, const ClipVertex& v) { work_[count_++] = {v, static_cast<std::uint8_t>(stage)}; }
  void pass(unsigned index, const ClipVertex& v);
  void push_crossing(unsigned index, const ClipVertex& v, std::int64_t distance);

  const Projection& projection_;
  const std::uint8_t planes_;
  Stage stages_[kPlanes];
  Work work_[kPlanes + 2];  // a vertex becomes two at most, and only the later one of a stage waits
  unsigned count_ = 0;
  unsigned closing_ = kPlanes;  // the next stage whose last edge, back to its first vertex, is to be fed
};

}  // namespace spanline
