// Registers. `Io` is the processor's own memory on a board and a fake on the host, so that every driver of this folder
// can be tried without hardware: `Io` has get(address), set(address, value) and address_of(memory), the address that a
// DMA controller knows memory by.
#pragma once

#include <concepts>
#include <cstdint>

#include "hal/fault.hpp"

namespace spanline::hal {

template <typename T>
concept RegisterIo = requires(std::uint32_t address, std::uint32_t value, const void* memory) {
  { T::get(address) } -> std::same_as<std::uint32_t>;
  { T::set(address, value) } -> std::same_as<void>;
  { T::address_of(memory) } -> std::same_as<std::uint32_t>;
};

struct Mmio {
  static std::uint32_t get(std::uint32_t address) { return *at(address); }
  static void set(std::uint32_t address, std::uint32_t value) { *at(address) = value; }
  // What was written to memory so far is there before a DMA controller hears of it.
  static std::uint32_t address_of(const void* memory) {
    asm volatile("" : : : "memory");
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(memory));
  }

 private:
  static volatile std::uint32_t* at(std::uint32_t address) {
    return reinterpret_cast<volatile std::uint32_t*>(std::uintptr_t{address});
  }
};

// One 32-bit register.
template <RegisterIo Io, std::uint32_t kAddress>
struct Register {
  static constexpr std::uint32_t kAt = kAddress;
  static std::uint32_t get() { return Io::get(kAddress); }
  static void set(std::uint32_t value) { Io::set(kAddress, value); }
  static bool any(std::uint32_t bits) { return (get() & bits) != 0; }
  static bool all(std::uint32_t bits) { return (get() & bits) == bits; }
  static void raise(std::uint32_t bits) { set(get() | bits); }
  static void lower(std::uint32_t bits) { set(get() & ~bits); }
  // The bits of `mask` become those of `value`.
  static void replace(std::uint32_t mask, std::uint32_t value) { set((get() & ~mask) | value); }
};

// Asks `ready` at most `polls` times; `otherwise` is what went wrong when it never was.
template <typename Ready>
Fault wait_for(Ready ready, std::uint32_t polls, Fault otherwise) {
  for (; polls != 0; --polls) {
    if (ready()) return Fault::none;
  }
  return otherwise;
}

// Polls for what takes `cycles` of the processor's clock: a poll reads a register, compares and branches, never in less
// than 4 cycles, so this is more than four times as long.
constexpr std::uint32_t polls_for(std::uint32_t cycles) { return cycles + 64; }

// Oscillators and PLLs start within 20 ms; at reset no core here is faster than 16 MHz.
inline constexpr std::uint32_t kClockPolls = 320'000;

}  // namespace spanline::hal
