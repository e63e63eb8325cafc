#pragma once

#include "core/geom/projection.hpp"
#include "core/scene/instance_cursor.hpp"
#include "core/vsg/depth.hpp"
#include "core/vsg/overlap.hpp"
#include "core/vsg/plane_cache.hpp"

namespace spanline {

// Depths of a scene's faces without a vertex cache: of the matrices only the row that leads to w is needed, and the
// last two instances' are kept. All faces lie inside the view.
class DepthRows {
 public:
  // Begins a frame. `farthest`: how far away instances are (farthest()) that hold() is not said of.
  void begin(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen, std::int32_t farthest);

  // To be said of instances' matrices before faces are asked for.
  void hold(const ClipMatrix& matrix);
  std::int32_t farthest() const { return farthest_; }

  // The plane of a face; what face_plane() gives. points[1 + vertex]: the scene's on the screen.
  DepthPlane plane(std::uint32_t face, const PoolRef<ScreenXY>& points);
  // The same of a face with these corners on the screen.
  DepthPlane plane(std::uint32_t face, const ScreenXY (&points)[3]);
  // The face of the set that is in front of all others wherever both are, as can be told from how far their corners
  // lie ahead; 0 where that takes planes.
  FaceId nearest(const OverlapSet& set, PlaneCache& cache);
  // Likewise of two faces.
  FaceId nearer(FaceId a, FaceId b, PlaneCache& cache) {
    const DepthReach& of_a = reach_of(a, cache);
    const std::int32_t nearest = of_a.nearest, farthest = of_a.farthest;  // the other one may take its place
    const DepthReach& of_b = reach_of(b, cache);
    if (apart(farthest, of_b.nearest)) return a;
    return apart(of_b.farthest, nearest) ? b : FaceId{0};
  }

 private:
  // The instance of a face that was asked for, as far as it is used here.
  struct Instance {
    std::uint32_t first_face = 0, faces = 0, first_vertex = 0;  // over the scene; how many
    const std::uint16_t* corners = nullptr;
    const Position* positions = nullptr;
    ClipRow ahead;   // that leads to w
    RoughRow rough;  // likewise
  };

  const Instance& instance_of(std::uint32_t face) {
    if (face - at_->first_face >= at_->faces) [[unlikely]]
      find(face);
    return *at_;
  }
  void find(std::uint32_t face);
  template <typename PointOf>
  DepthPlane plane_by(std::uint32_t face, const PointOf& point_of);
  [[gnu::noinline]] void reach(std::uint32_t face, DepthReach& to);
  const DepthReach& reach_of(FaceId face, PlaneCache& cache) {
    return cache.reach(face, [this, face](DepthReach& to) { reach(face - 1u, to); });
  }
  // Whether what lies no farther than `farthest` is in front of what lies no nearer than `nearest` by any planes. Those
  // are off by less than half a unit of depth (of 65536) each and depths by less than a tenth, so two units between
  // near / farthest and near / nearest will do: near * (nearest - farthest) * 2^15 >= farthest * nearest. In a reach's
  // units; as `farthest` is above 0, what is `nearest` below it is not in front.
  bool apart(std::int32_t farthest, std::int32_t nearest) const {
    return near_ * (nearest - farthest) >
           static_cast<std::int32_t>(static_cast<std::uint32_t>(farthest * nearest) >> 14);
  }

  Instance* at_ = nullptr;  // the one that was asked for last
  Normaliser normaliser_;
  std::int32_t near_ = 0;  // the near plane, in units of 2^15 of the rough row's
  Screen screen_;
  Projection projection_{CameraRecord{}, Screen{}};
  std::int32_t farthest_ = 0;  // w of any position there might be, Q16.16
  Instance instances_[2];      // asked for last: where two overlap, their faces come by turns
  const CameraRecord* camera_ = nullptr;
  InstanceCursor cursor_;
};

}  // namespace spanline
