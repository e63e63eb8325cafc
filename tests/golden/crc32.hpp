#pragma once

#include <cstdint>

#include "core/base/slice.hpp"

namespace spanline::golden {

// CRC-32 as in IEEE 802.3 and PNG.
class Crc32 {
 public:
  void add(Slice<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      register_ ^= byte;
      for (int bit = 0; bit < 8; ++bit) register_ = register_ >> 1 ^ ((register_ & 1u) != 0 ? 0xedb88320u : 0u);
    }
  }
  std::uint32_t value() const { return ~register_; }

 private:
  std::uint32_t register_ = 0xffffffffu;
};

}  // namespace spanline::golden
