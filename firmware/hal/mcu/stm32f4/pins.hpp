#pragma once

#include "hal/mcu/stm32f4/clocks.hpp"

namespace spanline::hal::stm32f4 {

// One pin of a port, an OutPin after begin().
template <RegisterIo Io, char kPort, unsigned kNumber>
class Pin {
  static_assert(kPort >= 'A' && kPort <= 'K' && kNumber < 16, "no such pin");
  static constexpr std::uint32_t kIndex = static_cast<std::uint32_t>(kPort - 'A');
  static constexpr std::uint32_t kBase = 0x40020000 + 0x400 * kIndex;
  using Mode = Register<Io, kBase + 0x00>;
  using Speed = Register<Io, kBase + 0x08>;
  using Pull = Register<Io, kBase + 0x0C>;
  using SetReset = Register<Io, kBase + 0x18>;
  using Function = Register<Io, kBase + (kNumber < 8 ? 0x20 : 0x24)>;
  static constexpr std::uint32_t kTwoBits = 2 * kNumber, kFourBits = 4 * (kNumber % 8);

 public:
  static void begin(bool level) {
    Rcc<Io>::template open<typename Rcc<Io>::Ahb1>(1u << kIndex);
    write(level);
    constexpr std::uint32_t kOutput = 1;
    Speed::raise(3u << kTwoBits);
    Mode::replace(3u << kTwoBits, kOutput << kTwoBits);
  }
  static void begin_function(std::uint32_t function) {
    Rcc<Io>::template open<typename Rcc<Io>::Ahb1>(1u << kIndex);
    constexpr std::uint32_t kAlternate = 2;
    Function::replace(15u << kFourBits, function << kFourBits);
    Speed::raise(3u << kTwoBits);
    Mode::replace(3u << kTwoBits, kAlternate << kTwoBits);
  }
  // A line that nobody drives reads as ones.
  static void pull_up() { Pull::replace(3u << kTwoBits, 1u << kTwoBits); }
  void set(bool level) { write(level); }

 private:
  static void write(bool level) { SetReset::set(level ? 1u << kNumber : 1u << (kNumber + 16)); }
};

}  // namespace spanline::hal::stm32f4
