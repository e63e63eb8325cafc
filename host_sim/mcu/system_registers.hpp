// The core's own registers at 0xE0000000: SysTick, the cycle counter and what start-up code asks the system control
// block.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace spanline::host {

// `now` is simulated time in core cycles.
class SystemRegisters {
 public:
  static constexpr std::uint32_t kBase = 0xE000'0000, kBytes = 0x0010'0000;

  // Nothing where the register is not modelled.
  std::optional<std::uint32_t> read(std::uint32_t address, std::uint64_t now);
  bool write(std::uint32_t address, std::uint32_t value, std::uint64_t now);

  // When SysTick asks for its interrupt next, or has asked already; UINT64_MAX: never.
  std::uint64_t next_tick() const;
  // The core takes it.
  void take_tick(std::uint64_t now) { ticks_taken_ = turns(now); }

  // The vector table's address as the image set it; 0 at reset.
  std::uint32_t vectors() const;

 private:
  std::uint32_t tick_value(std::uint64_t now) const;
  std::uint64_t turns(std::uint64_t now) const;

  std::map<std::uint32_t, std::uint32_t> stored_;
  std::uint32_t tick_control_ = 0, tick_reload_ = 0, tick_stopped_at_ = 0;
  std::uint64_t tick_begin_ = 0, turns_seen_ = 0, ticks_taken_ = 0;
  std::uint32_t cycles_control_ = 0;
  std::uint64_t cycles_begin_ = 0;
};

}  // namespace spanline::host
