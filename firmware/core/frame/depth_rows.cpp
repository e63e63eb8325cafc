#include "core/frame/depth_rows.hpp"

#include <utility>

namespace spanline {

[[gnu::cold]] void DepthRows::begin(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen,
                                    std::int32_t farthest) {
  cursor_.begin(scene);
  camera_ = &camera;
  screen_ = screen;
  projection_ = Projection(camera, screen);
  farthest_ = farthest;
  at_ = instances_;
  for (Instance& instance : instances_) instance.faces = 0;
}

void DepthRows::hold(const ClipMatrix& matrix) {
  const auto farthest = static_cast<std::int32_t>(matrix.farthest(2));
  if (farthest > farthest_) farthest_ = farthest;
}

[[gnu::cold]] void DepthRows::find(std::uint32_t face) {
  at_ = at_ == instances_ ? instances_ + 1 : instances_;
  if (face - at_->first_face < at_->faces) return;
  cursor_.to_face(face);
  const MeshRecord& mesh = cursor_.mesh();
  const ClipMatrix matrix = compose(*camera_, cursor_.instance().transform, mesh);
  const int up = RoughRow::most_up(farthest_);
  near_ = (projection_.near_w << up) >> 15;
  *at_ = {cursor_.first_face(),  mesh.face_count,    cursor_.first_vertex(), mesh.corners.data(),
          mesh.positions.data(), ClipRow(matrix, 2), RoughRow(matrix, 2, up)};
}

// point_of(vertex of the scene, which corner) is its place on the screen.
template <typename PointOf>
DepthPlane DepthRows::plane_by(std::uint32_t face, const PointOf& point_of) {
  const Instance& at = instance_of(face);
  const std::uint16_t* const corner = at.corners + 3 * (face - at.first_face);
  // The matrix fits, else the walker would not have begun.
  ScreenXY points[3];
  std::uint32_t depths[3];
#pragma GCC unroll 1  // three times the code is no faster
  for (int i = 0; i < 3; ++i) {
    points[i] = point_of(at.first_vertex + corner[i], i);
    depths[i] = projection_.depth(at.ahead.at(at.positions[corner[i]]), normaliser_);
  }
  return depth_plane(points, depths, screen_);
}

DepthPlane DepthRows::plane(std::uint32_t face, const PoolRef<ScreenXY>& points) {
  return plane_by(face, [&points](std::uint32_t vertex, int) { return points[vertex + 1]; });
}

DepthPlane DepthRows::plane(std::uint32_t face, const ScreenXY (&points)[3]) {
  return plane_by(face, [&points](std::uint32_t, int i) { return points[i]; });
}

// In units of 2^16 of the rough row's, rounded outwards.
void DepthRows::reach(std::uint32_t face, DepthReach& to) {
  const Instance& at = instance_of(face);
  const std::uint16_t* const corner = at.corners + 3 * (face - at.first_face);
  const auto ahead = [&](int i) { return at.rough.at(at.positions[corner[i]]); };
  const std::int32_t a = ahead(0), b = ahead(1), c = ahead(2);
  std::int32_t nearest = a < b ? a : b, farthest = a < b ? b : a;
  if (c < nearest) nearest = c;
  if (c > farthest) farthest = c;
  static_assert(RoughRow::kError == 1 << 16, "a unit");
  to.nearest = static_cast<std::int16_t>((nearest >> 16) - 1);
  to.farthest = static_cast<std::int16_t>((farthest >> 16) + 2);
}

[[gnu::cold]] FaceId DepthRows::nearest(const OverlapSet& set, PlaneCache& cache) {
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

}  // namespace spanline
