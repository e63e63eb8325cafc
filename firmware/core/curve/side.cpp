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

}  // namespace spanline
