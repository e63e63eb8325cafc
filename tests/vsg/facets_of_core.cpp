#include "vsg/facets_of_core.hpp"

namespace spanline::test {
namespace {

struct Collector {
  std::vector<std::vector<oracle::Vertex>> contours;
  void begin_contour() { contours.emplace_back(); }
  void vertex(const FacetVertex& vertex) { contours.back().push_back({vertex.at.x, vertex.at.y, vertex.depth}); }
  void end_contour() {}
};

}  // namespace

std::vector<oracle::Facet> facets_of(const SceneView& scene, const CameraRecord& camera, const Screen& screen) {
  std::vector<oracle::Facet> facets;
  ScreenPoint sink[1];
  FacetReader reader(scene, camera, screen, PoolRef<ScreenPoint>(sink, 0));
  for (std::uint16_t face = 0; face < scene.face_count(); ++face) {
    reader.select(face);
    if (reader.extent().empty()) continue;
    Collector collector;
    reader.read([](std::uint16_t) { return Rgb8{}; }, collector);
    const std::uint32_t parent = reader.parent() == kNoFace ? oracle::kNone : reader.parent();
    facets.push_back(
        {face, std::move(collector.contours), parent, scene.scene().materials[reader.face().material].see_through()});
  }
  return facets;
}

std::vector<MaterialRecord> materials_of(const SceneView& scene, const CameraRecord& camera, const Screen& screen) {
  std::vector<MaterialRecord> materials;
  ScreenPoint sink[1];
  FacetReader reader(scene, camera, screen, PoolRef<ScreenPoint>(sink, 0));
  for (std::uint16_t face = 0; face < scene.face_count(); ++face) {
    reader.select(face);
    materials.push_back(scene.scene().materials[reader.face().material]);
  }
  return materials;
}

}  // namespace spanline::test
