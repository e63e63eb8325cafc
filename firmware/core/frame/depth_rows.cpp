#include "core/frame/depth_rows.hpp"

#include <utility>

namespace spanline {

void DepthRows::hold(const ClipMatrix& matrix) {
  const auto farthest = static_cast<std::int32_t>(matrix.farthest(2));
  if (farthest > farthest_) farthest_ = farthest;
}

[[gnu::cold]] void DepthRows::find(std::uint32_t face) {
  std::swap(at_, other_);
  if (face - at_.first_face < at_.faces) return;
  cursor_.to_face(face);
  const MeshRecord& mesh = cursor_.mesh();
  const ClipMatrix matrix = compose(*camera_, cursor_.instance().transform, mesh);
  const int up = RoughRow::most_up(farthest_);
  near_ = projection_.near_w << up;
  // f * n / (near * 2^15) of apart(), for the farthest there might be.
  static_assert(4 << 15 >= 2 * RoughRow::kError, "what a reach is off by");
  const std::uint32_t most = (static_cast<std::uint32_t>(farthest_) << up >> 15) + 5;
  const std::uint32_t near = static_cast<std::uint32_t>(near_) >> 15;
  surely_apart_ = near > 1 && most <= 0xffff ? static_cast<std::int32_t>(most * most / near) : INT32_MAX;
  at_ = {cursor_.first_face(),  mesh.face_count,    cursor_.first_vertex(), mesh.corners.data(),
         mesh.positions.data(), ClipRow(matrix, 2), RoughRow(matrix, 2, up)};
}

// point_of(vertex of the scene, which corner) is its place on the screen.
template <typename PointOf>
DepthPlane DepthRows::plane_by(std::uint32_t face, const PointOf& point_of) {
  const Instance& at = instance_of(face);
  const std::uint16_t* const corner = at.corners + 3 * (face - at.first_face);
  // The matrix fits, else the walker would not have begun.
  const auto depth = [&](int i) { return projection_.depth(at.ahead.at(at.positions[corner[i]]), normaliser_); };
  const auto point = [&](int i) { return point_of(at.first_vertex + corner[i], i); };
  return depth_plane({point(0), point(1), point(2)}, {depth(0), depth(1), depth(2)}, screen_);
}

DepthPlane DepthRows::plane(std::uint32_t face, const PoolRef<ScreenXY>& points) {
  return plane_by(face, [&points](std::uint32_t vertex, int) { return points[vertex + 1]; });
}

DepthPlane DepthRows::plane(std::uint32_t face, const ScreenXY (&points)[3]) {
  return plane_by(face, [&points](std::uint32_t, int i) { return points[i]; });
}

// Of a face, in the rough row's units, rounded outwards.
void DepthRows::reach(std::uint32_t face, DepthReach& to) {
  const Instance& at = instance_of(face);
  const std::uint16_t* const corner = at.corners + 3 * (face - at.first_face);
  const auto ahead = [&](int i) { return at.rough.at(at.positions[corner[i]]); };
  const std::int32_t a = ahead(0), b = ahead(1), c = ahead(2);
  std::int32_t nearest = a < b ? a : b, farthest = a < b ? b : a;
  if (c < nearest) nearest = c;
  if (c > farthest) farthest = c;
  to = {nearest - RoughRow::kError, farthest + RoughRow::kError};
}

// Whether what lies no farther than `farthest` is in front of what lies no nearer than `nearest` by any planes. Those
// are off by less than half a unit of depth (of 65536) each and depths by less than a tenth, so two units between
// near / farthest and near / nearest will do: near * (nearest - farthest) * 2^15 >= farthest * nearest.
bool DepthRows::apart(std::int32_t farthest, std::int32_t nearest) const {
  if (nearest - farthest > surely_apart_) [[likely]]
    return true;
  return nearest > farthest && mul_high(near_, nearest - farthest) > mul_high(farthest, nearest) >> 15;
}

FaceId DepthRows::nearest(const OverlapSet& set, PlaneCache& cache) {
  const auto reach_of = [&](FaceId face) {
    return cache.reach(face, [this](FaceId f, DepthReach& to) { reach(f - 1u, to); });
  };
  FaceId front = set[0];
  const DepthReach* reach = reach_of(front);
  if (reach == nullptr) return 0;
  DepthReach of_front = *reach;
  if (set.count() == 2) [[likely]] {
    reach = reach_of(set[1]);
    if (reach == nullptr) return 0;
    if (of_front.farthest < reach->nearest) return apart(of_front.farthest, reach->nearest) ? front : FaceId{0};
    return apart(reach->farthest, of_front.nearest) ? set[1] : FaceId{0};
  }
  std::int32_t others = INT32_MAX;  // the nearest of the others
  for (unsigned i = 1; i < set.count(); ++i) {
    reach = reach_of(set[i]);
    if (reach == nullptr) return 0;
    std::int32_t passed = reach->nearest;
    if (reach->farthest < of_front.farthest) {
      front = set[i];
      passed = std::exchange(of_front, *reach).nearest;
    }
    if (passed < others) others = passed;
  }
  return apart(of_front.farthest, others) ? front : FaceId{0};
}

}  // namespace spanline
