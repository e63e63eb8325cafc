// Points of a cubic at t = i / n, by sums that are n^3 times as large. A coordinate is R(n^3 * B(i/n)), the sum an
// exact integer and R the quotient to the nearest; seen from the curve's other end the sum is the same, so the point
// is, too.
//
// Sums of 64 bits always do. Those of 32 bits take the control points with as many bits as leave room for n^3
// (CurveScale), and wrap as they like on the way.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "core/curve/basis.hpp"
#include "core/fx/bits.hpp"

namespace spanline {

// Most steps of a curve. A curve that would need more (a patch that fills the screen many times over) is stepped that
// often and no more: its chords are then coarser than asked for, on both sides of a joint alike.
inline constexpr std::uint32_t kMaxSteps = 64;

// 1 / n^3 as factor / 2^(32 + shift), factor in [2^30, 2^31) and n^3 <= 2^(shift + 2); n at least 2.
struct Cube {
  std::int32_t factor;
  std::int32_t shift;
};
inline constexpr auto kCubes = [] {
  std::array<Cube, kMaxSteps + 1> cubes{};
  for (std::uint32_t n = 2; n <= kMaxSteps; ++n) {
    const std::uint32_t cube = n * n * n;
    const auto shift = static_cast<int>(std::bit_width(cube - 1)) - 2;
    cubes[n] = {static_cast<std::int32_t>(((std::uint64_t{1} << (32 + shift)) + cube / 2) / cube), shift};
  }
  return cubes;
}();
static_assert(kCubes[2].factor == 1 << 30 && kCubes[2].shift == 1 && kCubes[kMaxSteps].shift == 16);

// One coordinate of a curve. Int: 64 bits, or 32, which hold n^3 times control points without their last `down` bits.
template <typename Int>
class ScaledAxis {
 public:
  // How coordinates are scaled: by 1 / n^3, and in 32 bits by what was cut off, too.
  struct Scale {
    Cube cube{};
    int down = 0;

    Scale() = default;
    Scale(std::uint32_t steps, int cut_off) : cube(kCubes[steps]), down(cut_off) {
      if constexpr (sizeof(Int) == 4) {
        const int excess = cube.shift - down;
        cube = {static_cast<std::int32_t>((bits(cube.factor, 0) + (Bits{1} << excess >> 1)) >> excess), 0};
      }
    }
  };

  ScaledAxis() = default;
  ScaledAxis(std::int32_t p0, std::int32_t p1, std::int32_t p2, std::int32_t p3, std::uint32_t steps, int down) {
    const Bits n = steps, q0 = bits(p0, down), q1 = bits(p1, down), q2 = bits(p2, down), q3 = bits(p3, down);
    const Bits a1 = 3 * (q1 - q0), a2 = 3 * (q0 - 2 * q1 + q2), a3 = q3 - q0 + 3 * (q1 - q2), six = 6 * a3;
    b_ = {word(n * n * n * q0), word((a1 * n + a2) * n + a3), word(2 * a2 * n + six), word(six)};
  }

  void step() { b_.step(); }
  std::int32_t at(const Scale& scale) const { return rounded(b_.b0.value(), scale); }

  // The coordinate of the sum with these weights, which add up to n^3.
  static std::int32_t weighted(std::int32_t p0, std::int32_t p1, std::int32_t p2, std::int32_t p3,
                               const std::int32_t (&weight)[4], const Scale& scale) {
    const auto term = [&](int i, std::int32_t p) { return bits(weight[i], 0) * bits(p, scale.down); };
    return rounded(static_cast<Int>(term(0, p0) + term(1, p1) + term(2, p2) + term(3, p3)), scale);
  }

 private:
  using Bits = std::make_unsigned_t<Int>;
  static constexpr Bits bits(std::int32_t v, int down) { return static_cast<Bits>(Int{v >> down}); }
  static constexpr Word<Int> word(Bits v) { return Word<Int>(static_cast<Int>(v)); }

  static std::int32_t rounded(Int sum, const Scale& scale) {
    if constexpr (sizeof(Int) == 4) {
      return mul_high_round(sum, scale.cube.factor);
    } else {
      const std::uint64_t low =
          std::uint64_t{static_cast<std::uint32_t>(sum)} * static_cast<std::uint32_t>(scale.cube.factor);
      const std::int64_t high = (sum >> 32) * scale.cube.factor + static_cast<std::int64_t>(low >> 32);
      return saturate32(shift_round(high, scale.cube.shift));
    }
  }

  CurveBasis<Int> b_;
};

}  // namespace spanline
