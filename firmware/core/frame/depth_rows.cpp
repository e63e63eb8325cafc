#include "core/frame/depth_rows.hpp"

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

DepthPlane DepthRows::plane(std::uint32_t face, const PoolRef<ScreenXY>& points) {
  const Instance& at = instance_of(face);
  // The matrix fits, else the walker would not have begun.
  return corner_plane(
      at.corners_of(face), at.positions(), at.ahead, projection_, normaliser_, screen_,
      [&points, first = at.first_vertex + 1](std::uint32_t vertex, int) { return points[first + vertex]; });
}

}  // namespace spanline
