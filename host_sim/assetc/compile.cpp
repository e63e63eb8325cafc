#include "assetc/compile.hpp"

#include "assetc/bake.hpp"
#include "assetc/detail.hpp"
#include "assetc/extent.hpp"
#include "assetc/fans.hpp"
#include "assetc/fixed_point.hpp"
#include "assetc/input_error.hpp"
#include "assetc/merge.hpp"
#include "assetc/triangulate.hpp"

namespace spanline::host {
namespace {

constexpr double kWorldEdge = kMaxWorld * 0.999;  // room for the rounding of records
constexpr double kFarOff = 4;  // a thing this many times its own size from the origin gives up the origin for precision

// The point to measure from: the origin, unless the box is so far off that its digits would be lost.
Vec3 pivot_of(const Box& box) {
  const Vec3 centre = box.centre();
  return largest(centre) > kFarOff * largest(box.half()) ? centre : Vec3{};
}

double largest_from(const Box& box, Vec3 pivot) {
  return std::max(largest(box.low - pivot), largest(box.high - pivot));
}

WorldFit fit_world(const Box& reach) {
  constexpr double kSmallest = 1e-9;  // a scene that is one point has no size to scale
  const Vec3 centre = pivot_of(reach);
  return {kWorldEdge / std::max(largest_from(reach, centre), kSmallest), centre};
}

// The mesh's own scale: as large as the world's, times the largest stretch by which an instance draws it.
MeshFit fit_mesh(const Box& box, double stretch, const WorldFit& world) {
  constexpr double kSmallest = 1e-12;
  const Vec3 pivot =
      box.centre();  // which every instance places within the world's reach; the mesh's origin may lie anywhere
  const double limit = kWorldEdge / std::max(largest_from(box, pivot), kSmallest);
  const double wanted = stretch > 0 ? world.scale * stretch : limit;
  return {std::min(wanted, limit), pivot};
}

Box reach_of_eyes(const CompiledScene& scene, const SceneDescription& description, double reach) {
  Box eyes;
  const Sphere& bounds = scene.bounds();
  const CameraSpec& camera = description.camera;
  eyes.add(view_in_frame(camera, bounds, description.height, 0, description.place).eye);
  for (const MotionKey& key : camera.motion.keys) eyes.add(Vec3{key.pose[0], key.pose[1], key.pose[2]});
  const double r = reach * bounds.radius;
  eyes.add(bounds.centre - Vec3{r, r, r});
  eyes.add(bounds.centre + Vec3{r, r, r});
  return eyes;
}

void check_totals(const SceneDescription& scene, const std::vector<MeshTables>& meshes) {
  std::size_t faces = 0, vertices = 0;
  for (const InstanceSpec& instance : scene.instances) {
    faces += meshes[static_cast<std::size_t>(instance.mesh)].face_count;
    vertices += meshes[static_cast<std::size_t>(instance.mesh)].positions.size();
  }
  const auto refuse = [&](const char* what, std::size_t count, std::size_t most) {
    throw InputError(scene.place, "the instances have " + std::to_string(count) + " " + what +
                                      ", a scene holds at most " + std::to_string(most));
  };
  if (faces > kMaxSceneFaces) refuse("faces", faces, kMaxSceneFaces);
  if (vertices > kMaxSceneVertices) refuse("vertices", vertices, kMaxSceneVertices);
}

bool is_gouraud(const SceneDescription& scene, std::int32_t material) {
  return material != kNone && scene.materials[static_cast<std::size_t>(material)].shading == Shading::kGouraud;
}

// How the instances of a scene use one mesh.
struct MeshUse {
  double stretch = 0;  // largest over its instances
  bool on_screen = false;
  bool smooth = false;  // some Gouraud material may draw it
};

std::vector<MeshUse> uses_of(const SceneDescription& scene) {
  std::vector<MeshUse> uses(scene.meshes.size());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const auto& faces = scene.meshes[i].faces;
    uses[i].smooth =
        std::any_of(faces.begin(), faces.end(), [&](const MeshFace& f) { return is_gouraud(scene, f.material); });
  }
  for (const InstanceSpec& instance : scene.instances) {
    MeshUse& use = uses[static_cast<std::size_t>(instance.mesh)];
    use.stretch = std::max(use.stretch, largest_stretch(instance));
    use.on_screen = use.on_screen || instance.on_screen;
    use.smooth = use.smooth || is_gouraud(scene, instance.material);
  }
  return uses;
}

void check_counts(const SceneDescription& scene) {
  constexpr std::size_t kMost = 65534;  // 16-bit indices; the last means none
  const auto refuse = [&](const char* what) {
    throw InputError(scene.place, std::string("has more than 65534 ") + what);
  };
  if (scene.materials.size() > kMost) refuse("materials");
  if (scene.meshes.size() > kMost) refuse("meshes");
}

std::uint16_t to_q8(double value) { return static_cast<std::uint16_t>(std::lround(value * 256)); }

LightRecord light_record(const LightSpec& light) {
  LightRecord record{};
  put(record.direction, unit_or(light.direction, {0, 0, -1}));
  record.intensity[0] = to_q8(light.intensity.x);
  record.intensity[1] = to_q8(light.intensity.y);
  record.intensity[2] = to_q8(light.intensity.z);
  return record;
}

std::uint16_t flags_of(const InstanceSpec& instance) {
  unsigned flags = InstanceRecord::kNone;
  if (!instance.cull) flags |= InstanceRecord::kTwoSided;
  if (instance.hidden) flags |= InstanceRecord::kHidden;
  if (instance.on_screen) flags |= InstanceRecord::kScreen;
  return static_cast<std::uint16_t>(flags);
}

// own -> mesh records -> world: matrix = fit.scale / mesh.scale * M, translation = fit(M pivot + T).
Transform transform_record(const Placement& place, const MeshFit& mesh, const WorldFit& world) {
  Transform transform{};
  const double ratio = world.scale / mesh.scale;
  for (std::size_t row = 0; row < 3; ++row) put(transform.matrix[row], ratio * place.rows[row]);
  put(transform.translation, world(place(mesh.pivot)));
  return transform;
}

}  // namespace

bool CompiledScene::moves() const {
  bool any = !scene_.camera.motion.keys.empty();
  for (const InstanceSpec& instance : scene_.instances) any = any || !instance.motion.keys.empty();
  return any;
}

void CompiledScene::place_instances(std::int64_t frame) {
  instances_.clear();
  for (const InstanceSpec& instance : scene_.instances) {
    InstanceRecord record;
    record.mesh = static_cast<std::uint16_t>(instance.mesh);
    record.flags = flags_of(instance);
    if (instance.material != kNone) record.material = static_cast<std::uint16_t>(instance.material);
    if (!instance.on_screen) {
      record.transform =
          transform_record(instance.placement(frame), mesh_fits_[static_cast<std::size_t>(instance.mesh)], fit_);
    }
    instances_.push_back(record);
  }
}

void CompiledScene::show(std::int64_t frame) {
  if (unshadowed_ && baked_ != frame && shadows_move(*unshadowed_)) make_records(frame);
  place_instances(frame);
  look(view_in_frame(scene_.camera, bounds_, scene_.height, frame, scene_.place));
}

void CompiledScene::look(const View& view) {
  view_ = view;
  camera_ = camera_record(view, fit_, scene_.height);
  lights_.clear();
  const std::vector<LightSpec> standard = {{default_light(axes_of(view))}};
  for (const LightSpec& light : scene_.lights.value_or(standard)) lights_.push_back(light_record(light));
}

void CompiledScene::merge_coplanar(std::uint32_t most_corners) {
  for (std::size_t mesh = 0; mesh < meshes_.size(); ++mesh) merge_coplanar(mesh, most_corners);
}

void CompiledScene::merge_coplanar(std::size_t mesh, std::uint32_t most_corners) {
  MeshTables merged = host::merge_coplanar(meshes_[mesh], scene_.meshes[mesh].place, most_corners);
  build_fans(merged);
  replace(mesh, std::move(merged));
}

std::vector<std::string> CompiledScene::triangulate() {
  std::vector<std::string> left;
  for (std::size_t mesh = 0; mesh < meshes_.size(); ++mesh) {
    if (std::optional<MeshTables> triangles = host::triangulate(meshes_[mesh], scene_.meshes[mesh].place)) {
      replace(mesh, std::move(*triangles));
    } else {
      left.push_back(meshes_[mesh].name);
    }
  }
  check_totals(scene_, meshes_);
  return left;
}

void CompiledScene::replace(std::size_t mesh, MeshTables tables) {
  meshes_[mesh] = std::move(tables);
  mesh_records_[mesh] = meshes_[mesh].record();
}

SceneRecord CompiledScene::record() const {
  const auto slice = [](const auto& items) { return Slice(items.data(), static_cast<std::uint32_t>(items.size())); };
  return {slice(mesh_records_),
          slice(instances_),
          slice(materials_),
          slice(lights_),
          {to_q8(scene_.ambient.x), to_q8(scene_.ambient.y), to_q8(scene_.ambient.z)},
          scene_.background,
          slice(scene_.reaches)};
}

CompiledScene compile(SceneDescription description, double reach) {
  description.materials.push_back({});  // the last one serves faces that have none
  CompiledScene out(std::move(description));
  const SceneDescription& scene = out.scene_;
  std::vector<Box> boxes;
  for (const MeshSource& mesh : scene.meshes) boxes.push_back(used_box(mesh));
  out.bounds_ = bounding_sphere(scene);
  Box world = reach_of_instances(scene, boxes);
  world.add(reach_of_eyes(out, scene, reach));
  out.fit_ = fit_world(world);
  if (scene.shadows) out.unshadowed_ = scene;
  out.make_records(0);
  out.show(0);
  return out;
}

// Bakes shadows, where there are any, and builds all that does not move.
void CompiledScene::make_records(std::int64_t frame) {
  if (unshadowed_) scene_ = bake_shadows(*unshadowed_, frame);
  baked_ = frame;
  const SceneDescription& scene = scene_;
  check_counts(scene);
  mesh_fits_.clear();
  meshes_.clear();
  mesh_records_.clear();
  materials_.clear();
  for (const MeshSource& mesh : scene.meshes) check_detail(mesh, scene.materials);
  const std::vector<MeshUse> uses = uses_of(scene);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    mesh_fits_.push_back(fit_mesh(used_box(scene.meshes[i]), uses[i].stretch, fit_));
    meshes_.push_back(compile_mesh(scene.meshes[i], scene.materials, mesh_fits_[i], uses[i].smooth, uses[i].on_screen));
  }
  check_totals(scene, meshes_);
  for (const MeshTables& mesh : meshes_) mesh_records_.push_back(mesh.record());
  for (const MaterialSpec& material : scene.materials) {
    materials_.push_back({material.color, material.shading, material.transmission, material.reach});
  }
}

}  // namespace spanline::host
