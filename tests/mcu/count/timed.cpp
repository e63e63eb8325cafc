// The work on an LM3S6965 at 50 MHz, and how many ticks of SysTick it took.
#include "work.hpp"

namespace {

volatile std::uint32_t& at(std::uint32_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(std::uintptr_t{address});
}

// The work between two marks for whoever counts from outside.
extern "C" [[gnu::noinline]] void work_begin() { asm volatile(""); }
extern "C" [[gnu::noinline]] void work_end() { asm volatile(""); }

void print_hex(std::uint32_t value) {
  constexpr std::uint32_t kWrite0 = 4;
  char text[10] = {};
  for (int i = 7; i >= 0; --i, value >>= 4) text[i] = "0123456789abcdef"[value & 15];
  text[8] = '\n';
  semihosting(kWrite0, text);
}

}  // namespace

void reset() {
  constexpr std::uint32_t kRunClock = 0x400F'E060, kPllBy4 = 0x01C0'0340;  // PLL from the main crystal, 200 MHz / 4
  constexpr std::uint32_t kControl = 0xE000'E010, kReload = 0xE000'E014, kValue = 0xE000'E018;
  constexpr std::uint32_t kEnable = 1, kProcessorClock = 4, kMask = 0x00FF'FFFF;
  at(kRunClock) = kPllBy4;
  at(kReload) = kMask;
  at(kValue) = 0;
  at(kControl) = kEnable | kProcessorClock;
  const std::uint32_t before = at(kValue);
  work_begin();
  work();
  work_end();
  print_hex((before - at(kValue)) & kMask);
  leave();
}
