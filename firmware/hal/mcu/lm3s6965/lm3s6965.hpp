// LM3S6965: clock, pins and SSI0. No DMA on this part: a transfer is over when start() returns. (datasheet DS-LM3S6965)
#pragma once

#include "hal/mcu/pl022.hpp"

namespace spanline::hal::lm3s6965 {

inline constexpr std::uint32_t kHz = 50'000'000;

template <RegisterIo Io>
struct System {
  using RawInterrupt = Register<Io, 0x400FE050>;
  using RunClock = Register<Io, 0x400FE060>;
  using Gate1 = Register<Io, 0x400FE104>;
  using Gate2 = Register<Io, 0x400FE108>;
  static constexpr std::uint32_t kSsi0 = 1u << 4;  // of Gate1

  // 50 MHz: the 8 MHz crystal, the PLL's 200 MHz by 4. In the datasheet's order: bypass, PLL up, divider, lock, no
  // bypass.
  static Fault begin() {
    constexpr std::uint32_t kBypass = 1u << 11, kDivide = 1u << 22, kPowerDown = 1u << 13, kOutputOff = 1u << 12;
    constexpr std::uint32_t kCrystalMask = 0xFu << 6, kCrystal8MHz = 0xEu << 6, kSourceMask = 3u << 4, kMainOff = 1u;
    constexpr std::uint32_t kDividerMask = 0xFu << 23, kBy4 = 3u << 23, kLocked = 1u << 6;
    RunClock::replace(kDivide | kMainOff, kBypass);
    RunClock::replace(kCrystalMask | kSourceMask | kPowerDown | kOutputOff, kCrystal8MHz);
    RunClock::replace(kDividerMask, kBy4 | kDivide);
    const Fault fault = wait_for([] { return RawInterrupt::all(kLocked); }, kClockPolls, Fault::clock_timeout);
    if (fault == Fault::none) RunClock::lower(kBypass);
    return fault;
  }

  // Ports by letter, 'A' to 'G'. The gated block answers three cycles after its gate opened: the read takes that long.
  static void open_port(char port) {
    Gate2::raise(1u << (port - 'A'));
    static_cast<void>(Gate2::get());
  }
  static void open_ssi0() {
    Gate1::raise(kSsi0);
    static_cast<void>(Gate1::get());
  }
};

constexpr std::uint32_t port_base(char port) {
  return port <= 'D' ? 0x40004000u + 0x1000u * static_cast<std::uint32_t>(port - 'A')
                     : 0x40024000u + 0x1000u * static_cast<std::uint32_t>(port - 'E');
}

// One pin of a port, an OutPin after begin().
template <RegisterIo Io, char kPort, unsigned kNumber>
class Pin {
  static_assert(kPort >= 'A' && kPort <= 'G' && kNumber < 8, "no such pin");
  static_assert(kPort != 'C' || kNumber >= 4, "PC0 to PC3 are the debugger's");
  static constexpr std::uint32_t kBase = port_base(kPort), kBit = 1u << kNumber;
  using Data = Register<Io, kBase + (kBit << 2)>;  // the address masks: a write touches this pin only
  using Direction = Register<Io, kBase + 0x400>;
  using Function = Register<Io, kBase + 0x420>;
  using Digital = Register<Io, kBase + 0x51C>;

 public:
  static void begin(bool level) {
    System<Io>::open_port(kPort);
    Function::lower(kBit);
    Direction::raise(kBit);
    Digital::raise(kBit);
    Data::set(level ? kBit : 0);
  }
  // Gives the pin to its peripheral.
  static void begin_function() {
    System<Io>::open_port(kPort);
    Function::raise(kBit);
    Digital::raise(kBit);
  }
  void set(bool level) { Data::set(level ? kBit : 0); }
};

// SSI0 on PA2 (clock) and PA5 (data), an SpiBus.
template <RegisterIo Io>
class Ssi0 {
 public:
  void begin() {
    System<Io>::open_ssi0();
    Pin<Io, 'A', 2>::begin_function();
    Pin<Io, 'A', 5>::begin_function();
  }
  void set_mode(std::uint8_t mode) { port_.set_mode(mode); }
  std::uint32_t set_clock(std::uint32_t hz) { return port_.set_clock(kHz, hz); }
  Fault write(Slice<const std::uint8_t> bytes) { return port_.write(bytes); }
  Fault start(Slice<const std::uint8_t> bytes) { return port_.write(bytes); }
  Fault wait() { return Fault::none; }

 private:
  Pl022<Io, 0x40008000> port_;
};

}  // namespace spanline::hal::lm3s6965
