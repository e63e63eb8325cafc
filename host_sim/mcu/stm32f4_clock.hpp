// The STM32F4's clock tree, power control and flash interface (RM0090, RM0383).
#pragma once

#include <functional>

#include "mcu/peripheral.hpp"

namespace spanline::host {

class Stm32Power final : public RegisterBank {
 public:
  Stm32Power() : RegisterBank("PWR", 0x4000'7000, 0x400, {{kControl, 0xC000}, {kState, 0}}) {}
  bool write(std::uint32_t offset, std::uint32_t value) override;
  bool over_drive() const { return (at(kState) & 3u << 16) == 3u << 16; }

 private:
  static constexpr std::uint32_t kControl = 0, kState = 4;
};

// ACR: wait states, prefetch, caches.
class Stm32Flash final : public RegisterBank {
 public:
  using Waits = std::function<void(unsigned)>;
  explicit Stm32Flash(Waits waits)
      : RegisterBank("flash interface", 0x4002'3C00, 0x400, {{kAccess, 0}}), waits_(std::move(waits)) {}
  bool write(std::uint32_t offset, std::uint32_t value) override;
  unsigned wait_states() const { return at(kAccess) & 15; }

 private:
  static constexpr std::uint32_t kAccess = 0;
  Waits waits_;
};

class Stm32Rcc final : public RegisterBank {
 public:
  using SetClock = std::function<void(std::uint32_t kilohertz)>;
  using Complain = std::function<void(const std::string&)>;
  static constexpr std::uint32_t kResetKilohertz = 16'000;

  Stm32Rcc(std::uint32_t crystal_kilohertz, const Stm32Power& power, const Stm32Flash& flash, SetClock set_clock,
           Complain complain);

  std::optional<std::uint32_t> read(std::uint32_t offset) override;
  bool write(std::uint32_t offset, std::uint32_t value) override;

  bool ahb1(std::uint32_t bits) const { return (at(kAhb1) & bits) == bits; }
  bool apb2(std::uint32_t bits) const { return (at(kApb2) & bits) == bits; }

  // Of the core's clock: what the APB2 bus divides it by.
  std::uint32_t apb2_divisor() const;

 private:
  static constexpr std::uint32_t kControl = 0x00, kPll = 0x04, kConfig = 0x08, kAhb1 = 0x30, kApb1 = 0x40, kApb2 = 0x44;
  std::uint32_t pll_kilohertz() const;
  void switch_clock();

  std::uint32_t crystal_kilohertz_;
  const Stm32Power& power_;
  const Stm32Flash& flash_;
  SetClock set_clock_;
  Complain complain_;
};

}  // namespace spanline::host
