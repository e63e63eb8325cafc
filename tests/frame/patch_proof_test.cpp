// The teapot, diced and as points, against the oversampled one in random views: no hole, the outline as near as the
// tolerance says, for points within a pixel, and the right patch in every pixel.
//
// A pixel is wrong where the picture shows the background, and all samples within the bound show one part of the teapot
// (a hole, or an outline too far in); or the other way round (too far out). Parts are what is joined by shared sides:
// body, lid, bottom, spout, handle. The handle's ends merely touch the body; where two parts meet, each may be off by
// the tolerance, and a pixel of background between them is a matter of their outlines, not a hole in either.
//
// Where all samples within a pixel show one patch, that one has to be seen: identity differs only within a pixel of a
// boundary. Parts that pierce each other do so at any angle, and the line between them may move along the surfaces by
// more than that: there the patch seen must be within a pixel in depth, and there are a few such pixels in a million.
//
// Near a boundary the patch seen is mostly one of those that meet there, some sample within a pixel showing it. Where
// it is not, another one, hidden or farther off, is seen past a rim whose facets are off by less than the tolerance: a
// pixel in twenty thousand at most; a point has the depth of its own place, not of its pixel's middle, and is allowed
// four times as many.
#include <gtest/gtest.h>

#include <initializer_list>
#include <map>
#include <string>

#include "frame/patch_oversampled.hpp"
#include "frame/patch_views.hpp"
#include "vsg/scale.hpp"

namespace spanline::test {
namespace {

struct Mode {
  const char* name;
  host::Surface surface;
  std::uint16_t tolerance;  // 1/16 px, of dicing
  double outline;           // px
  std::size_t identity;     // one pixel in so many may show another patch than the right one
};
constexpr Mode kHalf{"diced", host::Surface::dice, 8, 1.0, 20'000},
    kQuarter{"diced fine", host::Surface::dice, 4, 0.5, 20'000},
    kPoints{"points", host::Surface::points, 8, 1.0, 5'000};
constexpr double kIdentity = 1.0;            // px, across and in depth
constexpr std::size_t kPierced = 1'000'000;  // one pixel in so many may lie past a line of piercing by more

struct Wrong {
  std::size_t holes = 0, outline = 0, inside = 0, pierced = 0, identity = 0, covered = 0;
};

Wrong compare(const host::Rendering& drawn, const Oversampled& truth, double outline) {
  Wrong wrong;
  const int width = drawn.picture.width, height = drawn.picture.height;
  for (int line = 0; line < height; ++line) {
    for (int column = 0; column < width; ++column) {
      const std::uint32_t id =
          drawn
              .ids[static_cast<std::size_t>(line) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
      if (id == 0) {
        wrong.holes += truth.inside_a_part(column, line, outline);
      } else {
        ++wrong.covered;
        wrong.outline += !truth.shows_any(column, line, outline);
        const std::uint32_t only = truth.only(column, line, kIdentity);
        if (only == id || truth.shows(id, column, line, kIdentity)) continue;
        const bool pierced = truth.pierced_by(id, column, line, kIdentity, kIdentity);
        if (only != Oversampled::kSeveral) ++(pierced ? wrong.pierced : wrong.inside);
        wrong.identity += !pierced;
      }
    }
  }
  return wrong;
}

void compare_views(std::uint16_t width, std::uint16_t height, std::initializer_list<Mode> modes, std::uint64_t views) {
  host::CompiledScene scene = teapot_scene(host::MeshShading::flat, width, height);
  Oversampled truth(scene.description());
  std::map<std::string, Wrong> sums;
  for (std::uint64_t view = 0; view < views; ++view) {
    oracle::Random random(view + 1);
    look_from_anywhere(scene, random, 0.7 + random.below(100) / 100.0);
    truth.draw(scene);
    for (const Mode& mode : modes) {
      host::EngineOptions options;
      options.surface = mode.surface;
      options.pools.patch_tolerance = mode.tolerance;
      const Wrong wrong = compare(render(scene, options), truth, mode.outline);
      EXPECT_EQ(wrong.holes, 0u) << mode.name << ", view " << view;
      EXPECT_EQ(wrong.outline, 0u) << mode.name << ", view " << view;
      EXPECT_EQ(wrong.inside, 0u) << mode.name << ", view " << view;
      Wrong& sum = sums[mode.name];
      sum.pierced += wrong.pierced;
      sum.identity += wrong.identity;
      sum.covered += wrong.covered;
    }
  }
  for (const Mode& mode : modes) {
    const Wrong& sum = sums[mode.name];
    EXPECT_LE(sum.pierced, sum.covered / kPierced) << mode.name << " of " << sum.covered;
    EXPECT_LE(sum.identity, sum.covered / mode.identity) << mode.name << " of " << sum.covered;
  }
}

TEST(PatchProof, HalfAPixelAt320x240) { compare_views(320, 240, {kHalf, kPoints}, scene_count(20, 1000)); }
TEST(PatchProof, HalfAPixelAt480x320) { compare_views(480, 320, {kHalf, kPoints}, scene_count(60, 1000)); }
TEST(PatchProof, AQuarterOfAPixelAt320x240) { compare_views(320, 240, {kQuarter}, scene_count(8, 1000)); }
TEST(PatchProof, AQuarterOfAPixelAt480x320) { compare_views(480, 320, {kQuarter}, scene_count(4, 1000)); }

}  // namespace
}  // namespace spanline::test
