#pragma once

#include "core/geom/projection.hpp"
#include "core/scene/instance_cursor.hpp"
#include "core/vsg/depth.hpp"

namespace spanline {

// Depth planes of a scene's faces without a vertex cache: of the matrices only the row that leads to w is needed, and
// the last instance's is kept.
class DepthRows {
 public:
  DepthRows() = default;
  DepthRows(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen)
      : cursor_(scene), camera_(&camera), screen_(screen), projection_(camera, screen) {}

  // The plane of a triangle inside the view; what face_plane() gives. points[1 + vertex]: the scene's on the screen.
  DepthPlane plane(std::uint32_t face, const PoolRef<ScreenXY>& points);

 private:
  InstanceCursor cursor_;
  const CameraRecord* camera_ = nullptr;
  Screen screen_;
  Projection projection_{CameraRecord{}, Screen{}};
  Normaliser normaliser_;
  ClipRow ahead_;                        // that leads to w
  std::uint32_t instance_ = UINT32_MAX;  // of the row
};

inline DepthPlane DepthRows::plane(std::uint32_t face, const PoolRef<ScreenXY>& points) {
  cursor_.to_face(face);
  const MeshRecord& mesh = cursor_.mesh();
  if (instance_ != cursor_.index()) {
    instance_ = cursor_.index();
    ahead_ = ClipRow(compose(*camera_, cursor_.instance().transform, mesh), 2);
  }
  const std::uint16_t* const corner = mesh.corners.data() + 3 * (face - cursor_.first_face());
  const ScreenXY* const point = &points[cursor_.first_vertex() + 1];
  const Position* const position = mesh.positions.data();
  // Inside the view, and the matrix fits, else the walker would not have begun.
  const auto depth = [&](int i) { return projection_.depth(ahead_.at(position[corner[i]]), normaliser_); };
  return depth_plane({point[corner[0]], point[corner[1]], point[corner[2]]}, {depth(0), depth(1), depth(2)}, screen_);
}

}  // namespace spanline
