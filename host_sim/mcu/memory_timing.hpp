// What memory adds to the core's cycles: wait states behind a cache and a prefetch buffer. An estimate: how a vendor's
// buffer works inside is not published to the cycle.
#pragma once

#include <cstdint>
#include <vector>

namespace spanline::host {

// Tags of a cache with least-recently-used replacement.
class CacheTags {
 public:
  CacheTags() = default;
  CacheTags(unsigned sets, unsigned ways) : sets_(sets), ways_(ways), tags_(std::size_t{sets} * ways, kEmpty) {}

  // Looks for a line, and keeps it from now on. True where it was there.
  bool take(std::uint32_t line);

 private:
  static constexpr std::uint32_t kEmpty = UINT32_MAX;
  unsigned sets_ = 0, ways_ = 0;
  std::vector<std::uint32_t> tags_;  // of each set, the one used last first
};

class MemoryTiming {
 public:
  // The memory that stalls.
  struct Flash {
    std::uint32_t base = 0, size = 0;
    unsigned line_bits = 4;  // a line is 2 to this power bytes
    unsigned code_sets = 1, code_ways = 1;
    unsigned data_sets = 0, data_ways = 0;  // no sets: data share the cache with the code
    bool prefetches = false;                // the line behind the one that is executed
  };

  // Nothing stalls.
  MemoryTiming() = default;
  explicit MemoryTiming(const Flash& flash);

  // Cycles that a line costs which is in no cache.
  void set_miss(unsigned cycles) { miss_ = cycles; }

  // Stall cycles of an instruction's fetch and of a datum's read; `now` is the core's time.
  unsigned fetch(std::uint32_t address, std::uint64_t now) {
    if (address - flash_.base >= flash_.size || address >> flash_.line_bits == line_) return 0;
    return turn_to(address >> flash_.line_bits, now);
  }
  // So much time passes in which the code goes round and comes back to where it is.
  void pass(std::uint64_t time) { entered_ += time; }
  unsigned read(std::uint32_t address) {
    if (address - flash_.base >= flash_.size) return 0;
    CacheTags& tags = flash_.data_sets == 0 ? code_ : data_;
    return tags.take(address >> flash_.line_bits) ? 0 : miss_;
  }

 private:
  unsigned turn_to(std::uint32_t line, std::uint64_t now);

  Flash flash_;
  CacheTags code_, data_;
  unsigned miss_ = 0;
  std::uint32_t line_ = UINT32_MAX;  // the one being executed
  std::uint64_t entered_ = 0;        // when: the prefetch of its successor began then
};

}  // namespace spanline::host
