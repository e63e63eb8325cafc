// Patches as points: bands, pools and the order of what is drawn change nothing that one sees; what cannot be drawn is
// said.
#include <gtest/gtest.h>

#include <algorithm>

#include "frame/patch_views.hpp"
#include "sim/status_text.hpp"
#include "vsg/scale.hpp"

namespace spanline::test {
namespace {

using host::EngineOptions;
using host::MeshShading;
using host::Rendering;
using oracle::Random;

constexpr char kAmongMeshes[] = R"({"meshes":[{"name":"p","bpt":"teapot.bpt"},{"name":"c","obj":"cubes.obj"}],)"
                                R"("instances":[{"mesh":"c"},{"mesh":"p"},{"mesh":"c","translate":[2,0.5,1.5]},)"
                                R"({"mesh":"p","translate":[0,1,0],"scale":[1,-0.8,1],"cull":true}]})";

std::size_t covered(const Rendering& out) {
  return static_cast<std::size_t>(
      std::count_if(out.ids.begin(), out.ids.end(), [](std::uint32_t id) { return id != 0; }));
}

EngineOptions points() {
  EngineOptions options;
  options.surface = host::Surface::points;
  return options;
}

EngineOptions frugal(Random& random) {
  EngineOptions options = points();
  options.comparator = random.percent(50) ? Comparator::midpoint : Comparator::plane;
  options.bands = static_cast<std::uint16_t>(random.percent(20) ? 240 : random.between(1, 30));
  options.pools.point_lines = static_cast<std::uint16_t>(random.between(1, 100));
  options.pools.facets = static_cast<std::uint16_t>(random.between(100, 300));
  options.pools.edges = options.pools.vertices = options.pools.samples =
      static_cast<std::uint16_t>(random.between(0, 40));
  options.pools.implied = 0;
  return options;
}

void expect_same_in_views(host::CompiledScene scene, std::uint64_t seed, int views, double nearest) {
  Random random(seed);
  for (int view = 0; view < views && !testing::Test::HasFailure(); ++view) {
    look_from_anywhere(scene, random, nearest + random.below(100) / 100.0);
    const Rendering whole = render(scene, points()), parts = render(scene, frugal(random));
    ASSERT_TRUE(whole.status.ok());
    ASSERT_TRUE(parts.status.ok()) << parts.status.where << " needs " << parts.status.needed;
    EXPECT_EQ(whole.picture.rgb, parts.picture.rgb) << "view " << view;
    EXPECT_EQ(whole.ids, parts.ids) << "view " << view;
    EXPECT_EQ(whole.depth, parts.depth) << "view " << view;
  }
}

TEST(PointInvariance, TheTeapotFlat) { expect_same_in_views(teapot_scene(MeshShading::flat), 1, 12, 0.6); }
TEST(PointInvariance, TheTeapotGouraud) { expect_same_in_views(teapot_scene(MeshShading::gouraud), 2, 12, 0.6); }
TEST(PointInvariance, AmongMeshes) { expect_same_in_views(scene_of(kAmongMeshes), 3, 8, 0.5); }
TEST(PointInvariance, ThroughTheNearPlane) { expect_same_in_views(teapot_scene(MeshShading::gouraud), 4, 6, 0.01); }

// The modes agree on who is in front, but where surfaces are within a 500th in depth: near where they pierce each
// other.
TEST(PointInvariance, ModesAgreeAmongMeshes) {
  host::CompiledScene scene =
      scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt"},{"name":"c","obj":"cubes.obj"}],)"
               R"("instances":[{"mesh":"p"},{"mesh":"c"},{"mesh":"c","translate":[2,0.5,1.5]}]})");
  Random random(5);
  for (int view = 0; view < 6; ++view) {
    look_from_anywhere(scene, random, 1.0);
    const Rendering diced = render(scene, {}), stepped = render(scene, points());
    const int width = diced.picture.width, height = diced.picture.height;
    const auto index = [&](int x, int y) {
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    int wrong = 0, covered = 0;
    for (int y = 1; y + 1 < height; ++y) {
      for (int x = 1; x + 1 < width; ++x) {
        const std::size_t here = index(x, y);
        bool known = false;
        for (int v = -1; v <= 1; ++v) {
          for (int u = -1; u <= 1; ++u) {
            const std::size_t there = index(x + u, y + v);
            known = known || diced.ids[there] == stepped.ids[here] ||
                    500 * std::abs(diced.depth[there] - stepped.depth[here]) < stepped.depth[here];
          }
        }
        wrong += !known;
        covered += diced.ids[here] != 0;
      }
    }
    EXPECT_GT(covered, 2000);
    EXPECT_LE(wrong, covered / 500) << "view " << view << ", of " << covered;
  }
}

// Points stepped to over the pixels of the picture that show one: what lies behind is mostly not stepped.
TEST(PointInvariance, TheTeapotTakesThreePointsAPixelOfThePicture) {
  host::CompiledScene scene = teapot_scene(MeshShading::flat);
  const std::uint64_t views = scene_count(20, 1000);
  double sum = 0;
  for (std::uint64_t view = 0; view < views; ++view) {
    Random random(view + 1);
    look_from_anywhere(scene, random, 1.0);
    const Rendering out = render(scene, points());
    sum += out.statistics.points_emitted / static_cast<double>(covered(out));
  }
  EXPECT_LE(sum / static_cast<double>(views), 3.0);
  RecordProperty("mean", std::to_string(sum / static_cast<double>(views)));
}

TEST(PointInvariance, WithoutABandPatchesAreLeftOutAndItIsSaid) {
  const host::CompiledScene scene = scene_of(kAmongMeshes);
  EngineOptions options = points();
  options.pools.point_lines = 0;
  const Rendering out = render(scene, options);
  EXPECT_EQ(out.status.code, Code::pool_exhausted);
  EXPECT_STREQ(out.status.where, "point_lines");
  EXPECT_EQ(out.status.needed, 1u);
  EXPECT_TRUE(std::any_of(out.ids.begin(), out.ids.end(), [](std::uint32_t id) { return id != 0; }));
}

// One patch with these control points, which run over i % 4 and i / 4, seen from (0, 0, 5).
template <typename Point>
host::CompiledScene one_patch(const Point& point) {
  std::string vertices, indices;
  for (int i = 0; i < 16; ++i) {
    vertices += (i == 0 ? "" : ",") + point(i % 4, i / 4);
    indices += (i == 0 ? "" : ",") + std::to_string(i);
  }
  return scene_of(R"({"camera":{"eye":[0,0,5],"target":[0,0,0],"near":1,"far":20},"meshes":[{"name":"m","vertices":[)" +
                  vertices + R"(],"patches":[[)" + indices + R"(]]}],"instances":[{"mesh":"m"}]})");
}

std::string point(double x, double y, double z) {
  return "[" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "]";
}

TEST(PointInvariance, APatchCollapsedToAPointOrALine) {
  const auto to_point = one_patch([](int, int) { return point(0.1, 0.1, 0); });
  const auto to_line = one_patch([](int i, int) { return point(i - 1.5, 0.1, 0); });
  const Rendering a = render(to_point, points()), b = render(to_line, points());
  EXPECT_TRUE(a.status.ok() && b.status.ok());
  EXPECT_EQ(covered(a), 1u);
  // Three units at distance 5, 320 x 240 px at 45 degrees.
  EXPECT_NEAR(static_cast<double>(covered(b)), 3 / 5.0 * 120 / 0.41421, 2);
}

TEST(PointInvariance, APatchBehindTheEyeIsNotSeen) {
  EXPECT_EQ(covered(render(one_patch([](int i, int j) { return point(i - 1.5, j - 1.5, 7 + i); }), points())), 0u);
}

// From far before the eye to far behind it: what lies nearer than the near plane is cut off to the pixel.
TEST(PointInvariance, APatchThroughTheNearPlane) {
  const host::CompiledScene scene = one_patch([](int i, int j) { return point(i - 1.5, -0.5, 4 * j - 5); });
  const Rendering stepped = render(scene, points()), diced = render(scene, {});
  EXPECT_TRUE(stepped.status.ok());
  EXPECT_GT(covered(diced), 5000u);
  const std::size_t width = diced.picture.width;
  std::size_t wrong = 0;
  for (std::size_t at = width + 1; at + width + 1 < diced.ids.size(); ++at) {
    const auto any = [&](std::uint32_t id) {
      bool found = false;
      for (const std::size_t from : {at - width, at, at + width}) {
        found = found || diced.ids[from - 1] == id || diced.ids[from] == id || diced.ids[from + 1] == id;
      }
      return found;
    };
    wrong += !any(stepped.ids[at]);
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(PointInvariance, SeeThroughPolygonsAreRefused) {
  const host::CompiledScene scene =
      scene_of(R"({"materials":[{"name":"g","color":[1,1,1],"opacity":0.5}],"meshes":[{"name":"p","bpt":"teapot.bpt"},)"
               R"({"name":"c","obj":"cubes.obj"}],"instances":[{"mesh":"p"},{"mesh":"c","material":"g"}]})");
  EngineOptions options = points();
  Rendering out;
  const SceneRecord record = scene.record();
  EXPECT_EQ(host::Engine::make(options)->render(host::validated(record, "s"), scene.camera(), out).code,
            Code::bad_argument);
}

}  // namespace
}  // namespace spanline::test
