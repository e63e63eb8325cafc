// Scenes that own their records, for tests: what the scene compiler writes as constexpr tables, made at run time.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/scene/format.hpp"
#include "oracle/facet.hpp"

namespace spanline::oracle {

// How faces are laid down in the records; the picture must not depend on it.
struct Layout {
  bool share_vertices = true;  // equal positions become one vertex
  bool runs = false;           // faces in a row with equal corner counts share a group (and its material)
};

// One mesh under construction. Faces are numbered in the order they are added.
class MeshStore {
 public:
  explicit MeshStore(Layout layout = {}) : layout_(layout) {}

  // contours: one ring, or an outline and its holes, each of at least 3 positions.
  void add_face(const std::vector<std::vector<Position>>& contours, std::uint16_t material);
  // Surface detail on a face that is none; after it only more of the kind may be added.
  void add_detail(std::uint16_t parent, const std::vector<Position>& contour, std::uint16_t material);

  const std::vector<Position>& outline(std::uint16_t face) const { return outlines_[face]; }
  std::uint16_t material(std::uint16_t face) const;

  std::uint16_t face_count() const { return face_count_; }
  // Refers to this store. `origin` and `unit` as in MeshRecord; no normals.
  MeshRecord record(std::int32_t unit) const;

 private:
  std::uint16_t vertex(const Position& position);
  bool continues_group(const std::vector<std::vector<Position>>& contours) const;

  Layout layout_;
  std::vector<Position> positions_;
  std::vector<std::uint16_t> corners_;
  std::vector<std::uint16_t> contours_;
  std::vector<FaceGroup> groups_;
  std::vector<std::vector<Position>> outlines_;
  std::vector<std::uint16_t> parents_;
  std::uint16_t face_count_ = 0;
};

// A whole scene. Meshes and instances may be added until record() is called.
class SceneStore {
 public:
  MeshStore& add_mesh(Layout layout, std::int32_t unit);
  InstanceRecord& add_instance(std::uint16_t mesh, std::uint16_t flags);
  // Unlit, of a colour that no other material of the scene has.
  std::uint16_t add_material();
  std::uint16_t mesh_count() const { return static_cast<std::uint16_t>(meshes_.size()); }
  MeshStore& mesh(std::uint16_t index) { return meshes_[index]; }
  std::vector<MaterialRecord>& materials() { return materials_; }
  // Refers to this store.
  SceneRecord record();

 private:
  std::deque<MeshStore> meshes_;
  std::vector<std::int32_t> units_;
  std::vector<MeshRecord> mesh_records_;
  std::vector<InstanceRecord> instances_;
  std::vector<MaterialRecord> materials_;
};

// The facets as one mesh on the screen: face i of the scene is facets[i]. Depths must be whole units, 0 … 65535 (times
// 256).
SceneStore screen_scene(const std::vector<Facet>& facets, Layout layout);

// A camera that any scene may be drawn with; scenes on the screen do not look at it.
CameraRecord plain_camera();

}  // namespace spanline::oracle
