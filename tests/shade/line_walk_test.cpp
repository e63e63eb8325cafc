// The walks of a line, which some cores have in assembly, against one that paints pixel by pixel.
#include <gtest/gtest.h>

#include "core/shade/flat_walk.hpp"
#include "core/shade/smooth_walk.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr int kMostEdges = 14, kWidest = 150, kFaces = 20;

struct Line {
  ActiveEdge edges[kMostEdges + 2];  // those alive and a sentinel, those that begin and a sentinel
  ActiveEdge next[kMostEdges + 1];
  std::uint16_t words[kFaces + 1];
  std::uint8_t slots[kFaces + 1];
  FaceLook looks[kFaces + 1];
  alignas(4) std::uint16_t pixels[kWidest];
};

// Edges in order, as faces over the line make them: one face, none or several at a time.
void make_edges(Random& random, int width, ActiveEdge* edges, int count) {
  FaceId over[kMostEdges];
  int faces = 0;
  std::int32_t x = (random.between(-20, width) - 10) * (1 << ActiveEdge::kFraction);
  const int apart = random.percent(30) ? 3 : random.percent(50) ? 12 : 70;  // px
  for (int i = 0; i < count; ++i) {
    x += random.percent(20) ? 0 : random.below(apart << ActiveEdge::kFraction);
    const FaceId ends = faces > 0 && random.percent(70) ? over[--faces] : FaceId{0};
    FaceId begins = 0;
    if (ends == 0 || random.percent(60)) over[faces++] = begins = static_cast<FaceId>(1 + random.below(kFaces));
    const int lines = random.percent(25) ? 0 : random.between(1, 3);
    const std::uint32_t tall = random.percent(20) ? ActiveEdge::kTall : 0;
    edges[i] = {x, random.between(-3 << ActiveEdge::kFraction, 3 << ActiveEdge::kFraction),
                cover_of(begins) - cover_of(ends),
                static_cast<std::uint32_t>(lines) * ActiveEdge::kOneLine + tall + ends};
  }
  edges[count].x = ActiveEdge::kNever;
}

constexpr std::uint16_t kKnown = 7;  // the material
std::uint16_t colors[ColorTable::kEntries];

// Pixel by pixel, edge by edge.
WalkStop walk_slowly(LineWalk& walk, const Line& line, std::uint32_t y, bool smooth) {
  for (;;) {
    if (std::min(walk.edge->x, walk.other->x) > walk.side) return WalkStop::side;
    if (walk.other->x < walk.edge->x) {
      walk.limit = std::min(walk.edge->x, walk.side);
      std::swap(walk.edge, walk.other);
    }
    const ActiveEdge edge = *walk.edge;
    for (; walk.left < edge.column(); ++walk.left) {
      if (walk.key >= kTwoFaces) return WalkStop::front;
      const FaceId face = only_face(walk.key);
      std::uint16_t color = line.words[face];
      if (smooth && face != 0) {
        const FaceLook& look = line.looks[line.slots[face]];
        if (look.face != face) return WalkStop::look;
        if (look.material == FaceLook::kNoMaterial) {
          color = look.color();
        } else if (look.material == kKnown) {
          color = colors[look.plane.at(static_cast<std::uint32_t>(walk.left), y) >> 26];
        } else {
          return WalkStop::look;
        }
      }
      reinterpret_cast<std::uint16_t*>(walk.pixels)[walk.left] = color;
    }
    ++walk.edge;
    walk.key += edge.toggle;
    *walk.out = edge;
    if (edge.rest / ActiveEdge::kOneLine == 0) {
      if ((edge.rest & ActiveEdge::kTall) != 0) return WalkStop::tall;
      continue;
    }
    walk.out->x += edge.dx;
    walk.out->rest -= ActiveEdge::kOneLine;
    for (ActiveEdge* at = walk.out++; at != walk.begin && at[-1].x > at->x; --at) std::swap(at[-1], *at);
    walk.furthest = std::max(walk.furthest, edge.x + edge.dx);
  }
}

LineWalk begin(Line& line, int width, int alive) {
  LineWalk walk;
  walk.edge = line.edges;
  walk.other = line.edges + alive + 1;
  walk.begin = walk.out = line.next;
  walk.side = LineWalk::side_of(width);
  walk.limit = walk.limit_by(walk.other->x);
  walk.left = 0;
  walk.key = 0;
  walk.furthest = INT32_MIN;
  walk.pixels = reinterpret_cast<std::uint8_t*>(line.pixels);
  walk.faces = line.words;
  return walk;
}

void expect_same(const Line& a, const LineWalk& at_a, const Line& b, const LineWalk& at_b, int width) {
  ASSERT_EQ(at_a.edge - a.edges, at_b.edge - b.edges);
  ASSERT_EQ(at_a.other - a.edges, at_b.other - b.edges);
  ASSERT_EQ(at_a.out - a.next, at_b.out - b.next);
  ASSERT_EQ(at_a.limit, at_b.limit);
  ASSERT_EQ(at_a.left, at_b.left);
  ASSERT_EQ(at_a.key, at_b.key);
  ASSERT_EQ(at_a.furthest, at_b.furthest);
  for (int i = 0; i < at_a.left; ++i) ASSERT_EQ(a.pixels[i], b.pixels[i]) << "column " << i;
  for (int i = width; i < kWidest; ++i) ASSERT_EQ(a.pixels[i], 0xabcd) << "beyond the line's end";
  for (int i = 0; i < at_a.out - a.next; ++i) {
    ASSERT_EQ(a.next[i].x, b.next[i].x);
    ASSERT_EQ(a.next[i].dx, b.next[i].dx);
    ASSERT_EQ(a.next[i].toggle, b.next[i].toggle);
    ASSERT_EQ(a.next[i].rest, b.next[i].rest);
  }
}

Line fast, slow;

// Looks of which some are another face's, and some of another material.
void make_looks(Random& random, Line& line) {
  for (std::uint16_t& color : colors) color = static_cast<std::uint16_t>(random.below(0x10000));
  line.slots[0] = 0;
  for (FaceId face = 1; face <= kFaces; ++face) {
    line.slots[face] = static_cast<std::uint8_t>(face);
    const auto part = [&] { return static_cast<std::uint32_t>(random.next()); };
    line.looks[face] = {{part(), part() >> 6, part() >> 6}, face, kKnown};
    if (random.percent(20)) line.looks[face] = FaceLook::flat(static_cast<std::uint16_t>(random.below(0x10000)));
    line.looks[face].face = random.percent(95) ? face : FaceId{1};
    if (random.percent(5)) line.looks[face].material = 3;
  }
}

void compare(bool smooth) {
  int stops[4] = {0, 0, 0, 0};
  for (std::uint64_t seed = 0; seed < oracle::rounds(50000u); ++seed) {
    Random random(seed);
    const int width = random.between(1, kWidest - 8);
    const int alive = random.below(kMostEdges - 3), begun = random.percent(50) ? 0 : random.between(1, 3);
    make_edges(random, width, fast.edges, alive);
    make_edges(random, width, fast.edges + alive + 1, begun);
    for (std::uint16_t& word : fast.words) word = static_cast<std::uint16_t>(random.below(0x10000));
    for (std::uint16_t& pixel : fast.pixels) pixel = 0xabcd;
    if (smooth) make_looks(random, fast);
    slow = fast;
    const auto y = static_cast<std::uint16_t>(random.below(240));
    SmoothBrush brush(fast.looks, fast.slots);
    brush.begin_line(y, fast.words[0]);
    brush.dip(kKnown, colors);
    LineWalk at_fast = begin(fast, width, alive), at_slow = begin(slow, width, alive);
    at_fast.painter = &brush;
    for (;;) {
      const WalkStop stop = smooth ? smooth_walk(at_fast) : flat_walk(at_fast);
      ASSERT_TRUE(stop == walk_slowly(at_slow, slow, y, smooth)) << "seed " << seed;
      ++stops[static_cast<unsigned>(stop)];
      expect_same(fast, at_fast, slow, at_slow, width);
      if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
      if (stop == WalkStop::side) break;
      if (stop == WalkStop::tall) continue;
      for (const std::int32_t end = at_fast.next()->column(); at_fast.left < end; ++at_fast.left, ++at_slow.left) {
        fast.pixels[at_fast.left] = slow.pixels[at_fast.left] = 0x1234;
      }
    }
  }
  for (int i = 0; i < (smooth ? 4 : 3); ++i) EXPECT_GT(stops[i], 50) << i;
}

TEST(LineWalk, PaintsAndStepsAsPixelByPixel) { compare(false); }

TEST(LineWalk, PaintsSmoothSpansAsPixelByPixel) { compare(true); }

}  // namespace
}  // namespace spanline::test
