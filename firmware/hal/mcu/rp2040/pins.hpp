#pragma once

#include "hal/mcu/mmio.hpp"

namespace spanline::hal::rp2040 {

inline constexpr std::uint32_t kFunctionSpi = 1, kFunctionSio = 5;

// One GPIO of bank 0, an OutPin after begin(). IO_BANK0 and PADS_BANK0 must have left reset.
template <RegisterIo Io, unsigned kNumber>
class Pin {
  static_assert(kNumber < 30, "no such pin");
  static constexpr std::uint32_t kBit = 1u << kNumber;
  using Control = Register<Io, 0x40014004 + 8 * kNumber>;
  using Pad = Register<Io, 0x4001C004 + 4 * kNumber>;
  using Set = Register<Io, 0xD0000014>;
  using Clear = Register<Io, 0xD0000018>;
  using Enable = Register<Io, 0xD0000024>;
  static constexpr std::uint32_t kFastSlew = 1, kDrive12mA = 3u << 4;  // output enabled, no pulls

 public:
  static void begin(bool level) {
    write(level);
    Enable::set(kBit);
    begin_function(kFunctionSio);
  }
  static void begin_function(std::uint32_t function) {
    Pad::set(kFastSlew | kDrive12mA);
    Control::set(function);
  }
  // As an input of its peripheral, pulled up: a line that nobody drives reads as ones.
  static void begin_input(std::uint32_t function) {
    constexpr std::uint32_t kInputEnable = 1u << 6, kPullUp = 1u << 3;
    Pad::set(kInputEnable | kPullUp);
    Control::set(function);
  }
  void set(bool level) { write(level); }

 private:
  static void write(bool level) {
    if (level) {
      Set::set(kBit);
    } else {
      Clear::set(kBit);
    }
  }
};

}  // namespace spanline::hal::rp2040
