#pragma once

#include "core/base/pool.hpp"
#include "core/frame/depth_reaches.hpp"
#include "core/geom/mesh_points.hpp"
#include "core/scene/instance_cursor.hpp"

namespace spanline {

// What is kept of an instance whose vertices are projected, and whose faces' depths are asked for, one by one.
struct BandInstance {
  InstanceCursor cursor;
  MeshPoints points;
  RoughRow rough;                         // that leads to w
  std::uint32_t faces = 0, vertices = 0;  // how many it has; 0: it is not made

  const std::uint16_t* corners_of(std::uint32_t face) const {
    return cursor.mesh().corners.data() + 3 * (face - cursor.first_face());
  }
  const Position* positions() const { return points.positions; }
};

// The instances of a scene of triangle meshes, and where their vertices lie on the screen: none is kept, each is
// projected when it is asked for. Matrices are kept of the instances that were asked for last; the very last is the
// one at hand.
class InstancePoints : public DepthReaches<InstancePoints> {
 public:
  InstancePoints() = default;
  // The pool's sink is used, too.
  explicit InstancePoints(PoolRef<BandInstance> kept) : kept_(kept), at_(kept.sink()) {}

  // Begins a frame: none is known.
  void begin(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen);
  const SceneRecord& scene() const { return at_->cursor.scene(); }
  const CameraRecord& camera() const { return camera_; }

  // Goes to the first instance of the scene that is drawn, or the next one after that at hand; false: there is none.
  bool to_drawn(bool first);
  // Makes that one. To be said of all that are drawn before depths are asked for. False where it cannot be drawn:
  // fronts become backs, or positions do not fit. `surely`: no vertex is outside().
  bool enter(bool& surely);
  // Goes to the instance of a face or vertex, by its number in the scene.
  void to_face(std::uint32_t face) {
    if (face - first_face() >= at_->faces) [[unlikely]]
      find_face(face);
  }
  void to_vertex(std::uint32_t vertex) {
    if (vertex - first_vertex() >= at_->vertices) [[unlikely]]
      find_vertex(vertex);
  }

  // Of the instance that is at hand.
  std::uint32_t index() const { return at_->cursor.index(); }
  const InstanceRecord& instance() const { return at_->cursor.instance(); }
  const MeshRecord& mesh() const { return at_->cursor.mesh(); }
  std::uint32_t first_face() const { return at_->cursor.first_face(); }
  std::uint32_t first_vertex() const { return at_->cursor.first_vertex(); }

  // By its number in the mesh: whether a vertex is not well inside the view; where it lies on the screen.
  bool outside(std::uint32_t vertex) const {
    const MeshPoints& points = at_->points;
    return !points.projection.well_inside(points.to_clip(points.positions[vertex]));
  }
  ScreenXY operator[](std::uint32_t vertex) { return at_->points[vertex]; }
  MeshPoints& points() { return at_->points; }
  // Of all the vertices of the mesh: whether none is outside(); where they lie, one after another.
  bool all_inside() const { return at_->points.projection.well_inside(mesh().positions, at_->points.to_clip); }
  void place_all(ScreenXY* at) const { at_->points.projection.place(mesh().positions, at_->points.to_clip, at); }
  // The depth plane of a face of the scene, which becomes that at hand; its corners on the screen.
  DepthPlane plane(std::uint32_t face, const ScreenXY (&corners)[3], const Screen& screen);

 private:
  friend class DepthReaches<InstancePoints>;
  const BandInstance& instance_of(std::uint32_t face) {
    to_face(face);
    return *at_;
  }
  [[gnu::noinline]] void find_face(std::uint32_t face);
  [[gnu::noinline]] void find_vertex(std::uint32_t vertex);
  template <typename Holds>
  bool turn_back(const Holds& holds);
  void to_next();
  void forget();
  void hold(const ClipMatrix& matrix);
  bool make();

  PoolRef<BandInstance> kept_;
  BandInstance* at_ = nullptr;
  CameraRecord camera_{};
  std::int32_t farthest_ = 0;  // w of any position there might be, Q16.16
  int up_ = 0;                 // of the rough rows
};

}  // namespace spanline
