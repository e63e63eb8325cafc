#include "core/curve/side.hpp"

namespace spanline {

CurveParameter::CurveParameter(std::uint32_t index, std::uint32_t steps) : steps_(steps) {
  CHECK(index <= steps && steps >= 1 && steps <= kMaxSteps);
  const auto i = static_cast<std::int32_t>(index), rest = static_cast<std::int32_t>(steps - index);
  weight_[0] = rest * rest * rest;
  weight_[1] = 3 * rest * rest * i;
  weight_[2] = 3 * rest * i * i;
  weight_[3] = i * i * i;
}

void CurveParameter::of_columns(const ClipPoint (&p)[4][4], const CurveScale& scale, ClipPoint (&out)[4]) const {
  if (weight_[0] == 0 || weight_[3] == 0) {
    for (int j = 0; j < 4; ++j) out[j] = p[weight_[0] == 0 ? 3 : 0][j];
  } else if (scale.is_short) {
    blend_columns<std::int32_t>(p, scale.down, out);
  } else {
    blend_columns<std::int64_t>(p, scale.down, out);
  }
}

// From registers what blend() has from memory, once for four points.
template <typename Int>
void CurveParameter::blend_columns(const ClipPoint (&p)[4][4], int down, ClipPoint (&out)[4]) const {
  const typename ScaledAxis<Int>::Scale scale{kCubes[steps_], down};
  const std::int32_t weight[4] = {weight_[0], weight_[1], weight_[2], weight_[3]};
  for (std::int32_t ClipPoint::*const axis : {&ClipPoint::x, &ClipPoint::y, &ClipPoint::w}) {
    for (int j = 0; j < 4; ++j) {
      out[j].*axis =
          ScaledAxis<Int>::weighted(p[0][j].*axis, p[1][j].*axis, p[2][j].*axis, p[3][j].*axis, weight, scale);
    }
  }
}

}  // namespace spanline
