// What lies where for the core: memories, the image in them, and windows behind which registers answer.
#pragma once

#include <cstdint>
#include <deque>

#include "mcu/board.hpp"
#include "mcu/core_state.hpp"
#include "mcu/image.hpp"

namespace spanline::host {

// Whoever answers for registers.
class RegisterAccess {
 public:
  virtual std::uint32_t read_register(std::uint32_t address, unsigned size) = 0;
  virtual void write_register(std::uint32_t address, unsigned size, std::uint32_t value) = 0;

 protected:
  ~RegisterAccess() = default;
};

class MemoryMap {
 public:
  static constexpr std::uint32_t kPage = 0x1000;

  MemoryMap(CoreState& core, RegisterAccess& registers) : core_(core), registers_(registers) {}
  MemoryMap(const MemoryMap&) = delete;
  MemoryMap& operator=(const MemoryMap&) = delete;

  // The board's memories, and the image where the flash programmer puts it.
  void map_memories(const BoardDescription& board, const Image& image);

  // Whole pages.
  void map_registers(std::uint32_t base, std::uint32_t bytes);

 private:
  struct Window {
    RegisterAccess* registers;
    std::uint32_t base;
  };

  CoreState& core_;
  RegisterAccess& registers_;
  std::deque<Window> windows_;  // the emulator keeps their addresses
};

}  // namespace spanline::host
