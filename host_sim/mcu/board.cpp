#include "mcu/board.hpp"

#include <array>

#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kKb = 1024, kMb = 1024 * 1024;

// A bare core with room wherever vendors put flash and RAM, for images that belong to no board of ours.
BoardDescription bare(const char* name, Core core) {
  return {name,
          core,
          1000,
          {{"code", 0, 16 * kMb, true},
           {"flash", 0x0800'0000, 16 * kMb, true},
           {"xip", 0x1000'0000, 16 * kMb, true},
           {"ram", 0x2000'0000, 16 * kMb, false}}};
}

BoardDescription mps2(const char* name, Core core) {
  return {name, core, 25'000, {{"code", 0, 4 * kMb, true}, {"ram", 0x2000'0000, 4 * kMb, false}}};
}

constexpr std::uint8_t kMemoryWrite = 0x2C;  // RAMWR of MIPI DCS
using Family = BoardDescription::Family;

BoardDescription lm3s6965() {
  return {"ek-lm3s6965",
          Core::m3,
          50'000,
          {{"flash", 0, 256 * kKb, true}, {"ram", 0x2000'0000, 64 * kKb, false}},
          Family::lm3s6965,
          8'000,
          PanelWiring{"ssd0323", hal::Rotation::r0, {'A', 2}, {'A', 5}, {'A', 3}, {'C', 7}, {}, {}},
          {128, 64, PixelFormat::grey4}};
}

BoardDescription stm32f429() {
  return {"stm32f429i-disc1",
          Core::m4,
          180'000,
          {{"flash", 0x0800'0000, 2 * kMb, true},
           {"ccm", 0x1000'0000, 64 * kKb, false},
           {"ram", 0x2000'0000, 192 * kKb, false}},
          Family::stm32f4,
          8'000,
          PanelWiring{"ili9341", hal::Rotation::r0, {'F', 7}, {'F', 9}, {'C', 2}, {'D', 13}, {}, kMemoryWrite},
          {240, 320, PixelFormat::rgb565}};
}

BoardDescription stm32f411() {
  return {
      "nucleo-f411re",
      Core::m4,
      100'000,
      {{"flash", 0x0800'0000, 512 * kKb, true}, {"ram", 0x2000'0000, 128 * kKb, false}},
      Family::stm32f4,
      0,
      PanelWiring{
          "st7789-240x240", hal::Rotation::r0, {'A', 5}, {'A', 7}, {'B', 6}, {'C', 7}, PinName{'A', 9}, kMemoryWrite},
      {240, 240, PixelFormat::rgb565}};
}

BoardDescription pico() {
  return {"pico",
          Core::m0plus,
          125'000,
          {{"flash", 0x1000'0000, 2 * kMb, true}, {"ram", 0x2000'0000, 264 * kKb, false}},
          Family::rp2040,
          12'000,
          PanelWiring{
              "st7789", hal::Rotation::r90, {'P', 18}, {'P', 19}, {'P', 17}, {'P', 20}, PinName{'P', 21}, kMemoryWrite},
          {320, 240, PixelFormat::rgb565}};
}

// Sizes from the parts' datasheets, wiring from the boards' schematics; the STM32's flash is not mapped at 0, since our
// images never reach for it there.
const std::vector<BoardDescription>& boards() {
  static const std::vector<BoardDescription> all = {
      lm3s6965(),
      stm32f429(),
      stm32f411(),
      pico(),
      {"microbit", Core::m0, 16'000, {{"flash", 0, 256 * kKb, true}, {"ram", 0x2000'0000, 16 * kKb, false}}},
      mps2("mps2-an385", Core::m3),
      mps2("mps2-an386", Core::m4),
      mps2("mps2-an500", Core::m7),
      {"mps2-an505", Core::m33, 20'000, {{"code", 0x1000'0000, 4 * kMb, true}, {"ram", 0x3800'0000, 2 * kMb, false}}},
      bare("cortex-m0", Core::m0),
      bare("cortex-m0plus", Core::m0plus),
      bare("cortex-m3", Core::m3),
      bare("cortex-m4", Core::m4),
      bare("cortex-m7", Core::m7),
      bare("cortex-m33", Core::m33)};
  return all;
}

}  // namespace

const char* name(Core core) {
  constexpr std::array<const char*, 6> kNames = {"Cortex-M0", "Cortex-M0+", "Cortex-M3",
                                                 "Cortex-M4", "Cortex-M7",  "Cortex-M33"};
  return kNames[static_cast<std::size_t>(core)];
}

bool has_cycle_model(Core core) { return core != Core::m7 && core != Core::m33; }

const BoardDescription::Memory* BoardDescription::memory_at(std::uint32_t address) const {
  for (const Memory& memory : memories) {
    if (address - memory.base < memory.size) return &memory;
  }
  return nullptr;
}

bool BoardDescription::holds(std::uint32_t address, std::uint32_t size) const {
  const Memory* const memory = memory_at(address);
  return memory != nullptr && size <= memory->size - (address - memory->base);
}

const BoardDescription& board_named(const std::string& name) {
  std::string known;
  for (const BoardDescription& board : boards()) {
    if (name == board.name) return board;
    known += std::string(known.empty() ? "" : ", ") + board.name;
  }
  throw UsageError("--board: no board '" + name + "'; there are: " + known);
}

}  // namespace spanline::host
