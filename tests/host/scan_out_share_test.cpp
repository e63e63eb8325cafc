// How much of a turning teapot's frames crosses the wire.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assetc/compile.hpp"
#include "assetc/scene_json.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

constexpr int kTurn = 120;  // frames
constexpr Screen kScreen{320, 240};

// The benchmark's teapot, turned by `frame` parts of a turn.
CompiledScene teapot(int frame) {
  SceneDescription scene = read_scene(std::string(SPANLINE_ASSETS) + "/scenes/S3.json");
  const double angle = 2 * std::numbers::pi * frame / kTurn, c = std::cos(angle), s = std::sin(angle);
  scene.instances[0].matrix = Placement{{c, 0, s, 0, 1, 0, -s, 0, c}, {0, 0, 0}};
  return compile(std::move(scene));
}

// Bytes of a turn under each policy, commands included.
std::vector<std::uint64_t> bytes_of_a_turn(const std::vector<ScanPolicy>& policies) {
  std::vector<std::unique_ptr<HostScanOutMemory>> memories;
  std::vector<ScanOut> outs;
  constexpr std::uint8_t kWindowBytes = 11;
  for (const ScanPolicy policy : policies) {
    memories.push_back(std::make_unique<HostScanOutMemory>(kScreen, policy, kWindowBytes));
    outs.emplace_back(memories.back()->storage());
  }
  std::vector<std::uint64_t> bytes(policies.size());
  EngineOptions options;
  options.on_line = [&](const FinishedLine& line) {
    for (std::size_t i = 0; i < outs.size(); ++i) {
      outs[i].line(line.line, line.wire);
      for (PixelRun run; outs[i].next(run);) bytes[i] += 2u * (run.right - run.left) + (run.opens ? kWindowBytes : 0u);
    }
  };
  const std::unique_ptr<Engine> engine = Engine::make(options);
  Rendering rendering;
  for (int frame = -1; frame < kTurn; ++frame) {
    if (frame == 0) bytes.assign(bytes.size(), 0);  // the frame before has shown what there is
    const CompiledScene scene = teapot(frame);
    const SceneRecord record = scene.record();
    for (ScanOut& out : outs) out.begin_frame(record.background);
    EXPECT_TRUE(engine->render(validated(record, "teapot"), scene.camera(), rendering).ok());
  }
  return bytes;
}

TEST(ScanOutShare, OfATurningTeapot) {
  const std::vector<std::uint64_t> bytes = bytes_of_a_turn({ScanPolicy::full, ScanPolicy::extents, ScanPolicy::tiles});
  EXPECT_EQ(bytes[0], std::uint64_t{kTurn} * (320 * 240 * 2 + 11));
  RecordProperty("extents_percent", std::to_string(100.0 * double(bytes[1]) / double(bytes[0])));
  RecordProperty("tiles_percent", std::to_string(100.0 * double(bytes[2]) / double(bytes[0])));
  EXPECT_LE(bytes[1] * 100, bytes[0] * 45);
  EXPECT_LE(bytes[2] * 100, bytes[0] * 35);
  EXPECT_LT(bytes[2], bytes[1]);
}

}  // namespace
}  // namespace spanline::host
