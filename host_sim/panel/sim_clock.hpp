#pragma once

#include <cstdint>

namespace spanline::host {

// Simulated time: it passes where somebody waits or a byte crosses the wire. Satisfies hal::Clock.
class SimClock {
 public:
  void delay_us(std::uint32_t us) { advance_ns(std::uint64_t{us} * 1000); }
  std::uint32_t now_us() const { return static_cast<std::uint32_t>(now_ns_ / 1000); }

  void advance_ns(std::uint64_t ns) { now_ns_ += ns; }
  std::uint64_t now_ns() const { return now_ns_; }

 private:
  std::uint64_t now_ns_ = 1'000'000'000;  // power has been on for a while
};

}  // namespace spanline::host
