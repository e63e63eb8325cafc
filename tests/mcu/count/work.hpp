// A little of everything that compilers make of C++: sorting, wide products, divides, a switch, clamps (IT blocks),
// recursion. For images that two machines execute, to compare what they count.
#pragma once

#include <cstdint>

extern "C" [[noreturn]] void reset();

namespace {

struct VectorTable {
  std::uint32_t stack;
  void (*reset)();
};
[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors = {0x20008000, reset};

std::uint32_t seed;
std::int32_t numbers[200];
volatile std::int64_t sum;
volatile std::int32_t state;

std::int32_t random_number() {
  seed = seed * 1664525u + 1013904223u;
  return static_cast<std::int32_t>(seed);
}

[[gnu::noinline]] std::int32_t clamp(std::int32_t v, std::int32_t low, std::int32_t high) {
  return v < low ? low : v > high ? high : v;
}

[[gnu::noinline]] std::int32_t choose(unsigned which) {
  switch (which) {
    case 0:
      return 5;
    case 1:
      return state;
    case 2:
      state = 3;
      return 9;
    case 3:
      return state * 7;
    case 4:
      return 1;
    case 5:
      return state / 3;
    default:
      return 77;
  }
}

[[gnu::noinline]] std::int32_t fibonacci(std::int32_t n) { return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2); }

void sort() {
  for (unsigned i = 1; i < 200; ++i) {
    const std::int32_t v = numbers[i];
    unsigned j = i;
    for (; j != 0 && numbers[j - 1] > v; --j) numbers[j] = numbers[j - 1];
    numbers[j] = v;
  }
}

[[gnu::noinline]] void work() {
  seed = 1;
  for (std::int32_t& number : numbers) number = random_number();
  sort();
  std::int64_t total = 0;
  for (unsigned i = 0; i < 200; ++i) {
    total += static_cast<std::int64_t>(numbers[i]) * numbers[199 - i];
    total ^= clamp(numbers[i], -1000, 1000) / static_cast<std::int32_t>(1 + (i & 7));
    total += choose(i & 7);
  }
  sum = total;
  state = fibonacci(12);
}

std::uint32_t semihosting(std::uint32_t operation, const void* block) {
  register std::uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = block;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

[[noreturn]] void leave() {
  constexpr std::uint32_t kExit = 0x20, kApplicationExit = 0x20026;
  const std::uint32_t reason[2] = {kApplicationExit, 0};
  for (;;) semihosting(kExit, reason);
}

}  // namespace
