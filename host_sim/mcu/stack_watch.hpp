// How deep the stack went, and in which call.
#pragma once

#include <cstdint>

namespace spanline::host {

class StackWatch {
 public:
  void begin(std::uint32_t sp, std::uint32_t at) {
    lowest_ = sp;
    deepest_at_ = at;
  }

  // True where `sp` is deeper than ever before.
  bool deeper(std::uint32_t sp) const { return sp < lowest_; }
  // The instruction at `address`, in the call tree's node, made it so.
  void reach(std::uint32_t sp, std::uint32_t address, std::uint32_t node) {
    lowest_ = sp;
    deepest_at_ = address;
    deepest_node_ = node;
  }

  std::uint32_t lowest() const { return lowest_; }
  std::uint32_t deepest_at() const { return deepest_at_; }
  std::uint32_t deepest_node() const { return deepest_node_; }

 private:
  std::uint32_t lowest_ = 0, deepest_at_ = 0, deepest_node_ = 0;
};

}  // namespace spanline::host
