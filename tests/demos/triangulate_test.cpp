#include "assetc/triangulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "assetc/ring_faces.hpp"
#include "assetc/scene_json.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

// A mesh of one face in the plane z = x / 4, so that no direction of view is special.
MeshTables mesh_of(const std::vector<std::vector<GridPoint>>& rings) {
  MeshTables mesh;
  std::vector<Ring> numbered;
  for (const std::vector<GridPoint>& ring : rings) {
    numbered.emplace_back();
    for (const GridPoint p : ring) {
      numbered.back().push_back(static_cast<std::uint16_t>(mesh.positions.size()));
      mesh.positions.push_back(
          {static_cast<std::int16_t>(4 * p.u), static_cast<std::int16_t>(4 * p.v), static_cast<std::int16_t>(p.u)});
    }
  }
  append_rings(mesh, numbered, 0, false, "test");
  mesh.face_normals.push_back(Normal10::pack(0, 0, 511));
  return mesh;
}

// Twice the area of a face on the screen of its plane: outline and holes run in opposite ways.
std::int64_t doubled_area(const std::vector<Ring>& rings, const std::vector<Position>& positions) {
  std::int64_t sum = 0;
  for (const Ring& ring : rings) sum += newell(ring, positions).z;
  return sum;
}

// All that makes a set of triangles that one face: none turned over, as much area, and of their edges just those of the
// face have nothing on their other side.
void expect_cut(const MeshTables& mesh) {
  const std::optional<MeshTables> cut = triangulate(mesh, "test");
  ASSERT_TRUE(cut);
  const std::vector<Ring> rings = ring_faces(mesh)[0].rings;
  std::size_t corners = 0;
  for (const Ring& ring : rings) corners += ring.size();
  EXPECT_EQ(cut->face_count, corners + 2 * (rings.size() - 1) - 2);
  std::int64_t area = 0;
  std::map<std::pair<std::uint16_t, std::uint16_t>, int> sides;
  const auto add = [&](const Ring& ring, int way) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint16_t a = ring[i], b = ring[(i + 1) % ring.size()];
      sides[std::minmax(a, b)] += a < b ? way : -way;
    }
  };
  for (const RingFace& triangle : ring_faces(*cut)) {
    const std::int64_t own = doubled_area(triangle.rings, cut->positions);
    EXPECT_GE(own, 0);
    area += own;
    add(triangle.rings[0], 1);
  }
  EXPECT_EQ(area, doubled_area(rings, mesh.positions));
  for (const Ring& ring : rings) add(ring, -1);
  for (const auto& [side, balance] : sides) EXPECT_EQ(balance, 0) << side.first << " " << side.second;
}

// Corners around the origin at angles that grow, so that the ring never crosses itself; on a lattice, so that many are
// in one line.
std::vector<GridPoint> star(std::mt19937& random, int corners, double least, double most) {
  std::vector<GridPoint> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    const double radius = least + (most - least) * static_cast<double>(random() % 1000) / 1000;
    const GridPoint p{std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle))};
    if (ring.empty() || (ring.back() != p && ring.front() != p)) ring.push_back(p);
  }
  return ring;
}

TEST(Triangulate, StarsWithHolesAreCutIntoWhatTheyWere) {
  std::mt19937 random(1970);
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::vector<GridPoint>> rings = {star(random, 3 + static_cast<int>(random() % 40), 60, 200)};
    if (i % 2 == 1) {
      rings.push_back(star(random, 3 + static_cast<int>(random() % 9), 5, 24));
      std::reverse(rings.back().begin(), rings.back().end());
    }
    if (i % 4 == 3) {
      rings.push_back({{30, 0}, {30, 12}, {38, 4}});
      rings.push_back({{-40, 2}, {-44, 2}, {-44, 6}, {-40, 6}});
    }
    const MeshTables mesh = mesh_of(rings);
    const RingFace face = ring_faces(mesh)[0];
    if (!are_simple(face.rings, mesh.positions, face.normal) || newell(face.rings[0], mesh.positions).z <= 0) continue;
    ++cut;
    expect_cut(mesh);
    if (HasFailure()) FAIL() << "at " << i;
  }
  EXPECT_GT(cut, 1500);
}

TEST(Triangulate, StraightCornersAndBridgesAreNoEars) {
  expect_cut(mesh_of({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}}));
  expect_cut(mesh_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}}));
  expect_cut(mesh_of({{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 8}, {9, 8}, {9, 9}, {0, 9}}}));
}

TEST(Triangulate, AQuadIsCutAlongItsShorterDiagonal) {
  const std::optional<MeshTables> cut = triangulate(mesh_of({{{0, 0}, {10, 0}, {14, 4}, {4, 4}}}), "test");
  ASSERT_TRUE(cut);
  ASSERT_EQ(cut->corners.size(), 6u);
  const auto both = [&](std::uint16_t corner) { return std::count(cut->corners.begin(), cut->corners.end(), corner); };
  EXPECT_EQ(both(1), 2);
  EXPECT_EQ(both(3), 2);
}

TEST(Triangulate, WhatCrossesItselfIsLeftAlone) {
  EXPECT_FALSE(triangulate(mesh_of({{{0, 0}, {9, 9}, {9, 0}, {0, 8}}}), "test"));
  EXPECT_FALSE(triangulate(mesh_of({{{0, 6}, {9, 2}, {1, 2}, {8, 6}, {5, 0}}}), "test"));
  std::vector<GridPoint> comb;
  for (int i = 0; i <= static_cast<int>(kMostCutCorners) / 2; ++i) {
    comb.push_back({i, i % 2});
    comb.insert(comb.begin(), {i, 5});
  }
  EXPECT_FALSE(triangulate(mesh_of({comb}), "test"));
}

TEST(Triangulate, AFaceWithoutAreaIsCutAnyhow) {
  const std::optional<MeshTables> cut = triangulate(mesh_of({{{0, 0}, {4, 0}, {8, 0}, {6, 0}}}), "test");
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->face_count, 2);
}

std::vector<std::uint8_t> picture_of(CompiledScene& scene, std::int64_t frame, Walker walker) {
  scene.show(frame);
  EngineOptions options;
  options.width = scene.description().width;
  options.height = scene.description().height;
  options.walker = walker;
  Rendering rendering;
  const SceneRecord record = scene.record();
  EXPECT_TRUE(Engine::make(options)->render(validated(record, "scene"), scene.camera(), rendering).ok());
  return rendering.picture.rgb;
}

std::size_t pixels_apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t apart = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    apart += std::equal(a.begin() + at, a.begin() + at + 3, b.begin() + at) ? 0u : 1u;
  }
  return apart;
}

// Outlines and flat colours stay; only where teeth touch in one plane a depth of nothing decides between two gears.
TEST(Triangulate, AFlatSceneStaysAsItWas) {
  const struct {
    const char* name;
    std::size_t most_apart;
  } scenes[] = {{"demos/gears.json", 2}, {"demos/gears_small.json", 2}, {"scenes/S1.json", 0}};
  for (const auto& scene : scenes) {
    SceneDescription description = read_scene(std::string("assets/") + scene.name);
    for (MaterialSpec& material : description.materials) {
      if (material.shading == Shading::kGouraud) material.shading = Shading::kFlat;
    }
    CompiledScene plain = compile(description), cut = compile(description);
    EXPECT_TRUE(cut.triangulate().empty());
    for (const std::int64_t frame : {0, 13, 40}) {
      const std::vector<std::uint8_t> by_edges = picture_of(cut, frame, Walker::both);
      EXPECT_EQ(pixels_apart(picture_of(cut, frame, Walker::segments), by_edges), 0u) << scene.name;
      EXPECT_LE(pixels_apart(picture_of(plain, frame, Walker::segments), by_edges), scene.most_apart) << scene.name;
    }
  }
}

TEST(Triangulate, NamesTheMeshesThatItLeaves) {
  CompiledScene dial = compile(read_scene("assets/scenes/dial.json"));
  EXPECT_FALSE(dial.triangulate().empty()) << "outlines are curved";
  CompiledScene dice = compile(read_scene("assets/demos/dice.json"));
  EXPECT_FALSE(dice.triangulate().empty()) << "shadows are surface detail";
}

}  // namespace
}  // namespace spanline::host
