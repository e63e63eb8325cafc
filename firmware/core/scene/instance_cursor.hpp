#pragma once

#include "core/scene/format.hpp"

namespace spanline {

// Finds the instance that a face or vertex number of the scene belongs to. Numbers near the last one are found at once.
class InstanceCursor {
 public:
  InstanceCursor() = default;
  explicit InstanceCursor(const SceneRecord& scene) { begin(scene); }

  // Begins at the first instance of a scene.
  void begin(const SceneRecord& scene);

  // Makes the instance current that holds the vertex (or face) of this number over the scene.
  void to_vertex(std::uint32_t vertex);
  void to_face(std::uint32_t face) {
    if (face - first_face_ >= mesh_->face_count) find_face(face);
  }

  bool at_end() const { return index_ == scene_->instances.size(); }
  void next();

  const SceneRecord& scene() const { return *scene_; }
  std::uint32_t index() const { return index_; }
  std::uint32_t first_vertex() const { return first_vertex_; }  // of the current instance, over the scene
  std::uint32_t first_face() const { return first_face_; }
  const InstanceRecord& instance() const { return *instance_; }
  const MeshRecord& mesh() const { return *mesh_; }

 private:
  void rewind();
  void enter();
  void find_face(std::uint32_t face);

  const SceneRecord* scene_ = nullptr;
  const InstanceRecord* instance_ = nullptr;  // the current one, where not at_end()
  const MeshRecord* mesh_ = nullptr;          // its
  std::uint32_t index_ = 0, first_vertex_ = 0, first_face_ = 0;
};

}  // namespace spanline
