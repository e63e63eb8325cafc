// The walks of a line, which some cores have in assembly, against one that paints pixel by pixel.
#include <gtest/gtest.h>

#include "core/shade/band_walk.hpp"
#include "core/shade/flat_walk.hpp"
#include "core/shade/grid_walk.hpp"
#include "core/shade/smooth_grid_walk.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr int kMostEdges = 14, kWidest = 150, kFaces = 60, kPlaces = 32;

struct Cell {  // of a grid
  std::uint16_t color, other[5];
};

struct Line {
  ActiveEdge edges[kMostEdges + 2];  // those alive and a sentinel, those that begin and a sentinel
  ActiveEdge next[kMostEdges + 1];
  std::uint16_t words[kFaces + 1];
  Cell cells[kFaces / 2 + 1];
  std::uint8_t slots[kFaces + 1];
  std::uint8_t heads[LookChains::kMostHeads];
  FaceLook looks[kFaces + 1];
  FaceColor colors[kPlaces];
  std::uint16_t dipped;  // the material that the brush of a band is of
  int learned;
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

constexpr std::uint16_t kKnown = 7, kOther = 3;  // the materials
std::uint16_t colors[ColorTable::kEntries], other_colors[ColorTable::kEntries];
const std::uint16_t* colors_of(std::uint16_t material) { return material == kKnown ? colors : other_colors; }

enum class Kind { flat, cells, smooth, smooth_cells, band_flat, band_smooth };
constexpr bool knows_all(Kind kind) { return kind == Kind::flat || kind == Kind::cells; }
constexpr bool learns(Kind kind) {
  return kind == Kind::smooth || kind == Kind::band_flat || kind == Kind::band_smooth;
}
constexpr bool has_slots(Kind kind) { return kind == Kind::smooth || kind == Kind::smooth_cells; }
constexpr bool is_smooth(Kind kind) { return has_slots(kind) || kind == Kind::band_smooth; }

// What walks do not know is learned.
std::uint16_t learn_color(void* from, FaceId face) {
  Line& line = *static_cast<Line*>(from);
  ++line.learned;
  FaceColor& place = line.colors[face_place(face) % kPlaces];
  place = {face, static_cast<std::uint16_t>(face * 40503u)};
  return place.color;
}
const FaceLook& learn_look(Line& line, FaceId face) {
  ++line.learned;
  const int at = face == 0 ? kFaces : face;
  line.heads[LookChains::head_of(face)] = static_cast<std::uint8_t>(at);
  line.slots[face] = static_cast<std::uint8_t>(at);
  FaceLook& look = line.looks[at];
  look.face = face;
  if (look.smooth()) line.dipped = look.material;
  return look;
}
template <typename Brush>
struct Learner {
  Line& line;
  Brush& brush;
  static void learn(void* from, FaceId face) {
    const Learner& to = *static_cast<Learner*>(from);
    if (learn_look(to.line, face).smooth()) to.brush.dip(to.line.dipped, colors_of(to.line.dipped));
  }
};

// The colour of a pixel; false where the walk does not know it.
bool color_of(Line& line, Kind kind, FaceId face, std::int32_t x, std::uint32_t y, std::uint16_t& color) {
  if (kind == Kind::band_flat) {
    const std::uint32_t place = face_place(face) % kPlaces;
    color = line.colors[place].face == face ? line.colors[place].color : learn_color(&line, face);
    return true;
  }
  if (learns(kind) && !(kind == Kind::smooth && face == 0)) {
    const FaceLook* look = &line.looks[kind == Kind::smooth ? line.slots[face] : line.heads[LookChains::head_of(face)]];
    if (look->face != face || (look->smooth() && look->material != line.dipped)) look = &learn_look(line, face);
    color =
        look->smooth() ? colors_of(line.dipped)[look->plane.at(static_cast<std::uint32_t>(x), y) >> 26] : look->color();
    return true;
  }
  color = line.words[face];
  if (knows_all(kind) || (has_slots(kind) && face == 0)) return true;
  const FaceLook& look = line.looks[line.slots[face]];
  if (look.face != face) return false;
  color = look.material == kKnown ? colors[look.plane.at(static_cast<std::uint32_t>(x), y) >> 26] : look.color();
  return look.material == kKnown || look.material == FaceLook::kNoMaterial;
}

// Pixel by pixel, edge by edge.
WalkStop walk_slowly(LineWalk& walk, Line& line, std::uint32_t y, Kind kind, FaceId shown) {
  for (;; shown = 0) {
    if (std::min(walk.edge->x, walk.other->x) > walk.side) return WalkStop::side;
    if (walk.other->x < walk.edge->x) {
      walk.limit = std::min(walk.edge->x, walk.side);
      std::swap(walk.edge, walk.other);
    }
    const ActiveEdge edge = *walk.edge;
    for (; walk.left < edge.column(); ++walk.left) {
      if (walk.key >= kTwoFaces && shown == 0) return WalkStop::front;
      const FaceId face = shown != 0 ? shown : only_face(walk.key);
      std::uint16_t color = 0;
      if (!color_of(line, kind, face, walk.left, y, color)) return WalkStop::look;
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
  walk.now = line.edges;
  walk.alive_end = line.edges + alive;
  walk.begin = line.next;
  walk.side = LineWalk::side_of(width);
  walk.begin_line();
  walk.pixels = reinterpret_cast<std::uint8_t*>(line.pixels);
  walk.faces = line.words;
  return walk;
}

void expect_same_edges(const Line& a, const Line& b, std::ptrdiff_t count) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    ASSERT_EQ(a.next[i].x, b.next[i].x);
    ASSERT_EQ(a.next[i].dx, b.next[i].dx);
    ASSERT_EQ(a.next[i].toggle, b.next[i].toggle);
    ASSERT_EQ(a.next[i].rest, b.next[i].rest);
  }
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
  expect_same_edges(a, b, at_a.out - a.next);
}

// That a walk has ended the line where the other was through.
void expect_ended(const Line& a, const LineWalk& at_a, Line& b, LineWalk& at_b, int width) {
  ASSERT_TRUE(at_b.key == 0 && at_b.edge->x == ActiveEdge::kNever && at_b.other->x == ActiveEdge::kNever);
  at_b.end_line();
  ASSERT_TRUE(at_a.now == a.next && at_a.begin == a.edges && at_b.now == b.next);
  ASSERT_EQ(at_a.alive_end - a.next, at_b.alive_end - b.next);
  ASSERT_EQ(at_a.alive_end[0].x, ActiveEdge::kNever);
  ASSERT_EQ(at_a.alive_end[1].x, ActiveEdge::kNever);
  expect_same_edges(a, b, at_a.alive_end - a.next);
  std::fill(b.pixels + at_b.left, b.pixels + width, b.words[0]);
  for (int i = 0; i < kWidest; ++i) ASSERT_EQ(a.pixels[i], i < width ? b.pixels[i] : 0xabcd) << "column " << i;
}

Line fast, slow;

// Looks of which some are another face's, and some of another material.
void make_looks(Random& random, Line& line) {
  for (std::uint16_t& color : colors) color = static_cast<std::uint16_t>(random.below(0x10000));
  for (std::uint16_t& color : other_colors) color = static_cast<std::uint16_t>(random.below(0x10000));
  line.slots[0] = 0;
  for (FaceId face = 1; face <= kFaces; ++face) {
    line.slots[face] = static_cast<std::uint8_t>(face);
    const auto part = [&] { return static_cast<std::uint32_t>(random.next()); };
    line.looks[face] = {{part(), part() >> 6, part() >> 6}, face, kKnown};
    if (random.percent(20)) line.looks[face] = FaceLook::flat(static_cast<std::uint16_t>(random.below(0x10000)));
    line.looks[face].face = random.percent(95) ? face : FaceId{1};
    if (random.percent(5)) line.looks[face].material = kOther;
  }
}

// Each face's place holds it, or one that it shares the place with.
void make_places(Random& random, Line& line) {
  for (FaceId face = 0; face <= kFaces; ++face) {
    const std::uint32_t place = face_place(face) % kPlaces;
    if (face >= kPlaces && random.percent(70)) continue;
    line.colors[place].face = face;
    line.colors[place].color = static_cast<std::uint16_t>(random.below(0x10000));
  }
}

// Chains whose heads are mostly the faces' own, the background's, too.
void make_heads(Random& random, Line& line) {
  line.looks[0] = {{}, 0, FaceLook::kUnknown};
  line.looks[kFaces] = FaceLook::flat(line.words[0]);
  for (FaceId face = 0; face <= kFaces; ++face) {
    const int look = random.percent(95) ? (face == 0 ? kFaces : face) : random.below(kFaces + 1);
    line.heads[LookChains::head_of(face)] = static_cast<std::uint8_t>(look);
  }
}

WalkStop walk_fast(LineWalk& walk, Kind kind, FaceId shown) {
  switch (kind) {
    case Kind::cells:
      return grid_walk<Cell>(walk, shown);
    case Kind::smooth:
      return smooth_walk(walk, shown);
    case Kind::smooth_cells:
      return smooth_grid_walk<Cell>(walk, shown);
    case Kind::band_flat:
      return band_flat_walk(walk, shown);
    case Kind::band_smooth:
      return band_smooth_walk(walk, shown);
    default:
      return flat_walk(walk, shown);
  }
}

WalkStop start_fast(LineWalk& walk, Kind kind) {
  if (kind == Kind::flat) return flat_line(walk);
  if (kind == Kind::smooth) return smooth_line(walk);
  if (kind == Kind::smooth_cells) return smooth_grid_line<Cell>(walk);
  if (kind == Kind::cells) return grid_line<Cell>(walk);
  walk.begin_line();
  return walk_fast(walk, kind, 0);
}

void compare(Kind kind) {
  int stops[5] = {0, 0, 0, 0, 0}, learned = 0;
  for (std::uint64_t seed = 0; seed < oracle::rounds(50000u); ++seed) {
    Random random(seed);
    const int width = random.between(1, kWidest - 8);
    const int alive = random.below(kMostEdges - 3), begun = random.percent(50) ? 0 : random.between(1, 3);
    make_edges(random, width, fast.edges, alive);
    make_edges(random, width, fast.edges + alive + 1, begun);
    for (std::uint16_t& word : fast.words) word = static_cast<std::uint16_t>(random.below(0x10000));
    for (std::uint16_t& pixel : fast.pixels) pixel = 0xabcd;
    if (is_smooth(kind)) make_looks(random, fast);
    if (kind == Kind::band_flat) make_places(random, fast);
    if (kind == Kind::band_smooth) make_heads(random, fast);
    fast.dipped = kKnown;
    fast.learned = 0;
    for (int i = 0; i <= kFaces && kind == Kind::cells; ++i) {
      fast.words[i] = fast.words[i & ~1];
      fast.cells[i / 2] = {fast.words[i], {}};
    }
    for (int i = 0; i <= kFaces && kind == Kind::smooth_cells; ++i) {
      fast.slots[i] = fast.slots[i & ~1];
      fast.cells[i / 2] = {static_cast<std::uint16_t>(fast.slots[i] << 8 | random.below(256)), {}};
    }
    slow = fast;
    const auto y = static_cast<std::uint16_t>(random.below(240));
    SmoothBrush brush;
    Learner<SmoothBrush> by_slots{fast, brush};
    brush = SmoothBrush(fast.looks, {fast.slots}, Learner<SmoothBrush>::learn, &by_slots);
    LookChains chains({fast.looks, kFaces}, {fast.heads, LookChains::kMostHeads - 1}, {});
    BandBrush band_brush;
    Learner<BandBrush> by_heads{fast, band_brush};
    band_brush = BandBrush(chains.looks(), {chains.heads()}, Learner<BandBrush>::learn, &by_heads);
    GridBrush<Cell> grid_brush(fast.looks, {fast.cells});
    if (has_slots(kind)) {
      brush.begin_line(y, fast.words[0]);
      grid_brush.begin_line(y, fast.words[0]);
    }
    band_brush.begin_line(y);
    brush.dip(kKnown, colors);
    band_brush.dip(kKnown, colors);
    grid_brush.dip(kKnown, colors);
    const FaceColors face_colors({fast.colors, kPlaces - 1}, learn_color, &fast);
    std::copy(std::begin(fast.looks), std::end(fast.looks), slow.looks);
    LineWalk at_fast = begin(fast, width, alive), at_slow = begin(slow, width, alive);
    if (kind == Kind::cells) at_fast.faces = fast.cells;
    at_fast.painter = kind == Kind::smooth         ? static_cast<const void*>(&brush)
                      : kind == Kind::smooth_cells ? static_cast<const void*>(&grid_brush)
                      : kind == Kind::band_smooth  ? static_cast<const void*>(&band_brush)
                                                   : &face_colors;
    WalkStop stop = start_fast(at_fast, kind);
    FaceId shown = 0;
    for (;; stop = walk_fast(at_fast, kind, shown)) {
      const WalkStop slowly = walk_slowly(at_slow, slow, y, kind, shown);
      ASSERT_TRUE(stop == slowly || (stop == WalkStop::end && slowly == WalkStop::side)) << "seed " << seed;
      ++stops[static_cast<unsigned>(stop)];
      ASSERT_EQ(fast.learned, slow.learned) << "seed " << seed;
      learned += fast.learned;
      if (stop == WalkStop::end) {
        expect_ended(fast, at_fast, slow, at_slow, width);
      } else {
        expect_same(fast, at_fast, slow, at_slow, width);
      }
      if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
      if (!goes_on(stop)) break;
      // Of several faces one is shown, or others have painted; what has no look is painted by others.
      shown = stop == WalkStop::front && random.percent(70) ? static_cast<FaceId>(1 + random.below(kFaces)) : FaceId{0};
      if (stop == WalkStop::tall || shown != 0) continue;
      for (const std::int32_t end = at_fast.next()->column(); at_fast.left < end; ++at_fast.left, ++at_slow.left) {
        fast.pixels[at_fast.left] = slow.pixels[at_fast.left] = 0x1234;
      }
    }
  }
  for (int i = 0; i < (knows_all(kind) || learns(kind) ? 3 : 4); ++i) EXPECT_GT(stops[i], 50) << i;
  EXPECT_EQ(learned > 50, learns(kind));
}

TEST(LineWalk, PaintsAndStepsAsPixelByPixel) { compare(Kind::flat); }

TEST(LineWalk, PaintsTheCellsOfGridsAsPixelByPixel) { compare(Kind::cells); }

TEST(LineWalk, PaintsSmoothSpansAsPixelByPixel) { compare(Kind::smooth); }

TEST(LineWalk, PaintsTheSmoothCellsOfGridsAsPixelByPixel) { compare(Kind::smooth_cells); }

TEST(LineWalk, PaintsFlatFacesOfBandsAsPixelByPixel) { compare(Kind::band_flat); }

TEST(LineWalk, PaintsSmoothFacesOfBandsAsPixelByPixel) { compare(Kind::band_smooth); }

}  // namespace
}  // namespace spanline::test
