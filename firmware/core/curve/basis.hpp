// The forward-difference basis: f(t) = b0 + b1 * t + b2 * t(t-1)/2 + b3 * t(t-1)(t-2)/6, t counted in steps (seed 3,
// equation 4.3; Lien, Shantz and Pratt 1987). The seed prints halving and doubling exchanged (5.1, 5.2).
//
// With integer control points and at most k halvings every difference is a multiple of 2^-3k, so with 3k fraction bits
// every operator below is exact in any order: nothing is rounded, nothing drifts, joints meet to the bit.
#pragma once

#include <cstdint>
#include <type_traits>

namespace spanline {

// A register: sums wrap, because the differences after the very last step may leave the range that is in use while
// walking and then wrap back; a right shift keeps the sign.
template <typename Int>
class Word {
  static_assert(std::is_signed_v<Int> && sizeof(Int) >= sizeof(int), "narrower ones would be promoted");
  using Bits = std::make_unsigned_t<Int>;

 public:
  static constexpr int kBits = static_cast<int>(sizeof(Int)) * 8;

  constexpr Word() = default;
  constexpr explicit Word(Int value) : bits_(static_cast<Bits>(value)) {}
  constexpr Int value() const { return static_cast<Int>(bits_); }

  friend constexpr Word operator+(Word a, Word b) { return Word(static_cast<Int>(a.bits_ + b.bits_)); }
  friend constexpr Word operator-(Word a, Word b) { return Word(static_cast<Int>(a.bits_ - b.bits_)); }
  friend constexpr Word operator<<(Word a, int count) { return Word(static_cast<Int>(a.bits_ << count)); }
  friend constexpr Word operator>>(Word a, int count) { return Word(a.value() >> count); }
  friend constexpr bool operator==(Word, Word) = default;

 private:
  Bits bits_ = 0;
};

// T is a Word for a curve, and for a surface a Basis itself: the differences in u of the differences in v.
template <typename T>
struct Basis {
  T b0{}, b1{}, b2{}, b3{};

  // E: moves on by one step.
  constexpr void step() {
    b0 = b0 + b1;
    b1 = b1 + b2;
    b2 = b2 + b3;
  }

  // Steps become half as long: b1/2 - b2/8 + b3/16, b2/4 - b3/8, b3/8, so ordered that each shift is exact.
  constexpr void halve() {
    b2 = (b2 - (b3 >> 1)) >> 2;
    b1 = (b1 - b2) >> 1;
    b3 = b3 >> 3;
  }

  // Steps become twice as long: the inverse of halve().
  constexpr void double_step() {
    b1 = (b1 << 1) + b2;
    b2 = (b2 + b3) << 2;
    b3 = b3 << 3;
  }

  // For a piece that is one step long: leaves its first half here and returns the second.
  constexpr Basis split() {
    halve();
    Basis right = *this;
    right.step();
    return right;
  }

  friend constexpr Basis operator+(const Basis& a, const Basis& b) {
    return {a.b0 + b.b0, a.b1 + b.b1, a.b2 + b.b2, a.b3 + b.b3};
  }
  friend constexpr Basis operator-(const Basis& a, const Basis& b) {
    return {a.b0 - b.b0, a.b1 - b.b1, a.b2 - b.b2, a.b3 - b.b3};
  }
  friend constexpr Basis operator<<(const Basis& a, int n) { return {a.b0 << n, a.b1 << n, a.b2 << n, a.b3 << n}; }
  friend constexpr Basis operator>>(const Basis& a, int n) { return {a.b0 >> n, a.b1 >> n, a.b2 >> n, a.b3 >> n}; }
  friend constexpr bool operator==(const Basis&, const Basis&) = default;
};

template <typename Int>
using CurveBasis = Basis<Word<Int>>;
template <typename Int>
using SurfaceBasis = Basis<Basis<Word<Int>>>;

// The operators in the other direction of a surface.
template <typename T>
constexpr void step_inner(Basis<Basis<T>>& s) {
  s.b0.step(), s.b1.step(), s.b2.step(), s.b3.step();
}
template <typename T>
constexpr void halve_inner(Basis<Basis<T>>& s) {
  s.b0.halve(), s.b1.halve(), s.b2.halve(), s.b3.halve();
}
template <typename T>
constexpr void double_inner(Basis<Basis<T>>& s) {
  s.b0.double_step(), s.b1.double_step(), s.b2.double_step(), s.b3.double_step();
}

// A walk starts here: from level 2 on (steps of a quarter and shorter) the differences stay within the range of the
// control points, so that no head-room is needed. For range R and steps h, |b1| <= 3hR, |b2| <= 12hhR, |b3| <= 24hhhR.
inline constexpr int kFirstLevel = 2;

// The finest level k that is exact in `register_bits`, for control points of `coordinate_bits` (sign and subpixels
// included: |p| <= 2^(coordinate_bits - 1)). In range R = 2^coordinate_bits every register, and what halve() passes
// through, stays within 3/4 R from level 2 on.
constexpr int curve_levels(int register_bits, int coordinate_bits) { return (register_bits - 1 - coordinate_bits) / 3; }

// Likewise the sum of the levels in u and v of a surface, both from level 2 on: the operators' norms on control points
// of size R/2 are at most 3/2 in each direction, 9/4 * R/2 = 9/8 R in both.
constexpr int surface_levels(int register_bits, int coordinate_bits) {
  return (register_bits - 2 - coordinate_bits) / 3;
}

// The differences of a Bezier curve at `level` with `fraction` fraction bits; level >= 0, fraction >= 3 * level. The
// control points may be Bases: first each row of a patch, then the rows.
template <typename T>
constexpr Basis<T> bezier_basis(const T& p0, const T& p1, const T& p2, const T& p3, int fraction, int level) {
  const auto three = [](const T& v) { return v + (v << 1); };
  const T a1 = three(p1 - p0);
  const T a2 = three((p2 - p1) - (p1 - p0));
  const T a3 = (p3 - p0) - three(p2 - p1);
  const T cube = a3 << (fraction - 3 * level);
  const T square = a2 << (fraction - 2 * level);
  const T six = three(cube) << 1;
  return {p0 << fraction, (a1 << (fraction - level)) + square + cube, (square << 1) + six, six};
}

// A curve's registers with their width proved: at most kFinest halvings from level 0 of control points of
// kCoordinateBits.
template <typename Int, int kCoordinateBits, int kFinest>
struct CurveFormat {
  static_assert(kFinest >= kFirstLevel);
  static_assert(kFinest <= curve_levels(Word<Int>::kBits, kCoordinateBits), "the registers would overflow");
  static constexpr int kFraction = 3 * kFinest;

  // At level kFirstLevel.
  static constexpr CurveBasis<Int> start(const Int (&p)[4]) {
    using W = Word<Int>;
    return bezier_basis(W(p[0]), W(p[1]), W(p[2]), W(p[3]), kFraction, kFirstLevel);
  }
};

// A bicubic surface's registers: kFinestU halvings of the outer, kFinestV of the inner direction.
template <typename Int, int kCoordinateBits, int kFinestU, int kFinestV>
struct SurfaceFormat {
  static_assert(kFinestU >= kFirstLevel && kFinestV >= kFirstLevel);
  static_assert(kFinestU + kFinestV <= surface_levels(Word<Int>::kBits, kCoordinateBits),
                "the registers would overflow");
  static constexpr int kFraction = 3 * (kFinestU + kFinestV);

  // At level kFirstLevel in both directions; p[i][j], i along u.
  static constexpr SurfaceBasis<Int> start(const Int (&p)[4][4]) {
    using W = Word<Int>;
    const auto row = [&](int i) {
      return bezier_basis(W(p[i][0]), W(p[i][1]), W(p[i][2]), W(p[i][3]), 3 * kFinestV, kFirstLevel);
    };
    return bezier_basis(row(0), row(1), row(2), row(3), 3 * kFinestU, kFirstLevel);
  }
};

// What the widths come to: 9 + 4 bits are 512 px of 1/16 px (320 x 240 and 480 x 320 screens), 10 + 4 are 1024 px.
static_assert(curve_levels(32, 9 + 4) == 6 && curve_levels(32, 9 + 8) == 4 && curve_levels(32, 10 + 4) == 5);
static_assert(surface_levels(64, 9 + 4) == 16 && surface_levels(64, 9 + 8) == 15 && surface_levels(64, 10 + 4) == 16);

}  // namespace spanline
