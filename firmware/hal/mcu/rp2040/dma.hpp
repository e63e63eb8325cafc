#pragma once

#include "core/base/slice.hpp"
#include "hal/mcu/mmio.hpp"

namespace spanline::hal::rp2040 {

// One channel of the DMA that feeds bytes to the register at kTarget when the peripheral of kRequest asks. A
// DmaChannel.
template <RegisterIo Io, unsigned kChannel, std::uint32_t kTarget, std::uint32_t kRequest>
class Dma {
  static_assert(kChannel < 12, "no such channel");
  static constexpr std::uint32_t kBase = 0x50000000 + 0x40 * kChannel;
  using From = Register<Io, kBase + 0x0>;
  using To = Register<Io, kBase + 0x4>;
  using Count = Register<Io, kBase + 0x8>;
  using Trigger = Register<Io, kBase + 0xC>;
  using Abort = Register<Io, 0x50000444>;
  static constexpr std::uint32_t kEnable = 1, kNextByte = 1u << 4, kQuiet = 1u << 21, kBusy = 1u << 24;
  static constexpr std::uint32_t kWriteError = 1u << 29, kReadError = 1u << 30, kBusError = 1u << 31;
  static constexpr std::uint32_t kNoChain = kChannel << 11;  // chained to itself: to nobody
  static constexpr std::uint32_t kAnyError = kWriteError | kReadError | kBusError;

 public:
  Fault start(Slice<const std::uint8_t> bytes) {
    if (busy()) return Fault::dma_error;
    if (Trigger::any(kAnyError)) stop();
    From::set(Io::address_of(bytes.data()));
    To::set(kTarget);
    Count::set(bytes.size());
    Trigger::set(kWriteError | kReadError | kQuiet | kRequest << 15 | kNoChain | kNextByte |
                 kEnable);  // errors: 1 clears
    return Fault::none;
  }
  bool busy() const { return (Trigger::get() & (kBusy | kAnyError)) == kBusy; }
  Fault fault() const { return Trigger::any(kAnyError) ? Fault::dma_error : Fault::none; }

  // Gives up on a transfer, so that the next one finds the channel free.
  void stop() {
    Abort::set(1u << kChannel);
    static_cast<void>(wait_for([] { return !Abort::any(1u << kChannel); }, polls_for(1000), Fault::dma_timeout));
  }
};

}  // namespace spanline::hal::rp2040
