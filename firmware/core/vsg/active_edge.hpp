// Edges as the edge walker steps them: 12.20 fixed point, one addition a line, and still in the exact column on every
// line.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/base/check.hpp"
#include "core/fx/bits.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

// What covers a pixel column, as a sum over the faces that do: their count above, their ids below. With at most one
// face the low half is its id, and there is neither list nor look-up.
using CoverKey = std::uint32_t;
using FaceId = std::uint16_t;  // 1 + the face's number in the scene; 0: none

inline constexpr int kCoverCount = 20;                             // where the count stands
inline constexpr CoverKey kTwoFaces = CoverKey{2} << kCoverCount;  // keys below: one face or none
// n ids add up to less than n << 16, so a key of two faces and more never looks like less.
static_assert(kCoverCount >= 16);

constexpr CoverKey cover_of(FaceId face) { return face == 0 ? 0u : (CoverKey{1} << kCoverCount) + face; }
constexpr FaceId only_face(CoverKey key) { return static_cast<FaceId>(key); }

// An edge on a scan line. x is where it meets the line's centre, less half a pixel, plus a pixel less a unit: so
// x >> 20 is the first column whose centre is not left of it.
struct ActiveEdge {
  static constexpr int kFraction = 20;
  static constexpr std::int32_t kNever = INT32_MAX;  // x of the sentinel at an array's end
  static constexpr std::uint32_t kOneLine = 1u << 17;
  static constexpr std::uint32_t kTall = 1u << 16;

  std::int32_t x;   // Q12.20 px
  std::int32_t dx;  // a line
  CoverKey toggle;  // what it adds to the key: the face that begins less the one that ends
  std::uint32_t
      rest;  // lines after this one until it ends (or is begun again, where kTall), kTall, the FaceId that ends

  std::int32_t column() const { return x >> kFraction; }
  FaceId ending() const { return static_cast<FaceId>(rest); }
  FaceId beginning() const { return only_face(toggle + rest); }  // toggle's low half: what begins less what ends
};
static_assert(sizeof(ActiveEdge) == 16);

// Where an edge runs: of ActiveEdge, for lines from the one it was made for on.
struct EdgeRun {
  std::int32_t x, dx;
  std::int32_t lines;  // that x + n * dx holds for, 1 at least
};

// With D = 16 dy, where an edge meets a line is a multiple of 1 / D px: a place that is not a pixel's lies at least
// 2^20 / D = 65536 / dy units right of one. The slope is cut off towards minus infinity, so x falls behind by less than
// a unit a line, and by less than one at the start; while x is behind by less than 65536 / dy - 1 the column is exact.
// From its upper end an edge has dy / 16 lines, so one of
inline constexpr std::int32_t kTallEdge = 1000;  // 28.4
// is exact all the way, and a taller one for 65536 / dy - 1 lines from any line where x is exact.
static_assert(65536 / kTallEdge - 1 >= (kTallEdge + 15) / 16 + 1);
constexpr std::int32_t exact_lines(std::int32_t dy) {
  const std::int32_t lines = 65536 / dy - 1;
  return lines > 1 ? lines : 1;
}
static_assert(65536 / 32768 >= 2, "and for one line at any height that the guard band allows");

// The run of an edge from `line`, one of its own lines, on; for edges of any height and slope.
EdgeRun start_run(ScreenXY top, ScreenXY bottom, std::int32_t line);

// The slope of a short edge by a table, where a divide costs more. It is cut off by more than a unit, which is no
// matter for edges of few lines.
class SlopeByTable {
 public:
  static constexpr std::int32_t kTallest = 256;  // dy, and a quarter of dx, of these is less
  static constexpr int kShiftBits = 8;

  static std::int32_t of(std::int32_t dx, std::int32_t dy) {
    const std::uint32_t entry = kReciprocals[static_cast<std::uint32_t>(dy)];
    // An edge to the left runs by the next greater reciprocal, so that the slope is never too great.
    return dx * (static_cast<std::int32_t>(entry >> kShiftBits) - (dx >> 31)) >> (entry & ((1u << kShiftBits) - 1));
  }

  // Whether x, behind by so much a line and a unit at the start, stays in the exact column.
  static constexpr bool stays_exact() {
    for (std::uint32_t dy = 1; dy < kTallest; ++dy) {
      const std::uint32_t a_line = 4 * kTallest / std::bit_floor(dy) + 2;
      if (a_line * (dy / kSubpixels + 1) + 1 >= 65536 / dy - 1) return false;
    }
    return true;
  }

 private:
  // 2^(20 + shift) / dy, with the shift that leaves it 20 bits or 2^20, above the shift.
  static const std::array<std::uint32_t, kTallest> kReciprocals asm("spanline_reciprocals");
  static constexpr std::uint32_t reciprocal(std::uint32_t dy) {
    const auto shift = static_cast<std::uint32_t>(std::bit_width(dy) - 1);
    return ((1u << (20 + shift)) / dy) << kShiftBits | shift;
  }
};
static_assert(SlopeByTable::stays_exact());

// The runs of the edges that begin in one vertex.
class FromVertex {
 public:
  FromVertex(PackedXY top, std::int32_t line)
      : x_(top.word << 16), centre_(line * kSubpixels + kSubpixels / 2), before_(centre_ - top.y()) {}

  // Whether an edge to there has ended before the line.
  bool has_ended(PackedXY bottom) const { return bottom.y() <= centre_; }

  static constexpr std::int32_t kShort = 512;  // dy, and half of dx, of edges that one divide begins

  // Makes an edge to `bottom` what it is on the line; `ending`: the face that ends. One divide, or none, where the edge
  // is short.
  template <bool kDivide = kDivides>
  void run(ActiveEdge& edge, PackedXY bottom, std::uint32_t ending) const {
    const std::int32_t below = bottom.y() - centre_;
    const std::uint32_t across = (bottom.word << 16) - x_;  // dx, in the upper half: |dx| <= 2^15, which is far
    const std::int32_t dy = below + before_;
    if (!is_short<kDivide>(across, dy)) [[unlikely]] {
      edge.x = static_cast<std::int32_t>(bottom.word);
      edge.rest = ending;
      return run_far(edge, static_cast<std::uint32_t>(centre_ - before_) << 16 | x_ >> 16, centre_);
    }
    const auto dx = static_cast<std::int32_t>(across) >> 16;
    const std::int32_t slope = kDivide ? static_cast<std::int32_t>(across << 4) / dy - 1 : SlopeByTable::of(dx, dy);
    static_assert(1024 * std::int64_t{(1 << 20) + 1} <= INT32_MAX, "dx times a reciprocal");
    // Before < dy: the product stays within dx.
    edge.x = static_cast<std::int32_t>(x_ + static_cast<std::uint32_t>((slope * before_) >> 4)) + kLessHalf;
    edge.dx = slope;
    edge.rest = ending + static_cast<std::uint32_t>((below - 1) >> 4) * ActiveEdge::kOneLine;  // lines after this one
  }

 private:
  // From a point to ActiveEdge::x: half a pixel less, a pixel less a unit more.
  static constexpr std::int32_t kLessHalf = (1 << ActiveEdge::kFraction) / 2 - 1;

  template <bool kDivide>
  static bool is_short(std::uint32_t across, std::int32_t dy) {
    const std::uint32_t wide = across ^ static_cast<std::uint32_t>(static_cast<std::int32_t>(across) >> 31);
    const auto tall = static_cast<std::uint32_t>(dy);
    return kDivide ? (wide >> 17 | tall) < std::uint32_t{kShort}
                   : (wide >> 18 | tall) < std::uint32_t{SlopeByTable::kTallest};
  }
  static_assert(kShort / 2 == SlopeByTable::kTallest, "dx is less than 64 px");

  // edge.x: where it ends, edge.rest: the face that does. Both points are PackedXY. By values, so that nothing here
  // needs a place in memory.
  static void run_far(ActiveEdge& edge, std::uint32_t top, std::int32_t centre) asm("spanline_run_far");

  // A quotient that is cut off towards 0, less one, is never too great, and falls behind by less than two units a line.
  static_assert(2 * ((kShort + 15) / kSubpixels + 1) + 1 <= 65536 / kShort - 1);

  std::uint32_t x_;      // of the vertex: 28.4 in the upper half
  std::int32_t centre_;  // of the line, 28.4
  std::int32_t before_;  // from the vertex to there
};

}  // namespace spanline
