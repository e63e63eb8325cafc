// What boards have in common: a clock on the core's timer, and a demo's budget taken as it is.
#pragma once

#include "core/frame/budget.hpp"
#include "hal/mcu/systick.hpp"

namespace spanline::boards {

// A board whose time comes from SysTick, at kHz.
template <std::uint32_t kHz>
class Clocked {
 public:
  using Time = hal::SysTick<hal::Mmio, kHz>;
  static void tick() { Time::tick(); }
  // Sleeps for good, the picture stays.
  [[noreturn]] static void rest() {
    for (;;) asm volatile("wfi");
  }

 protected:
  Time time_;
};

struct AnyBudget {
  static constexpr Budget fit(const Budget& budget) { return budget; }
};

}  // namespace spanline::boards
