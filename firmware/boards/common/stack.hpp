// The stack lies at the bottom of RAM: an overflow leaves RAM and faults. It is painted at reset, and what has lost its
// paint was used.
#pragma once

#include <cstdint>

// By the linker script.
extern "C" std::uint32_t stack_bottom[], stack_top[];

namespace spanline::boards {

inline constexpr std::uint32_t kStackPaint = 0xA5C3E187;  // no address, no small number

// Paints the stack up to `end`. Never a call: start-up paints before its callees are in place.
[[gnu::always_inline]] inline void paint_stack(const std::uint32_t* end) {
  for (volatile std::uint32_t* at = stack_bottom; at < end; ++at) *at = kStackPaint;
}

// Bytes of the deepest use so far.
inline std::uint32_t stack_used() {
  const volatile std::uint32_t* deepest = stack_bottom;
  while (deepest < stack_top && *deepest == kStackPaint) ++deepest;
  return static_cast<std::uint32_t>(stack_top - deepest) * sizeof(std::uint32_t);
}

}  // namespace spanline::boards
