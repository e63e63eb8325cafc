#include "machine/stack.hpp"

#include "boards/common/stack.hpp"

namespace spanline::target {

[[gnu::noinline]] std::uint32_t stack_used_by(void (*work)()) {
  const std::uint32_t* before;
  asm volatile("mov %0, sp" : "=r"(before));
  boards::paint_stack(before);
  work();
  return boards::stack_used() - static_cast<std::uint32_t>(stack_top - before) * sizeof(std::uint32_t);
}

}  // namespace spanline::target
