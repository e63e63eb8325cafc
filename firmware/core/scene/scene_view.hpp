#pragma once

#include "core/base/status.hpp"
#include "core/scene/format.hpp"

namespace spanline {

inline constexpr std::uint16_t kNoFace = 65535;

// A scene whose records have been checked once, so that everything behind it reads in place and checks nothing.
class SceneView {
 public:
  SceneView() = default;

  // Checks every record and field of `scene`. On success `view` refers to the records, which must outlive it. On
  // failure the status names the record type, its index, the field and the offending value, and `view` is left as it
  // was.
  static Status validate(const SceneRecord& scene, SceneView& view);

  // A view of records that are known to be what validate() asks for: the scene compiler's (`spanline assets`), which
  // has validated what it writes. Leaves 4 KB of checks out of an image that calls nothing else.
  static SceneView of_compiled(const SceneRecord& scene);

  const SceneRecord& scene() const { return *scene_; }
  std::uint16_t face_count() const { return face_count_; }      // over all instances, hidden ones too
  bool has_patches() const { return has_patches_; }             // some instance is of patches
  std::uint16_t vertex_count() const { return vertex_count_; }  // over all instances
  std::uint16_t curve_count() const { return curve_count_; }    // over all instances, hidden ones too
  bool layered() const { return layered_; }                     // has surface detail or see-through materials

 private:
  const SceneRecord* scene_ = nullptr;
  std::uint16_t face_count_ = 0;
  std::uint16_t vertex_count_ = 0;
  bool has_patches_ = false;
  std::uint16_t curve_count_ = 0;
  bool layered_ = false;
};

}  // namespace spanline
