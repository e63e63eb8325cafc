// What one function does to the stack, read from its machine code.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mcu/decoder.hpp"
#include "mcu/image.hpp"

namespace spanline::host {

struct StackFrame {
  struct Call {
    std::uint32_t at;      // of the instruction
    std::uint32_t callee;  // where it goes, 0 where that is not known
    std::uint32_t depth;   // bytes of this function that are on the stack meanwhile
  };
  std::uint32_t depth = 0;            // bytes at most, callees aside
  std::vector<Call> calls;            // tail calls included
  std::vector<std::string> problems;  // why `depth` may not hold
};

// Follows every path from `entry` to where the function ends. Code that only a jump table reaches counts with the
// function's deepest frame.
StackFrame stack_frame(const Image& image, const Decoder& decoder, std::uint32_t entry);

}  // namespace spanline::host
