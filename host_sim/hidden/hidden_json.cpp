#include "hidden/hidden_json.hpp"

#include <map>
#include <nlohmann/json.hpp>

namespace spanline::host {
namespace {

using nlohmann::ordered_json;

ordered_json numbers(Vec3 v) { return ordered_json::array({v.x, v.y, v.z}); }
ordered_json numbers(Rgb8 c) { return ordered_json::array({c.r, c.g, c.b}); }

// From the screen back into the scene's own units, by the very camera that the engine used.
class Unprojection {
 public:
  explicit Unprojection(const CompiledScene& scene)
      : camera_(scene.camera()),
        fit_(scene.fit()),
        width_(scene.description().width),
        height_(scene.description().height) {}

  Vec3 operator()(const ScreenVertex& v) const {
    const double near = camera_.near_plane.raw / 65536.0, far = camera_.far_plane.raw / 65536.0;
    const double distance = std::clamp(v.depth > 0 ? near * 65536 / v.depth : far, near, far);
    const double per_px = distance / (camera_.focal.raw / 4096.0);
    const double right = (v.at.x / double{kSubpixels} - width_ / 2.0) * per_px;
    const double up = (height_ / 2.0 - v.at.y / double{kSubpixels}) * per_px;
    const Vec3 engine = eye() + right * axis(0) + up * axis(1) - distance * axis(2);
    return (1 / fit_.scale) * engine + fit_.centre;
  }

 private:
  Vec3 axis(int i) const {
    constexpr double kOne = 1 << 30;
    return {camera_.axes[i][0].raw / kOne, camera_.axes[i][1].raw / kOne, camera_.axes[i][2].raw / kOne};
  }
  Vec3 eye() const {
    return {camera_.eye[0].raw / 65536.0, camera_.eye[1].raw / 65536.0, camera_.eye[2].raw / 65536.0};
  }

  const CameraRecord& camera_;
  const WorldFit& fit_;
  double width_, height_;
};

// One look, one material.
class Materials {
 public:
  std::string name_of(Rgb8 c, Rgb8 through) {
    const auto [entry, fresh] = names_.emplace(std::array{c.r, c.g, c.b, through.r, through.g, through.b},
                                               "seen" + std::to_string(names_.size()));
    if (!fresh) return entry->second;
    list.push_back({{"name", entry->second}, {"color", numbers(c)}, {"shading", "unlit"}});
    if (through != Rgb8{}) {
      list.back()["transmission"] = numbers((1 / 255.0) * Vec3{1.0 * through.r, 1.0 * through.g, 1.0 * through.b});
    }
    return entry->second;
  }

  ordered_json list = ordered_json::array();

 private:
  std::map<std::array<std::uint8_t, 6>, std::string> names_;
};

ordered_json on_screen(const VisiblePolygon& polygon, const FacetList& facets) {
  ordered_json rings = ordered_json::array(), films = ordered_json::array();
  for (const auto& ring : polygon.rings) {
    ordered_json& points = rings.emplace_back(ordered_json::array());
    for (const ScreenVertex& v : ring) {
      points.push_back({v.at.x / double{kSubpixels}, v.at.y / double{kSubpixels}, v.depth});
    }
  }
  for (const std::uint16_t film : polygon.films) films.push_back(facets[film].face);
  return {{"source", facets[polygon.facet].face}, {"films", std::move(films)}, {"rings", std::move(rings)}};
}

}  // namespace

std::string hidden_json(const HiddenView& view, const FacetList& facets, const CompiledScene& scene) {
  const SceneDescription& description = scene.description();
  const Unprojection unproject(scene);
  Materials materials;
  ordered_json meshes = ordered_json::array(), instances = ordered_json::array(), polygons = ordered_json::array();
  for (std::size_t i = 0; i < view.polygons.size();) {
    const VisiblePolygon& first = view.polygons[i];
    const std::string name = "seen" + std::to_string(meshes.size());
    ordered_json vertices = ordered_json::array(), faces = ordered_json::array();
    for (; i < view.polygons.size() && looks_like(view.polygons[i], first); ++i) {
      ordered_json& face = faces.emplace_back(ordered_json::array());
      for (const auto& ring : view.polygons[i].rings) {
        ordered_json& corners = face.emplace_back(ordered_json::array());
        for (const ScreenVertex& v : ring) {
          corners.push_back(vertices.size());
          vertices.push_back(numbers(unproject(v)));
        }
      }
      polygons.push_back(on_screen(view.polygons[i], facets));
    }
    meshes.push_back({{"name", name},
                      {"material", materials.name_of(first.color, first.transmission)},
                      {"vertices", std::move(vertices)},
                      {"faces", std::move(faces)}});
    instances.push_back({{"mesh", name}, {"cull", false}});
  }
  if (meshes.empty()) {
    // Nothing is visible, and a scene has a mesh.
    meshes.push_back({{"name", "nothing"}, {"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {"faces", {{0, 1, 2}}}});
    instances.push_back({{"mesh", "nothing"}, {"hidden", true}});
  }
  const View& seen = scene.view();
  const ordered_json document = {
      {"size", {description.width, description.height}},
      {"camera",
       {{"eye", numbers(seen.eye)},
        {"target", numbers(seen.target)},
        {"up", numbers(seen.up)},
        {"fov", seen.fov},
        {"near", seen.near},
        {"far", seen.far}}},
      {"background",
       {{"top", numbers(description.background.top)}, {"bottom", numbers(description.background.bottom)}}},
      {"materials", std::move(materials.list)},
      {"meshes", std::move(meshes)},
      {"instances", std::move(instances)},
      {"hidden", {{"clips", view.clips}, {"windows", view.windows}, {"polygons", std::move(polygons)}}}};
  return document.dump() + "\n";
}

}  // namespace spanline::host
