// STM32F4 clock tree (RM0090, RM0383): voltage scale, flash wait states, PLL, bus dividers.
#pragma once

#include "hal/mcu/mmio.hpp"

namespace spanline::hal::stm32f4 {

enum class Source : std::uint8_t { internal, crystal };

// The processor's clock is source_hz / m * n / 2, the APB2 bus half of it or all of it, APB1 a quarter or half.
struct ClockPlan {
  Source source;
  std::uint32_t source_hz;
  std::uint32_t m, n;
  std::uint32_t q;  // for the 48 MHz domain, which nothing here uses: 2 to 15
  bool halve_apb2;
  bool over_drive;            // needed above 168 MHz (F42x, F43x)
  std::uint32_t flash_waits;  // at 2.7 V to 3.6 V: one for each 30 MHz begun, less one
  constexpr std::uint32_t hz() const { return source_hz / m * n / 2; }
  constexpr std::uint32_t apb2_hz() const { return halve_apb2 ? hz() / 2 : hz(); }
};

// STM32F429 with an 8 MHz crystal: 180 MHz, APB2 90 MHz.
inline constexpr ClockPlan kF429At180MHz{Source::crystal, 8'000'000, 4, 180, 8, true, true, 5};
// STM32F411 from its internal oscillator: 100 MHz, APB2 100 MHz. No crystal needed: the Nucleo comes without one.
inline constexpr ClockPlan kF411At100MHz{Source::internal, 16'000'000, 8, 100, 5, false, false, 3};
static_assert(kF429At180MHz.hz() == 180'000'000 && kF411At100MHz.hz() == 100'000'000);

template <RegisterIo Io>
struct Rcc {
  using Control = Register<Io, 0x40023800>;
  using Pll = Register<Io, 0x40023804>;
  using Config = Register<Io, 0x40023808>;
  using Ahb1 = Register<Io, 0x40023830>;
  using Apb1 = Register<Io, 0x40023840>;
  using Apb2 = Register<Io, 0x40023844>;
  using Power = Register<Io, 0x40007000>;
  using PowerState = Register<Io, 0x40007004>;
  using Flash = Register<Io, 0x40023C00>;
  static constexpr std::uint32_t kDma2 = 1u << 22;                    // of Ahb1; the ports are bits 0 (A) to 10 (K)
  static constexpr std::uint32_t kSpi1 = 1u << 12, kSpi5 = 1u << 20;  // of Apb2

  // A peripheral answers two bus cycles after its clock came: the read takes that long.
  template <typename Gate>
  static void open(std::uint32_t blocks) {
    Gate::raise(blocks);
    static_cast<void>(Gate::get());
  }

  static Fault begin(const ClockPlan& plan) {
    open<Apb1>(kPower);
    Power::raise(kScale1);
    Fault fault = begin_source(plan.source);
    if (fault == Fault::none) fault = begin_pll(plan);
    if (fault == Fault::none && plan.over_drive) fault = begin_over_drive();
    if (fault == Fault::none) fault = switch_to_pll(plan);
    return fault;
  }

 private:
  static constexpr std::uint32_t kPower = 1u << 28, kScale1 = 3u << 14;

  template <typename State>
  static Fault ready(std::uint32_t bits) {
    return wait_for([bits] { return State::all(bits); }, kClockPolls, Fault::clock_timeout);
  }

  static Fault begin_source(Source source) {
    constexpr std::uint32_t kInternal = 1, kCrystal = 1u << 16;
    const std::uint32_t on = source == Source::crystal ? kCrystal : kInternal;
    Control::raise(on);
    return ready<Control>(on << 1);
  }

  static Fault begin_pll(const ClockPlan& plan) {
    constexpr std::uint32_t kFromCrystal = 1u << 22, kOn = 1u << 24, kLocked = 1u << 25;
    Pll::set(plan.q << 24 | (plan.source == Source::crystal ? kFromCrystal : 0) | plan.n << 6 | plan.m);
    Control::raise(kOn);
    return ready<Control>(kLocked);
  }

  static Fault begin_over_drive() {
    constexpr std::uint32_t kOverDrive = 1u << 16, kSwitch = 1u << 17;  // the ready bits stand at the same places
    Power::raise(kOverDrive);
    const Fault fault = ready<PowerState>(kOverDrive);
    if (fault != Fault::none) return fault;
    Power::raise(kSwitch);
    return ready<PowerState>(kSwitch);
  }

  static Fault switch_to_pll(const ClockPlan& plan) {
    constexpr std::uint32_t kPrefetchAndCaches = 7u << 8, kToPll = 2, kOnPll = 2u << 2, kSwitchMask = 3;
    constexpr std::uint32_t kApb1By2 = 4u << 10, kApb1By4 = 5u << 10, kApb2By2 = 4u << 13, kDividers = 0xFCF0;
    Flash::set(kPrefetchAndCaches | plan.flash_waits);
    static_cast<void>(Flash::get());  // the wait states must hold before the clock rises
    Config::replace(kDividers, plan.halve_apb2 ? kApb1By4 | kApb2By2 : kApb1By2);
    Config::replace(kSwitchMask, kToPll);
    return wait_for([] { return (Config::get() & 3u << 2) == kOnPll; }, kClockPolls, Fault::clock_timeout);
  }
};

}  // namespace spanline::hal::stm32f4
