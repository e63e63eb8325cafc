// The sample space generator (III.E): last line's visible edges, stepped to this line, give its spans. The borders of
// the screen are implied sample edges.
#pragma once

#include "core/base/pool.hpp"

namespace spanline {

class SampleSpace {
 public:
  SampleSpace() = default;
  SampleSpace(PoolRef<std::int16_t> a, PoolRef<std::int16_t> b) : lists_{a, b} {}

  void clear() { count_[0] = count_[1] = 0; }

  void begin_line(std::int32_t width) {
    now_ ^= 1;
    count_[now_ ^ 1] = 0;
    read_ = 0;
    last_ = 0;
    width_ = width;
  }

  // The right sample point of the span that begins at `left`.
  std::int32_t right_of(std::int32_t left) {
    while (read_ < count_[now_]) {
      const std::int32_t column = lists_[now_][read_ + 1u];
      if (column > left) return column;
      ++read_;
    }
    return width_;
  }

  // Keeps a sample point for the next line; out of order or off the screen it is worth nothing. False where the pool is
  // full.
  bool keep(std::int32_t column) {
    if (column <= last_ || column >= width_) return true;
    std::uint16_t& count = count_[now_ ^ 1];
    if (count == lists_[now_ ^ 1].capacity()) return false;
    lists_[now_ ^ 1][++count] = static_cast<std::int16_t>(column);
    last_ = column;
    return true;
  }
  std::uint16_t kept() const { return count_[now_ ^ 1]; }

 private:
  PoolRef<std::int16_t> lists_[2];
  std::uint16_t count_[2] = {0, 0};
  std::uint16_t read_ = 0;
  unsigned now_ = 0;
  std::int32_t last_ = 0, width_ = 0;
};

}  // namespace spanline
