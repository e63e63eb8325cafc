// The plane of a face as a whole-number grid, and what is thrown onto it along a light.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assetc/region.hpp"
#include "assetc/scene_description.hpp"

namespace spanline::host {

using Ring3 = std::vector<Vec3>;

// The rings of a face in the mesh's own coordinates.
std::vector<Ring3> rings_of(const MeshSource& mesh, const MeshFace& face);

// A grid on the plane of a face: the point (x, y) lies at origin + x * right + y * up, in the mesh's own coordinates. A
// face fills 60,000 units of it in the longer direction; beside it there is room for a margin (kMargin) and no more.
class FacePlane {
 public:
  static constexpr std::int32_t kReach = 30000;  // units: no corner of the face is further from the origin in x or y
  static constexpr std::int32_t kMargin = 480;   // units: about a hundredth of the face
  static constexpr std::int32_t kWindow = kReach + 2 * kMargin;  // what lies further out does not matter

  // Nothing where the face has no area.
  static std::optional<FacePlane> of(const MeshSource& mesh, const MeshFace& face);

  Vec3 origin() const { return origin_; }
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 at(area::GridPoint p) const { return origin_ + double{1} * p.x * right_ + double{1} * p.y * up_; }

  // The nearest grid point to a point of the plane.
  area::GridPoint grid_point(Vec3 p) const;
  Region region(const std::vector<Ring3>& rings) const;

  // The region and a margin round it.
  Region with_margin(const Region& region, RegionClipper& clipper) const;

 private:
  Vec3 origin_, right_, up_;
};

// Throws polygons of the world along a light onto the plane of a face that `place` puts into the world.
class ShadowThrow {
 public:
  // Nothing where the light travels along the plane. `direction` is of unit length.
  static std::optional<ShadowThrow> onto(const FacePlane& plane, const Placement& place, Vec3 direction);

  // The shadow of a polygon (world) within the window; what lies in the plane or behind it throws none.
  Region shadow(const std::vector<Ring3>& rings) const;

 private:
  Vec3 origin_;                // world
  Vec3 to_x_, to_y_, to_way_;  // rows: a world point less the origin to grid x, grid y and its way along the light
  double nearest_ = 0;         // ways below are in the plane
};

}  // namespace spanline::host
