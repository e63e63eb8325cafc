#include "mcu/memory_timing.hpp"

#include <utility>

namespace spanline::host {

// The line goes first; those before its place, or all where it is new, make room.
bool CacheTags::take(std::uint32_t line) {
  std::uint32_t* const first = &tags_[std::size_t{line % sets_} * ways_];
  std::uint32_t moved = line;
  for (unsigned way = 0; way < ways_; ++way) {
    std::swap(moved, first[way]);
    if (moved == line) return true;
  }
  return false;
}

MemoryTiming::MemoryTiming(const Flash& flash)
    : flash_(flash), code_(flash.code_sets, flash.code_ways), data_(flash.data_sets, flash.data_ways) {}

unsigned MemoryTiming::turn_to(std::uint32_t line, std::uint64_t now) {
  const bool follows = flash_.prefetches && line == line_ + 1;
  const std::uint64_t ago = now - entered_;
  unsigned stall = 0;
  if (!code_.take(line)) stall = !follows ? miss_ : ago < miss_ ? miss_ - static_cast<unsigned>(ago) : 0;
  line_ = line;
  entered_ = now + stall;
  return stall;
}

}  // namespace spanline::host
