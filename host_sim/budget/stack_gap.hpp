// Why the bound of the stack lies above what a run reached.
#pragma once

#include <string>
#include <vector>

#include "budget/stack_analysis.hpp"
#include "mcu/machine.hpp"

namespace spanline::host {

// One sentence.
std::string explain_gap(const StackBound& bound, const RunReport& run);

}  // namespace spanline::host
