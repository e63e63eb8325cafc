#include "machine/stack.hpp"

// The lowest word of the stack, by the linker script.
extern "C" std::uint32_t stack_bottom[];

namespace spanline::target {
namespace {

constexpr std::uint32_t kPaint = 0xa5c3e187;  // no address, no small number

std::uint32_t* stack_pointer() {
  std::uint32_t* sp;
  asm volatile("mov %0, sp" : "=r"(sp));
  return sp;
}

}  // namespace

[[gnu::noinline]] void paint_stack() {
  for (volatile std::uint32_t* at = stack_bottom; at < stack_pointer(); ++at) *at = kPaint;
}

[[gnu::noinline]] std::uint32_t stack_used_by(void (*work)()) {
  paint_stack();
  std::uint32_t* const before = stack_pointer();
  work();
  const volatile std::uint32_t* deepest = stack_bottom;
  while (deepest < before && *deepest == kPaint) ++deepest;
  return static_cast<std::uint32_t>(before - deepest) * sizeof(std::uint32_t);
}

}  // namespace spanline::target
