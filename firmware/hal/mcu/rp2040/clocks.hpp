// RP2040 (datasheet RP-008371-DS): crystal, system PLL, and what has to leave reset.
#pragma once

#include "hal/mcu/mmio.hpp"

namespace spanline::hal::rp2040 {

inline constexpr std::uint32_t kCrystalHz = 12'000'000;
inline constexpr std::uint32_t kHz = 125'000'000;

template <RegisterIo Io>
struct Resets {
  using Reset = Register<Io, 0x4000C000>;
  using Done = Register<Io, 0x4000C008>;
  static constexpr std::uint32_t kDma = 1u << 2, kIoBank0 = 1u << 5, kPadsBank0 = 1u << 8, kPllSys = 1u << 12,
                                 kSpi0 = 1u << 16;

  static Fault release(std::uint32_t blocks) {
    Reset::raise(blocks);
    Reset::lower(blocks);
    return wait_for([blocks] { return Done::all(blocks); }, kClockPolls, Fault::clock_timeout);
  }
};

template <RegisterIo Io>
struct Clocks {
  using RefControl = Register<Io, 0x40008030>;
  using RefSelected = Register<Io, 0x40008038>;
  using SysControl = Register<Io, 0x4000803C>;
  using SysDivide = Register<Io, 0x40008040>;
  using SysSelected = Register<Io, 0x40008044>;
  using PeriControl = Register<Io, 0x40008048>;
  using CrystalControl = Register<Io, 0x40024000>;
  using CrystalState = Register<Io, 0x40024004>;
  using CrystalStartup = Register<Io, 0x4002400C>;
  using PllControl = Register<Io, 0x40028000>;
  using PllPower = Register<Io, 0x40028004>;
  using PllFeedback = Register<Io, 0x40028008>;
  using PllDivide = Register<Io, 0x4002800C>;

  // 125 MHz: 12 MHz * 125 / 6 / 2, for processor and peripherals alike.
  static Fault begin() {
    Fault fault = begin_crystal();
    if (fault != Fault::none) return fault;
    // Off the PLL, in case that somebody before us ran on it, before it is reset.
    SysControl::lower(1);
    fault = selected<SysSelected>(0);
    if (fault != Fault::none) return fault;
    RefControl::replace(3, kFromCrystal);
    fault = selected<RefSelected>(kFromCrystal);
    if (fault != Fault::none) return fault;
    fault = begin_pll();
    if (fault != Fault::none) return fault;
    constexpr std::uint32_t kAuxMask = 7u << 5, kAuxPllSys = 0, kAux = 1, kPeriEnable = 1u << 11;
    SysDivide::set(1u << 8);
    SysControl::replace(kAuxMask, kAuxPllSys);
    SysControl::raise(kAux);
    fault = selected<SysSelected>(kAux);
    PeriControl::set(kPeriEnable);  // from the system clock
    return fault;
  }

 private:
  static constexpr std::uint32_t kFromCrystal = 2;

  static Fault begin_crystal() {
    constexpr std::uint32_t kRange1To15MHz = 0xAA0, kEnable = 0xFABu << 12, kStable = 1u << 31;
    constexpr std::uint32_t kStartupMs = 1;
    CrystalStartup::set((kCrystalHz / 1000 * kStartupMs + 128) / 256);
    CrystalControl::set(kRange1To15MHz | kEnable);
    return wait_for([] { return CrystalState::all(kStable); }, kClockPolls, Fault::clock_timeout);
  }

  static Fault begin_pll() {
    constexpr std::uint32_t kFeedback = 125, kBy6 = 6u << 16, kBy2 = 2u << 12, kLocked = 1u << 31;
    constexpr std::uint32_t kPowerDown = 1, kPostDividerDown = 1u << 3, kOscillatorDown = 1u << 5;
    static_assert(kCrystalHz * kFeedback / 6 / 2 == kHz);
    const Fault fault = Resets<Io>::release(Resets<Io>::kPllSys);
    if (fault != Fault::none) return fault;
    PllControl::set(1);  // reference divider
    PllFeedback::set(kFeedback);
    PllPower::lower(kPowerDown | kOscillatorDown);
    const Fault locked = wait_for([] { return PllControl::all(kLocked); }, kClockPolls, Fault::clock_timeout);
    if (locked != Fault::none) return locked;
    PllDivide::set(kBy6 | kBy2);
    PllPower::lower(kPostDividerDown);
    return Fault::none;
  }

  // A glitchless multiplexer shows the source that it has switched to as one bit.
  template <typename Selected>
  static Fault selected(std::uint32_t source) {
    return wait_for([source] { return Selected::all(1u << source); }, kClockPolls, Fault::clock_timeout);
  }
};

}  // namespace spanline::hal::rp2040
