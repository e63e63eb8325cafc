// Doubles to the engine's numbers: rounded to nearest, cut off at the ends of the type.
#pragma once

#include <cmath>
#include <cstdint>

#include "assetc/vec.hpp"
#include "core/fx/fixed.hpp"

namespace spanline::host {

inline std::int32_t round_to_int32(double value) {
  return static_cast<std::int32_t>(std::llround(std::clamp(value, double{INT32_MIN}, double{INT32_MAX})));
}

template <int F>
Fixed<F> to_fixed(double value) {
  return Fixed<F>::from_raw(round_to_int32(std::ldexp(value, F)));
}

template <int F>
void put(Fixed<F> (&out)[3], Vec3 v) {
  out[0] = to_fixed<F>(v.x);
  out[1] = to_fixed<F>(v.y);
  out[2] = to_fixed<F>(v.z);
}

}  // namespace spanline::host
