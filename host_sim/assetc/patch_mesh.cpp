#include "assetc/patch_mesh.hpp"

#include <map>
#include <tuple>

#include "assetc/patch_sides.hpp"

namespace spanline::host {
namespace {

// Opens a patch; its sixteen corners are to follow.
void begin_patch(MeshSource& mesh, std::int32_t material) {
  mesh.faces.push_back(
      {static_cast<std::uint32_t>(mesh.corners.size()), FaceGroup::kPatchCorners, 0, FaceGroup::kPatches, material});
}

// Numbers points, the same ones alike.
class PointTable {
 public:
  explicit PointTable(std::vector<Vec3>& positions) : positions_(positions) {}

  std::int32_t number(Vec3 p) {
    const auto next = static_cast<std::int32_t>(positions_.size());
    const auto [found, is_new] = numbers_.try_emplace({p.x, p.y, p.z}, next);
    if (is_new) positions_.push_back(p);
    return found->second;
  }

 private:
  std::vector<Vec3>& positions_;
  std::map<std::tuple<double, double, double>, std::int32_t> numbers_;
};

}  // namespace

std::int32_t add_patches(SceneDescription& scene, const std::vector<BptPatch>& patches, const std::string& name,
                         const std::string& place, MeshShading shading) {
  MaterialSpec material;
  material.shading = shading == MeshShading::flat    ? Shading::kFlat
                     : shading == MeshShading::unlit ? Shading::kUnlit
                                                     : Shading::kGouraud;
  MeshSource mesh;
  mesh.name = name;
  mesh.place = place;
  PointTable points(mesh.positions);
  for (const BptPatch& patch : patches) {
    begin_patch(mesh, static_cast<std::int32_t>(scene.materials.size()));
    for (const auto& row : patch.points) {
      for (const Vec3& p : row) mesh.corners.push_back({points.number(p)});
    }
  }
  turn_patches_out(mesh);
  scene.materials.push_back(material);
  scene.meshes.push_back(std::move(mesh));
  return static_cast<std::int32_t>(scene.meshes.size()) - 1;
}

SceneDescription describe_bpt(const std::string& path, MeshShading shading) {
  SceneDescription scene;
  scene.place = path;
  InstanceSpec instance;
  instance.mesh = add_patches(scene, read_bpt(path), "patches", path, shading);
  instance.cull = false;
  scene.instances.push_back(instance);
  return scene;
}

void read_inline_patches(const JsonNode& node, MeshSource& mesh, std::int32_t material) {
  const std::vector<JsonNode> patches = node.elements(1);
  if (patches.size() > kMaxSceneFaces) node.fail("more than 65535 patches in one mesh");
  for (const JsonNode& patch : patches) {
    const std::vector<JsonNode> indices = patch.elements();
    if (indices.size() != FaceGroup::kPatchCorners) patch.fail("must have 16 elements, four rows of four");
    begin_patch(mesh, material);
    for (const JsonNode& index : indices) {
      mesh.corners.push_back({static_cast<std::int32_t>(index.whole(0, std::ssize(mesh.positions) - 1))});
    }
  }
}

}  // namespace spanline::host
