#include <algorithm>

#include "boards/fake_io.hpp"
#include "boards/pl022_model.hpp"
#include "hal/contract/dma_channel.hpp"
#include "hal/contract/out_pin.hpp"
#include "hal/contract/spi_bus.hpp"
#include "hal/contract/spi_reads.hpp"
#include "hal/mcu/rp2040/spi.hpp"

namespace spanline::hal {
namespace {

using namespace rp2040;

constexpr std::uint32_t kReset = 0x4000C000, kResetDone = 0x4000C008;
constexpr std::uint32_t kRefSelected = 0x40008038, kSysSelected = 0x40008044, kCrystalState = 0x40024004;
constexpr std::uint32_t kPllControl = 0x40028000, kPllPower = 0x40028004;
constexpr std::uint32_t kDmaFrom = 0x50000000, kDmaCount = 0x50000008, kDmaControl = 0x5000000C, kDmaAbort = 0x50000444;
constexpr std::uint32_t kDmaBusy = 1u << 24, kDmaError = 3u << 30;

class Rp2040 : public FakeDevice {
 public:
  Rp2040() { words_[kPllPower] = 0x2D; }
  Pl022Model spi{0x4003C000};
  bool dma_by_itself = true;  // a transfer completes while it is waited for

  std::uint32_t word(std::uint32_t address) { return words_[address]; }
  void finish() {
    if ((words_[kDmaControl] & kDmaBusy) == 0) return;
    const std::uint8_t* from = memory_at(words_[kDmaFrom]);
    std::for_each(from, from + words_[kDmaCount], [this](std::uint8_t byte) { spi.put(byte); });
    words_[kDmaControl] &= ~kDmaBusy;
  }
  void fail() { words_[kDmaControl] |= kDmaError; }

 private:
  std::uint32_t get(std::uint32_t address) override {
    if (spi.owns(address)) return spi.get(address);
    switch (address) {
      case kResetDone:
        return ~words_[kReset];
      case kRefSelected:
        return 1u << (words_[0x40008030] & 3);
      case kSysSelected:
        return 1u << (words_[0x4000803C] & 1);
      case kCrystalState:
        return (words_[0x40024000] >> 12 & 0xFFF) == 0xFAB ? 1u << 31 : 0;
      case kPllControl:
        return words_[kPllControl] | ((words_[kPllPower] & 0x21) == 0 ? 1u << 31 : 0);
      case kDmaControl:
        if (dma_by_itself && ++polls_ % 5 == 0) finish();
        return words_[kDmaControl];
      default:
        return words_[address];
    }
  }
  void set(std::uint32_t address, std::uint32_t value) override {
    if (spi.owns(address)) return spi.set(address, value);
    if (address == kDmaAbort) {
      words_[kDmaControl] &= ~kDmaBusy;
    } else if (address == kDmaControl) {
      words_[kDmaControl] = (value & ~(3u << 29)) | kDmaBusy;
    } else if (address == 0xD0000014) {
      words_[0xD0000010] |= value;
    } else if (address == 0xD0000018) {
      words_[0xD0000010] &= ~value;
    } else {
      words_[address] = value;
    }
  }
  unsigned polls_ = 0;
};

class Rig {
 public:
  static constexpr Fault kJammed = Fault::spi_timeout;
  Rig() {
    static_cast<void>(bus_.begin());
    bus_.set_clock(62'500'000);
    pin_.begin(false);
  }
  Spi0<FakeIo, 18, 19>& bus() { return bus_; }
  const std::vector<std::uint8_t>& wire() const { return device_.spi.wire(); }
  void jam() {
    device_.stick_low(device_.spi.state_register(), 2);
    device_.dma_by_itself = false;
  }
  Pin<FakeIo, 20>& pin() { return pin_; }
  bool level() { return (device_.word(0xD0000010) & 1u << 20) != 0; }

 private:
  Rp2040 device_;
  Spi0<FakeIo, 18, 19> bus_;
  Pin<FakeIo, 20> pin_;
};

class ReadingRig {
 public:
  ReadingRig() {
    EXPECT_EQ(bus_.begin(), Fault::none);
    bus_.set_clock(62'500'000);
  }
  auto& bus() { return bus_; }
  void answer(std::uint8_t byte) { device_.spi.answer = byte; }
  void mute() { device_.stick_low(device_.spi.state_register(), 4); }

 private:
  Rp2040 device_;
  Spi0<FakeIo, 18, 19, 16> bus_;
};

class DmaRig {
 public:
  DmaRig() { device_.dma_by_itself = false; }
  auto& dma() { return dma_; }
  void finish() { device_.finish(); }
  void fail() { device_.fail(); }
  const std::vector<std::uint8_t>& moved() const { return device_.spi.wire(); }

 private:
  Rp2040 device_;
  Dma<FakeIo, 0, 0x4003C008, kRequestSpi0Transmit> dma_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Rp2040, SpiBusContract, Rig);
INSTANTIATE_TYPED_TEST_SUITE_P(Rp2040, SpiReadsContract, ReadingRig);
INSTANTIATE_TYPED_TEST_SUITE_P(Rp2040, OutPinContract, Rig);
INSTANTIATE_TYPED_TEST_SUITE_P(Rp2040, DmaChannelContract, DmaRig);

static_assert(SpiReads<Spi0<FakeIo, 18, 19, 16>> && !SpiReads<Spi0<FakeIo, 18, 19>>);

TEST(Rp2040Clock, EndsAt125MHz) {
  Rp2040 device;
  EXPECT_EQ(Clocks<FakeIo>::begin(), Fault::none);
  EXPECT_EQ(device.word(0x40028008), 125u);
  EXPECT_EQ(device.word(0x4002800C), 6u << 16 | 2u << 12);
  EXPECT_EQ(device.word(0x4000803C) & 0xE1, 1u) << "the system runs on the PLL";
  EXPECT_NE(device.word(0x40008048) & 1u << 11, 0u) << "the peripherals' clock is on";
}

TEST(Rp2040Clock, WhateverNeverComesIsAFault) {
  const struct {
    std::uint32_t address, bits;
  } dead[] = {{kCrystalState, 1u << 31}, {kSysSelected, 1},       {kRefSelected, 4},
              {kResetDone, 1u << 12},    {kPllControl, 1u << 31}, {kSysSelected, 2}};
  for (const auto& [address, bits] : dead) {
    Rp2040 device;
    device.stick_low(address, bits);
    EXPECT_EQ(Clocks<FakeIo>::begin(), Fault::clock_timeout) << std::hex << address;
    EXPECT_LT(device.reads(), 2 * kClockPolls);
  }
}

TEST(Rp2040Spi, ABlockThatDoesNotLeaveResetIsAFault) {
  Rp2040 device;
  device.stick_low(kResetDone, 1u << 16);
  Spi0<FakeIo, 18, 19> bus;
  EXPECT_EQ(bus.begin(), Fault::clock_timeout);
}

TEST(Rp2040Spi, ADmaErrorComesOutOfWaitAndTheNextTransferWorks) {
  Rp2040 device;
  Spi0<FakeIo, 18, 19> bus;
  bus.set_clock(62'500'000);
  device.dma_by_itself = false;
  const std::uint8_t bytes[] = {1, 2, 3};
  EXPECT_EQ(bus.start(bytes), Fault::none);
  device.fail();
  EXPECT_EQ(bus.wait(), Fault::dma_error);
  device.dma_by_itself = true;
  EXPECT_EQ(bus.start(bytes), Fault::none);
  EXPECT_EQ(bus.wait(), Fault::none);
}

TEST(Rp2040Spi, ATransferThatNeverEndsIsAFaultInTheTimeOfItsBytes) {
  Rp2040 device;
  Spi0<FakeIo, 18, 19> bus;
  bus.set_clock(62'500'000);
  device.dma_by_itself = false;
  const std::uint8_t bytes[480] = {};
  EXPECT_EQ(bus.start(bytes), Fault::none);
  EXPECT_EQ(bus.start(bytes), Fault::dma_error) << "one is under way";
  EXPECT_EQ(bus.wait(), Fault::dma_timeout);
  EXPECT_LT(device.reads(), 20'000u);
  EXPECT_EQ(device.word(kDmaControl) & kDmaBusy, 0u) << "aborted";
}

TEST(Rp2040Spi, ABusThatStaysBusyAfterDmaIsAFault) {
  Rp2040 device;
  Spi0<FakeIo, 18, 19> bus;
  bus.set_clock(62'500'000);
  device.stick_high(device.spi.state_register(), 1u << 4);
  const std::uint8_t bytes[] = {1, 2, 3};
  EXPECT_EQ(bus.start(bytes), Fault::none);
  EXPECT_EQ(bus.wait(), Fault::spi_timeout);
}

}  // namespace
}  // namespace spanline::hal
