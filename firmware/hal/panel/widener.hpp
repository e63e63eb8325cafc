#pragma once

#include <cstdint>

#include "core/base/slice.hpp"

namespace spanline::hal {

// Makes three bytes of each rgb565 pixel for controllers that take 18-bit colour only (their low two bits are ignored):
// chunk by chunk, in two buffers by turns, so that one is filled while the other is in flight.
class Widener {
 public:
  static constexpr std::uint32_t kPixels = 32;              // a chunk
  static constexpr std::uint32_t kLineBytes = 2 * kPixels;  // that many bytes of the line

  // The chunk that begins at byte `at` of the line; valid until the call after the next.
  Slice<const std::uint8_t> widen(Slice<const std::uint8_t> line, std::uint32_t at) {
    turn_ = !turn_;
    std::uint8_t* out = chunks_[turn_ ? 1 : 0];
    const std::uint32_t end = line.size() - at < kLineBytes ? line.size() : at + kLineBytes;
    std::uint32_t size = 0;
    for (; at + 1 < end; at += 2) {
      const unsigned pixel = static_cast<unsigned>(line[at]) << 8 | line[at + 1];
      out[size++] = five(pixel >> 11);
      out[size++] = static_cast<std::uint8_t>((pixel >> 5 & 63u) << 2);
      out[size++] = five(pixel & 31u);
    }
    return {out, size};
  }

 private:
  // Five bits to the six that count, by bit replication: full white stays full white.
  static constexpr std::uint8_t five(unsigned level) {
    return static_cast<std::uint8_t>((level << 1 | level >> 4) << 2);
  }

  std::uint8_t chunks_[2][3 * kPixels] = {};
  bool turn_ = false;
};

}  // namespace spanline::hal
