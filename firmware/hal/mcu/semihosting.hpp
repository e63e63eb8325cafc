// Arm's semihosting: how an image speaks to the emulator that runs it. Without an emulator or debugger that listens,
// the breakpoint is a fault: call only where one is known to be there.
#pragma once

#include <cstdint>

namespace spanline::hal::semihosting {

inline void call(std::uint32_t operation, const void* argument) {
  register std::uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

inline void print(const char* text) {
  constexpr std::uint32_t kWrite0 = 0x04;
  call(kWrite0, text);
}

// Ends the run; `code` becomes the emulator's exit status.
[[noreturn]] inline void leave(std::uint32_t code) {
  constexpr std::uint32_t kExitExtended = 0x20, kApplicationExit = 0x20026;
  const std::uint32_t reason[2] = {kApplicationExit, code};
  for (;;) call(kExitExtended, reason);
}

}  // namespace spanline::hal::semihosting
