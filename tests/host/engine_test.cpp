// The core as the host runs it: pools, bands and comparators change nothing that one sees.
#include "sim/engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "assetc/compile.hpp"
#include "assetc/scene_json.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

const std::string kPlate = R"({"size":[64,48],"camera":{"eye":[0,0,10],"target":[0,0,0]},)"
                           R"("background":[0,0,0],"materials":[{"name":"a","color":[255,255,255],"shading":"unlit"}],)"
                           R"("meshes":[{"name":"m","material":"a","vertices":[[-2,-2,0],[2,-2,0],[2,2,0],[-2,2,0],)"
                           R"([-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]],"faces":[[[0,1,2,3],[4,7,6,5]]]}],)";

Rendering rendered(CompiledScene& scene, EngineOptions options) {
  options.width = scene.description().width;
  options.height = scene.description().height;
  options.observe = true;
  Rendering out;
  const SceneRecord record = scene.record();
  const Status status = Engine::make(options)->render(validated(record, "s"), scene.camera(), out);
  EXPECT_TRUE(status.ok()) << status_text(status);
  return out;
}

std::size_t count_of(const Rendering& rendering, std::uint32_t id) {
  return static_cast<std::size_t>(std::count(rendering.ids.begin(), rendering.ids.end(), id));
}

TEST(EngineOnHost, LeavesHolesOpen) {
  CompiledScene scene = compile(parse_scene("s", kPlate + R"("instances":[{"mesh":"m"}]})"));
  const Rendering out = rendered(scene, {});
  // A plate of 4 units at distance 10: 4 * focal / 10 px wide, with a hole of half that.
  const double side = 4 * 24 / std::tan(radians(22.5)) / 10;
  EXPECT_NEAR(static_cast<double>(count_of(out, 1)), side * side * 3 / 4, side * 4);
  EXPECT_EQ(out.ids[24 * 64 + 32], 0u);
  EXPECT_EQ(out.depth[24 * 64 + 32], 0u);
}

TEST(EngineOnHost, NumbersFacesThroughInstances) {
  CompiledScene scene = compile(parse_scene(
      "s",
      kPlate +
          R"("instances":[{"mesh":"m","hidden":true},{"mesh":"m"},{"mesh":"m","translate":[0,0,1],"scale":0.5}]})"));
  const Rendering out = rendered(scene, {});
  EXPECT_EQ(count_of(out, 1), 0u);
  EXPECT_GT(count_of(out, 2), 0u);
  EXPECT_GT(count_of(out, 3), 0u);
}

TEST(EngineOnHost, CullsBacksUnlessTold) {
  const auto pixels = [](const char* instance) {
    CompiledScene scene = compile(parse_scene("s", kPlate + instance));
    return count_of(rendered(scene, {}), 1);
  };
  EXPECT_EQ(pixels(R"("instances":[{"mesh":"m","rotate":[0,180,0]}]})"), 0u);
  EXPECT_GT(pixels(R"("instances":[{"mesh":"m","rotate":[0,180,0],"cull":false}]})"), 0u);
  EXPECT_GT(pixels(R"("instances":[{"mesh":"m","rotate":[0,180,0],"scale":[1,1,-1]}]})"), 0u);
}

TEST(EngineOnHost, PicturesDoNotDependOnPoolsBandsOrComparator) {
  CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::automatic));
  const Rendering reference = rendered(scene, {});
  EngineOptions options;
  for (const std::uint16_t bands : std::initializer_list<std::uint16_t>{2, 7, 240}) {
    options = {};
    options.bands = bands;
    EXPECT_EQ(rendered(scene, options).picture.rgb, reference.picture.rgb) << bands;
    EXPECT_GE(rendered(scene, options).statistics.bands, bands);
  }
  options = {};
  options.comparator = Comparator::midpoint;
  EXPECT_EQ(rendered(scene, options).picture.rgb, reference.picture.rgb);
  options.pools.vertices = options.pools.samples = options.pools.implied = 0;
  options.pools.edges = 3;
  const Rendering poor = rendered(scene, options);
  EXPECT_EQ(poor.picture.rgb, reference.picture.rgb);
  EXPECT_EQ(poor.ids, reference.ids);
  EXPECT_EQ(poor.depth, reference.depth);
}

TEST(EngineOnHost, ReportsALineThatDoesNotFit) {
  CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::automatic));
  EngineOptions options;
  options.pools.segments = 1;
  const Rendering out = rendered(scene, options);
  EXPECT_EQ(out.status.code, Code::pool_exhausted);
  EXPECT_STREQ(out.status.where, "segments");
}

TEST(EngineOnHost, RendersFarAndTinyScenesAlike) {
  // The same cube a million units away, and a millionth of the size: the compiler's scale takes care of both.
  const std::string text = R"({"size":[64,48],"meshes":[{"name":"m","obj":"good/cube.obj"}],"instances":[{"mesh":"m")";
  const auto ids = [&](const std::string& placement) {
    CompiledScene scene = compile(parse_scene("s", text + placement + "}]}"));
    return rendered(scene, {}).ids;
  };
  const std::vector<std::uint32_t> near = ids("");
  EXPECT_EQ(ids(R"(,"scale":1e-6)"), near);
  EXPECT_EQ(ids(R"(,"translate":[1e6,-2e6,3e6])"), near);
}

}  // namespace
}  // namespace spanline::host
