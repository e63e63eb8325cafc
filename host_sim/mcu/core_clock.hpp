#pragma once

#include <cstdint>

namespace spanline::host {

// The one clock of a run: core cycles since reset, and their place in nanoseconds as the clock tree changes.
class CoreClock {
 public:
  explicit CoreClock(std::uint32_t kilohertz) : kilohertz_(kilohertz) {}

  std::uint32_t kilohertz() const { return kilohertz_; }
  void set_kilohertz(std::uint32_t kilohertz, std::uint64_t now) {
    ns_ = ns_at(now);
    since_ = now;
    kilohertz_ = kilohertz;
  }
  std::uint64_t ns_at(std::uint64_t cycle) const { return ns_ + (cycle - since_) * 1'000'000 / kilohertz_; }
  // The last cycle that has begun at `ns`, which is not before the clock's last change.
  std::uint64_t cycle_at(std::uint64_t ns) const { return since_ + (ns - ns_) * kilohertz_ / 1'000'000; }

 private:
  std::uint32_t kilohertz_;
  std::uint64_t since_ = 0, ns_ = 0;
};

}  // namespace spanline::host
