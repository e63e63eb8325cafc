#include "mcu/stm32f4_clock.hpp"

namespace spanline::host {

bool Stm32Power::write(std::uint32_t offset, std::uint32_t value) {
  if (offset != kControl) return false;
  at(kControl) = value;
  at(kState) = value & 3u << 16;  // over-drive and its switch are ready at once
  return true;
}

bool Stm32Flash::write(std::uint32_t offset, std::uint32_t value) {
  if (!RegisterBank::write(offset, value)) return false;
  waits_(value & 15);
  return true;
}

Stm32Rcc::Stm32Rcc(std::uint32_t crystal_kilohertz, const Stm32Power& power, const Stm32Flash& flash,
                   SetClock set_clock, Complain complain)
    : RegisterBank("RCC", 0x4002'3800, 0x400,
                   {{kControl, 0x83}, {kPll, 0x2400'3010}, {kConfig, 0}, {kAhb1, 0x0010'0000}, {kApb1, 0}, {kApb2, 0}}),
      crystal_kilohertz_(crystal_kilohertz),
      power_(power),
      flash_(flash),
      set_clock_(std::move(set_clock)),
      complain_(std::move(complain)) {}

std::optional<std::uint32_t> Stm32Rcc::read(std::uint32_t offset) {
  const std::optional<std::uint32_t> value = RegisterBank::read(offset);
  if (!value) return value;
  constexpr std::uint32_t kOn = 1u << 0 | 1u << 24;
  const std::uint32_t crystal = crystal_kilohertz_ != 0 ? 1u << 16 : 0;
  if (offset == kControl) return *value | (*value & (kOn | crystal)) << 1;  // every ready bit follows its switch
  if (offset == kConfig) return (*value & ~(3u << 2)) | (*value & 3) << 2;
  return value;
}

bool Stm32Rcc::write(std::uint32_t offset, std::uint32_t value) {
  if (!RegisterBank::write(offset, value)) return false;
  if (offset == kConfig) switch_clock();
  return true;
}

std::uint32_t Stm32Rcc::pll_kilohertz() const {
  const std::uint32_t pll = at(kPll), m = pll & 63, n = pll >> 6 & 511, p = 2 * (pll >> 16 & 3) + 2;
  const std::uint32_t source = (pll & 1u << 22) != 0 ? crystal_kilohertz_ : kResetKilohertz;
  const std::uint32_t input = m < 2 ? 0 : source / m;
  if (input < 950 || input > 2100) complain_("the PLL's input is not 0.95 to 2.1 MHz");
  if (input * n < 100'000 || input * n > 432'000) complain_("the PLL's oscillator is not at 100 to 432 MHz");
  return input * n / p;
}

void Stm32Rcc::switch_clock() {
  constexpr std::uint32_t kToPll = 2, kMostWithoutOverDrive = 168'000, kMost = 180'000, kOfAWaitState = 30'000;
  const std::uint32_t from = at(kConfig) & 3;
  const std::uint32_t kilohertz = from == kToPll ? pll_kilohertz() : from == 1 ? crystal_kilohertz_ : kResetKilohertz;
  if (kilohertz == 0) return complain_("the core is switched to a clock that does not run");
  if (kilohertz > kMost || (kilohertz > kMostWithoutOverDrive && !power_.over_drive())) {
    complain_("the core runs at " + std::to_string(kilohertz) + " kHz, which the supply does not allow");
  }
  if (kilohertz > kOfAWaitState * (flash_.wait_states() + 1)) {
    complain_("the flash has too few wait states for " + std::to_string(kilohertz) + " kHz");
  }
  set_clock_(kilohertz);
}

std::uint32_t Stm32Rcc::apb2_divisor() const {
  const std::uint32_t code = at(kConfig) >> 13 & 7;
  return code < 4 ? 1 : 2u << (code - 4);
}

}  // namespace spanline::host
