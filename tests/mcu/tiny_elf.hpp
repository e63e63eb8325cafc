// ELF files of a few instructions, written by hand: the tests need no cross compiler.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spanline::host {

struct TinySymbol {
  std::string name;
  std::uint32_t address;  // with bit 0 for Thumb code
  std::uint32_t size = 0;
  bool function = true;
};

struct TinyElf {
  std::uint32_t base = 0;           // where the flash begins
  std::vector<std::uint16_t> code;  // at base + kCode; the vector table before it starts there
  std::vector<TinySymbol> symbols = {{"reset", 0x41, 0}};
  std::uint16_t machine = 40;  // Arm
  std::uint32_t stack = 0x2000'1000;
  std::uint32_t tick = 0;  // SysTick's vector

  static constexpr std::uint32_t kCode = 0x40;
};

// A path in a folder that this process alone uses and that goes with it.
std::string temporary_file(const std::string& name);

// Writes temporary_file(name) and returns its path.
std::string write_tiny_elf(const TinyElf& elf, const std::string& name);

}  // namespace spanline::host
