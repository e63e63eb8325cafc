// Time from the core's own timer, which every Cortex-M of this house has.
#pragma once

#include "hal/mcu/mmio.hpp"

namespace spanline::hal {

// A Clock. Put tick() into the vector table: it runs once a millisecond. kHz: the processor's clock, whole megahertz.
template <RegisterIo Io, std::uint32_t kHz>
class SysTick {
  static_assert(kHz >= 1'000'000 && kHz % 1'000'000 == 0, "SysTick counts whole cycles of a microsecond");
  static constexpr std::uint32_t kPerUs = kHz / 1'000'000, kPerMs = kPerUs * 1000;
  static_assert(kPerMs <= 1u << 24, "the counter has 24 bits");
  using Control = Register<Io, 0xE000E010>;
  using Reload = Register<Io, 0xE000E014>;
  using Value = Register<Io, 0xE000E018>;
  using InterruptState = Register<Io, 0xE000ED04>;
  static constexpr std::uint32_t kEnable = 1, kInterrupt = 2, kProcessorClock = 4;
  static constexpr std::uint32_t kPending = 1u << 26;  // of InterruptState

 public:
  static void begin() {
    Reload::set(kPerMs - 1);
    Value::set(0);
    Control::set(kEnable | kInterrupt | kProcessorClock);
    // The counter begins at 0, which would be the end of a millisecond: a cycle later, in emulation many, it has its
    // start value.
    static_cast<void>(wait_for([] { return Value::get() != 0; }, kPerMs, Fault::clock_timeout));
  }

  static void tick() { ms_ = ms_ + 1; }

  // Wraps after 71 minutes. Where the counter has wrapped and tick() has not run yet, that millisecond counts already.
  std::uint32_t now_us() const {
    std::uint32_t ms = ms_;
    std::uint32_t left = Value::get();
    if (InterruptState::any(kPending) || ms != ms_) {
      left = Value::get();
      ms = ms_ + (InterruptState::any(kPending) ? 1 : 0);
    }
    return ms * 1000 + (kPerMs - 1 - left) / kPerUs;
  }

  // Bounded even where the timer stands still: a turn takes more than one cycle.
  void delay_us(std::uint32_t us) const {
    const std::uint32_t from = now_us();
    for (std::uint32_t turns = turns_for(us); turns != 0; --turns) {
      if (now_us() - from > us) return;
    }
  }

 private:
  static constexpr std::uint32_t turns_for(std::uint32_t us) {
    return us < UINT32_MAX / kPerUs ? us * kPerUs + kPerUs : UINT32_MAX;
  }
  static inline volatile std::uint32_t ms_ = 0;
};

}  // namespace spanline::hal
