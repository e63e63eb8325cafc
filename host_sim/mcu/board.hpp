// What a board offers an image: its core, its memories, and which chip and panel are around them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geom/screen.hpp"
#include "mcu/wiring.hpp"

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
  // Whose peripherals are modelled.
  enum class Family : std::uint8_t { none, lm3s6965, stm32f4, rp2040 };

  const char* name;
  Core core;
  std::uint32_t kilohertz;  // of the core, as its firmware sets it
  std::vector<Memory> memories;
  Family family = Family::none;
  std::uint32_t crystal_kilohertz = 0;  // 0: none
  std::optional<PanelWiring> panel = {};
  Screen screen = {};  // of the panel

  bool holds(std::uint32_t address, std::uint32_t size) const;
  const Memory* memory_at(std::uint32_t address) const;
};

// Throws UsageError with the names of all boards where there is none of that name.
const BoardDescription& board_named(const std::string& name);

}  // namespace spanline::host
