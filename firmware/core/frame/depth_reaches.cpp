#include "core/frame/depth_reaches.hpp"

#include <utility>

#include "core/frame/depth_rows.hpp"
#include "core/frame/instance_points.hpp"

namespace spanline {

// In units of 2^16 of the rough row's, rounded outwards.
template <typename Instances>
void DepthReaches<Instances>::reach(std::uint32_t face, DepthReach& to) {
  const auto& at = static_cast<Instances*>(this)->instance_of(face);
  const std::uint16_t* const corner = at.corners_of(face);
  const Position* const positions = at.positions();
  const auto ahead = [&](int i) { return at.rough.at(positions[corner[i]]); };
  const std::int32_t a = ahead(0), b = ahead(1), c = ahead(2);
  std::int32_t nearest = a < b ? a : b, farthest = a < b ? b : a;
  if (c < nearest) nearest = c;
  if (c > farthest) farthest = c;
  static_assert(RoughRow::kError == 1 << 16, "a unit");
  to.nearest = static_cast<std::int16_t>((nearest >> 16) - 1);
  to.farthest = static_cast<std::int16_t>((farthest >> 16) + 2);
}

template <typename Instances>
[[gnu::cold]] FaceId DepthReaches<Instances>::nearest(const OverlapSet& set, PlaneCache& cache) {
  FaceId front = 0;
  std::int32_t farthest = INT16_MAX, nearest = INT16_MAX;  // how far the one in front reaches
  std::int32_t others = INT16_MAX;                         // the nearest of the others
  for (unsigned i = 0; i < set.count(); ++i) {
    const DepthReach& of = reach_of(set[i], cache);
    std::int32_t passed = of.nearest;
    if (of.farthest < farthest) {
      front = set[i];
      farthest = of.farthest;
      passed = std::exchange(nearest, passed);
    }
    if (passed < others) others = passed;
  }
  return apart(farthest, others) ? front : FaceId{0};
}

template class DepthReaches<DepthRows>;
template class DepthReaches<InstancePoints>;

}  // namespace spanline
