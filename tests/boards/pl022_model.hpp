// A PL022 whose other end echoes: every byte that is sent is received, too, in a FIFO of eight; full, it stops the
// port, as the emulator's does.
#pragma once

#include <vector>

#include "boards/fake_io.hpp"

namespace spanline::hal {

class Pl022Model {
 public:
  explicit Pl022Model(std::uint32_t base) : base_(base) {}

  std::uint8_t answer = 0xFF;  // what every byte that is received is

  bool owns(std::uint32_t address) const { return address >= base_ && address < base_ + 0x28; }
  std::uint32_t state_register() const { return base_ + 0x0C; }
  const std::vector<std::uint8_t>& wire() const { return wire_; }
  std::uint32_t control0() const { return control0_; }

  std::uint32_t get(std::uint32_t address) {
    if (address - base_ == 0x08) {
      if (received_ != 0) --received_;
      return answer;
    }
    if (address - base_ == 0x0C) return kTransmitEmpty | kNotFull | (received_ != 0 ? kReceived : 0);
    return 0;
  }
  void set(std::uint32_t address, std::uint32_t value) {
    if (address - base_ == 0x00) control0_ = value;
    if (address - base_ == 0x04) enabled_ = (value & 2) != 0;
    if (address - base_ != 0x08 || !enabled_ || (control0_ & 15) != 7 || received_ == 8) return;
    wire_.push_back(static_cast<std::uint8_t>(value));
    ++received_;
  }
  // As DMA does it: nobody empties the FIFO, and the port goes on, as the real one does.
  void put(std::uint8_t byte) {
    wire_.push_back(byte);
    received_ = received_ < 8 ? received_ + 1 : 8;
  }

 private:
  static constexpr std::uint32_t kTransmitEmpty = 1, kNotFull = 2, kReceived = 4;
  std::uint32_t base_, control0_ = 0;
  bool enabled_ = false;
  unsigned received_ = 0;
  std::vector<std::uint8_t> wire_;
};

}  // namespace spanline::hal
