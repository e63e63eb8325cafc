// Facets: clipping, culling, and what two faces of one edge must have in common.
#include "core/geom/facet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geom/exact_projection.hpp"
#include "oracle/random_camera_scene.hpp"

namespace spanline::test {
namespace {

constexpr Screen kScreen{64, 48, PixelFormat::rgb565};

using Ring = std::vector<FacetVertex>;

struct Rings {
  std::vector<Ring> all;
  void begin_contour() { all.emplace_back(); }
  void vertex(const FacetVertex& vertex) { all.back().push_back(vertex); }
  void end_contour() {}
};

// A scene with a reader that caches nothing.
class Reading {
 public:
  Reading(oracle::SceneStore& store, const CameraRecord& camera) : record_(store.record()), camera_(camera) {
    const Status status = SceneView::validate(record_, view_);
    EXPECT_TRUE(status.ok()) << status.where << " " << status.field;
    reader_ = FacetReader(view_, camera_, kScreen, PoolRef<ScreenPoint>(sink_, 0));
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  FacetReader& select(std::uint16_t face) {
    reader_.select(face);
    return reader_;
  }
  const SceneView& view() const { return view_; }
  std::vector<Ring> rings(std::uint16_t face) {
    Rings rings;
    select(face).read([](std::uint16_t) { return Rgb8{}; }, rings);
    return rings.all;
  }

 private:
  SceneRecord record_;
  CameraRecord camera_;
  SceneView view_;
  ScreenPoint sink_[1];
  FacetReader reader_;
};

constexpr std::int32_t kUnit = 1 << 23;  // Q1.31: 1/256 world unit

oracle::SceneStore scene_of(const std::vector<std::vector<Position>>& faces, std::uint16_t flags) {
  oracle::SceneStore store;
  oracle::MeshStore& mesh = store.add_mesh({}, kUnit);
  for (const auto& face : faces) mesh.add_face({face}, store.add_material());
  store.add_instance(0, flags);
  return store;
}

bool same(const FacetVertex& a, const FacetVertex& b) { return a.at == b.at && a.depth == b.depth; }

int common_vertices(const Ring& a, const Ring& b) {
  return static_cast<int>(std::count_if(a.begin(), a.end(), [&b](const FacetVertex& vertex) {
    return std::any_of(b.begin(), b.end(), [&vertex](const FacetVertex& other) { return same(vertex, other); });
  }));
}

// Some of the way from p to q, in 1/256, that lies well inside the view; false where none of it does.
bool is_seen(const EyePoint& p, const EyePoint& q, const CameraRecord& camera) {
  int inside = 0;
  for (int i = 0; i <= 256; ++i) {
    const long double t = i / 256.0L;
    const EyePoint at{p.right + t * (q.right - p.right), p.up + t * (q.up - p.up), p.ahead + t * (q.ahead - p.ahead)};
    const long double nearest = static_cast<long double>(camera.near_plane.raw) / 65536;
    const long double farthest = static_cast<long double>(camera.far_plane.raw) / 65536;
    if (at.ahead < nearest * 1.01L || at.ahead > farthest * 0.99L) continue;
    const ExactPoint screen = project(at, camera, kScreen.width, kScreen.height);
    const long double guard = 16 * 1000;
    inside += screen.x > -guard && screen.x < guard && screen.y > -guard && screen.y < guard;
  }
  return inside > 2;
}

TEST(Facet, AnEdgeOfTwoFacesClipsToIdenticalVertices) {
  int clipped = 0;
  for (std::uint64_t seed = 0; seed < oracle::rounds(6000u); ++seed) {
    oracle::Random random(seed);
    const CameraRecord camera = oracle::random_camera_scene(seed).camera;
    const auto position = [&random] {
      return Position{static_cast<std::int16_t>(random.between(-3000, 3000)),
                      static_cast<std::int16_t>(random.between(-3000, 3000)),
                      static_cast<std::int16_t>(random.between(-3000, 3000))};
    };
    const Position u = position(), v = position(), a = position(), b = position();
    oracle::SceneStore store = scene_of({{a, u, v}, {b, v, u}}, InstanceRecord::kTwoSided);
    Reading reading(store, camera);
    FacetReader& reader = reading.select(0);
    const bool seen = is_seen(seen_from(camera, reader.instance(), reader.mesh(), u),
                              seen_from(camera, reader.instance(), reader.mesh(), v), camera);
    if (!seen) continue;
    clipped += reader.clipped();
    const std::vector<Ring> first = reading.rings(0), second = reading.rings(1);
    ASSERT_EQ(first.size(), 1u) << seed;
    ASSERT_EQ(second.size(), 1u) << seed;
    EXPECT_GE(common_vertices(first[0], second[0]), 2) << seed;
  }
  EXPECT_GT(clipped, oracle::rounds(500));
}

TEST(Facet, VerticesStayInTheGuardBandAndInTheDepthRange) {
  for (std::uint64_t seed = 0; seed < oracle::rounds(500u); ++seed) {
    oracle::CameraScene space = oracle::random_camera_scene(seed);
    Reading reading(space.scene, space.camera);
    for (std::uint16_t face = 0; face < reading.view().face_count(); ++face) {
      for (const Ring& ring : reading.rings(face)) {
        for (const FacetVertex& vertex : ring) {
          EXPECT_LE(std::abs(vertex.at.x - 8 * kScreen.width), kGuardPx * 16);
          EXPECT_LE(std::abs(vertex.at.y - 8 * kScreen.height), kGuardPx * 16);
          EXPECT_LT(vertex.depth, 1u << 24);
        }
      }
    }
  }
}

// A square of two units at z = 0, counter-clockwise as seen from +z.
const std::vector<Position> kSquare{{-256, -256, 0}, {256, -256, 0}, {256, 256, 0}, {-256, 256, 0}};

CameraRecord at_distance(int z) {
  CameraRecord camera = oracle::plain_camera();
  camera.eye[2] = Fx16::from_int(z);
  return camera;
}

TEST(Facet, BacksAreCulledUnlessTwoSided) {
  std::vector<Position> back = kSquare;
  std::reverse(back.begin(), back.end());
  oracle::SceneStore one_sided = scene_of({kSquare, back}, InstanceRecord::kNone);
  Reading reading(one_sided, at_distance(4));
  EXPECT_FALSE(reading.select(0).extent().empty());
  EXPECT_TRUE(reading.select(0).extent().front());
  EXPECT_TRUE(reading.select(1).extent().empty());
  oracle::SceneStore two_sided = scene_of({kSquare, back}, InstanceRecord::kTwoSided);
  Reading both(two_sided, at_distance(4));
  EXPECT_FALSE(both.select(1).extent().empty());
  EXPECT_FALSE(both.select(1).extent().front());
}

TEST(Facet, AMirrorKeepsItsFronts) {
  oracle::SceneStore store;
  store.add_mesh({}, kUnit).add_face({kSquare}, store.add_material());
  InstanceRecord& instance = store.add_instance(0, InstanceRecord::kNone);
  instance.transform.matrix[2][2] = -instance.transform.matrix[2][2];
  instance.transform.matrix[0][0] = -instance.transform.matrix[0][0];
  instance.transform.matrix[1][1] = -instance.transform.matrix[1][1];
  // A point reflection turns the face's front, which looked towards +z, away from the viewer.
  Reading reading(store, at_distance(4));
  EXPECT_TRUE(reading.select(0).extent().empty());
  Reading behind(store, [] {
    CameraRecord camera = at_distance(-4);
    camera.axes[0][0] = -camera.axes[0][0];
    camera.axes[2][2] = -camera.axes[2][2];
    return camera;
  }());
  EXPECT_FALSE(behind.select(0).extent().empty());
}

TEST(Facet, HiddenInstancesShowNothing) {
  oracle::SceneStore store = scene_of({kSquare}, InstanceRecord::kHidden);
  Reading reading(store, at_distance(4));
  EXPECT_TRUE(reading.select(0).extent().empty());
}

TEST(Facet, BehindTheEyeShowsNothing) {
  oracle::SceneStore store = scene_of({kSquare}, InstanceRecord::kTwoSided);
  Reading reading(store, at_distance(-4));
  EXPECT_TRUE(reading.select(0).extent().empty());
}

TEST(Facet, ScreenFacetsAreHandedOutAsTheyAre) {
  const std::vector<Position> far_out{{-32768, -32768, -32768}, {32767, -32768, 0}, {0, 32767, 32767}};
  oracle::SceneStore store = scene_of({far_out}, InstanceRecord::kScreen);
  Reading reading(store, at_distance(4));
  const std::vector<Ring> rings = reading.rings(0);
  ASSERT_EQ(rings.size(), 1u);
  ASSERT_EQ(rings[0].size(), 3u);
  EXPECT_EQ(rings[0][0].at, (ScreenXY{-32768, -32768}));
  EXPECT_EQ(rings[0][0].depth, 0u);
  EXPECT_EQ(rings[0][1].depth, 32768u * 256);
  EXPECT_EQ(rings[0][2].depth, 65535u * 256);
}

TEST(Facet, TheCacheChangesNothing) {
  for (std::uint64_t seed = 0; seed < oracle::rounds(200u); ++seed) {
    oracle::CameraScene space = oracle::random_camera_scene(seed);
    const SceneRecord record = space.scene.record();
    SceneView scene;
    ASSERT_TRUE(SceneView::validate(record, scene).ok());
    Reading plain(space.scene, space.camera);
    std::vector<ScreenPoint> blocks(static_cast<std::size_t>(scene.vertex_count()) / 2 + 1);
    FacetReader cached(scene, space.camera, kScreen,
                       PoolRef<ScreenPoint>(blocks.data(), static_cast<std::uint16_t>(blocks.size() - 1)));
    cached.fill_cache();
    for (std::uint16_t face = 0; face < scene.face_count(); ++face) {
      cached.select(face);
      Rings rings;
      cached.read([](std::uint16_t) { return Rgb8{}; }, rings);
      const std::vector<Ring> expected = plain.rings(face);
      ASSERT_EQ(rings.all.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_TRUE(std::equal(expected[i].begin(), expected[i].end(), rings.all[i].begin(), rings.all[i].end(), same));
      }
    }
  }
}

TEST(Screen, FirstCentreIsHalfOpen) {
  EXPECT_EQ(first_centre(8), 0);
  EXPECT_EQ(first_centre(9), 1);
  EXPECT_EQ(first_centre(-8), -1);
  EXPECT_EQ(first_centre(-7), 0);
  EXPECT_EQ(first_centre(24), 1);
}

}  // namespace
}  // namespace spanline::test
