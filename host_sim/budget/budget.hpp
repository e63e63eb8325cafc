// The whole report on an image: memory, stack, and what its run took.
#pragma once

#include <optional>
#include <string>

#include "budget/frame_report.hpp"
#include "budget/memory_report.hpp"
#include "budget/stack_analysis.hpp"
#include "mcu/machine.hpp"

namespace spanline::host {

struct BudgetReport {
  const Image* image;
  const BoardDescription* board;
  MemoryReport memory;
  std::optional<StackBound> stack, exception;  // nothing where they were not asked for
  RunReport run;
  std::optional<FrameReport> frames;  // where the image marks them
};

// For the terminal; long tables are cut off, the JSON has them whole.
std::string budget_text(const BudgetReport& budget);

// One object: board, core, end, instructions, cycles (null without a cycle model), passages, functions, stages, frames,
// memory, pools, stack.
std::string budget_json(const BudgetReport& budget);

// One page that needs nothing else: lines against the wire, pools, stages, flame graph.
std::string budget_html(const BudgetReport& budget);

}  // namespace spanline::host
