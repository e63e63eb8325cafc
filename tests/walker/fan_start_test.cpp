// The loops that begin edges, which some cores have in assembly, against the plain ones: fans of any kind, that need be
// no mesh's, edges short and far, room and none.
#include <gtest/gtest.h>

#include <cstring>

#include "core/vsg/band_start.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr int kVertices = 12, kMostSpokes = 6, kFaces = 9, kMostEdges = 40;
constexpr std::uint32_t kFirst = 5;  // vertex of the mesh
constexpr std::uint16_t kEnd = 0xffff;

struct Fans {
  ScreenXY points[kVertices];
  std::uint16_t starts[kVertices + 1];
  FanEdge edges[kVertices * kMostSpokes];
  std::uint16_t links[kFirst + kVertices + 1];
  std::uint16_t words[kFaces];
  std::uint8_t bytes[kFaces];
};

// Boards have little memory.
Fans fans;
ActiveEdge fast[kMostEdges + 1], slow[kMostEdges + 1];

void make_fans(Random& random) {
  const int height = random.percent(30) ? 1500 : random.percent(50) ? 500 : 60;
  for (ScreenXY& point : fans.points) {
    point.x = static_cast<std::int16_t>(random.between(-height - 100, height + 100));
    point.y = static_cast<std::int16_t>(random.between(-height, height));
  }
  fans.starts[0] = 0;
  for (int v = 0; v < kVertices; ++v) {
    fans.starts[v + 1] = static_cast<std::uint16_t>(fans.starts[v] + random.between(1, kMostSpokes));
    for (int i = fans.starts[v]; i < fans.starts[v + 1]; ++i) {
      const int face = random.percent(15) ? FanEdge::kNone : random.below(kFaces);
      fans.edges[i] = {static_cast<std::uint16_t>(random.below(kVertices)), static_cast<std::uint16_t>(face)};
      // No face lies on both sides of an edge.
      if (i != fans.starts[v] && fans.edges[i - 1].face == face) fans.edges[i].face = FanEdge::kNone;
    }
    if (fans.edges[fans.starts[v]].face == fans.edges[fans.starts[v + 1] - 1].face) {
      fans.edges[fans.starts[v]].face = FanEdge::kNone;
    }
  }
  for (int f = 0; f < kFaces; ++f) fans.words[f] = fans.bytes[f] = static_cast<std::uint8_t>(random.below(3));
}

// Any of the vertices above the line, in any order, and one that is another mesh's or none.
std::uint16_t make_list(Random& random, std::int32_t line) {
  std::uint16_t first = random.percent(50) ? kEnd : std::uint16_t{kFirst + kVertices};
  for (int v = 0; v < kVertices; ++v) {
    if (first_centre(fans.points[v].y) > line || random.percent(30)) continue;
    fans.links[kFirst + static_cast<unsigned>(v)] = first;
    first = static_cast<std::uint16_t>(kFirst + static_cast<unsigned>(v));
  }
  return first;
}

template <typename Word>
void compare(const Word* words) {
  int begun = 0, stopped = 0;
  constexpr auto kRounds = oracle::rounds(50000u);
  for (std::uint64_t seed = 0; seed < kRounds; ++seed) {
    Random random(seed);
    make_fans(random);
    const std::int32_t line = random.between(-20, 20);
    const auto start_in = [&](ActiveEdge* edges, std::uint16_t first, int room) {
      FanStart start{};
      start.points = fans.points;
      start.words = words;
      start.vertex = first;
      start.line = line;
      start.out = start.begin = edges + 1;
      start.not_drawn = 1;
      start.cover = cover_of(100);
      start.first = kFirst;
      start.count = kVertices;
      start.starts = fans.starts;
      start.fans = fans.edges;
      start.links = fans.links;
      start.last = reinterpret_cast<std::uintptr_t>(edges + 1 + room);
      edges[0].x = INT32_MIN;
      return start;
    };
    const std::uint16_t first = make_list(random, line);
    const int room = random.percent(40) ? kMostEdges : random.below(kMostEdges / 2);
    FanStart at_fast = start_in(fast, first, room), at_slow = start_in(slow, first, room);
    start_fans(at_fast, words);
    start_fans_plain<Word>(at_slow);
    ASSERT_EQ(at_fast.vertex, at_slow.vertex) << "seed " << seed;
    ASSERT_EQ(at_fast.out - fast, at_slow.out - slow) << "seed " << seed;
    const auto bytes = static_cast<std::size_t>(at_slow.out - slow) * sizeof(ActiveEdge);
    ASSERT_EQ(std::memcmp(fast + 1, slow + 1, bytes - sizeof(ActiveEdge)), 0) << "seed " << seed;
    begun += static_cast<int>(at_slow.out - at_slow.begin);
    stopped += at_slow.at() < at_slow.count;
    for (const ActiveEdge* edge = slow + 2; edge < at_slow.out; ++edge) ASSERT_LE(edge[-1].x, edge->x);
  }
  EXPECT_GT(begun, static_cast<int>(kRounds));
  EXPECT_GT(stopped, static_cast<int>(kRounds / 50));
}

TEST(FanStart, BeginsEdgesByWordsAsThePlainLoop) { compare<std::uint16_t>(fans.words); }

TEST(FanStart, BeginsEdgesByBytesAsThePlainLoop) { compare<std::uint8_t>(fans.bytes); }

// The same fans where vertices are of a band, wait below it or have been reached.
struct BandOfFans {
  std::uint8_t keys[kVertices];
  BandVertex vertices[1 + kVertices];
  Position positions[kVertices];
  std::uint32_t drawn[2];
  MeshPoints points;
};

// Seen from straight ahead.
ClipRows straight_ahead() {
  ClipMatrix matrix{};
  matrix.linear[0][0] = matrix.linear[1][1] = 1 << 21;
  matrix.offset[2] = 64 << 16;
  return ClipRows(matrix);
}

void make_band(Random& random, BandOfFans& of) {
  for (int v = 0; v < kVertices; ++v) {
    const auto place = static_cast<std::uint8_t>(1 + v);
    of.vertices[place] = {fans.points[v], static_cast<std::uint16_t>(kFirst + static_cast<unsigned>(v)), 0, 0};
    const int below = random.between(1, BandVertices::kFiled - 1);
    of.keys[v] = static_cast<std::uint8_t>(random.percent(60)   ? BandVertices::kFiled + place
                                           : random.percent(70) ? below
                                                                : 0);
    of.positions[v] = {static_cast<std::int16_t>(random.between(-32000, 32000)),
                       static_cast<std::int16_t>(random.between(-32000, 32000)), 0};
  }
  for (std::uint32_t& word : of.drawn) word = static_cast<std::uint32_t>(random.next());
}

// Any of the vertices above the line, in any order; the first by its place.
std::uint32_t list_of_band(Random& random, BandOfFans& of, std::int32_t line) {
  std::uint8_t first = 0;
  for (std::uint8_t place = kVertices; place != 0; --place) {
    BandVertex& vertex = of.vertices[place];
    if (first_centre(vertex.at.y) > line || random.percent(30)) continue;
    if (random.percent(5)) vertex.vertex = kFirst + kVertices;  // of another mesh
    vertex.next = first;
    first = place;
  }
  return first;
}

TEST(FanStart, BeginsEdgesInABandAsThePlainLoop) {
  static BandOfFans of;
  of.points = MeshPoints(CameraRecord{}, Screen{320, 240});
  of.points.positions = of.positions;
  of.points.to_clip = straight_ahead();
  int begun = 0, stopped = 0;
  constexpr auto kRounds = oracle::rounds(50000u);
  for (std::uint64_t seed = 0; seed < kRounds; ++seed) {
    Random random(seed);
    make_fans(random);
    make_band(random, of);
    const std::int32_t line = random.between(-20, 120);
    const std::uint32_t first = list_of_band(random, of, line);
    if (first == 0) continue;
    const int room = random.percent(70) ? kMostEdges : random.below(kMostEdges);
    const auto skip = static_cast<std::uint32_t>(random.below(32));
    const auto start_in = [&](ActiveEdge* edges) {
      BandStart start{};
      start.keys = of.keys;
      start.band = of.vertices;
      start.vertex = first;
      start.line = line;
      start.out = start.begin = edges + 1;
      start.drawn = of.drawn;
      start.skip = skip;
      start.first = kFirst;
      start.count = kVertices;
      start.starts = fans.starts;
      start.fans = fans.edges;
      start.cover = cover_of(100);
      start.last = reinterpret_cast<std::uintptr_t>(edges + 1 + room);
      start.points = &of.points;
      edges[0].x = INT32_MIN;
      return start;
    };
    BandStart at_fast = start_in(fast), at_slow = start_in(slow);
    start_band_fans(at_fast);
    start_band_fans_plain(at_slow);
    ASSERT_EQ(at_fast.vertex, at_slow.vertex) << "seed " << seed;
    ASSERT_EQ(at_fast.out - fast, at_slow.out - slow) << "seed " << seed;
    const auto bytes = static_cast<std::size_t>(at_slow.out - slow) * sizeof(ActiveEdge);
    ASSERT_EQ(std::memcmp(fast + 1, slow + 1, bytes - sizeof(ActiveEdge)), 0) << "seed " << seed;
    begun += static_cast<int>(at_slow.out - at_slow.begin);
    stopped += at_slow.vertex != 0;
    for (const ActiveEdge* edge = slow + 2; edge < at_slow.out; ++edge) ASSERT_LE(edge[-1].x, edge->x);
  }
  EXPECT_GT(begun, static_cast<int>(kRounds));
  EXPECT_GT(stopped, static_cast<int>(kRounds / 50));
}

}  // namespace
}  // namespace spanline::test
