#include <algorithm>

#include "boards/fake_io.hpp"
#include "hal/contract/dma_channel.hpp"
#include "hal/contract/out_pin.hpp"
#include "hal/contract/spi_bus.hpp"
#include "hal/contract/spi_reads.hpp"
#include "hal/mcu/stm32f4/spi.hpp"

namespace spanline::hal {
namespace {

using namespace stm32f4;

constexpr std::uint32_t kControl = 0x40023800, kConfig = 0x40023808, kPower = 0x40007000, kPowerState = 0x40007004;
constexpr std::uint32_t kSpi = 0x40015000, kSpiState = kSpi + 0x08, kSpiData = kSpi + 0x0C;
constexpr std::uint32_t kStream4 = 0x40026400 + 0x10 + 0x18 * 4, kHighFlags = 0x40026404, kClearHighFlags = 0x4002640C;
constexpr std::uint32_t kReceived = 1, kEmpty = 2, kBusy = 1u << 7;
constexpr std::uint32_t kEnable = 1u << 6, kOneLine = 1u << 15, kDrive = 1u << 14;

class Stm32f4 : public FakeDevice {
 public:
  bool dma_by_itself = true;  // a transfer completes while it is waited for
  std::vector<std::uint8_t> wire;
  std::uint8_t answer = 0xFF;  // what every byte that is received is

  std::uint32_t word(std::uint32_t address) { return words_[address]; }
  void finish() {
    if ((words_[kStream4] & 1) == 0) return;
    const std::uint8_t* from = memory_at(words_[kStream4 + 0xC]);
    wire.insert(wire.end(), from, from + words_[kStream4 + 4]);
    words_[kStream4] &= ~1u;
    words_[kHighFlags] |= 1u << 5;
  }
  void fail(std::uint32_t flag) { words_[kHighFlags] |= flag; }

 private:
  std::uint32_t get(std::uint32_t address) override {
    if (address == kControl) {  // what is switched on is ready: the bit beside it
      const std::uint32_t on = words_[kControl] & (1u << 0 | 1u << 16 | 1u << 24);
      return words_[kControl] | on << 1;
    }
    if (address == kPowerState) return words_[kPower] & (3u << 16);
    if (address == kConfig) return words_[kConfig] | (words_[kConfig] & 3) << 2;
    if (address == kSpiState) return kEmpty | (received_ || listens() ? kReceived : 0);
    if (address == kSpiData) {
      received_ = false;
      return answer;
    }
    if (address == kStream4 && dma_by_itself && ++polls_ % 5 == 0) finish();
    return words_[address];
  }
  void set(std::uint32_t address, std::uint32_t value) override {
    if (address == kSpiData) {
      wire.push_back(static_cast<std::uint8_t>(value));
      received_ = (words_[kSpi] & kOneLine) == 0;
    }
    if (address == kClearHighFlags) words_[kHighFlags] &= ~value;
    if (address == 0x40020C18) words_[0x40020C14] = (words_[0x40020C14] | (value & 0xFFFF)) & ~(value >> 16);
    words_[address] = value;
  }
  // On one line and not driving it: the clock runs, byte after byte comes in.
  bool listens() { return (words_[kSpi] & (kOneLine | kDrive | kEnable)) == (kOneLine | kEnable); }

  unsigned polls_ = 0;
  bool received_ = false;
};

using Bus = Spi<FakeIo, SpiWiring{kSpi, Rcc<FakeIo>::kSpi5, 4, 2, 'F', 7, 'F', 9}, kF429At180MHz>;

class Rig {
 public:
  static constexpr Fault kJammed = Fault::spi_timeout;
  Rig() {
    bus_.begin();
    bus_.set_clock(40'000'000);
    pin_.begin(false);
  }
  Bus& bus() { return bus_; }
  const std::vector<std::uint8_t>& wire() const { return device_.wire; }
  void jam() {
    device_.stick_low(kSpiState, kEmpty);
    device_.dma_by_itself = false;
  }
  Pin<FakeIo, 'D', 13>& pin() { return pin_; }
  bool level() { return (device_.word(0x40020C14) & 1u << 13) != 0; }

 private:
  Stm32f4 device_;
  Bus bus_;
  Pin<FakeIo, 'D', 13> pin_;
};

constexpr SpiWiring kOwnPin{kSpi, Rcc<FakeIo>::kSpi5, 4, 2, 'F', 7, 'F', 9, Answer::own_pin, 'F', 8};
constexpr SpiWiring kDataLine{kSpi, Rcc<FakeIo>::kSpi5, 4, 2, 'F', 7, 'F', 9, Answer::data_line};

template <SpiWiring kWiring>
class ReadingRig {
 public:
  ReadingRig() {
    bus_.begin();
    bus_.set_clock(40'000'000);
  }
  auto& bus() { return bus_; }
  void answer(std::uint8_t byte) { device_.answer = byte; }
  void mute() { device_.stick_low(kSpiState, kReceived); }

 private:
  Stm32f4 device_;
  Spi<FakeIo, kWiring, kF429At180MHz> bus_;
};

class DmaRig {
 public:
  DmaRig() { device_.dma_by_itself = false; }
  auto& dma() { return dma_; }
  void finish() { device_.finish(); }
  void fail() { device_.fail(1u << 3); }
  const std::vector<std::uint8_t>& moved() const { return device_.wire; }

 private:
  Stm32f4 device_;
  Dma2<FakeIo, 4, 2, kSpiData> dma_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Stm32f4, SpiBusContract, Rig);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32f4OwnPin, SpiReadsContract, ReadingRig<kOwnPin>);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32f4DataLine, SpiReadsContract, ReadingRig<kDataLine>);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32f4, OutPinContract, Rig);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32f4, DmaChannelContract, DmaRig);

TEST(Stm32f4Clock, TheF429EndsAt180MHz) {
  Stm32f4 device;
  EXPECT_EQ(Rcc<FakeIo>::begin(kF429At180MHz), Fault::none);
  EXPECT_EQ(device.word(0x40023804), 8u << 24 | 1u << 22 | 180u << 6 | 4u);
  EXPECT_EQ(device.word(0x40023C00), 0x700u | 5u);
  EXPECT_EQ(device.word(kConfig), 2u | 5u << 10 | 4u << 13);
}

TEST(Stm32f4Clock, TheF411EndsAt100MHzWithoutCrystalOrOverDrive) {
  Stm32f4 device;
  device.stick_low(kControl, 1u << 17);
  device.stick_low(kPowerState, 3u << 16);
  EXPECT_EQ(Rcc<FakeIo>::begin(kF411At100MHz), Fault::none);
  EXPECT_EQ(device.word(0x40023804), 5u << 24 | 100u << 6 | 8u);
  EXPECT_EQ(device.word(0x40023C00), 0x700u | 3u);
  EXPECT_EQ(device.word(kConfig), 2u | 4u << 10);
}

TEST(Stm32f4Clock, WhateverNeverComesIsAFault) {
  const struct {
    std::uint32_t address, bits;
    const char* what;
  } dead[] = {{kControl, 1u << 17, "crystal"},
              {kControl, 1u << 25, "PLL"},
              {kPowerState, 1u << 16, "over-drive"},
              {kPowerState, 1u << 17, "over-drive switch"},
              {kConfig, 3u << 2, "switch to the PLL"}};
  for (const auto& [address, bits, what] : dead) {
    Stm32f4 device;
    device.stick_low(address, bits);
    EXPECT_EQ(Rcc<FakeIo>::begin(kF429At180MHz), Fault::clock_timeout) << what;
    EXPECT_LT(device.reads(), 2 * kClockPolls);
  }
}

TEST(Stm32f4Spi, EveryErrorFlagComesOutOfWaitAndTheNextTransferWorks) {
  for (const std::uint32_t flag : {1u << 2, 1u << 3}) {
    Stm32f4 device;
    Bus bus;
    bus.set_clock(40'000'000);
    device.dma_by_itself = false;
    const std::uint8_t bytes[] = {1, 2, 3};
    EXPECT_EQ(bus.start(bytes), Fault::none);
    device.fail(flag);
    EXPECT_EQ(bus.wait(), Fault::dma_error);
    EXPECT_EQ(device.word(kStream4) & 1, 0u) << "stopped";
    device.dma_by_itself = true;
    EXPECT_EQ(bus.start(bytes), Fault::none);
    EXPECT_EQ(bus.wait(), Fault::none);
  }
}

TEST(Stm32f4Spi, ATransferThatNeverEndsIsAFaultInTheTimeOfItsBytes) {
  Stm32f4 device;
  Bus bus;
  bus.set_clock(40'000'000);
  device.dma_by_itself = false;
  const std::uint8_t bytes[480] = {};
  EXPECT_EQ(bus.start(bytes), Fault::none);
  EXPECT_EQ(bus.start(bytes), Fault::dma_error) << "one is under way";
  EXPECT_EQ(bus.wait(), Fault::dma_timeout);
  EXPECT_LT(device.reads(), 200'000u);
}

TEST(Stm32f4Spi, AStreamThatDoesNotStopCannotHoldItUp) {
  Stm32f4 device;
  Bus bus;
  bus.set_clock(40'000'000);
  device.dma_by_itself = false;
  const std::uint8_t bytes[] = {1};
  EXPECT_EQ(bus.start(bytes), Fault::none);
  device.stick_high(kStream4, 1);
  EXPECT_EQ(bus.wait(), Fault::dma_timeout);
}

TEST(Stm32f4Spi, ABusThatStaysBusyIsAFault) {
  Stm32f4 device;
  Bus bus;
  bus.set_clock(40'000'000);
  device.stick_high(kSpiState, kBusy);
  const std::uint8_t bytes[] = {1, 2, 3};
  EXPECT_EQ(bus.write(bytes), Fault::spi_timeout);
  EXPECT_EQ(bus.start(bytes), Fault::none);
  EXPECT_EQ(bus.wait(), Fault::spi_timeout);
}

TEST(Stm32f4Spi, AfterAnAnswerOnTheDataLineItDrivesTheLineAgain) {
  Stm32f4 device;
  Spi<FakeIo, kDataLine, kF429At180MHz> bus;
  bus.set_clock(5'000'000);
  const std::uint32_t before = device.word(kSpi);
  std::uint8_t came[1] = {};
  EXPECT_EQ(bus.read(came), Fault::none);
  EXPECT_EQ(device.word(kSpi), before);
  EXPECT_TRUE(device.wire.empty()) << "nothing is sent while the panel speaks";
}

TEST(Stm32f4Spi, ClockAndMode) {
  Stm32f4 device;
  Bus bus;
  EXPECT_EQ(bus.set_clock(UINT32_MAX), 45'000'000u);
  EXPECT_EQ(bus.set_clock(40'000'000), 22'500'000u);
  EXPECT_EQ(bus.set_clock(22'500'000), 22'500'000u);
  EXPECT_EQ(bus.set_clock(1), 90'000'000u / 256);
  bus.set_mode(3);
  bus.set_clock(40'000'000);
  EXPECT_EQ(device.word(kSpi) & 3, 3u);
}

}  // namespace
}  // namespace spanline::hal
