#pragma once

#include "core/geom/projection.hpp"
#include "core/vsg/depth.hpp"
#include "core/vsg/overlap.hpp"
#include "core/vsg/plane_cache.hpp"

namespace spanline {

// Which of several faces is in front, as far as that can be told from how far their corners lie ahead. Instances:
// instance_of(a face of the scene) has its `rough` row to w and its mesh's `positions`, corners_of(face) the face's.
template <typename Instances>
class DepthReaches {
 public:
  // The face of the set that is in front of all others wherever both are; 0 where that takes planes.
  FaceId nearest(const OverlapSet& set, PlaneCache& cache);
  // Likewise of two faces.
  FaceId nearer(FaceId a, FaceId b, PlaneCache& cache) {
    const DepthReach& of_a = reach_of(a, cache);
    const std::int32_t nearest = of_a.nearest, farthest = of_a.farthest;  // the other one may take its place
    const DepthReach& of_b = reach_of(b, cache);
    if (apart(farthest, of_b.nearest)) return a;
    return apart(of_b.farthest, nearest) ? b : FaceId{0};
  }

 protected:
  std::int32_t near_ = 0;  // the near plane, in units of 2^15 of the rough rows'

 private:
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
};

// The depth plane of a face that lies inside the view. point_of(vertex of its mesh, which corner) is its place on the
// screen; `ahead`: the row that leads to w.
template <typename PointOf>
inline DepthPlane corner_plane(const std::uint16_t* corner, const Position* positions, const ClipRow& ahead,
                               const Projection& projection, Normaliser& normaliser, const Screen& screen,
                               const PointOf& point_of) {
  ScreenXY points[3];
  std::uint32_t depths[3];
#pragma GCC unroll 1  // three times the code is no faster
  for (int i = 0; i < 3; ++i) {
    points[i] = point_of(corner[i], i);
    depths[i] = projection.depth(ahead.at(positions[corner[i]]), normaliser);
  }
  return depth_plane(points, depths, screen);
}

}  // namespace spanline
