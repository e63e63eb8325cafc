// The contract of hal::OutPin. A Rig makes the pin and reads its level back: pin(), level().
#pragma once

#include <gtest/gtest.h>

#include "hal/concepts.hpp"

namespace spanline::hal {

template <typename Rig>
class OutPinContract : public testing::Test {
 protected:
  Rig rig_;
};
TYPED_TEST_SUITE_P(OutPinContract);

TYPED_TEST_P(OutPinContract, FollowsWhatIsSet) {
  static_assert(OutPin<std::remove_cvref_t<decltype(this->rig_.pin())>>);
  for (const bool level : {true, false, false, true, true}) {
    this->rig_.pin().set(level);
    EXPECT_EQ(this->rig_.level(), level);
  }
}

REGISTER_TYPED_TEST_SUITE_P(OutPinContract, FollowsWhatIsSet);

}  // namespace spanline::hal
