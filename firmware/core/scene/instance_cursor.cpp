#include "core/scene/instance_cursor.hpp"

namespace spanline {

// None of this is met often, so it is short instead.
[[gnu::cold]] void InstanceCursor::enter() {
  if (at_end()) return;
  instance_ = &scene_->instances[index_];
  mesh_ = &scene_->meshes[instance_->mesh];
}

[[gnu::cold]] void InstanceCursor::next() {
  first_vertex_ += mesh_->positions.size();
  first_face_ += mesh_->face_count;
  ++index_;
  enter();
}

[[gnu::cold]] void InstanceCursor::begin(const SceneRecord& scene) {
  scene_ = &scene;
  rewind();
}

[[gnu::cold]] void InstanceCursor::rewind() {
  index_ = first_vertex_ = first_face_ = 0;
  enter();
}

[[gnu::cold]] void InstanceCursor::to_vertex(std::uint32_t vertex) {
  if (vertex < first_vertex_) rewind();
  while (vertex - first_vertex_ >= mesh_->positions.size()) next();
}

[[gnu::cold]] void InstanceCursor::find_face(std::uint32_t face) {
  if (face < first_face_) rewind();
  while (face - first_face_ >= mesh_->face_count) next();
}

}  // namespace spanline
