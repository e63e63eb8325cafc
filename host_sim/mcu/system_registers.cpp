#include "mcu/system_registers.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kTickControl = 0xE000'E010, kTickReload = 0xE000'E014, kTickValue = 0xE000'E018;
constexpr std::uint32_t kInterruptState = 0xE000'ED04, kVectors = 0xE000'ED08, kTickPending = 1u << 26;
constexpr std::uint32_t kCyclesControl = 0xE000'1000, kCycles = 0xE000'1004;
constexpr std::uint32_t kEnable = 1, kInterrupt = 2, kReachedZero = 1u << 16, kMask24 = 0x00FF'FFFF;

// Registers that keep what was written: VTOR, AIRCR, SCR, CCR, SHPR1 to 3, SHCSR, CFSR, HFSR, CPACR, DEMCR, FPCCR.
bool keeps(std::uint32_t address) {
  constexpr std::uint32_t kFirst = 0xE000'ED08, kLast = 0xE000'ED2C;
  return (address >= kFirst && address <= kLast) || address == 0xE000'ED88 || address == 0xE000'EDFC ||
         address == 0xE000'EF34;
}

}  // namespace

// Writing the value clears it; the next cycle loads it anew.
std::uint32_t SystemRegisters::tick_value(std::uint64_t now) const {
  if ((tick_control_ & kEnable) == 0) return tick_stopped_at_;
  if (now == tick_begin_) return 0;
  return tick_reload_ - static_cast<std::uint32_t>((now - tick_begin_ - 1) % (std::uint64_t{tick_reload_} + 1));
}

// How often the counter has reached zero since it began.
std::uint64_t SystemRegisters::turns(std::uint64_t now) const {
  return (tick_control_ & kEnable) == 0 ? 0 : (now - tick_begin_) / (std::uint64_t{tick_reload_} + 1);
}

std::uint64_t SystemRegisters::next_tick() const {
  constexpr std::uint32_t kBoth = kEnable | kInterrupt;
  if ((tick_control_ & kBoth) != kBoth) return UINT64_MAX;
  return tick_begin_ + (ticks_taken_ + 1) * (std::uint64_t{tick_reload_} + 1);
}

std::uint32_t SystemRegisters::vectors() const {
  const auto found = stored_.find(kVectors);
  return found == stored_.end() ? 0 : found->second;
}

std::optional<std::uint32_t> SystemRegisters::read(std::uint32_t address, std::uint64_t now) {
  switch (address) {
    case kTickControl: {
      const bool reached_zero = turns(now) > turns_seen_;
      turns_seen_ = turns(now);
      return tick_control_ | (reached_zero ? kReachedZero : 0);
    }
    case kTickReload:
      return tick_reload_;
    case kInterruptState:
      return next_tick() <= now ? kTickPending : 0;
    case kTickValue:
      return tick_value(now);
    case kCyclesControl:
      return cycles_control_;
    case kCycles:
      return (cycles_control_ & kEnable) != 0 ? static_cast<std::uint32_t>(now - cycles_begin_) : 0;
    default:
      if (!keeps(address)) return std::nullopt;
      return stored_[address];
  }
}

bool SystemRegisters::write(std::uint32_t address, std::uint32_t value, std::uint64_t now) {
  switch (address) {
    case kTickControl:
      tick_stopped_at_ = tick_value(now);
      tick_control_ = value & 7;
      tick_begin_ = now;
      turns_seen_ = ticks_taken_ = 0;
      return true;
    case kTickReload:
      tick_reload_ = value & kMask24;
      return true;
    case kTickValue:
      tick_begin_ = now;
      tick_stopped_at_ = 0;
      turns_seen_ = ticks_taken_ = 0;
      return true;
    case kCyclesControl:
      cycles_control_ = value;
      return true;
    case kCycles:
      cycles_begin_ = now - value;
      return true;
    default:
      if (!keeps(address)) return false;
      stored_[address] = value;
      return true;
  }
}

}  // namespace spanline::host
