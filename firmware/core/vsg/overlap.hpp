// Where two faces or more cover the same pixels: which ones, and which of them is in front.
#pragma once

#include "core/vsg/active_edge.hpp"
#include "core/vsg/comparator.hpp"

namespace spanline {

// The faces over a run of pixels, a set that edges toggle their faces in and out of.
class OverlapSet {
 public:
  static constexpr unsigned kMost = 16;

  void set(FaceId only) {
    faces_[0] = only;
    count_ = only != 0;
  }
  void set(FaceId a, FaceId b) {
    faces_[0] = a;
    faces_[1] = b;
    count_ = 2;
  }
  // Edges of one column may come in any order: a face may end before it has begun.
  void toggle(const ActiveEdge& edge) {
    toggle(edge.ending());
    toggle(edge.beginning());
  }

  unsigned count() const { return count_; }
  FaceId operator[](unsigned i) const { return faces_[i]; }
  void clear_overflow() { overflow_ = false; }
  bool overflow() const { return overflow_; }  // more faces than the set holds

 private:
  unsigned find(FaceId face) const {
    unsigned at = 0;
    while (at < count_ && faces_[at] != face) ++at;
    return at;
  }
  [[gnu::noinline]] void toggle(FaceId face) {
    if (face == 0) return;
    const unsigned at = find(face);
    if (at < count_) {
      faces_[at] = faces_[--count_];
    } else if (count_ < kMost) {
      faces_[count_++] = face;
    } else {
      overflow_ = true;
    }
  }

  FaceId faces_[kMost] = {};
  unsigned count_ = 0;
  bool overflow_ = false;
};

// The face of the set that is in front of the others all over the columns [left, right), which every face covers. 0:
// they cross, and the visible ones have been handed to show(left, right, face, ramp) from left to right. ramp_of(face)
// is a face's depth along the line.
template <typename RampOf, typename Show>
[[gnu::cold, gnu::noinline]] FaceId resolve_overlap(const OverlapSet& set, std::int32_t left, std::int32_t right,
                                                    const RampOf& ramp_of, const Show& show) {
  struct Ramp {  // as DepthRamp, but not cleared first
    std::uint32_t at_zero, slope;
    std::uint32_t at(std::int32_t column) const { return at_zero + slope * static_cast<std::uint32_t>(column); }
    DepthRamp ramp() const { return {at_zero, slope}; }
  } ramps[OverlapSet::kMost];
  const unsigned count = set.count();
  for (unsigned i = 0; i < count; ++i) {
    const DepthRamp ramp = ramp_of(set[i]);
    ramps[i] = {ramp.at_zero, ramp.slope};
  }
  // Whether face i is in front of face j where they have these depths, as Contest::first_ahead().
  const auto ahead = [&](unsigned i, std::uint32_t depth_i, unsigned j, std::uint32_t depth_j) {
    const auto lead = static_cast<std::int32_t>(depth_i - depth_j);
    return lead > 0 || (lead == 0 && set[i] < set[j]);
  };
  const std::int32_t begin = left;
  do {
    unsigned front = 0;
    std::uint32_t nearest = ramps[0].at(left);
    for (unsigned i = 1; i < count; ++i) {
      const std::uint32_t depth = ramps[i].at(left);
      if (!ahead(i, depth, front, nearest)) continue;
      front = i;
      nearest = depth;
    }
    // Depth is linear: who is ahead at both ends is ahead between them.
    std::int32_t end = right;
    std::uint32_t at_end = ramps[front].at(end - 1);
    for (unsigned i = 0; i < count; ++i) {
      if (i == front || !ahead(i, ramps[i].at(end - 1), front, at_end)) continue;
      std::uint32_t cycles = 0;
      const Contest contest{ramps[front].ramp(), ramps[i].ramp(), left, end, set[front] < set[i]};
      end = DepthComparator<Comparator::plane>::crossing(contest, cycles);
      at_end = ramps[front].at(end - 1);
    }
    if (left == begin && end == right) return set[front];
    show(left, end, set[front], ramps[front].ramp());
    left = end;
  } while (left < right);
  return 0;
}

}  // namespace spanline
