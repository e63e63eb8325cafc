// From reset to main() on any Cortex-M: vector table, painted stack, data, bss, constructors.
#include <cstdint>

#include "machine/semihosting.hpp"
#include "machine/stack.hpp"

int main();

// Places that the linker script names.
extern "C" {
extern std::uint32_t stack_top[], data_image[], data_begin[], data_end[], bss_begin[], bss_end[];
extern void (*const init_array_begin[])();
extern void (*const init_array_end[])();
}

extern "C" [[noreturn, gnu::used]] void report_fault(std::uint32_t exception) {
  spanline::target::print("fault=");
  spanline::target::print(exception);
  spanline::target::print("\n");
  spanline::target::leave(1);
}

// ARMv6-M has the hard fault only; the finer faults of the others end there too while they are not enabled. The stack
// may be what is broken (it overflowed out of RAM), so the handler begins it anew.
extern "C" [[gnu::naked]] void fault() {
  asm volatile(
      "mrs r0, ipsr\n"
      "ldr r1, =stack_top\n"
      "mov sp, r1\n"
      "bl report_fault\n"
      ".ltorg");
}

extern "C" [[noreturn]] void reset() {
  spanline::target::paint_stack();
  const std::uint32_t* from = data_image;
  for (std::uint32_t* to = data_begin; to != data_end; ++to) *to = *from++;
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) *to = 0;
  for (auto* constructor = init_array_begin; constructor != init_array_end; ++constructor) (*constructor)();
  spanline::target::leave(main());
}

// The initial stack pointer, reset, NMI, the faults and the system calls; no device interrupts anybody.
struct VectorTable {
  std::uint32_t* stack;
  void (*handlers[15])();
};
[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};
