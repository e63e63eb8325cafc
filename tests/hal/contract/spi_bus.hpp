// The contract of hal::SpiBus. A Rig makes the bus and looks at the wire: bus(), wire() (every byte that crossed it),
// jam() (from now on the hardware is never ready) and kJammed (the fault that this ends in).
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "hal/concepts.hpp"

namespace spanline::hal {

template <typename Rig>
class SpiBusContract : public testing::Test {
 protected:
  using Bytes = std::vector<std::uint8_t>;
  static Slice<const std::uint8_t> view(const Bytes& bytes) {
    return {bytes.data(), static_cast<std::uint32_t>(bytes.size())};
  }
  static Bytes counting(std::size_t count) {
    Bytes bytes(count);
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + 1);
    return bytes;
  }

  Rig rig_;
};
TYPED_TEST_SUITE_P(SpiBusContract);

TYPED_TEST_P(SpiBusContract, ReachesAtMostTheClockAskedFor) {
  static_assert(SpiBus<std::remove_cvref_t<decltype(this->rig_.bus())>>);
  for (const std::uint32_t hz : {1'000'000u, 4'000'000u, 40'000'000u, 62'500'000u}) {
    const std::uint32_t reached = this->rig_.bus().set_clock(hz);
    EXPECT_GT(reached, 0u);
    EXPECT_LE(reached, hz);
  }
}

TYPED_TEST_P(SpiBusContract, WriteReturnsWhenAllHasLeft) {
  const auto bytes = this->counting(37);
  EXPECT_EQ(this->rig_.bus().write(this->view(bytes)), Fault::none);
  EXPECT_EQ(this->rig_.wire(), bytes);
}

TYPED_TEST_P(SpiBusContract, WaitEndsWhatStartBegan) {
  const auto first = this->counting(256), second = this->counting(3);
  auto both = first;
  both.insert(both.end(), second.begin(), second.end());
  EXPECT_EQ(this->rig_.bus().start(this->view(first)), Fault::none);
  EXPECT_EQ(this->rig_.bus().wait(), Fault::none);
  EXPECT_EQ(this->rig_.wire(), first);
  EXPECT_EQ(this->rig_.bus().start(this->view(second)), Fault::none);
  EXPECT_EQ(this->rig_.bus().wait(), Fault::none);
  EXPECT_EQ(this->rig_.wire(), both);
}

TYPED_TEST_P(SpiBusContract, WaitWithNothingStartedIsNoFault) {
  EXPECT_EQ(this->rig_.bus().wait(), Fault::none);
  EXPECT_EQ(this->rig_.bus().wait(), Fault::none);
}

TYPED_TEST_P(SpiBusContract, ABusThatIsNeverReadyEndsInItsFault) {
  const auto bytes = this->counting(100);
  this->rig_.jam();
  EXPECT_EQ(this->rig_.bus().write(this->view(bytes)), TypeParam::kJammed);
  Fault fault = this->rig_.bus().start(this->view(bytes));
  if (fault == Fault::none) fault = this->rig_.bus().wait();
  EXPECT_NE(fault, Fault::none);
}

REGISTER_TYPED_TEST_SUITE_P(SpiBusContract, ReachesAtMostTheClockAskedFor, WriteReturnsWhenAllHasLeft,
                            WaitEndsWhatStartBegan, WaitWithNothingStartedIsNoFault,
                            ABusThatIsNeverReadyEndsInItsFault);

}  // namespace spanline::hal
