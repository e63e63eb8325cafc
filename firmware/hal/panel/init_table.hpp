// Controller set-up as data, one step after another: command, argument count | kDelay, the arguments and, where kDelay
// is set, the milliseconds to wait afterwards.
#pragma once

#include <cstdint>

#include "core/base/slice.hpp"

namespace spanline::hal {

inline constexpr std::uint8_t kDelay = 0x80;

struct InitStep {
  std::uint8_t command = 0;
  Slice<const std::uint8_t> arguments;
  std::uint8_t delay_ms = 0;
};

class InitReader {
 public:
  constexpr explicit InitReader(Slice<const std::uint8_t> table) : rest_(table) {}

  // The next step; false at the end of the table, or where the rest is shorter than its step says.
  constexpr bool next(InitStep& step) {
    if (rest_.size() < 2) return false;
    const bool delayed = (rest_[1] & kDelay) != 0;
    const std::uint32_t count = rest_[1] & (kDelay - 1u);
    const std::uint32_t size = 2 + count + (delayed ? 1 : 0);
    if (rest_.size() < size) return false;
    step.command = rest_[0];
    step.arguments = {rest_.data() + 2, count};
    step.delay_ms = delayed ? rest_[size - 1] : std::uint8_t{0};
    rest_ = {rest_.data() + size, rest_.size() - size};
    return true;
  }

  constexpr bool at_end() const { return rest_.empty(); }

 private:
  Slice<const std::uint8_t> rest_;
};

constexpr bool well_formed(Slice<const std::uint8_t> table) {
  InitReader reader(table);
  for (InitStep step; reader.next(step);) {
  }
  return reader.at_end();
}

}  // namespace spanline::hal
