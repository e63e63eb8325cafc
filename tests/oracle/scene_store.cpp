#include "oracle/scene_store.hpp"

#include <algorithm>
#include <cstddef>

namespace spanline::oracle {
namespace {

template <typename T>
Slice<const T> slice_of(const std::vector<T>& items) {
  return {items.data(), static_cast<std::uint32_t>(items.size())};
}

}  // namespace

std::uint16_t MeshStore::vertex(const Position& position) {
  if (layout_.share_vertices) {
    const auto found = std::find_if(positions_.begin(), positions_.end(), [&position](const Position& each) {
      return each.x == position.x && each.y == position.y && each.z == position.z;
    });
    if (found != positions_.end()) return static_cast<std::uint16_t>(found - positions_.begin());
  }
  positions_.push_back(position);
  return static_cast<std::uint16_t>(positions_.size() - 1);
}

bool MeshStore::continues_group(const std::vector<std::vector<Position>>& contours) const {
  return layout_.runs && !groups_.empty() && contours.size() == 1 && groups_.back().contour_count == 1 &&
         groups_.back().corners_per_face == contours[0].size();
}

void MeshStore::add_face(const std::vector<std::vector<Position>>& contours, std::uint16_t material) {
  const auto first_corner = static_cast<std::uint32_t>(corners_.size());
  for (const std::vector<Position>& contour : contours) {
    for (const Position& position : contour) corners_.push_back(vertex(position));
  }
  if (continues_group(contours)) {
    ++groups_.back().face_count;
  } else {
    groups_.push_back({first_corner, face_count_, 1, static_cast<std::uint16_t>(corners_.size() - first_corner),
                       static_cast<std::uint16_t>(contours_.size()), static_cast<std::uint16_t>(contours.size()),
                       material});
    if (contours.size() > 1) {
      for (const auto& contour : contours) contours_.push_back(static_cast<std::uint16_t>(contour.size()));
    } else {
      groups_.back().first_contour = 0;
    }
  }
  outlines_.push_back(contours[0]);
  ++face_count_;
}

void MeshStore::add_detail(std::uint16_t parent, const std::vector<Position>& contour, std::uint16_t material) {
  const Layout layout = layout_;
  layout_.runs = false;  // of a run all have the first one's material
  add_face({contour}, material);
  layout_ = layout;
  parents_.push_back(parent);
}

std::uint16_t MeshStore::material(std::uint16_t face) const {
  const auto next =
      std::find_if(groups_.begin(), groups_.end(), [face](const FaceGroup& group) { return group.first_face > face; });
  return (next - 1)->material;
}

MeshRecord MeshStore::record(std::int32_t unit) const {
  MeshRecord record{};
  record.name = "random";
  record.positions = slice_of(positions_);
  record.corners = slice_of(corners_);
  record.contours = slice_of(contours_);
  record.groups = slice_of(groups_);
  record.face_count = face_count_;
  record.unit = unit;
  record.parents = slice_of(parents_);
  return record;
}

MeshStore& SceneStore::add_mesh(Layout layout, std::int32_t unit) {
  units_.push_back(unit);
  return meshes_.emplace_back(layout);
}

InstanceRecord& SceneStore::add_instance(std::uint16_t mesh, std::uint16_t flags) {
  InstanceRecord instance{};
  instance.mesh = mesh;
  instance.flags = flags;
  instances_.push_back(instance);
  return instances_.back();
}

std::uint16_t SceneStore::add_material() {
  const auto number = static_cast<std::uint32_t>(materials_.size() + 1);
  // An odd multiplier is a bijection modulo 2^24: neighbours in number are far apart in colour.
  const std::uint32_t color = number * 0x9e3779u;
  materials_.push_back({{static_cast<std::uint8_t>(color >> 16 & 255), static_cast<std::uint8_t>(color >> 8 & 255),
                         static_cast<std::uint8_t>(color & 255)},
                        MaterialRecord::kUnlit});
  return static_cast<std::uint16_t>(number - 1);
}

SceneRecord SceneStore::record() {
  mesh_records_.clear();
  for (std::size_t i = 0; i < meshes_.size(); ++i) mesh_records_.push_back(meshes_[i].record(units_[i]));
  SceneRecord record{};
  record.meshes = slice_of(mesh_records_);
  record.instances = slice_of(instances_);
  record.materials = slice_of(materials_);
  return record;
}

SceneStore screen_scene(const std::vector<Facet>& facets, Layout layout) {
  SceneStore scene;
  MeshStore& mesh = scene.add_mesh(layout, 1 << 20);
  for (const Facet& facet : facets) {
    std::vector<std::vector<Position>> contours;
    for (const std::vector<Vertex>& contour : facet.contours) {
      std::vector<Position>& ring = contours.emplace_back();
      for (const Vertex& vertex : contour) {
        ring.push_back({static_cast<std::int16_t>(vertex.x), static_cast<std::int16_t>(vertex.y),
                        static_cast<std::int16_t>(vertex.z / 256 - 32768)});
      }
    }
    mesh.add_face(contours, scene.add_material());
  }
  scene.add_instance(0, InstanceRecord::kScreen);
  return scene;
}

CameraRecord plain_camera() {
  CameraRecord camera{};
  for (int axis = 0; axis < 3; ++axis) camera.axes[axis][axis] = Fx30::from_int(1);
  camera.focal = Fx12::from_int(64);
  camera.near_plane = Fx16::from_int(1);
  camera.far_plane = Fx16::from_int(100);
  return camera;
}

}  // namespace spanline::oracle
