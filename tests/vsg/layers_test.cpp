// Surface detail and see-through polygons against the oracle, surface by surface and byte by byte.
#include "oracle/layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "oracle/compare.hpp"
#include "oracle/random_camera_scene.hpp"
#include "oracle/random_layers.hpp"
#include "oracle/random_scene.hpp"
#include "vsg/drawing.hpp"
#include "vsg/facets_of_core.hpp"
#include "vsg/scale.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

struct LayeredScene {
  oracle::SceneStore store;
  CameraRecord camera;
};

LayeredScene layered(oracle::SceneStore store, const CameraRecord& camera, std::uint64_t seed) {
  Random random(~seed);
  oracle::add_random_layers(store, random);
  return {std::move(store), camera};
}

LayeredScene on_screen(std::uint64_t seed, std::vector<oracle::Facet> (*make)(std::uint64_t)) {
  return layered(oracle::screen_scene(make(seed), oracle::random_layout(seed)), oracle::plain_camera(), seed);
}

LayeredScene before_camera(std::uint64_t seed) {
  oracle::CameraScene space = oracle::random_camera_scene(seed);
  return layered(std::move(space.scene), space.camera, seed);
}

Choices with_layers(Comparator comparator) {
  Choices choices;
  choices.comparator = comparator;
  choices.layers = true;
  return choices;
}

// (255 - t) parts of the layer's own colour and t parts of what is behind, to the nearest.
int seen_through(int own, int t, int behind) { return (2 * (own * (255 - t) + behind * t) + 255) / 510; }

std::uint16_t wire_of(int r, int g, int b) {
  const int pixel = (r / 8 << 11) | (g / 4 << 5) | b / 8;
  return static_cast<std::uint16_t>((pixel & 255) << 8 | pixel >> 8);
}

// What is wrong with a picture of unlit materials before a black background.
std::string judge_layers(const Drawing& drawing, const SceneView& scene, const CameraRecord& camera,
                         std::int64_t tolerance) {
  if (!drawing.broken.empty()) return drawing.broken;
  if (!drawing.status.ok()) return std::string("status ") + drawing.status.where;
  const std::vector<oracle::Facet> facets = facets_of(scene, camera, kRandomScreen);
  const oracle::FacetsByFace faces = oracle::by_face(facets);
  const oracle::Rendering truth = oracle::render(kRandomScreen.width, kRandomScreen.height, facets);
  const std::vector<MaterialRecord> materials = materials_of(scene, camera, kRandomScreen);
  for (int line = 0; line < truth.height(); ++line) {
    for (int column = 0; column < truth.width(); ++column) {
      const auto pixel = static_cast<std::size_t>(line * truth.width() + column);
      const std::vector<std::uint32_t>& stack = drawing.stacks[pixel];
      const std::string place = "column " + std::to_string(column) + ", line " + std::to_string(line) + ": ";
      const std::string wrong = oracle::wrong_stack(stack, truth.candidates(column, line), faces, tolerance);
      if (!wrong.empty()) return place + wrong;
      int r = 0, g = 0, b = 0;
      for (std::size_t i = stack.size(); i-- > 0;) {
        const MaterialRecord& material = materials[stack[i]];
        r = seen_through(material.color.r, material.transmission.r, r);
        g = seen_through(material.color.g, material.transmission.g, g);
        b = seen_through(material.color.b, material.transmission.b, b);
      }
      const std::uint16_t drawn =
          static_cast<std::uint16_t>(drawing.bytes[2 * pixel] | drawing.bytes[2 * pixel + 1] << 8);
      if (drawn != wire_of(r, g, b)) return place + "another colour";
    }
  }
  return {};
}

class Layers : public testing::TestWithParam<int> {
 protected:
  // check(scene, view, seed, random) for all three kinds of scenes in turn; SPANLINE_SEED=N looks at that seed alone.
  template <typename Check>
  void for_each_scene(std::uint64_t slice, std::uint64_t full, const Check& check) {
    const char* only = std::getenv("SPANLINE_SEED");
    const std::uint64_t first = static_cast<std::uint64_t>(only != nullptr ? std::atoll(only) : GetParam());
    const std::uint64_t end = only != nullptr ? first + 1 : scene_count(slice, full);
    for (std::uint64_t seed = first; seed < end && !HasFailure(); seed += kShards) {
      LayeredScene scenes[] = {on_screen(seed, oracle::random_screen_facets),
                               on_screen(seed, oracle::random_level_facets), before_camera(seed)};
      Random random(seed);
      for (int kind = 0; kind < 3; ++kind) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", kind " << kind);
        const SceneRecord record = scenes[kind].store.record();
        SceneView view;
        const Status status = SceneView::validate(record, view);
        ASSERT_TRUE(status.ok()) << status.where << " " << status.field;
        check(view, scenes[kind].camera, kind == 1 ? 0 : oracle::kOneUnit, random);
      }
    }
  }

  Drawer drawer_;
};

void expect_same(const Drawing& expected, const Drawing& actual) {
  EXPECT_EQ(actual.broken, "");
  EXPECT_TRUE(actual.status.ok()) << actual.status.where << " line " << actual.status.line << ": needs "
                                  << actual.status.needed << " of " << actual.status.limit;
  EXPECT_TRUE(actual.bytes == expected.bytes) << "other bytes";
  EXPECT_TRUE(actual.stacks == expected.stacks) << "other surfaces";
  EXPECT_TRUE(actual.depths == expected.depths) << "other depths";
}

TEST_P(Layers, AsTheOracleLaysThem) {
  for_each_scene(
      1200, 8000, [this](const SceneView& view, const CameraRecord& camera, std::int64_t tolerance, Random&) {
        for (const Comparator comparator : {Comparator::plane, Comparator::midpoint}) {
          EXPECT_EQ(judge_layers(drawer_.draw(view, camera, with_layers(comparator)), view, camera, tolerance), "");
        }
      });
}

TEST_P(Layers, AnyBandSplitComparatorAndPoolSize) {
  for_each_scene(160, 2000, [this](const SceneView& view, const CameraRecord& camera, std::int64_t, Random& random) {
    const Drawing whole = drawer_.draw(view, camera, with_layers(Comparator::plane));
    Choices choices = with_layers(random.percent(50) ? Comparator::plane : Comparator::midpoint);
    for (std::uint16_t line = 1; line < kRandomScreen.height; ++line) choices.cuts.push_back(line);
    const Drawing lines = drawer_.draw(view, camera, choices);
    expect_same(whole, lines);
    const auto at_least = [&random](std::uint32_t need) {
      return std::max(need, 1u) + static_cast<std::uint32_t>(random.percent(50) ? 0 : random.below(10));
    };
    choices.limits.facets = at_least(lines.statistics.max_facets);
    choices.limits.polygons = at_least(lines.statistics.max_polygons);
    choices.limits.edges = at_least(lines.statistics.max_edges);
    choices.limits.segments = at_least(lines.statistics.max_segments);
    choices.limits.samples = static_cast<std::uint32_t>(random.below(6));
    choices.cuts.clear();
    expect_same(whole, drawer_.draw(view, camera, choices));
  });
}

// The layers need a place for every segment of theirs over one pixel and no more; the oracle knows how many there are.
TEST_P(Layers, APoolThatHoldsOnePixel) {
  for_each_scene(160, 2000, [this](const SceneView& view, const CameraRecord& camera, std::int64_t, Random&) {
    const std::vector<oracle::Facet> facets = facets_of(view, camera, kRandomScreen);
    const oracle::FacetsByFace faces = oracle::by_face(facets);
    const oracle::Rendering truth = oracle::render(kRandomScreen.width, kRandomScreen.height, facets);
    std::ptrdiff_t most = 1;
    for (int line = 0; line < truth.height(); ++line) {
      for (int column = 0; column < truth.width(); ++column) {
        const auto& all = truth.candidates(column, line);
        most = std::max(most, std::count_if(all.begin(), all.end(), [&faces](const oracle::Candidate& each) {
                          const oracle::Facet& facet = *faces.at(each.face);
                          return facet.parent != oracle::kNone || facet.see_through;
                        }));
      }
    }
    Choices choices = with_layers(Comparator::plane);
    const Drawing whole = drawer_.draw(view, camera, choices);
    choices.limits.layers = static_cast<std::uint32_t>(most);
    expect_same(whole, drawer_.draw(view, camera, choices));
  });
}

TEST_P(Layers, APoolThatDoesNotIsNamedAndTheNextFrameIsWhole) {
  int exhausted = 0;
  for_each_scene(160, 2000, [&](const SceneView& view, const CameraRecord& camera, std::int64_t, Random& random) {
    Choices choices = with_layers(Comparator::plane);
    const Drawing whole = drawer_.draw(view, camera, choices);
    choices.limits.layers = static_cast<std::uint32_t>(random.below(3));
    choices.limits.active = static_cast<std::uint32_t>(random.percent(30) ? 1 + random.below(4) : 65535);
    const Drawing poor = drawer_.draw(view, camera, choices);
    EXPECT_EQ(poor.broken, "");
    if (poor.status.ok()) {
      expect_same(whole, poor);
    } else {
      ++exhausted;
      EXPECT_EQ(poor.status.code, Code::pool_exhausted);
      EXPECT_TRUE(std::string(poor.status.where) == "layers" || std::string(poor.status.where) == "active");
      EXPECT_GT(poor.status.needed, poor.status.limit);
    }
    expect_same(whole, drawer_.draw(view, camera, with_layers(Comparator::midpoint)));
  });
  if (!HasFailure()) {
    EXPECT_GT(exhausted, 5);
  }
}

// What hides is found as if detail and glass were not there: a scene without either is the same frame, counter by
// counter.
TEST_P(Layers, CostNothingWhereThereAreNone) {
  for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < 80; seed += kShards) {
    oracle::SceneStore store = oracle::screen_scene(oracle::random_screen_facets(seed), oracle::random_layout(seed));
    const SceneRecord record = store.record();
    SceneView view;
    ASSERT_TRUE(SceneView::validate(record, view).ok());
    const Drawing plain = drawer_.draw(view, oracle::plain_camera(), {});
    const Drawing ready = drawer_.draw(view, oracle::plain_camera(), with_layers(Comparator::plane));
    expect_same(plain, ready);
    EXPECT_EQ(plain.statistics.segment_references, ready.statistics.segment_references);
    EXPECT_EQ(plain.statistics.comparator_cycles, ready.statistics.comparator_cycles);
    EXPECT_EQ(plain.statistics.output_segments, ready.statistics.output_segments);
    EXPECT_EQ(plain.statistics.depth_tests, ready.statistics.depth_tests);
  }
}

INSTANTIATE_TEST_SUITE_P(Shards, Layers, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
