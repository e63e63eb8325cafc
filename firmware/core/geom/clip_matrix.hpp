// The matrix from mesh units to clip space, and its rows made ready for many positions.
#pragma once

#include <cstdint>
#include <type_traits>

#include "core/fx/bits.hpp"
#include "core/scene/format.hpp"

namespace spanline {

// A point in clip space: x right, y down, w the distance along the view direction; Q16.16, x and y in units of the
// guard band.
struct ClipPoint {
  std::int32_t x, y, w;
};

// Mesh units to clip space: clip = (linear * position) + offset.
struct ClipMatrix {
  std::int32_t linear[3][3];  // Q1.31 world units a mesh unit, rows x, y (scaled by the focal length) and w
  std::int32_t offset[3];     // Q16.16

  // Point: a Position, or what lies a little outside the positions: |x|, |y|, |z| < 2^24 mesh units.
  template <typename Point>
  std::int32_t row(int i, const Point& p) const {
    // The offset and the rounding begin the sum, which is then one chain of multiply-adds.
    const std::int64_t sum = std::int64_t{offset[i]} * (1 << 15) + (1 << 14) + std::int64_t{linear[i][0]} * p.x +
                             std::int64_t{linear[i][1]} * p.y + std::int64_t{linear[i][2]} * p.z;  // Q17.31
    return saturate32(sum >> 15);
  }
  // How far from its offset a row may be, whatever the position (|position| <= 2^15).
  std::int64_t reach(int i) const {
    std::int64_t reach = 1;
    for (const std::int32_t c : linear[i]) reach += (c < 0 ? -std::int64_t{c} : c) + 1;
    return reach;
  }
  // Whether no position saturates, and a mesh unit is less than half a world unit.
  bool fits() const;
  std::int64_t farthest(int i) const { return (offset[i] < 0 ? -std::int64_t{offset[i]} : offset[i]) + reach(i); }
  template <typename Point>
  ClipPoint operator()(const Point& p) const {
    return {row(0, p), row(1, p), row(2, p)};
  }
};

// A row of a matrix that fits(), made ready for many positions: at() is ClipMatrix::row(). In 64 bits,
class LongRow {
 public:
  LongRow() = default;
  LongRow(const ClipMatrix& matrix, int row);

  std::int32_t at(const Position& p) const {
    const std::int64_t sum =
        start_ + std::int64_t{linear_[0]} * p.x + std::int64_t{linear_[1]} * p.y + std::int64_t{linear_[2]} * p.z;
    return static_cast<std::int32_t>(sum >> 15);
  }

 private:
  std::int64_t start_ = 0;  // Q17.31
  std::int32_t linear_[3] = {0, 0, 0};
};

// or by products of 32 bits: with c = high * 2^15 + low, the sum of c * p over 2^15 is that of high * p, which wraps as
// it likes where the result fits, and that of low * p over 2^15,
struct CoefficientParts {
  explicit constexpr CoefficientParts(std::int32_t c)
      : high((c >> 15) + (c >> 14 & 1)),
        low(static_cast<std::int32_t>(std::int64_t{c} - std::int64_t{high} * (1 << 15))) {}
  std::int32_t high;
  std::int32_t low;  // -2^14 … 2^14 - 1
};

class SplitRow {
 public:
  SplitRow() = default;
  SplitRow(const ClipMatrix& matrix, int row);

  std::int32_t at(const Position& p) const {
    static_assert(3 * (std::int64_t{1} << 14) * (1 << 15) + (1 << 14) <= INT32_MAX);
    const std::int32_t low = low_[0] * p.x + low_[1] * p.y + low_[2] * p.z + (1 << 14);
    const auto times = [](std::uint32_t c, std::int32_t v) { return c * static_cast<std::uint32_t>(v); };
    return static_cast<std::int32_t>(offset_ + times(high_[0], p.x) + times(high_[1], p.y) + times(high_[2], p.z) +
                                     static_cast<std::uint32_t>(low >> 15));
  }

 private:
  std::uint32_t offset_ = 0;  // Q16.16
  std::uint32_t high_[3] = {0, 0, 0};
  std::int32_t low_[3] = {0, 0, 0};
};

// or by products of 16 bits, two at a time, with the same parts of c, of which the higher fits 16 bits, too.
class PackedRow {
 public:
  PackedRow() = default;
  PackedRow(const ClipMatrix& matrix, int row);

  std::int32_t at(const Position& p) const {
    const std::uint32_t xy = first_two(p);
    const std::uint32_t high = add_products(high_xy_, xy, offset_);
    const std::uint32_t low = add_products(low_xy_, xy, 1 << 14) + static_cast<std::uint32_t>(high_half(z_) * p.z);
    return static_cast<std::int32_t>(high + static_cast<std::uint32_t>(low_half(z_) * p.z) +
                                     static_cast<std::uint32_t>(static_cast<std::int32_t>(low) >> 15));
  }
  // x below y.
  static std::uint32_t first_two(const Position& p) {
    std::uint32_t xy;
    __builtin_memcpy(&xy, &p, sizeof xy);
    return xy;
  }

 private:
  std::uint32_t offset_ = 0;                        // Q16.16
  std::uint32_t high_xy_ = 0, low_xy_ = 0, z_ = 0;  // of z the higher part in the lower half
};

using ClipRow = std::conditional_t<kDualMultiply, PackedRow, std::conditional_t<kLongMultiply, LongRow, SplitRow>>;

// A row for comparing, without products of 64 bits: at() is the row as Q(16 - up).(16 + up), off by less than kError.
class RoughRow {
 public:
  static constexpr std::int32_t kError = 1 << 16;

  // The most that positions of such a row (ClipMatrix::farthest) can go up.
  static int most_up(std::int32_t farthest) {
    int up = 0;
    while (up < 15 && farthest >> (29 - up) == 0) ++up;
    return up;
  }

  RoughRow() = default;
  RoughRow(const ClipMatrix& matrix, int row, int up) : offset_(matrix.offset[row] * (1 << up)) {
    // Three coefficients are off by half a unit each, times 2^15; row() rounds by half of 2^up more.
    static_assert(3 * (1 << 14) + (1 << 14) <= kError);
    for (int i = 0; i < 3; ++i) {
      const std::int32_t c = matrix.linear[row][i];
      linear_[i] = up == 15 ? c : (c >> (15 - up)) + (c >> (14 - up) & 1);
    }
  }

  // Sums wrap on the way.
  std::int32_t at(const Position& p) const {
    const auto times = [](std::int32_t c, std::int32_t v) {
      return static_cast<std::uint32_t>(c) * static_cast<std::uint32_t>(v);
    };
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(offset_) + times(linear_[0], p.x) +
                                     times(linear_[1], p.y) + times(linear_[2], p.z));
  }

 private:
  std::int32_t offset_ = 0, linear_[3] = {0, 0, 0};
};

// Three rows at once.
template <typename Row>
ClipPoint at(const Row (&rows)[3], const Position& p) {
  return {rows[0].at(p), rows[1].at(p), rows[2].at(p)};
}
#if defined(__ARM_FEATURE_SIMD32)
// Compilers load a row's words one by one, and take a line of assembly for one instruction, so that a macro of the
// assembler's would put what is behind it out of a short branch's reach.
#define SPANLINE_PACKED_ROW(sum)      \
  "ldm %[row]!, {r3, r4, r5, r6}\n\t" \
  "smlad r3, r4, %[xy], r3\n\t"       \
  "smlad r5, r5, %[xy], %[half]\n\t"  \
  "smlabb r3, r6, %[z], r3\n\t"       \
  "smlatb r5, r6, %[z], r5\n\t"       \
  "add " sum ", r3, r5, asr #15\n\t"
inline ClipPoint at(const PackedRow (&rows)[3], const Position& p) {
  ClipPoint out;
  const PackedRow* row = rows;
  asm(SPANLINE_PACKED_ROW("%[x]") SPANLINE_PACKED_ROW("%[y]") SPANLINE_PACKED_ROW("%[w]")
      : [row] "+r"(row), [x] "=&r"(out.x), [y] "=&r"(out.y), [w] "=r"(out.w)
      : "m"(rows), [xy] "r"(PackedRow::first_two(p)), [z] "r"(p.z), [half] "r"(1 << 14)
      : "r3", "r4", "r5", "r6");
  return out;
}
#undef SPANLINE_PACKED_ROW
#endif

// A matrix that fits(), made ready for many positions.
class ClipRows {
 public:
  ClipRows() = default;
  explicit ClipRows(const ClipMatrix& matrix);
  ClipPoint operator()(const Position& p) const { return at(rows_, p); }
  const ClipRow& ahead() const { return rows_[2]; }  // that leads to w

 private:
  ClipRow rows_[3];
};

}  // namespace spanline
