// From reset to main() on any Cortex-M: vector table, painted stack, data, bss, constructors; and what happens after a
// fault.
#include <cstdint>

#include "boards/common/report.hpp"
#include "boards/common/run_request.hpp"
#include "boards/common/stack.hpp"

int main();

// Places that the linker script names. data may contain code: copied, it runs without waiting for the flash.
extern "C" {
extern std::uint32_t data_image[], data_begin[], data_end[], bss_begin[], bss_end[];
extern void (*const init_array_begin[])();
extern void (*const init_array_end[])();
[[noreturn]] void reset();
void fault();
void tick();
[[gnu::used, noreturn]] void show_fault(const std::uint32_t* stacked);
}

// The request stays as the emulator wrote it.
[[gnu::section(".request"), gnu::used]] volatile spanline::boards::RunRequest run_request;

// Runs before its callees are in place: no calls until data is copied, no memcpy made from its loops (the build sees to
// it).
void reset() {
  std::uint32_t* here;
  asm volatile("mov %0, sp" : "=r"(here));
  spanline::boards::paint_stack(here);
  const std::uint32_t* from = data_image;
  for (std::uint32_t* to = data_begin; to != data_end; ++to) *to = *from++;
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) *to = 0;
  for (auto* constructor = init_array_begin; constructor != init_array_end; ++constructor) (*constructor)();
  main();
  spanline::boards::stop("main returned", 1, 0, 0);
}

// Looks at the stack pointer before anything is pushed: after an overflow there is nowhere to push to.
[[gnu::naked]] void fault() {
  asm volatile(
      "mrs r0, msp\n"
      "ldr r1, =stack_bottom + 64\n"
      "cmp r0, r1\n"
      "blo 1f\n"
      "ldr r1, =stack_top\n"
      "cmp r0, r1\n"
      "bls 2f\n"
      "1: ldr r1, =stack_top\n"
      "mov sp, r1\n"
      "movs r0, #0\n"
      "2: ldr r1, =show_fault\n"
      "bx r1\n"
      ".pool\n");
}

// `stacked`: r0 to r3, r12, lr, pc, psr; null where the stack is lost.
void show_fault(const std::uint32_t* stacked) {
  constexpr std::uint32_t kConfigurableFaultStatus = 0xE000ED28;  // reads as 0 on ARMv6-M
  std::uint32_t exception;
  asm volatile("mrs %0, ipsr" : "=r"(exception));
  const std::uint32_t status =
      *reinterpret_cast<const volatile std::uint32_t*>(std::uintptr_t{kConfigurableFaultStatus});
  const char* cause = stacked == nullptr ? "stack overflow" : exception == 3 ? "hard fault" : "unexpected exception";
  spanline::boards::stop(cause, exception, status, stacked == nullptr ? 0 : stacked[6]);
}

namespace {

// The initial stack pointer, reset, NMI, the faults and the system calls; no device interrupts anybody.
struct VectorTable {
  std::uint32_t* stack;
  void (*handlers[15])();
};
[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, tick}};

}  // namespace
