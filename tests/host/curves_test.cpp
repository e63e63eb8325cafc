// Curves in scenes: paths and records read, pictures that no band and no pool changes.
#include <gtest/gtest.h>

#include <algorithm>

#include "assetc/compile.hpp"
#include "assetc/scene_json.hpp"
#include "assetc/svg_path.hpp"
#include "host/support.hpp"
#include "oracle/random.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

using oracle::Random;

// ---- paths ----

std::vector<PathContour> path_of(const std::string& text) {
  const nlohmann::json value = text;
  return read_svg_path(JsonNode(value, "p"));
}

std::string message_of_path(const std::string& text) {
  return message_of([&] { path_of(text); });
}

TEST(SvgPath, ReadsEveryCommandAbsoluteAndRelative) {
  const auto absolute = path_of("M10,20 L40 20 H70 V50 C70 60 60 70 50 70 S30 80 20 70 Q10 60 10 50 T10 30 Z");
  const auto relative = path_of("m10 20l30 0h30v30c0 10-10 20-20 20s-20 10-30 0q-10-10-10-20t0-20z");
  ASSERT_EQ(absolute.size(), 1u);
  ASSERT_EQ(relative.size(), 1u);
  EXPECT_TRUE(absolute[0].closed);
  ASSERT_EQ(absolute[0].points.size(), 24u);  // eight pieces and no end of their own
  ASSERT_EQ(relative[0].points.size(), 24u);
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_NEAR(length(absolute[0].points[i] - relative[0].points[i]), 0, 1e-9) << i;
  }
  const std::vector<Vec3>& p = absolute[0].points;
  EXPECT_EQ(p[3], (Vec3{40, 20, 0}));
  EXPECT_EQ(p[13], (Vec3{40, 70, 0})) << "S mirrors the control point before it: 2 * (50, 70) - (60, 70)";
}

TEST(SvgPath, MirrorsOnlyControlPointsOfItsKind) {
  const auto after_line = path_of("M0 0 L6 0 S9 3 12 0");
  EXPECT_EQ(after_line[0].points[4], (Vec3{6, 0, 0}));
  const auto after_cubic = path_of("M0 0 C0 6 6 6 6 0 S9 -6 12 0");
  EXPECT_EQ(after_cubic[0].points[4], (Vec3{6, -6, 0}));
}

TEST(SvgPath, SeparatesSubpaths) {
  const auto contours = path_of("M0 0 1 0 1 1 Z M5 5 L6 6");
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_TRUE(contours[0].closed);
  EXPECT_EQ(contours[0].points.size(), 9u);
  EXPECT_FALSE(contours[1].closed);
  EXPECT_EQ(contours[1].points.size(), 4u);
}

TEST(SvgPath, SaysWhatItDoesNotUnderstand) {
  EXPECT_EQ(message_of_path("L1 1"), "p: /: the subpath does not begin with a move at offset 4 of the path");
  EXPECT_EQ(message_of_path("M0 0 A1 1 0 0 0 2 2"),
            "p: /: 'A' is not a command that is understood (M L H V C S Q T Z) at offset 6 of the path");
  EXPECT_EQ(message_of_path("M0 0 L1"), "p: /: a number is missing or out of range at offset 7 of the path");
  EXPECT_EQ(message_of_path("M0 0 Lnan 1"), "p: /: a number is missing or out of range at offset 6 of the path");
  EXPECT_EQ(message_of_path("M0 0 L1e30 1"), "p: /: a number is missing or out of range at offset 6 of the path");
  EXPECT_EQ(message_of_path("0 0"), "p: /: a command is missing at offset 0 of the path");
  EXPECT_EQ(message_of_path("M0 0 M1 1"), "p: /: a subpath has no pieces at offset 6 of the path");
  EXPECT_EQ(message_of_path("  "), "p: /: is an empty path");
}

// ---- pictures ----

std::string number(int value) { return std::to_string(value); }

// A curve of random kind with points in a box of `size` about the origin, or on the screen.
std::string random_curve(Random& random, int size, bool on_screen) {
  const char* const kinds[] = {"bezier", "quadratic", "b-spline", "catmull-rom"};
  const int kind = random.below(4), pieces = random.between(1, 3);
  const bool closed = random.percent(30);
  const int degree = kind == 0 ? 3 : 2;
  const int count = kind < 2 ? degree * pieces + (closed ? 0 : 1) : pieces + 3;
  std::string text = std::string(R"({"kind":")") + kinds[kind] + R"(","points":[)";
  for (int i = 0; i < count; ++i) {
    const int low = on_screen ? -20 : -size;
    text += (i == 0 ? "[" : ",[") + number(random.between(low, size)) + "," + number(random.between(low, size)) + "," +
            (on_screen ? "0" : number(random.between(low, size))) + "]";
  }
  return text + R"(],"closed":)" + (closed ? "true" : "false") + R"(,"width":)" + number(random.below(9)) +
         R"(,"smooth":)" + (random.percent(60) ? "true" : "false") + R"(,"material":"m)" + number(random.below(3)) +
         R"("})";
}

std::string curves_of(Random& random, int size, bool on_screen) {
  std::string text;
  const int count = random.between(1, 5);
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + random_curve(random, size, on_screen);
  return text;
}

// Curves before and across the eye, others on the screen, over a square.
CompiledScene random_scene(Random& random) {
  return compile(parse_scene(
      "s", R"({"size":[80,60],"camera":{"eye":[0,0,9],"target":[0,0,0],"near":0.5,"far":40},"materials":[)"
           R"({"name":"m0","color":"#ff2000"},{"name":"m1","color":"#20ff80"},{"name":"m2","color":"#e0e0ff"}],)"
           R"("meshes":[{"name":"space","curves":[)" +
               curves_of(random, 6, false) + R"(]},{"name":"screen","curves":[)" + curves_of(random, 90, true) +
               R"(]},{"name":"face","vertices":[[-2,-2,0],[2,-2,0],[2,2,0],[-2,2,0]],"faces":[[0,1,2,3]]}],)" +
               R"("instances":[{"mesh":"space","rotate":[)" + number(random.below(360)) +
               R"(,40,0]},{"mesh":"space","translate":[0,0,8]},{"mesh":"face"},{"mesh":"screen","screen":true}]})"));
}

Rendering rendered(CompiledScene& scene, EngineOptions options) {
  options.width = scene.description().width;
  options.height = scene.description().height;
  Rendering out;
  const SceneRecord record = scene.record();
  const Status status = Engine::make(options)->render(validated(record, "s"), scene.camera(), out);
  EXPECT_TRUE(status.ok()) << status_text(status);
  return out;
}

TEST(CurvesInScenes, PicturesDoNotDependOnBandsOrPools) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    CompiledScene scene = random_scene(random);
    for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::grey4, PixelFormat::mono1}) {
      EngineOptions options;
      options.format = format;
      const Rendering whole = rendered(scene, options);
      ASSERT_TRUE(whole.status.ok());
      options.bands = static_cast<std::uint16_t>(random.between(2, 60));
      options.pools.curves = static_cast<std::uint16_t>(random.between(40, 80));
      options.pools.edges = 3;
      const Rendering cut = rendered(scene, options);
      ASSERT_TRUE(cut.status.ok()) << status_text(cut.status);
      ASSERT_EQ(whole.picture.rgb, cut.picture.rgb) << "seed " << seed;
    }
  }
}

// A band that begins anywhere shows what the whole frame shows there.
TEST(CurvesInScenes, AnyLineMayComeFirst) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    CompiledScene scene = random_scene(random);
    const SceneRecord record = scene.record();
    const SceneView view = validated(record, "s");
    HostMemory memory({80, 60, PixelFormat::rgb565}, 60, {});
    Frame<> frame(memory.storage());
    alignas(4) std::uint8_t line[160];
    const auto lines_from = [&](std::uint16_t top) {
      std::vector<std::uint8_t> bytes;
      const Band band = frame.prepare(view, scene.camera(), {top, 60});
      EXPECT_EQ(band.bottom, 60);
      while (frame.next_line(line)) bytes.insert(bytes.end(), line, line + sizeof line);
      return bytes;
    };
    const std::vector<std::uint8_t> whole = lines_from(0);
    const auto top = static_cast<std::uint16_t>(random.between(1, 59));
    const std::vector<std::uint8_t> rest = lines_from(top);
    ASSERT_EQ(rest.size(), (60u - top) * sizeof line);
    ASSERT_TRUE(std::equal(rest.begin(), rest.end(), whole.begin() + top * std::ptrdiff_t{sizeof line})) << seed;
  }
}

std::string strokes(const std::string& list) {
  return R"({"size":[40,30],"background":[0,0,0],"materials":[{"name":"w","color":"#ffffff"},)"
         R"({"name":"r","color":"#ff0000"}],"meshes":[{"name":"m","curves":[)" +
         list + R"(]}],"instances":[{"mesh":"m","screen":true}]})";
}

Color pixel(const Rendering& rendering, std::size_t x, std::size_t y) {
  const std::uint8_t* at = rendering.picture.rgb.data() + 3 * (y * rendering.picture.width + x);
  return {at[0], at[1], at[2]};
}

TEST(CurvesInScenes, LaterOnesLieOverEarlierOnesAndEdgesMix) {
  CompiledScene scene = compile(parse_scene("s", strokes(R"({"path":"M0 10 H40","width":3,"material":"r"},)"
                                                         R"({"path":"M20 0 V30","width":4,"material":"w"})")));
  const Rendering out = rendered(scene, {});
  EXPECT_EQ(pixel(out, 5, 9), (Color{255, 0, 0}));
  EXPECT_EQ(pixel(out, 5, 7), (Color{0, 0, 0}));
  EXPECT_NEAR(pixel(out, 5, 8).r, 128, 8) << "half of the pixel is covered";
  EXPECT_EQ(pixel(out, 19, 9), (Color{255, 255, 255}));
  EXPECT_EQ(pixel(out, 20, 20), (Color{255, 255, 255}));
}

TEST(CurvesInScenes, TooFewStrandsLeaveOutTheHighestCurvesAndSaySo) {
  CompiledScene scene = compile(parse_scene("s", strokes(R"({"path":"M5 2 V28","width":2,"material":"r"},)"
                                                         R"({"path":"M30 10 V28","width":2,"material":"w"})")));
  EngineOptions options;
  options.pools.strands = 1;
  const Rendering out = rendered(scene, options);
  EXPECT_EQ(out.status.code, Code::pool_exhausted);
  EXPECT_STREQ(out.status.where, "strands");
  EXPECT_EQ(out.status.needed, 2u);
  EXPECT_EQ(pixel(out, 5, 20), (Color{255, 0, 0}));
  EXPECT_EQ(pixel(out, 30, 20), (Color{0, 0, 0}));
}

TEST(CurvesInScenes, AFrameWithoutStrandsSaysSo) {
  CompiledScene scene = compile(parse_scene("s", strokes(R"({"path":"M5 2 V28"})")));
  static FrameMemory<Budget{.width = 40, .height = 30}> memory;
  Frame<> frame(memory.storage());
  const SceneRecord record = scene.record();
  EXPECT_FALSE(frame.prepare(validated(record, "s"), scene.camera(), {0, 30}).empty());
  EXPECT_EQ(frame.status().code, Code::pool_exhausted);
  EXPECT_STREQ(frame.status().where, "strands");
}

// Pieces far across the view, behind the eye, and of no length.
TEST(CurvesInScenes, NothingIsTooFarOff) {
  for (const char* curve :
       {R"({"path":"M-2000 15 C-2000 -1900 2000 1900 2000 15","width":64})", R"({"path":"M20 15 L20 15","width":6})",
        R"({"path":"M-2000 -2000 H2000 V2000 H-2000 Z","width":0})"}) {
    CompiledScene scene = compile(parse_scene("s", strokes(curve)));
    EXPECT_TRUE(rendered(scene, {}).status.ok()) << curve;
  }
}

// ---- filled outlines ----

constexpr double kCircle = 0.5522847;  // of the radius: a cubic Bezier's control points for a quarter of a circle

std::string circle(double x, double y, double r) {
  const auto at = [&](double u, double v) { return std::to_string(x + r * u) + " " + std::to_string(y + r * v) + " "; };
  const double k = kCircle;
  return "M" + at(1, 0) + "C" + at(1, k) + at(k, 1) + at(0, 1) + at(-k, 1) + at(-1, k) + at(-1, 0) + at(-1, -k) +
         at(-k, -1) + at(0, -1) + at(k, -1) + at(1, -k) + at(1, 0) + "Z ";
}

std::string filled(const std::string& path, const std::string& instance, int size = 200) {
  return R"({"size":[)" + number(size) + "," + number(size) + R"(],"background":[0,0,0],)" +
         R"("camera":{"eye":[0,0,10],"target":[0,0,0],"near":1,"far":50},)" +
         R"("materials":[{"name":"w","color":"#ffffff","shading":"unlit"}],"meshes":[{"name":"m","material":"w",)" +
         R"("outlines":[{"path":")" + path + R"("}]}],"instances":[)" + instance + "]}";
}

// Pixels whose centres are nearer to a circle than `slack` may go either way; a chord is a quarter of a pixel off it at
// most, a vertex a sixteenth.
void expect_ring(const Rendering& out, double x, double y, double outer, double inner) {
  constexpr double kSlack = 0.4;
  for (std::size_t row = 0; row < out.picture.height; ++row) {
    for (std::size_t column = 0; column < out.picture.width; ++column) {
      const double d = std::hypot(static_cast<double>(column) + 0.5 - x, static_cast<double>(row) + 0.5 - y);
      if (std::abs(d - outer) < kSlack || std::abs(d - inner) < kSlack) continue;
      ASSERT_EQ(pixel(out, column, row).r, d < outer && d > inner ? 255 : 0) << column << " " << row;
    }
  }
}

TEST(FilledOutlines, AreSmoothAtAnySizeWithHoles) {
  for (const int size : {10, 40, 200, 1000}) {
    const double middle = size / 2.0 + 0.3, outer = size * 0.45, inner = size * 0.2;
    CompiledScene scene = compile(parse_scene("s", filled(circle(middle, middle, outer) + circle(middle, middle, inner),
                                                          R"({"mesh":"m","screen":true})", size)));
    expect_ring(rendered(scene, {}), middle, middle, outer, inner);
    if (testing::Test::HasFatalFailure()) FAIL() << size;
  }
}

TEST(FilledOutlines, AreProjectedLikeAnyFace) {
  CompiledScene scene = compile(parse_scene("s", filled(circle(0, 0, 3) + circle(0, 0, 1), R"({"mesh":"m"})")));
  const double scale = 100 / std::tan(radians(22.5)) / 10;
  expect_ring(rendered(scene, {}), 100, 100, 3 * scale, scale);
  CompiledScene back = compile(parse_scene("s", filled(circle(0, 0, 3), R"({"mesh":"m","rotate":[0,180,0]})")));
  expect_ring(rendered(back, {}), 100, 100, 0, 0);
}

// Across the guard band, the near plane and bands.
TEST(FilledOutlines, AreClippedAndCutIntoBandsLikeAnyFace) {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const double r = random.between(1, 60);
    CompiledScene scene = compile(parse_scene(
        "s",
        filled(circle(random.between(-20, 20), random.between(-20, 20), r) + circle(0, 0, r / 3),
               R"({"mesh":"m","cull":false,"rotate":[)" + number(random.below(360)) + "," + number(random.below(360)) +
                   "," + number(random.below(360)) + R"(],"translate":[0,0,)" + number(random.between(-5, 9)) + "]}",
               60)));
    const Rendering whole = rendered(scene, {});
    ASSERT_TRUE(whole.status.ok()) << i;
    EngineOptions options;
    options.bands = static_cast<std::uint16_t>(random.between(2, 60));
    options.pools.edges = static_cast<std::uint16_t>(random.below(20));
    const Rendering cut = rendered(scene, options);
    ASSERT_TRUE(cut.status.ok()) << status_text(cut.status);
    ASSERT_EQ(whole.picture.rgb, cut.picture.rgb) << i;
  }
}

TEST(FilledOutlines, StayCurvesInTheTablesOfAFirmware) {
  CompiledScene scene = compile(parse_scene("s", filled(circle(0, 0, 3) + circle(0, 0, 1), R"({"mesh":"m"})")));
  scene.merge_coplanar(64);
  const FaceGroup& group = scene.meshes()[0].groups[0];
  EXPECT_TRUE(group.curved());
  EXPECT_EQ(group.rings(), 2);
  EXPECT_EQ(group.corners_per_face, 24);
}

TEST(CurvesInScenes, TablesOfAFirmwareHoldThem) {
  CompiledScene scene = compile(parse_scene("s", strokes(R"({"kind":"b-spline","closed":true,"width":2.5,)"
                                                         R"("points":[[1,1,0],[9,1,0],[5,9,0]],"material":"r"})")));
  scene.merge_coplanar(64);
  const MeshTables& mesh = scene.meshes()[0];
  ASSERT_EQ(mesh.curves.size(), 1u);
  EXPECT_EQ(mesh.curves[0].pieces(), 3u);
  EXPECT_EQ(mesh.curves[0].width, 40);
  EXPECT_EQ(mesh.positions[mesh.corners[mesh.curves[0].first_corner + 1]].x, 9 * 16);
}

}  // namespace
}  // namespace spanline::host
