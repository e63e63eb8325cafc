// The integer divider beside each core of the RP2040 (datasheet, 2.3.1.5): an operand written starts it, eight cycles
// later quotient and remainder are there.
#pragma once

#include <cstdint>
#include <optional>

namespace spanline::host {

class SioDivider {
 public:
  // Where it lies in SIO.
  static constexpr std::uint32_t kOffset = 0x060, kBytes = 0x01C;

  // `offset` within the divider. Nothing where it is too early: the result is not there yet.
  std::optional<std::uint32_t> read(std::uint32_t offset, std::uint64_t now);
  bool write(std::uint32_t offset, std::uint32_t value, std::uint64_t now);

 private:
  void divide(std::uint64_t now);

  std::uint32_t dividend_ = 0, divisor_ = 0, quotient_ = 0, remainder_ = 0;
  bool signed_ = false, dirty_ = false;
  std::uint64_t ready_at_ = 0;
};

}  // namespace spanline::host
