#pragma once

#include "core/base/pool.hpp"

namespace spanline {

// A set of numbers from 0 on, a bit each, in somebody's words.
class BitPool {
 public:
  BitPool() = default;
  explicit BitPool(PoolRef<std::uint32_t> words) : words_(words) {}

  static constexpr std::uint32_t words_for(std::uint32_t numbers) { return (numbers + 31) / 32; }

  std::uint32_t capacity() const { return 32u * words_.capacity(); }
  // None of the numbers below `count` is in the set.
  void clear(std::uint32_t count) {
    for (std::uint32_t word = words_for(count); word != 0; --word) words_[word] = 0;
  }
  // The word of a number; its bit is that of number % 32.
  const std::uint32_t* word(std::uint32_t number) const { return &words_[1 + number / 32]; }
  bool has(std::uint32_t number) const { return (words_[1 + number / 32] >> number % 32 & 1u) != 0; }
  void put(std::uint32_t number) { words_[1 + number / 32] |= 1u << number % 32; }

 private:
  PoolRef<std::uint32_t> words_;
};

}  // namespace spanline
