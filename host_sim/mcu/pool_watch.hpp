// Watches a frame's pools in the image's RAM: blocks are handed out in order, so the highest one ever written is the
// pool's high-water mark.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mcu/debug_info.hpp"
#include "mcu/image.hpp"

namespace spanline::host {

struct PoolUse {
  std::string name;
  std::uint32_t block_bytes, capacity;  // without the sink, block 0
  std::uint32_t used = 0;
};

class PoolWatch {
 public:
  // Finds the FrameMemory of the image; watches nothing where there is none, or no debug information.
  PoolWatch(const Image& image, const DebugInfo& debug);

  void written(std::uint32_t address) {
    if (address - base_ < bytes_) note(address);
  }
  // What start-up wrote does not count.
  void clear();

  const std::vector<PoolUse>& pools() const { return pools_; }

 private:
  struct Range {
    std::uint32_t base, bytes;
    std::size_t pool;
  };
  void add_pools(const DebugInfo::Structure& structure, std::uint32_t base, const DebugInfo& debug);
  void note(std::uint32_t address);

  std::uint32_t base_ = 0, bytes_ = 0;
  std::vector<Range> ranges_;  // two of the same pool where it has two halves
  std::vector<PoolUse> pools_;
};

}  // namespace spanline::host
