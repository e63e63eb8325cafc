#include "hal/mcu/systick.hpp"

#include "boards/fake_io.hpp"
#include "hal/contract/clock.hpp"

namespace spanline::hal {
namespace {

constexpr std::uint32_t kValue = 0xE000E018;
using Time = SysTick<FakeIo, 50'000'000>;

// Counts down by 70 cycles at each look and calls the interrupt where it wraps.
class Core : public FakeDevice {
 private:
  std::uint32_t get(std::uint32_t address) override {
    if (address != kValue) return words_[address];
    if (left_ < 70) {
      left_ += 50'000;
      Time::tick();
    }
    return left_ -= 70;
  }
  std::uint32_t left_ = 49'999;
};

class Rig {
 public:
  Rig() { Time::begin(); }
  Time& clock() { return time_; }

 private:
  Core core_;
  Time time_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(SysTick, ClockContract, Rig);

TEST(SysTick, BeginsWithAMillisecond) {
  FakeDevice core;
  Time::begin();
  EXPECT_EQ(core.read(0xE000E014), 49'999u);
  EXPECT_EQ(core.read(0xE000E010), 7u);
}

TEST(SysTick, ATimerThatStandsStillCannotHoldUpADelay) {
  FakeDevice core;
  Time time;
  time.delay_us(100);
  EXPECT_LT(core.reads(), 20'000u);
}

}  // namespace
}  // namespace spanline::hal
