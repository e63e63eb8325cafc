// The plane of a face as a whole-number grid.
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

  // Nothing where the face has no area.
  static std::optional<FacePlane> of(const MeshSource& mesh, const MeshFace& face);

  Vec3 origin() const { return origin_; }
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 at(area::GridPoint p) const { return origin_ + double{1} * p.x * right_ + double{1} * p.y * up_; }

  // The nearest grid point to a point of the plane.
  area::GridPoint grid_point(Vec3 p) const;
  Region region(const std::vector<Ring3>& rings) const;

  // What lies no further than `margin`, in x and in y, from those edges of `region` that run along the outline of
  // `face`, or no further from it than the margin and kMargin / 8.
  static Region margin_along(const Region& region, const Region& face, std::int32_t margin, RegionClipper& clipper);

 private:
  Vec3 origin_, right_, up_;
};

}  // namespace spanline::host
