// The contract of hal::SpiReads, and of a panel's driver on such a bus. A Rig makes the bus: bus(), answer(byte) (what
// comes in from now on) and mute() (nothing comes in any more).
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "hal/concepts.hpp"
#include "hal/panel/ili9341.hpp"

namespace spanline::hal {

template <typename Rig>
class SpiReadsContract : public testing::Test {
 protected:
  struct Time {
    void delay_us(std::uint32_t us) { now += us; }
    std::uint32_t now_us() const { return now; }
    std::uint32_t now = 0;
  };
  struct Level {
    void set(bool) {}
  };
  using Bus = std::remove_cvref_t<decltype(std::declval<Rig&>().bus())>;
  using Panel = Ili9341<Rotation::r0, Wires<Bus, Level, Level, Level, Time>>;

  Fault begin() { return Panel{{rig_.bus(), {}, {}, {}, time_}}.begin(); }

  Rig rig_;
  Time time_;
};
TYPED_TEST_SUITE_P(SpiReadsContract);

TYPED_TEST_P(SpiReadsContract, KeepsWhatComesInAndWritesAfterwards) {
  auto& bus = this->rig_.bus();
  static_assert(SpiReads<std::remove_cvref_t<decltype(bus)>>);
  this->rig_.answer(0xA5);
  const std::uint8_t command[] = {0x0A};
  EXPECT_EQ(bus.write(command), Fault::none);
  std::uint8_t came[3] = {};
  EXPECT_EQ(bus.read(came), Fault::none);
  for (const std::uint8_t byte : came) EXPECT_EQ(byte, 0xA5);
  EXPECT_EQ(bus.write(command), Fault::none);
  EXPECT_EQ(bus.start(command), Fault::none);
  EXPECT_EQ(bus.wait(), Fault::none);
}

TYPED_TEST_P(SpiReadsContract, WhereNothingComesInItIsAFault) {
  this->rig_.mute();
  std::uint8_t came[1] = {};
  EXPECT_EQ(this->rig_.bus().read(came), Fault::spi_timeout);
}

TYPED_TEST_P(SpiReadsContract, APanelThatDoesNotAnswerIsAbsent) {
  this->rig_.answer(0x9C);  // RDDPM: booster on, awake, normal mode, display on
  EXPECT_EQ(this->begin(), Fault::none);
  for (const std::uint8_t floating : {std::uint8_t{0xFF}, std::uint8_t{0x00}}) {
    this->rig_.answer(floating);
    EXPECT_EQ(this->begin(), Fault::panel_absent);
  }
}

REGISTER_TYPED_TEST_SUITE_P(SpiReadsContract, KeepsWhatComesInAndWritesAfterwards, WhereNothingComesInItIsAFault,
                            APanelThatDoesNotAnswerIsAbsent);

}  // namespace spanline::hal
