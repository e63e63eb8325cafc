#pragma once

#include "hal/mcu/dma_bus.hpp"
#include "hal/mcu/pl022.hpp"
#include "hal/mcu/rp2040/clocks.hpp"
#include "hal/mcu/rp2040/dma.hpp"
#include "hal/mcu/rp2040/pins.hpp"

namespace spanline::hal::rp2040 {

inline constexpr std::uint32_t kRequestSpi0Transmit = 16;

// For kAnswer below: nothing is wired to the port's input.
inline constexpr unsigned kNoAnswer = ~0u;

// SPI0, fed by DMA channel 0: an SpiBus, and one that reads where kAnswer names the pin that the panel's output is on.
// kClock, kData and kAnswer: GPIOs 2, 6, 18, 22; 3, 7, 19, 23; 0, 4, 16, 20.
template <RegisterIo Io, unsigned kClock, unsigned kData, unsigned kAnswer = kNoAnswer>
class Spi0 {
  static_assert(kClock == 2 || kClock == 6 || kClock == 18 || kClock == 22, "not a clock of SPI0");
  static_assert(kData == 3 || kData == 7 || kData == 19 || kData == 23, "not a data output of SPI0");
  static_assert(kAnswer == kNoAnswer || kAnswer == 0 || kAnswer == 4 || kAnswer == 16 || kAnswer == 20,
                "not a data input of SPI0");
  using Port = Pl022<Io, 0x4003C000>;

 public:
  Fault begin() {
    using Blocks = Resets<Io>;
    const Fault fault = Blocks::release(Blocks::kSpi0 | Blocks::kDma | Blocks::kIoBank0 | Blocks::kPadsBank0);
    Pin<Io, kClock>::begin_function(kFunctionSpi);
    Pin<Io, kData>::begin_function(kFunctionSpi);
    if constexpr (kAnswer != kNoAnswer) Pin<Io, kAnswer>::begin_input(kFunctionSpi);
    return fault;
  }
  void set_mode(std::uint8_t mode) { port_.set_mode(mode); }
  std::uint32_t set_clock(std::uint32_t hz) { return port_.set_clock(kHz, hz); }
  Fault write(Slice<const std::uint8_t> bytes) { return port_.write(bytes); }
  Fault read(Slice<std::uint8_t> answer) requires(kAnswer != kNoAnswer) { return port_.read(answer); }
  Fault start(Slice<const std::uint8_t> bytes) { return transfer_.start(dma_, bytes); }
  Fault wait() { return transfer_.wait(dma_, port_); }

 private:
  Port port_;
  Dma<Io, 0, Port::Data::kAt, kRequestSpi0Transmit> dma_;
  Transfer transfer_;
};

}  // namespace spanline::hal::rp2040
