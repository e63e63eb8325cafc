#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "core/frame/frame_impl.hpp"
#include "core/frame/line_frame.hpp"
#include "demos/all.hpp"

namespace spanline::demos {
namespace {

constexpr Screen kWide{320, 240, PixelFormat::rgb565}, kSquare{240, 240, PixelFormat::rgb565},
    kTall{240, 320, PixelFormat::rgb565}, kSmall{128, 64, PixelFormat::grey4};
// frames after which each of kAll repeats
constexpr std::uint32_t kLoops[] = {180, 360, 600, 360, 180, 240, 240, 240, 240, 360};

// Where anything but background was seen.
struct Extent {
  std::uint32_t left = UINT32_MAX, right = 0, top = UINT32_MAX, bottom = 0;

  static void note(void* context, const VisibleSpan& span) {
    if (span.face == kNoFace) return;
    auto& extent = *static_cast<Extent*>(context);
    extent.left = std::min<std::uint32_t>(extent.left, span.left);
    extent.right = std::max<std::uint32_t>(extent.right, span.right);
    extent.top = std::min<std::uint32_t>(extent.top, span.line);
    extent.bottom = std::max<std::uint32_t>(extent.bottom, span.line + 1u);
  }
  static void note_layers(void* context, const LayeredSpan& layers) { note(context, layers.nearest()); }
};

constexpr FrameOptions observed(FrameOptions options) {
  options.statistics = options.taps = true;
  return options;
}

template <const Layouts& kDemo, Screen kScreen>
void check_every_frame(std::uint32_t loop) {
  constexpr Demo kFramed = kDemo.framed_for(kScreen);
  constexpr Budget kBudget = budget_for(kFramed, kScreen);
  static FrameMemory<kBudget> memory;
  constexpr FrameOptions kOptions = observed(options_for(kBudget));
  Frame<kOptions> frame(memory.storage());
  Extent extent;
  frame.set_tap({&extent, Extent::note, Extent::note_layers});
  Stage stage;
  ASSERT_TRUE(stage.begin(kFramed, kScreen).ok());
  alignas(4) static std::uint8_t line[640];
  for (std::uint32_t k = 0; k < loop; k += 3) {
    stage.show(k);
    frame.redraw({0, kScreen.height});
    for (Band rest{0, kScreen.height}; !rest.empty();) {
      const Band band = frame.prepare(stage.view(), stage.camera(), rest);
      ASSERT_FALSE(band.empty());
      while (frame.next_line(line)) {
      }
      rest.top = band.bottom;
    }
    const Status& status = frame.status();
    ASSERT_TRUE(status.ok()) << kDemo.name << " " << kScreen.width << "x" << kScreen.height << ", frame " << k << ": "
                             << status.where << " needs " << status.needed << " of " << status.limit;
  }
  // Everything is inside the picture, and fills it one way or the other.
  EXPECT_GE(extent.left, 1u) << kDemo.name << " " << kScreen.width;
  EXPECT_GE(extent.top, 1u) << kDemo.name << " " << kScreen.width;
  EXPECT_LT(extent.right, kScreen.width) << kDemo.name;
  EXPECT_LT(extent.bottom, kScreen.height) << kDemo.name;
  const double filled =
      std::max(double(extent.right - extent.left) / kScreen.width, double(extent.bottom - extent.top) / kScreen.height);
  EXPECT_GT(filled, 0.8) << kDemo.name << " " << kScreen.width << "x" << kScreen.height;
}

template <const Layouts& kDemo>
void check_every_screen(std::uint32_t loop) {
  check_every_frame<kDemo, kWide>(loop);
  check_every_frame<kDemo, kSquare>(loop);
  check_every_frame<kDemo, kTall>(loop);
  check_every_frame<kDemo, kSmall>(loop);
}

TEST(Demos, EveryFrameFitsItsPoolsAndThePicture) {
  check_every_screen<teapot>(kLoops[0]);
  check_every_screen<cubes>(kLoops[1]);
  check_every_screen<gears>(kLoops[2]);
  check_every_screen<gauges>(kLoops[3]);
  check_every_screen<patches>(kLoops[4]);
  check_every_screen<dice>(kLoops[5]);
  check_every_screen<house>(kLoops[6]);
  check_every_screen<panes>(kLoops[7]);
  check_every_screen<dial>(kLoops[9]);
}

template <Screen kScreen>
void check_every_plot() {
  constexpr Demo kFramed = plot.framed_for(kScreen);
  constexpr Budget kBudget = budget_for(kFramed, kScreen);
  static MemoryFor<kBudget> memory;
  FrameFor<kBudget> frame(memory.storage());
  Stage stage;
  ASSERT_TRUE(stage.begin(kFramed, kScreen).ok());
  for (std::uint32_t k = 0; k < 240; k += 3) {
    stage.show(k);
    ASSERT_FALSE(frame.prepare(stage.view(), stage.camera(), {0, kScreen.height}).empty());
    const Status& status = frame.status();
    ASSERT_TRUE(status.ok()) << kScreen.width << "x" << kScreen.height << ", frame " << k << ": " << status.where
                             << " needs " << status.needed << " of " << status.limit;
  }
}

TEST(Demos, EveryPlotFitsItsPools) {
  check_every_plot<kWide>();
  check_every_plot<kSquare>();
  check_every_plot<kTall>();
  check_every_plot<kSmall>();
}

TEST(Demos, APlotWithoutRoomSaysWhatItLacksAndHasNoLines) {
  constexpr Demo kFramed = plot.framed_for(kSmall);
  constexpr Budget kBudget = budget_for(kFramed, kSmall);
  static MemoryFor<kBudget> memory;
  Stage stage;
  ASSERT_TRUE(stage.begin(kFramed, kSmall).ok());
  struct Lack {
    const char* pool;
    void (*limit)(LineStorage& storage);
  };
  const Lack lacks[] = {{"facets", [](LineStorage& s) { s.bounds.limit(20); }},
                        {"names", [](LineStorage& s) { s.names.limit(5); }},
                        {"polygons", [](LineStorage& s) { s.sort.polygons.limit(2); }},
                        {"pieces", [](LineStorage& s) { s.sort.pieces.limit(1); }},
                        {"borders", [](LineStorage& s) { s.sort.borders.limit(20); }},
                        {"segments", [](LineStorage& s) { s.sort.clipper.segments.limit(12); }},
                        {"lines", [](LineStorage& s) { s.edges.limit(100); }},
                        {"lines", [](LineStorage& s) { s.corners.limit(100); }}};
  for (const Lack& lack : lacks) {
    LineStorage storage = memory.storage();
    lack.limit(storage);
    LineFrame frame(storage);
    ASSERT_FALSE(frame.prepare(stage.view(), stage.camera(), {0, kSmall.height}).empty());
    EXPECT_EQ(frame.status().code, Code::pool_exhausted) << lack.pool;
    EXPECT_STREQ(frame.status().where, lack.pool);
    EXPECT_STREQ(frame.status().field, "polygon");
    EXPECT_LT(frame.status().index, stage.view().face_count()) << lack.pool;
    alignas(4) std::uint8_t line[kSmall.width / 2];
    while (frame.next_line(line)) {
      for (const std::uint8_t pixels : line) ASSERT_EQ(pixels, 0xff) << lack.pool << ": paper";
    }
  }
  LineFrame frame(memory.storage());
  CameraRecord nowhere = stage.camera();
  nowhere.near_plane = nowhere.far_plane;
  EXPECT_TRUE(frame.prepare(stage.view(), nowhere, {0, kSmall.height}).empty());
  EXPECT_EQ(frame.status().code, Code::bad_argument);
}

std::vector<std::uint8_t> state(const Stage& stage) {
  const auto& instances = stage.view().scene().instances;
  std::vector<std::uint8_t> bytes(instances.size() * sizeof(InstanceRecord) + sizeof(CameraRecord));
  std::memcpy(bytes.data(), instances.data(), instances.size() * sizeof(InstanceRecord));
  std::memcpy(bytes.data() + instances.size() * sizeof(InstanceRecord), &stage.camera(), sizeof(CameraRecord));
  return bytes;
}

TEST(Demos, FramesRepeatAndComeInAnyOrder) {
  for (std::size_t i = 0; i < std::size(kAll); ++i) {
    Stage stage;
    ASSERT_TRUE(stage.begin(kAll[i]->framed_for(kWide), kWide).ok());
    const auto first = state(stage);
    stage.show(41);
    const auto later = state(stage);
    EXPECT_NE(later, first) << kAll[i]->name;
    stage.show(kLoops[i]);
    EXPECT_EQ(state(stage), first) << kAll[i]->name;
    stage.show(kLoops[i] * 1000 + 41);
    EXPECT_EQ(state(stage), later) << kAll[i]->name;
  }
}

TEST(Demos, TheGearsStayInMesh) {
  Stage stage;
  ASSERT_TRUE(stage.begin(gears.framed_for(kWide), kWide).ok());
  const auto angle = [&](std::uint32_t gear) {
    const auto& m = stage.view().scene().instances[gear].transform.matrix;
    return std::atan2(m[1][0].raw, m[0][0].raw) / (2 * std::numbers::pi);
  };
  // Teeth that have passed: 20 a turn of the one, 12 the other way of the other.
  const auto slip = [&] { return 20 * angle(0) + 12 * angle(1); };
  const double rest = slip();
  for (std::uint32_t k = 0; k < 600; ++k) {
    stage.show(k);
    const double teeth = slip() - rest;
    EXPECT_NEAR(teeth, std::round(teeth), 0.01) << "frame " << k;
  }
}

TEST(Demos, ASceneOfTooManyInstancesIsRefused) {
  static constexpr InstanceRecord kMany[kMaxInstances + 1] = {};
  SceneRecord scene = *teapot.wide.shot.scene;
  scene.instances = kMany;
  Demo demo = teapot.framed_for(kWide);
  demo.shot.scene = &scene;
  Stage stage;
  const Status status = stage.begin(demo, kWide);
  EXPECT_EQ(status.code, Code::bad_record);
  EXPECT_STREQ(status.field, "instances");
}

}  // namespace
}  // namespace spanline::demos
