// The contract of hal::Clock. A Rig makes the clock: clock(). Its time may be simulated.
#pragma once

#include <gtest/gtest.h>

#include "hal/concepts.hpp"

namespace spanline::hal {

template <typename Rig>
class ClockContract : public testing::Test {
 protected:
  Rig rig_;
};
TYPED_TEST_SUITE_P(ClockContract);

TYPED_TEST_P(ClockContract, WaitsAtLeastThatLong) {
  static_assert(Clock<std::remove_cvref_t<decltype(this->rig_.clock())>>);
  auto&& clock = this->rig_.clock();
  for (const std::uint32_t us : {0u, 1u, 7u, 999u, 20'000u}) {
    const std::uint32_t before = clock.now_us();
    clock.delay_us(us);
    EXPECT_GE(clock.now_us() - before, us);  // modulo 2^32, as the clock wraps
  }
}

REGISTER_TYPED_TEST_SUITE_P(ClockContract, WaitsAtLeastThatLong);

}  // namespace spanline::hal
