#pragma once

#include <cstdint>

namespace spanline::host {

// What a run took, its parts apart.
struct Count {
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;   // core cycles, zero wait states; 0 on cores without a model
  std::uint64_t stalls = 0;   // cycles in which the core waits for memory: an estimate
  std::uint64_t waiting = 0;  // of cycles and stalls: spent in loops that ask a register again and again

  Count& operator+=(const Count& other) {
    instructions += other.instructions;
    cycles += other.cycles;
    stalls += other.stalls;
    waiting += other.waiting;
    return *this;
  }
  Count operator-(const Count& other) const {
    return {instructions - other.instructions, cycles - other.cycles, stalls - other.stalls, waiting - other.waiting};
  }
  std::uint64_t time() const { return cycles + stalls; }
  std::uint64_t busy() const { return time() - waiting; }
};

}  // namespace spanline::host
