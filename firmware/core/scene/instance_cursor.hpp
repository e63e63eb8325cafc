#pragma once

#include "core/scene/format.hpp"

namespace spanline {

// Finds the instance that a face or vertex number of the scene belongs to. Numbers near the last one are found at once.
class InstanceCursor {
 public:
  InstanceCursor() = default;
  explicit InstanceCursor(const SceneRecord& scene) : scene_(&scene) {}

  // Makes the instance current that holds the vertex (or face) of this number over the scene.
  void to_vertex(std::uint32_t vertex) {
    if (vertex < first_vertex_) rewind();
    while (vertex - first_vertex_ >= mesh().positions.size()) next();
  }
  void to_face(std::uint32_t face) {
    if (face < first_face_) rewind();
    while (face - first_face_ >= mesh().face_count) next();
  }

  void rewind() { index_ = first_vertex_ = first_face_ = 0; }
  bool at_end() const { return index_ == scene_->instances.size(); }
  void next() {
    first_vertex_ += mesh().positions.size();
    first_face_ += mesh().face_count;
    ++index_;
  }

  std::uint32_t index() const { return index_; }
  std::uint32_t first_vertex() const { return first_vertex_; }  // of the current instance, over the scene
  std::uint32_t first_face() const { return first_face_; }
  const InstanceRecord& instance() const { return scene_->instances[index_]; }
  const MeshRecord& mesh() const { return scene_->meshes[instance().mesh]; }

 private:
  const SceneRecord* scene_ = nullptr;
  std::uint32_t index_ = 0, first_vertex_ = 0, first_face_ = 0;
};

}  // namespace spanline
