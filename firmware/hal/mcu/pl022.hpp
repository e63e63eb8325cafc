// ARM's PL022 synchronous serial port, as master, 8 bits: in the LM3S6965 and the RP2040. (ARM DDI 0194)
#pragma once

#include "core/base/slice.hpp"
#include "hal/mcu/mmio.hpp"

namespace spanline::hal {

template <RegisterIo Io, std::uint32_t kBase>
class Pl022 {
  using Control0 = Register<Io, kBase + 0x00>;
  using Control1 = Register<Io, kBase + 0x04>;
  using State = Register<Io, kBase + 0x0C>;
  using Prescale = Register<Io, kBase + 0x10>;
  using DmaControl = Register<Io, kBase + 0x24>;
  static constexpr std::uint32_t kEnable = 1u << 1;
  static constexpr std::uint32_t kEightBits = 7;
  static constexpr std::uint32_t kNotFull = 1u << 1, kReceived = 1u << 2, kBusy = 1u << 4;
  static constexpr std::uint32_t kTransmitDma = 1u << 1;
  static constexpr std::uint32_t kFifo = 8;

 public:
  using Data = Register<Io, kBase + 0x08>;

  // SPI mode 0 to 3, in force from the next set_clock() on.
  void set_mode(std::uint8_t mode) { mode_ = mode; }

  // The port's clock is source_hz / (prescale * (1 + rate)), prescale even: the fastest that is at most `hz`, or the
  // slowest there is. Returns what was reached.
  std::uint32_t set_clock(std::uint32_t source_hz, std::uint32_t hz) {
    std::uint32_t prescale = 2, rate = 255;
    for (; prescale < 254; prescale += 2) {
      const std::uint32_t wanted = hz == 0 ? UINT32_MAX : (source_hz + prescale * hz - 1) / (prescale * hz);
      if (wanted <= 256) {
        rate = wanted == 0 ? 0 : wanted - 1;
        break;
      }
    }
    Control1::set(0);
    Prescale::set(prescale);
    Control0::set(rate << 8 | phase_and_polarity() | kEightBits);
    DmaControl::set(kTransmitDma);
    Control1::set(kEnable);
    cycles_per_byte_ = 8 * prescale * (1 + rate);
    return source_hz / (prescale * (1 + rate));
  }

  // Of the port's source clock, which is the processor's on both families.
  std::uint32_t cycles_per_byte() const { return cycles_per_byte_; }

  Fault write(Slice<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      if (wait_for([] { return State::any(kNotFull); }, polls_for(cycles_per_byte_), Fault::spi_timeout) !=
          Fault::none) {
        return Fault::spi_timeout;
      }
      Data::set(byte);
      drop_received();
    }
    return finish();
  }

  // Sends ones and keeps what comes in meanwhile.
  Fault read(Slice<std::uint8_t> answer) {
    const Fault fault = finish();
    if (fault != Fault::none) return fault;
    for (std::uint8_t& byte : answer) {
      Data::set(0xFF);
      const Fault received =
          wait_for([] { return State::any(kReceived); }, polls_for(2 * cycles_per_byte_), Fault::spi_timeout);
      if (received != Fault::none) return received;
      byte = static_cast<std::uint8_t>(Data::get());
    }
    return Fault::none;
  }

  // Ends when the last bit has left. The receive FIFO is emptied: full, it stops some implementations for good.
  Fault finish() {
    const Fault fault =
        wait_for([] { return !State::any(kBusy); }, polls_for(cycles_per_byte_ * (kFifo + 1)), Fault::spi_timeout);
    drop_received();
    return fault;
  }

 private:
  // Mode bit 0 is the phase (SPH, bit 7), bit 1 the polarity (SPO, bit 6).
  std::uint32_t phase_and_polarity() const { return (mode_ & 1u) << 7 | (mode_ & 2u) << 5; }

  static void drop_received() {
    for (std::uint32_t at_most = kFifo; at_most != 0 && State::any(kReceived); --at_most)
      static_cast<void>(Data::get());
  }

  std::uint32_t cycles_per_byte_ = 8 * 2 * 256;
  std::uint8_t mode_ = 0;
};

}  // namespace spanline::hal
