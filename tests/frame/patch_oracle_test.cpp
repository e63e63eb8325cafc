// What is seen of diced facets, among each other and against meshes, is what the exact oracle sees of them.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "core/frame/patch_source.hpp"
#include "frame/patch_views.hpp"
#include "oracle/compare.hpp"
#include "sim/status_text.hpp"

namespace spanline::test {
namespace {

struct Collector {
  std::vector<std::vector<oracle::Vertex>> contours;
  void begin_contour() { contours.emplace_back(); }
  void vertex(const FacetVertex& v) { contours.back().push_back({v.at.x, v.at.y, v.depth}); }
  void end_contour() {}
};

// Every facet of a frame as its own oracle face, in the engine's order of ties; `face_of` leads back.
struct Facets {
  std::vector<oracle::Facet> all;
  std::vector<std::uint32_t> face_of;

  void add(std::uint32_t face, Collector&& collector) {
    all.push_back({static_cast<std::uint32_t>(all.size()), std::move(collector.contours)});
    face_of.push_back(face);
  }
};

Facets facets_of(const SceneView& scene, const CameraRecord& camera, const Screen& screen) {
  std::vector<DicedFacet> facets(32768);
  std::vector<ScreenPoint> vertices(32768), sink(1);
  PatchSource patches({{facets.data(), 32767}, {vertices.data(), 32767}, {}, 8, {}}, screen);
  FacetReader reader(scene, camera, screen, {sink.data(), 0});
  const LightRig lights(scene.scene(), Transform::identity());
  const MaterialRecord unlit{{}, MaterialRecord::kUnlit};
  Facets out;
  for (std::uint16_t face = 0; face < scene.face_count(); ++face) {
    reader.select(face);
    if (!reader.is_patch()) {
      if (reader.extent().empty()) continue;
      Collector collector;
      reader.read([](std::uint16_t) { return Rgb8{}; }, collector);
      out.add(face, std::move(collector));
      continue;
    }
    patches.begin_band(0, screen.height);
    const bool two_sided = (reader.instance().flags & InstanceRecord::kTwoSided) != 0;
    EXPECT_TRUE(patches.dice(reader, {&lights, &unlit, screen.format, false, two_sided}));
    std::map<std::uint16_t, Collector> in_order;
    for (std::uint16_t i = 1; i <= patches.count(); ++i) {
      patches.read(
          patches[i], [](const Normal10&) { return Rgb8{}; }, in_order[patches[i].part]);
    }
    for (auto& [part, collector] : in_order) out.add(face, std::move(collector));
  }
  return out;
}

void expect_exact(const host::CompiledScene& scene, int view) {
  const Screen screen{scene.description().width, scene.description().height, PixelFormat::rgb565};
  const host::Rendering drawn = render(scene, {});
  const SceneRecord record = scene.record();
  const Facets facets = facets_of(host::validated(record, "s"), scene.camera(), screen);
  const oracle::Rendering truth = oracle::render(screen.width, screen.height, facets.all);
  int wrong = 0;
  for (int line = 0; line < screen.height; ++line) {
    for (int column = 0; column < screen.width; ++column) {
      const auto at = static_cast<std::size_t>(line) * screen.width + static_cast<std::size_t>(column);
      const auto& there = truth.candidates(column, line);
      const std::uint32_t id = drawn.ids[at];
      if (there.empty() || id == 0) {
        wrong += there.empty() != (id == 0);
        continue;
      }
      // Some facet of the face drawn must be as near as the nearest, but for the rounding of depths.
      bool near = false;
      for (const oracle::Candidate& c : there) {
        near = near || (facets.face_of[c.face] + 1 == id &&
                        oracle::closer_than(c.depth, there.front().depth, oracle::kOneUnit));
      }
      wrong += !near;
    }
  }
  EXPECT_EQ(wrong, 0) << "view " << view;
}

TEST(PatchOracle, TheTeapotIsExact) {
  oracle::Random random(1);
  host::CompiledScene scene = teapot_scene(host::MeshShading::flat);
  for (int view = 0; view < 6; ++view) {
    look_from_anywhere(scene, random, 0.6 + random.below(100) / 100.0);
    expect_exact(scene, view);
  }
}

TEST(PatchOracle, IntersectionsWithMeshesAreExact) {
  oracle::Random random(2);
  host::CompiledScene scene = scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt"},{"name":"c","obj":"cubes.obj"}],)"
                                       R"("instances":[{"mesh":"c","scale":2.2,"translate":[0,0,1]},{"mesh":"p"}]})");
  for (int view = 0; view < 4; ++view) {
    look_from_anywhere(scene, random, 0.6 + random.below(100) / 100.0);
    expect_exact(scene, view);
  }
}

}  // namespace
}  // namespace spanline::test
