// Random numbers that are the same on every machine and library.
#pragma once

#include <cstdint>

namespace spanline::oracle {

// How many of `all` rounds a random test makes: a share of them, never none, where SPANLINE_ROUNDS_SHARE says so, as on
// an emulated microcontroller.
#ifdef SPANLINE_ROUNDS_SHARE
template <typename Count>
constexpr Count rounds(Count all) {
  return (all - 1) / SPANLINE_ROUNDS_SHARE + 1;
}
#else
template <typename Count>
constexpr Count rounds(Count all) {
  return all;
}
#endif

// splitmix64 (Steele, Lea, Flood 2014): any seed is good, consecutive seeds too.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  // 0 … count - 1; 1 <= count < 2^31.
  int below(int count) { return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(count) >> 32); }
  // low … high, both included; high - low < 2^31 - 1.
  int between(int low, int high) { return low + below(high - low + 1); }
  bool percent(int chance) { return below(100) < chance; }

 private:
  std::uint64_t state_;
};

}  // namespace spanline::oracle
