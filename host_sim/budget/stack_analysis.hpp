// The deepest the stack can get, from the machine code alone.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mcu/board.hpp"
#include "mcu/image.hpp"

namespace spanline::host {

// What the machine code does not tell, stated by the user.
struct StackNotes {
  std::map<std::uint32_t, std::vector<std::uint32_t>> callees;  // of functions that call through pointers
  std::optional<std::vector<std::uint32_t>> other_callees;      // of those that `callees` does not name
  std::map<std::uint32_t, std::uint32_t> turns;                 // of recursive functions: so many frames at most
};

// Lines "CALLER calls CALLEE", "CALLER calls nothing", "others call CALLEE", "others call nothing",
// "FUNCTION recurses N"; '#' begins a comment. Throws InputError.
StackNotes read_stack_notes(const Image& image, const std::string& path);

struct StackBound {
  struct Step {
    std::string function;
    std::uint32_t bytes;  // of its own on the stack while it calls the next one
  };
  std::uint32_t bytes = 0;            // holds where `problems` is empty
  std::vector<Step> path;             // the deepest, from the outermost function
  std::vector<std::string> problems;  // recursion and calls through pointers without a note

  // An exception may come where all the rest is deepest.
  void add(const StackBound& exception) {
    bytes += exception.bytes;
    path.insert(path.end(), exception.path.begin(), exception.path.end());
  }
};

// From `entry` on, exceptions aside.
StackBound stack_bound(const Image& image, Core core, std::uint32_t entry, const StackNotes& notes);

// What one exception adds at most, its registers that the core stacks included: the deepest handler of SVC, PendSV,
// SysTick and the interrupts in the vector table. Faults end a run and are left out; nested interrupts add theirs.
// `bytes` is 0 where there are no handlers.
StackBound exception_bound(const Image& image, Core core, std::uint32_t vectors, const StackNotes& notes);

}  // namespace spanline::host
