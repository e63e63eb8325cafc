#include "assetc/scene_json.hpp"

#include <map>
#include <optional>

#include "assetc/curve_json.hpp"
#include "assetc/detail.hpp"
#include "assetc/json_node.hpp"
#include "assetc/motion_json.hpp"
#include "assetc/patch_mesh.hpp"
#include "assetc/text_file.hpp"
#include "core/geom/screen.hpp"

namespace spanline::host {
namespace {

constexpr double kMaxIntensity =
    16;  // Q8.8 records hold up to 255; four lights and the ambient add up in 16 bits of Q8.8

using Names = std::map<std::string, std::int32_t>;

// What `node` names, one of `names`.
std::int32_t look_up(const JsonNode& node, const Names& names, const char* kind) {
  const std::string name = node.text();
  const auto found = names.find(name);
  if (found == names.end()) node.fail(std::string("there is no ") + kind + " '" + printable(name) + "'");
  return found->second;
}

void add_name(const JsonNode& node, Names& names, std::size_t index) {
  const std::string name = node.text();
  if (!names.emplace(name, static_cast<std::int32_t>(index)).second) node.fail("the name is taken");
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

Color read_hex_color(const JsonNode& node) {
  const std::string text = node.text();
  std::uint8_t channels[3] = {};
  bool good = text.size() == 7 && text[0] == '#';
  for (std::size_t i = 0; good && i < 3; ++i) {
    const int high = hex_digit(text[1 + 2 * i]), low = hex_digit(text[2 + 2 * i]);
    good = high >= 0 && low >= 0;
    channels[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  if (!good) node.fail("must be [r, g, b] or \"#rrggbb\"");
  return {channels[0], channels[1], channels[2]};
}

Color read_color(const JsonNode& node) {
  if (node.is_string()) return read_hex_color(node);
  if (!node.is_array() || node.size() != 3) node.fail("must be [r, g, b] or \"#rrggbb\"");
  std::vector<std::uint8_t> channels;
  for (const JsonNode& element : node.elements()) channels.push_back(static_cast<std::uint8_t>(element.whole(0, 255)));
  return {channels[0], channels[1], channels[2]};
}

Vec3 read_intensity(const JsonNode& node) {
  if (!node.is_array()) {
    const double all = node.number(0, kMaxIntensity);
    return {all, all, all};
  }
  if (node.size() != 3) node.fail("must be a number or three");
  const std::vector<JsonNode> each = node.elements();
  return {each[0].number(0, kMaxIntensity), each[1].number(0, kMaxIntensity), each[2].number(0, kMaxIntensity)};
}

BackgroundRecord read_background(const JsonNode& node) {
  if (!node.is_object()) return {read_color(node), read_color(node)};
  node.allow_keys({"top", "bottom"});
  return {read_color(node.require("top")), read_color(node.require("bottom"))};
}

void read_size(const JsonNode& node, SceneDescription& scene) {
  const std::vector<JsonNode> sides = node.elements();
  if (sides.size() != 2) node.fail("must be [width, height]");
  scene.width = static_cast<std::uint16_t>(sides[0].whole(1, kMaxExtent));
  scene.height = static_cast<std::uint16_t>(sides[1].whole(1, kMaxExtent));
}

std::vector<LightSpec> read_lights(const JsonNode& node) {
  std::vector<LightSpec> lights;
  for (const JsonNode& each : node.elements()) {
    each.allow_keys({"direction", "intensity"});
    if (lights.size() == kMaxLights) node.fail("has more than " + std::to_string(kMaxLights) + " lights");
    LightSpec light;
    light.direction = each.require("direction").point();
    if (largest(light.direction) == 0) each.require("direction").fail("is zero: it has no direction");
    if (const auto intensity = each.find("intensity")) light.intensity = read_intensity(*intensity);
    lights.push_back(light);
  }
  return lights;
}

template <typename T>
T read_choice(const JsonNode& node, const std::map<std::string, T>& choices) {
  const auto found = choices.find(node.text());
  if (found != choices.end()) return found->second;
  std::string all;
  for (const auto& [name, value] : choices) all += (all.empty() ? "\"" : ", \"") + name + "\"";
  node.fail("must be one of " + all);
}

Vec3 read_parts(const JsonNode& node) {
  if (!node.is_array()) {
    const double all = node.number(0, 1);
    return {all, all, all};
  }
  if (node.size() != 3) node.fail("must be a number or three");
  const std::vector<JsonNode> each = node.elements();
  return {each[0].number(0, 1), each[1].number(0, 1), each[2].number(0, 1)};
}

Color read_transmission(const JsonNode& material) {
  const std::optional<JsonNode> opacity = material.find("opacity"), given = material.find("transmission");
  if (opacity && given) material.fail("'opacity' and 'transmission' exclude each other");
  Vec3 part;
  if (opacity) part = (1 - opacity->number(0, 1)) * Vec3{1, 1, 1};
  if (given) part = read_parts(*given);
  return {channel(part.x), channel(part.y), channel(part.z)};
}

void read_materials(const JsonNode& node, SceneDescription& scene, Names& names) {
  for (const JsonNode& each : node.elements()) {
    each.allow_keys({"name", "color", "shading", "opacity", "transmission"});
    add_name(each.require("name"), names, scene.materials.size());
    MaterialSpec material;
    material.name = each.require("name").text();
    material.color = read_color(each.require("color"));
    if (const auto shading = each.find("shading")) {
      material.shading = read_choice<Shading>(
          *shading, {{"flat", Shading::kFlat}, {"gouraud", Shading::kGouraud}, {"unlit", Shading::kUnlit}});
    }
    material.transmission = read_transmission(each);
    scene.materials.push_back(material);
  }
}

// Appends the corners of one ring; its length.
std::uint32_t read_ring(const JsonNode& node, MeshSource& mesh) {
  const std::vector<JsonNode> indices = node.elements(3);
  if (indices.size() > 65535) node.fail("has more than 65535 corners");
  const std::size_t first = mesh.corners.size();
  for (const JsonNode& index : indices) {
    const auto position = static_cast<std::int32_t>(index.whole(0, std::ssize(mesh.positions) - 1));
    if (mesh.corners.size() > first && mesh.corners.back().position == position)
      index.fail("repeats the vertex before it");
    mesh.corners.push_back({position});
  }
  if (mesh.corners.back().position == mesh.corners[first].position) node.fail("ends in the vertex that it begins with");
  return static_cast<std::uint32_t>(indices.size());
}

void read_face(const JsonNode& node, MeshSource& mesh, std::int32_t material) {
  MeshFace face{static_cast<std::uint32_t>(mesh.corners.size()), 0, static_cast<std::uint32_t>(mesh.rings.size()), 1,
                material};
  const std::vector<JsonNode> parts = node.elements(1);
  if (!parts[0].is_array()) {
    face.corner_count = read_ring(node, mesh);
  } else {
    face.ring_count = static_cast<std::uint32_t>(parts.size());
    for (const JsonNode& ring : parts) {
      const std::uint32_t length = read_ring(ring, mesh);
      face.corner_count += length;
      if (parts.size() > 1) mesh.rings.push_back(static_cast<std::uint16_t>(length));
    }
    if (face.corner_count > 65535) node.fail("has more than 65535 corners");
  }
  mesh.faces.push_back(face);
}

void read_vertices(const JsonNode& node, MeshSource& mesh) {
  for (const JsonNode& vertex : node.require("vertices").elements(3)) mesh.positions.push_back(vertex.point());
}

void read_faces(const JsonNode& node, MeshSource& mesh, std::int32_t material) {
  const std::vector<JsonNode> faces = node.require("faces").elements(1);
  if (faces.size() > kMaxSceneFaces) node.require("faces").fail("more than 65535 faces in one mesh");
  for (const JsonNode& face : faces) read_face(face, mesh, material);
}

void read_detail(const JsonNode& node, MeshSource& mesh, std::int32_t mesh_material, const Names& materials) {
  const std::int64_t faces = std::ssize(mesh.faces);
  for (const JsonNode& each : node.elements()) {
    each.allow_keys({"on", "material", "faces"});
    const auto parent = static_cast<std::uint16_t>(each.require("on").whole(0, faces - 1));
    std::int32_t material = mesh_material;
    if (const auto given = each.find("material")) material = look_up(*given, materials, "material");
    for (const JsonNode& face : each.require("faces").elements(1)) {
      read_face(face, mesh, material);
      if (mesh.faces.size() > kMaxSceneFaces) face.fail("more than 65535 faces in one mesh");
      mesh.parents.push_back(parent);
      if (!lies_on(mesh, mesh.faces[parent], mesh.faces.back())) {
        face.fail("does not lie in the plane of face " + std::to_string(parent));
      }
    }
  }
}

void read_inline_mesh(const JsonNode& node, SceneDescription& scene, const Names& materials) {
  MeshSource mesh;
  mesh.name = node.require("name").text();
  mesh.place = node.place();
  std::int32_t material = kNone;
  if (const auto given = node.find("material")) material = look_up(*given, materials, "material");
  const MaterialOf material_of = [&](const JsonNode& name) { return look_up(name, materials, "material"); };
  const auto outlines = node.find("outlines"), curves = node.find("curves"), isocurves = node.find("isocurves");
  if (const auto patches = node.find("patches")) {
    read_vertices(node, mesh);
    read_inline_patches(*patches, mesh, material);
  } else if (node.find("vertices") || node.find("faces") || (!outlines && !curves && !isocurves)) {
    read_vertices(node, mesh);
    read_faces(node, mesh, material);
  }
  if (outlines) read_outlines(*outlines, mesh, material, material_of);
  if (const auto detail = node.find("detail")) read_detail(*detail, mesh, material, materials);
  turn_detail(mesh);
  if (curves) read_curves(*curves, mesh, material, material_of);
  if (isocurves) read_isocurves(*isocurves, mesh, material, material_of);
  scene.meshes.push_back(std::move(mesh));
}

// A mesh from the file that `key` names: add(path, name, place, shading).
template <typename Add>
void read_mesh_file(const JsonNode& node, const char* key, const Add& add) {
  const JsonNode file = node.require(key);
  const std::string path = path_beside(node.file(), file.text());
  const std::string name = node.require("name").text();
  auto shading = MeshShading::automatic;
  if (const auto given = node.find("shading")) {
    shading = read_choice<MeshShading>(*given, {{"auto", MeshShading::automatic},
                                                {"flat", MeshShading::flat},
                                                {"gouraud", MeshShading::gouraud},
                                                {"unlit", MeshShading::unlit}});
  }
  try {
    add(path, name, file.place(), shading);
  } catch (const InputError& error) {
    file.fail(error.what());
  }
}

void read_meshes(const JsonNode& node, SceneDescription& scene, const Names& materials, Names& names) {
  for (const JsonNode& each : node.elements(1)) {
    if (!each.is_object()) each.fail("must be an object");
    add_name(each.require("name"), names, scene.meshes.size());
    const auto add_obj_file = [&](const auto& path, const auto&... rest) { add_obj(scene, read_obj(path), rest...); };
    const auto add_bpt_file = [&](const auto& path, const auto&... rest) {
      add_patches(scene, read_bpt(path), rest...);
    };
    if (each.find("obj")) {
      each.allow_keys({"name", "obj", "shading", "detail"});
      read_mesh_file(each, "obj", add_obj_file);
      if (const auto detail = each.find("detail")) {
        std::vector<std::string> names_of_detail;
        for (const JsonNode& name : detail->elements()) names_of_detail.push_back(name.text());
        set_detail(scene.meshes.back(), scene.materials, names_of_detail);
      }
    } else if (each.find("bpt")) {
      each.allow_keys({"name", "bpt", "shading"});
      read_mesh_file(each, "bpt", add_bpt_file);
    } else if (each.find("patches")) {
      each.allow_keys({"name", "vertices", "patches", "curves", "isocurves", "material"});
      read_inline_mesh(each, scene, materials);
    } else {
      each.allow_keys({"name", "vertices", "faces", "outlines", "curves", "isocurves", "material", "detail"});
      read_inline_mesh(each, scene, materials);
    }
  }
}

// Screen instances stand as their mesh says.
void read_screen(const JsonNode& node, InstanceSpec& instance) {
  const auto screen = node.find("screen");
  if (!screen || !screen->boolean()) return;
  instance.on_screen = true;
  for (const char* key : {"matrix", "translate", "rotate", "scale", "motion"}) {
    if (const auto placed = node.find(key)) placed->fail("an instance on the screen has no placement");
  }
}

// Meshes that are drawn on the screen have their points in pixels; records have them in sixteenths.
void scale_screen_meshes(const JsonNode& node, SceneDescription& scene) {
  const std::vector<JsonNode> nodes = node.elements();
  std::vector<bool> scaled(scene.meshes.size());
  const auto is_lit = [&](std::int32_t material) {
    return material == kNone || scene.materials[static_cast<std::size_t>(material)].shading != Shading::kUnlit;
  };
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const InstanceSpec& instance = scene.instances[i];
    MeshSource& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    for (const InstanceSpec& other : scene.instances) {
      if (other.mesh == instance.mesh && other.on_screen != instance.on_screen) {
        nodes[i].fail("the mesh is drawn on the screen and in the world");
      }
    }
    if (!instance.on_screen) continue;
    for (const MeshFace& face : mesh.faces) {
      if (is_lit(instance.material == kNone ? face.material : instance.material)) {
        nodes[i].fail("a face on the screen needs a material with \"shading\": \"unlit\"");
      }
    }
    if (scaled[static_cast<std::size_t>(instance.mesh)]) continue;
    scaled[static_cast<std::size_t>(instance.mesh)] = true;
    for (Vec3& p : mesh.positions) p = {kSubpixels * p.x, kSubpixels * p.y, p.z};
  }
}

void read_instances(const JsonNode& node, SceneDescription& scene, const Names& materials, const Names& meshes) {
  for (const JsonNode& each : node.elements(1)) {
    each.allow_keys({"mesh", "material", "matrix", "translate", "rotate", "scale", "cull", "hidden", "shadows",
                     "screen", "motion"});
    InstanceSpec instance;
    instance.mesh = look_up(each.require("mesh"), meshes, "mesh");
    if (const auto material = each.find("material")) instance.material = look_up(*material, materials, "material");
    instance.cull = !scene.meshes[static_cast<std::size_t>(instance.mesh)].of_patches();
    if (const auto cull = each.find("cull")) instance.cull = cull->boolean();
    if (const auto hidden = each.find("hidden")) instance.hidden = hidden->boolean();
    if (const auto shadows = each.find("shadows")) instance.shadows = shadows->boolean();
    read_placement(each, instance);
    read_screen(each, instance);
    scene.instances.push_back(instance);
  }
  scale_screen_meshes(node, scene);
}

}  // namespace

SceneDescription parse_scene(const std::string& name, std::string_view text) {
  const nlohmann::json document = parse_json(name, text);
  const JsonNode root(document, name);
  root.allow_keys(
      {"size", "camera", "ambient", "lights", "background", "shadows", "materials", "meshes", "instances", "hidden"});
  SceneDescription scene;
  scene.place = name;
  Names materials, meshes;
  if (const auto size = root.find("size")) read_size(*size, scene);
  if (const auto camera = root.find("camera")) read_camera(*camera, scene.camera);
  if (const auto ambient = root.find("ambient")) scene.ambient = read_intensity(*ambient);
  if (const auto lights = root.find("lights")) scene.lights = read_lights(*lights);
  if (const auto background = root.find("background")) scene.background = read_background(*background);
  if (const auto shadows = root.find("shadows")) scene.shadows = shadows->boolean();
  if (const auto list = root.find("materials")) read_materials(*list, scene, materials);
  read_meshes(root.require("meshes"), scene, materials, meshes);
  read_instances(root.require("instances"), scene, materials, meshes);
  return scene;
}

SceneDescription read_scene(const std::string& path) { return parse_scene(path, read_file(path)); }

}  // namespace spanline::host
