#pragma once

#include "core/base/slice.hpp"
#include "hal/mcu/mmio.hpp"

namespace spanline::hal::stm32f4 {

// One stream of DMA2 that feeds bytes to the register at kTarget. A DmaChannel. kRequest: the channel that the
// reference manual's request table names.
template <RegisterIo Io, unsigned kStream, unsigned kRequest, std::uint32_t kTarget>
class Dma2 {
  static_assert(kStream < 8 && kRequest < 8, "no such stream");
  static constexpr std::uint32_t kBase = 0x40026400, kOwn = kBase + 0x10 + 0x18 * kStream;
  static constexpr std::uint32_t kShift = 6 * (kStream % 2) + 16 * (kStream % 4 / 2);
  using Flags = Register<Io, kBase + (kStream < 4 ? 0x0 : 0x4)>;
  using ClearFlags = Register<Io, kBase + (kStream < 4 ? 0x8 : 0xC)>;
  using Control = Register<Io, kOwn + 0x00>;
  using Count = Register<Io, kOwn + 0x04>;
  using To = Register<Io, kOwn + 0x08>;
  using From = Register<Io, kOwn + 0x0C>;
  using Fifo = Register<Io, kOwn + 0x14>;
  static constexpr std::uint32_t kEnable = 1, kFromMemory = 1u << 6, kNextByte = 1u << 10, kHighPriority = 2u << 16;
  static constexpr std::uint32_t kErrors = (1u << 2 | 1u << 3) << kShift;  // direct mode, transfer
  static constexpr std::uint32_t kAllFlags = 0x3Du << kShift;
  static constexpr std::uint32_t kLongest = 0xFFFF;

 public:
  Fault start(Slice<const std::uint8_t> bytes) {
    if (busy() || bytes.size() > kLongest) return Fault::dma_error;
    if (Control::any(kEnable)) stop();
    ClearFlags::set(kAllFlags);
    To::set(kTarget);
    From::set(Io::address_of(bytes.data()));
    Count::set(bytes.size());
    Fifo::set(0);  // direct mode
    Control::set(kRequest << 25 | kHighPriority | kNextByte | kFromMemory);
    Control::raise(kEnable);
    return Fault::none;
  }
  bool busy() const { return Control::any(kEnable) && !Flags::any(kErrors); }
  Fault fault() const { return Flags::any(kErrors) ? Fault::dma_error : Fault::none; }

  // Gives up on a transfer, so that the next one finds the stream free.
  void stop() {
    Control::lower(kEnable);
    static_cast<void>(wait_for([] { return !Control::any(kEnable); }, polls_for(1000), Fault::dma_timeout));
  }
};

}  // namespace spanline::hal::stm32f4
