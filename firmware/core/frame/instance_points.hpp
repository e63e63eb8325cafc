#pragma once

#include "core/frame/depth_rows.hpp"
#include "core/geom/mesh_points.hpp"
#include "core/scene/instance_cursor.hpp"

namespace spanline {

// One instance of a scene of triangle meshes, and where its vertices lie on the screen: none is kept, each is projected
// when it is asked for. It is the instance that was asked for last.
class InstancePoints {
 public:
  InstancePoints() = default;
  // The camera must stay where it is.
  InstancePoints(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen)
      : cursor_(scene), camera_(&camera), points_(camera, screen) {}

  // Goes to the instance at a cursor, whose matrix `rows` hold. False where it cannot be drawn: fronts become backs, or
  // positions do not fit. `surely`: no vertex is outside().
  bool enter(const InstanceCursor& at, DepthRows& rows, bool& surely);
  // Goes to the instance of a face or vertex, by its number in the scene.
  void to_face(std::uint32_t face) {
    if (face - first_face() < faces_) return;
    cursor_.to_face(face);
    enter();
  }
  void to_vertex(std::uint32_t vertex) {
    if (vertex - first_vertex() < vertices_) return;
    cursor_.to_vertex(vertex);
    enter();
  }

  // Of the instance that is at hand.
  std::uint32_t index() const { return cursor_.index(); }
  const InstanceRecord& instance() const { return cursor_.instance(); }
  const MeshRecord& mesh() const { return cursor_.mesh(); }
  std::uint32_t first_face() const { return cursor_.first_face(); }
  std::uint32_t first_vertex() const { return cursor_.first_vertex(); }

  // By its number in the mesh: whether a vertex is not well inside the view; where it lies on the screen.
  bool outside(std::uint32_t vertex) const {
    return !points_.projection.well_inside(points_.to_clip(points_.positions[vertex]));
  }
  ScreenXY operator[](std::uint32_t vertex) { return points_[vertex]; }
  MeshPoints& points() { return points_; }
  // Of all the vertices of the mesh: whether none is outside(); where they lie, one after another.
  bool all_inside() const { return points_.projection.well_inside(mesh().positions, points_.to_clip); }
  void place_all(ScreenXY* at) const { points_.projection.place(mesh().positions, points_.to_clip, at); }

 private:
  ClipMatrix enter();

  InstanceCursor cursor_;
  const CameraRecord* camera_ = nullptr;
  MeshPoints points_;
  std::uint32_t faces_ = 0, vertices_ = 0;
};

}  // namespace spanline
