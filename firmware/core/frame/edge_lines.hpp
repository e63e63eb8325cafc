// The edge walker's lines of a scene of meshes, or of patches.
#pragma once

#include "core/frame/patch_lines.hpp"

namespace spanline {

template <bool kTaps>
class EdgeLines {
 public:
  EdgeLines() = default;
  explicit EdgeLines(const FrameStorage& storage) : mesh_(storage), patches_(storage) {}

  // As MeshLines.
  template <typename Changes>
  Status begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top, Changes& changes) {
    of_patches_ = scene.has_patches();
    return of_patches_ ? patches_.begin(scene, camera, top) : mesh_.begin(scene, camera, top, changes);
  }
  bool ready() const { return of_patches_ ? patches_.ready() : mesh_.ready(); }
  const SceneRecord& scene() const { return of_patches_ ? patches_.scene() : mesh_.scene(); }
  bool next(std::uint16_t line, Painter& painter, const SpanTap& tap) {
    return of_patches_ ? patches_.next(line, painter, tap) : mesh_.next(line, painter, tap);
  }
  Status shortage() const { return of_patches_ ? patches_.shortage() : mesh_.shortage(); }

 private:
  MeshLines<kTaps> mesh_;
  PatchLines<kTaps> patches_;
  bool of_patches_ = false;
};

}  // namespace spanline
