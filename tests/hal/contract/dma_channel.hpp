// The contract of hal::DmaChannel. A Rig makes the channel and plays its hardware: dma(), finish() (the transfer
// completes), fail() (the controller reports an error), moved() (the bytes that reached the peripheral).
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "hal/concepts.hpp"

namespace spanline::hal {

template <typename Rig>
class DmaChannelContract : public testing::Test {
 protected:
  static constexpr std::uint8_t kBytes[] = {1, 2, 3, 250};
  Rig rig_;
};
TYPED_TEST_SUITE_P(DmaChannelContract);

TYPED_TEST_P(DmaChannelContract, IsBusyFromStartToTheEnd) {
  static_assert(DmaChannel<std::remove_cvref_t<decltype(this->rig_.dma())>>);
  EXPECT_FALSE(this->rig_.dma().busy());
  EXPECT_EQ(this->rig_.dma().start(this->kBytes), Fault::none);
  EXPECT_TRUE(this->rig_.dma().busy());
  this->rig_.finish();
  EXPECT_FALSE(this->rig_.dma().busy());
  EXPECT_EQ(this->rig_.dma().fault(), Fault::none);
  EXPECT_EQ(this->rig_.moved(), std::vector<std::uint8_t>(std::begin(this->kBytes), std::end(this->kBytes)));
}

TYPED_TEST_P(DmaChannelContract, RefusesASecondStart) {
  EXPECT_EQ(this->rig_.dma().start(this->kBytes), Fault::none);
  EXPECT_EQ(this->rig_.dma().start(this->kBytes), Fault::dma_error);
}

TYPED_TEST_P(DmaChannelContract, ReportsAnErrorAndStartsAfresh) {
  EXPECT_EQ(this->rig_.dma().start(this->kBytes), Fault::none);
  this->rig_.fail();
  EXPECT_FALSE(this->rig_.dma().busy());
  EXPECT_EQ(this->rig_.dma().fault(), Fault::dma_error);
  EXPECT_EQ(this->rig_.dma().start(this->kBytes), Fault::none);
  this->rig_.finish();
  EXPECT_EQ(this->rig_.dma().fault(), Fault::none);
}

REGISTER_TYPED_TEST_SUITE_P(DmaChannelContract, IsBusyFromStartToTheEnd, RefusesASecondStart,
                            ReportsAnErrorAndStartsAfresh);

}  // namespace spanline::hal
