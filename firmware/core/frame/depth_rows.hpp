#pragma once

#include "core/frame/depth_reaches.hpp"
#include "core/scene/instance_cursor.hpp"

namespace spanline {

// Depths of a scene's faces without a vertex cache: of the matrices only the row that leads to w is needed, and the
// last two instances' are kept. All faces lie inside the view.
class DepthRows : public DepthReaches<DepthRows> {
 public:
  // Begins a frame. `farthest`: how far away instances are (farthest()) that hold() is not said of.
  void begin(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen, std::int32_t farthest);

  // To be said of instances' matrices before faces are asked for.
  void hold(const ClipMatrix& matrix);
  std::int32_t farthest() const { return farthest_; }

  // The plane of a face; what face_plane() gives. points[1 + vertex]: the scene's on the screen.
  DepthPlane plane(std::uint32_t face, const PoolRef<ScreenXY>& points);

 private:
  // The instance of a face that was asked for, as far as it is used here.
  struct Instance {
    std::uint32_t first_face = 0, faces = 0, first_vertex = 0;  // over the scene; how many
    const std::uint16_t* corners = nullptr;
    const Position* places = nullptr;
    ClipRow ahead;   // that leads to w
    RoughRow rough;  // likewise

    const std::uint16_t* corners_of(std::uint32_t face) const { return corners + 3 * (face - first_face); }
    const Position* positions() const { return places; }
  };
  friend class DepthReaches<DepthRows>;

  const Instance& instance_of(std::uint32_t face) {
    if (face - at_->first_face >= at_->faces) [[unlikely]]
      find(face);
    return *at_;
  }
  void find(std::uint32_t face);

  Instance* at_ = nullptr;  // the one that was asked for last
  Normaliser normaliser_;
  Screen screen_;
  Projection projection_{CameraRecord{}, Screen{}};
  std::int32_t farthest_ = 0;  // w of any position there might be, Q16.16
  Instance instances_[2];      // asked for last: where two overlap, their faces come by turns
  const CameraRecord* camera_ = nullptr;
  InstanceCursor cursor_;
};

}  // namespace spanline
