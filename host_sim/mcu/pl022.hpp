// ARM's PL022 synchronous serial port, as master, 8 bits: in the LM3S6965 and the RP2040 (ARM DDI 0194).
#pragma once

#include <functional>

#include "mcu/peripheral.hpp"
#include "mcu/serial_port.hpp"

namespace spanline::host {

class Pl022 final : public RegisterBank {
 public:
  static constexpr std::size_t kFifo = 8;

  // What the chip around it knows and wants to hear.
  struct Around {
    std::function<std::uint64_t()> now;
    std::function<std::uint32_t()> kilohertz;  // of its clock, which is the core's
    std::function<bool()> alive;               // clocked, out of reset
    std::function<void(const std::string&)> complain;
    std::function<void(bool)> want_dma;  // it asks for bytes to send, or no longer
  };

  Pl022(std::string name, std::uint32_t base, SerialPort& port, Around around);

  bool alive() const override { return around_.alive(); }
  std::optional<std::uint32_t> read(std::uint32_t offset) override;
  bool write(std::uint32_t offset, std::uint32_t value) override;

 private:
  void send(std::uint32_t value);

  SerialPort& port_;
  Around around_;
};

}  // namespace spanline::host
