#include "machine/semihosting.hpp"

namespace spanline::target {
namespace {

constexpr std::uint32_t kWrite0 = 0x04, kExitExtended = 0x20;
constexpr std::uint32_t kApplicationExit = 0x20026;

void call(std::uint32_t operation, const void* argument) {
  register std::uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

}  // namespace

void print(const char* text) { call(kWrite0, text); }

void print(std::uint32_t number) {
  char digits[11];
  char* at = digits + sizeof digits - 1;
  *at = 0;
  do {
    *--at = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  print(at);
}

void leave(int code) {
  const std::uint32_t reason[2] = {kApplicationExit, static_cast<std::uint32_t>(code)};
  for (;;) call(kExitExtended, reason);
}

}  // namespace spanline::target
