// What a board offers an image: its core and its memories. Peripherals are not here: touching one stops the run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spanline::host {

enum class Core : std::uint8_t { m0, m0plus, m3, m4, m7, m33 };

// "Cortex-M0+".
const char* name(Core core);

// False for the cores of which instructions are counted only.
bool has_cycle_model(Core core);

struct BoardDescription {
  struct Memory {
    const char* name;
    std::uint32_t base, size;  // whole pages of 4 KB
    bool flash;
  };
  const char* name;
  Core core;
  std::uint32_t kilohertz;
  std::vector<Memory> memories;

  bool holds(std::uint32_t address, std::uint32_t size) const;
  const Memory* memory_at(std::uint32_t address) const;
};

// Throws UsageError with the names of all boards where there is none of that name.
const BoardDescription& board_named(const std::string& name);

}  // namespace spanline::host
