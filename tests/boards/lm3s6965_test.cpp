#include "hal/mcu/lm3s6965/lm3s6965.hpp"

#include "boards/fake_io.hpp"
#include "boards/pl022_model.hpp"
#include "hal/contract/out_pin.hpp"
#include "hal/contract/spi_bus.hpp"

namespace spanline::hal {
namespace {

using namespace lm3s6965;

constexpr std::uint32_t kRawInterrupt = 0x400FE050, kRunClock = 0x400FE060, kLocked = 1u << 6;

class Lm3s6965 : public FakeDevice {
 public:
  Lm3s6965() { words_[kRunClock] = 0x078E3AD1; }  // as after reset
  Pl022Model ssi{0x40008000};
  std::uint32_t word(std::uint32_t address) { return words_[address]; }

 private:
  std::uint32_t get(std::uint32_t address) override { return ssi.owns(address) ? ssi.get(address) : words_[address]; }
  void set(std::uint32_t address, std::uint32_t value) override {
    if (ssi.owns(address)) return ssi.set(address, value);
    if (address == kRunClock && (words_[kRunClock] & 1u << 13) != 0 && (value & 1u << 13) == 0)
      words_[kRawInterrupt] = kLocked;
    if (address >= 0x40006000 && address < 0x40006400) {  // port C: the address masks what is written
      const std::uint32_t mask = (address - 0x40006000) >> 2;
      words_[0x400063FC] = (words_[0x400063FC] & ~mask) | (value & mask);
      return;
    }
    words_[address] = value;
  }
};

class Rig {
 public:
  static constexpr Fault kJammed = Fault::spi_timeout;
  Rig() {
    bus_.begin();
    pin_.begin(false);
    bus_.set_clock(4'000'000);
  }
  Ssi0<FakeIo>& bus() { return bus_; }
  const std::vector<std::uint8_t>& wire() const { return device_.ssi.wire(); }
  void jam() { device_.stick_low(device_.ssi.state_register(), 2); }
  Pin<FakeIo, 'C', 7>& pin() { return pin_; }
  bool level() { return (device_.word(0x400063FC) & 1u << 7) != 0; }

 private:
  Lm3s6965 device_;
  Ssi0<FakeIo> bus_;
  Pin<FakeIo, 'C', 7> pin_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Lm3s6965, SpiBusContract, Rig);
INSTANTIATE_TYPED_TEST_SUITE_P(Lm3s6965, OutPinContract, Rig);

TEST(Lm3s6965Clock, EndsAt50MHzOnThePll) {
  Lm3s6965 device;
  EXPECT_EQ(System<FakeIo>::begin(), Fault::none);
  const std::uint32_t rcc = device.word(kRunClock);
  EXPECT_EQ(rcc & 1u << 11, 0u) << "bypassed";
  EXPECT_EQ(rcc >> 23 & 15, 3u) << "divided by four";
  EXPECT_NE(rcc & 1u << 22, 0u);
  EXPECT_EQ(rcc >> 6 & 15, 14u) << "8 MHz crystal";
  EXPECT_EQ(rcc & 1, 0u) << "main oscillator on";
}

TEST(Lm3s6965Clock, APllThatNeverLocksIsAFaultAndStaysBypassed) {
  Lm3s6965 device;
  device.stick_low(kRawInterrupt, kLocked);
  EXPECT_EQ(System<FakeIo>::begin(), Fault::clock_timeout);
  EXPECT_NE(device.word(kRunClock) & 1u << 11, 0u);
  EXPECT_LT(device.reads(), 2 * kClockPolls);
}

TEST(Lm3s6965Ssi, ABusThatStaysBusyIsAFault) {
  Lm3s6965 device;
  Ssi0<FakeIo> bus;
  bus.set_clock(4'000'000);
  device.stick_high(device.ssi.state_register(), 1u << 4);
  const std::uint8_t bytes[] = {1, 2, 3};
  EXPECT_EQ(bus.write(bytes), Fault::spi_timeout);
  EXPECT_LT(device.reads(), 10'000u);
}

TEST(Lm3s6965Ssi, AReceiverThatIsNeverEmptyCannotHoldItUp) {
  Lm3s6965 device;
  Ssi0<FakeIo> bus;
  bus.set_clock(4'000'000);
  device.stick_high(device.ssi.state_register(), 1u << 2);
  const std::uint8_t bytes[] = {1, 2, 3};
  EXPECT_EQ(bus.write(bytes), Fault::none);
}

TEST(Lm3s6965Ssi, ClockAndMode) {
  Lm3s6965 device;
  Ssi0<FakeIo> bus;
  EXPECT_EQ(bus.set_clock(25'000'000), 25'000'000u);
  EXPECT_EQ(bus.set_clock(UINT32_MAX), 25'000'000u);
  EXPECT_EQ(bus.set_clock(4'000'000), 50'000'000u / 14);
  EXPECT_EQ(bus.set_clock(10'000), 50'000'000u / 5000);
  EXPECT_EQ(bus.set_clock(1), 50'000'000u / (254 * 256)) << "the slowest there is";
  for (std::uint8_t mode = 0; mode < 4; ++mode) {
    bus.set_mode(mode);
    bus.set_clock(1'000'000);
    EXPECT_EQ(device.ssi.control0() >> 7 & 1, mode & 1u) << "phase";
    EXPECT_EQ(device.ssi.control0() >> 6 & 1, mode >> 1 & 1u) << "polarity";
  }
}

}  // namespace
}  // namespace spanline::hal
