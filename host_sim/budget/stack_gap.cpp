#include "budget/stack_gap.hpp"

#include <algorithm>

#include "budget/plain_name.hpp"

namespace spanline::host {
namespace {

bool was_executed(const std::string& function, const RunReport& run) {
  return std::find(run.executed.begin(), run.executed.end(), function) != run.executed.end();
}

}  // namespace

std::string explain_gap(const StackBound& bound, const RunReport& run) {
  if (!bound.problems.empty()) return "there is no bound";
  if (bound.bytes <= run.stack_reached) return "the run reached the bound";
  std::uint32_t never = 0;
  std::string first, last;
  for (const StackBound::Step& step : bound.path) {
    if (was_executed(step.function, run)) continue;
    never += step.bytes;
    if (first.empty()) first = plain_name(step.function);
    last = plain_name(step.function);
  }
  const std::string deepest = run.stack_path.empty() ? "" : plain_name(run.stack_path.back());
  if (never == 0)
    return "every function of the deepest path ran, but not all of them at once; the run was deepest in " + deepest;
  return std::to_string(never) + " bytes belong to functions that the run never called, from " + first +
         (last == first ? "" : " to " + last) + "; the run was deepest in " + deepest;
}

}  // namespace spanline::host
