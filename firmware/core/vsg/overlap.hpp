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
  void toggle(FaceId face) {
    if (face == 0) return;
    for (unsigned i = 0; i < count_; ++i) {
      if (faces_[i] != face) continue;
      faces_[i] = faces_[--count_];
      return;
    }
    if (count_ < kMost) {
      faces_[count_++] = face;
    } else {
      overflow_ = true;
    }
  }
  void toggle(const ActiveEdge& edge) {
    toggle(edge.ending());
    toggle(edge.beginning());
  }

  unsigned count() const { return count_; }
  FaceId operator[](unsigned i) const { return faces_[i]; }
  void clear_overflow() { overflow_ = false; }
  bool overflow() const { return overflow_; }  // more faces than the set holds

 private:
  FaceId faces_[kMost];
  unsigned count_ = 0;
  bool overflow_ = false;
};

// Hands the visible faces over the columns [left, right), which every face of the set covers, to show(left, right,
// face, ramp) from left to right. ramp_of(face) is a face's depth along the line.
template <typename RampOf, typename Show>
void resolve_overlap(const OverlapSet& set, std::int32_t left, std::int32_t right, const RampOf& ramp_of,
                     const Show& show) {
  struct Ramp {  // as DepthRamp, but not cleared first
    std::uint32_t at_zero, slope;
  } ramps[OverlapSet::kMost];
  for (unsigned i = 0; i < set.count(); ++i) {
    const DepthRamp ramp = ramp_of(set[i]);
    ramps[i] = {ramp.at_zero, ramp.slope};
  }
  const auto ramp = [&](unsigned i) { return DepthRamp{ramps[i].at_zero, ramps[i].slope}; };
  const auto contest = [&](unsigned a, unsigned b, std::int32_t from, std::int32_t to) {
    return Contest{ramp(a), ramp(b), from, to, set[a] < set[b]};
  };
  while (left < right) {
    unsigned front = 0;
    for (unsigned i = 1; i < set.count(); ++i) {
      const Contest c = contest(front, i, left, right);
      if (!c.first_ahead(c.lead(left))) front = i;
    }
    // Depth is linear: who is ahead at both ends is ahead between them.
    std::int32_t end = right;
    for (unsigned i = 0; i < set.count(); ++i) {
      if (i == front) continue;
      const Contest c = contest(front, i, left, end);
      std::uint32_t cycles = 0;
      if (!c.first_ahead(c.lead(end - 1))) end = DepthComparator<Comparator::plane>::crossing(c, cycles);
    }
    show(left, end, set[front], ramp(front));
    left = end;
  }
}

}  // namespace spanline
