// The front door: bands, budgets, and what is said when something is wrong.
#include "core/frame/frame.hpp"

#include <gtest/gtest.h>

#include <string>

namespace spanline {
namespace {

// Two overlapping squares on a screen of 16 x 8, the second one nearer.
constexpr Position kCorners[] = {{16, 16, 0}, {16, 112, 0}, {176, 112, 0}, {176, 16, 0},
                                 {96, 48, 9}, {96, 128, 9}, {256, 128, 9}, {256, 48, 9}};
constexpr std::uint16_t kIndices[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr FaceGroup kGroups[] = {{0, 0, 1, 4, 0, 1, 0}, {4, 1, 1, 4, 0, 1, 1}};
constexpr MeshRecord kMesh{"squares", kCorners, {}, {}, kIndices, {}, kGroups, 2, {}, 1};
constexpr MeshRecord kMeshes[] = {kMesh};
constexpr InstanceRecord kInstances[] = {{0, InstanceRecord::kScreen}};
constexpr MaterialRecord kMaterials[] = {{{100, 100, 100}, MaterialRecord::kUnlit},
                                         {{200, 200, 200}, MaterialRecord::kUnlit}};
constexpr SceneRecord kScene{kMeshes, kInstances, kMaterials, {}, {256, 256, 256}, {{0, 0, 0}, {0, 0, 0}}};
constexpr const char* kPicture =
    "................\n"
    ".##########.....\n"
    ".##########.....\n"
    ".#####@@@@@@@@@@\n"
    ".#####@@@@@@@@@@\n"
    ".#####@@@@@@@@@@\n"
    ".#####@@@@@@@@@@\n"
    "......@@@@@@@@@@\n";

constexpr Budget kBudget{.width = 16,
                         .height = 8,
                         .format = PixelFormat::grey8,
                         .facets = 4,
                         .vertices = 8,
                         .polygons = 4,
                         .edges = 4,
                         .segments = 4,
                         .samples = 4,
                         .implied = 2,
                         .gouraud = false};

constexpr CameraRecord any_camera() {
  CameraRecord camera{};
  for (int i = 0; i < 3; ++i) camera.axes[i][i].raw = Fx30::kOne;
  camera.focal = Fx12::from_int(10);
  camera.near_plane = Fx16::from_int(1);
  camera.far_plane = Fx16::from_int(10);
  return camera;
}

class FrameTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(SceneView::validate(kScene, view_).ok()); }

  // Renders in bands of at most `lines` lines.
  std::string draw(Frame<>& frame, std::uint16_t lines = 8) {
    std::string text;
    alignas(4) std::uint8_t line[16];
    for (std::uint16_t top = 0; top < 8;) {
      const auto bottom = static_cast<std::uint16_t>(std::min(8, top + lines));
      const Band band = frame.prepare(view_, camera_, {top, bottom});
      if (band.empty()) return text;
      while (frame.next_line(line)) {
        for (const std::uint8_t p : line) text += p == 0 ? '.' : p == 100 ? '#' : '@';
        text += '\n';
      }
      top = band.bottom;
    }
    return text;
  }

  SceneView view_;
  CameraRecord camera_ = any_camera();
  FrameMemory<kBudget> memory_;
};

TEST_F(FrameTest, DrawsTheSamePictureInAnyBands) {
  for (std::uint16_t lines = 1; lines <= 8; ++lines) {
    Frame<> frame(memory_.storage());
    EXPECT_EQ(draw(frame, lines), kPicture) << lines;
    EXPECT_TRUE(frame.status().ok());
    EXPECT_EQ(draw(frame), kPicture) << "once more";
  }
}

TEST_F(FrameTest, HalvesBandsWhereFacetsDoNotFit) {
  FrameStorage storage = memory_.storage();
  storage.facets.limit(1);
  Frame<> frame(storage);
  // Lines 3 to 6 hold two facets, and a band that begins there has to file both.
  const std::string picture = draw(frame);
  EXPECT_EQ(picture.size(), std::string(kPicture).size());
  EXPECT_EQ(frame.status().code, Code::pool_exhausted);
  EXPECT_STREQ(frame.status().where, "facets");
  EXPECT_EQ(frame.status().needed, 2u);
  EXPECT_EQ(frame.status().limit, 1u);
  EXPECT_EQ(picture.substr(0, 3 * 17), std::string(kPicture).substr(0, 3 * 17)) << "lines that fit are whole";
}

TEST_F(FrameTest, LeavesOutTheHighestFacesWhereALineDoesNotFit) {
  for (const char* pool : {"polygons", "segments", "active"}) {
    FrameStorage storage = memory_.storage();
    if (std::string(pool) == "polygons") storage.vsg.polygons.limit(1);
    if (std::string(pool) == "segments") storage.vsg.segments.limit(1);
    if (std::string(pool) == "active") storage.vsg.active.limit(1);
    Frame<> frame(storage);
    const std::string picture = draw(frame, 1);
    EXPECT_EQ(frame.status().code, Code::pool_exhausted) << pool;
    EXPECT_STREQ(frame.status().where, pool);
    EXPECT_EQ(frame.status().line, 3u) << pool;
    EXPECT_EQ(frame.status().needed, 2u) << pool;
    EXPECT_EQ(picture.substr(3 * 17, 7), ".######") << pool << ": the lower face stays";
    Frame<> whole(memory_.storage());
    EXPECT_EQ(draw(whole), kPicture) << "the next frame is whole";
  }
}

TEST_F(FrameTest, RefusesWhatItCannotDo) {
  Frame<> frame(memory_.storage());
  EXPECT_TRUE(frame.prepare(view_, camera_, {0, 9}).empty());
  EXPECT_STREQ(frame.status().where, "band");
  EXPECT_TRUE(frame.prepare(view_, camera_, {0, 0}).empty());
  CameraRecord camera = camera_;
  camera.near_plane = {};
  EXPECT_TRUE(frame.prepare(view_, camera, {0, 8}).empty());
  EXPECT_STREQ(frame.status().field, "near_plane");
  alignas(4) std::uint8_t line[20];
  EXPECT_FALSE(frame.next_line(line)) << "no band is prepared";
  ASSERT_FALSE(frame.prepare(view_, camera_, {0, 8}).empty());
  EXPECT_TRUE(frame.status().ok()) << "a new frame forgets";
  EXPECT_FALSE(frame.next_line({line, 15}));
  EXPECT_STREQ(frame.status().field, "size");
  EXPECT_FALSE(frame.next_line({line + 1, 16}));
  EXPECT_TRUE(frame.next_line({line, 16})) << "the line was not lost";
}

TEST_F(FrameTest, DrawsNothingOfAnEmptyScene) {
  const SceneRecord empty{{}, {}, {}, {}, {0, 0, 0}, {{100, 100, 100}, {100, 100, 100}}};
  ASSERT_TRUE(SceneView::validate(empty, view_).ok());
  Frame<> frame(memory_.storage());
  EXPECT_EQ(draw(frame).find_first_not_of("#\n"), std::string::npos);
}

}  // namespace
}  // namespace spanline
