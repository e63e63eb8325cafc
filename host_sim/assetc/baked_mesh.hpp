// A mesh whose faces are divided by shadows, under construction.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "assetc/shadow_parts.hpp"

namespace spanline::host {

class BakedMesh {
 public:
  // The material (SceneDescription::materials) of a face of the source where the lights reach it so.
  using Naming = std::function<std::int32_t(const MeshFace& face, const ReachRecord& reach)>;

  // `source` and `clipper` must outlive it.
  BakedMesh(const MeshSource& source, RegionClipper& clipper);

  // Faces that are no detail, in order: as the light reaches all of it, or in parts, of which the first stays the face
  // itself. Detail on it comes along.
  void keep(std::size_t face, const Naming& name);
  void add(std::size_t face, const FacePlane& plane, const std::vector<ShadowPart>& parts, const Naming& name);

  // Whether any light is kept from any face.
  bool changed() const { return changed_; }
  MeshSource take();

 private:
  // New corners on one face's plane: equal grid points are one, corners of the source are found again.
  struct Corners {
    const FacePlane& plane;
    const MeshFace& face;
    std::map<std::pair<int, int>, ObjCorner> known;
  };

  void keep_with(std::size_t face, const ReachRecord& reach, const Naming& name);
  void keep_detail(std::size_t parent, const MeshFace& detail, std::int32_t material);
  void add_detail(std::size_t parent, const Region& region, std::int32_t material, Corners& corners);
  void remember(const MeshFace& face, Corners& corners) const;
  ObjCorner corner_at(area::GridPoint point, Corners& corners);
  std::int32_t normal_at(area::GridPoint point, const Corners& corners);
  std::vector<std::size_t> detail_on(std::size_t face) const;

  const MeshSource& source_;
  RegionClipper& clipper_;
  std::vector<Vec3> around_;  // the mean normal of each position of the source
  MeshSource out_;
  std::vector<MeshFace> detail_;
  bool changed_ = false;
};

}  // namespace spanline::host
