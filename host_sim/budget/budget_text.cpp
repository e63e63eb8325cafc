#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "budget/budget.hpp"

namespace spanline::host {
namespace {

constexpr std::size_t kRows = 20, kNameWidth = 90;

std::string short_name(const std::string& name) {
  return name.size() <= kNameWidth ? name : name.substr(0, kNameWidth - 3) + "...";
}

std::vector<std::size_t> busiest(const RunReport& run) {
  std::vector<std::size_t> order(run.functions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::max(run.functions[a].cycles, run.functions[a].instructions) >
           std::max(run.functions[b].cycles, run.functions[b].instructions);
  });
  order.erase(
      std::remove_if(order.begin(), order.end(), [&](std::size_t i) { return run.functions[i].instructions == 0; }),
      order.end());
  return order;
}

std::string function_name(const Image& image, std::size_t index) {
  return index < image.functions().size() ? image.functions()[index].name : "(no symbol)";
}

void write_run(std::ostream& out, const Budget& budget) {
  const RunReport& run = budget.run;
  const bool timed = has_cycle_model(budget.board->core);
  out << "run: " << run.end << "\n  " << run.total.instructions << " instructions";
  if (timed) {
    out << ", " << run.total.cycles << " core cycles at zero wait states; memory stalls and bus time are not in them\n";
  } else {
    out << "; no cycle table for a " << name(budget.board->core) << "\n";
  }
  if (run.unknown != 0) out << "  " << run.unknown << " of them unknown to the decoder, taken as one cycle each\n";
  if (run.passages.size() > 1) {
    out << "  passages (instructions" << (timed ? ", cycles" : "") << "):\n";
    for (const Count& passage : run.passages) {
      out << std::setw(14) << passage.instructions;
      if (timed) out << std::setw(14) << passage.cycles;
      out << "\n";
    }
  }
  const std::vector<std::size_t> order = busiest(run);
  out << "by function:\n  instructions" << (timed ? "        cycles" : "") << "  function\n";
  for (std::size_t i = 0; i < order.size() && i < kRows; ++i) {
    const Count& count = run.functions[order[i]];
    out << std::setw(14) << count.instructions;
    if (timed) out << std::setw(14) << count.cycles;
    out << "  " << short_name(function_name(*budget.image, order[i])) << "\n";
  }
  if (order.size() > kRows) out << "  and " << order.size() - kRows << " more\n";
}

void write_memory(std::ostream& out, const Budget& budget) {
  const MemoryReport& memory = budget.memory;
  out << "memory: flash " << memory.flash << " of " << memory.flash_of_board << " bytes, RAM " << memory.ram << " of "
      << memory.ram_of_board << "\n       flash       RAM  section\n";
  const auto row = [&](const MemoryReport::Part& part) {
    out << std::setw(12) << part.flash << std::setw(10) << part.ram << "  " << short_name(part.name) << "\n";
  };
  for (const MemoryReport::Part& part : memory.sections) row(part);
  out << "       flash       RAM  symbol\n";
  for (std::size_t i = 0; i < memory.symbols.size() && i < kRows; ++i) row(memory.symbols[i]);
  if (memory.symbols.size() > kRows) out << "  and " << memory.symbols.size() - kRows << " more\n";
}

void write_stack(std::ostream& out, const Budget& budget) {
  out << "stack: " << budget.run.stack_reached << " bytes reached, in " << short_name(budget.run.stack_deepest) << "\n";
  if (!budget.stack) return;
  const StackBound& bound = *budget.stack;
  out << (bound.problems.empty() ? "  bound: " : "  no bound; at least ") << bound.bytes << " bytes by the code";
  if (bound.problems.empty() && bound.bytes >= budget.run.stack_reached) {
    out << ", " << bound.bytes - budget.run.stack_reached << " more than the run reached";
  }
  out << "; the deepest path:\n";
  for (const StackBound::Step& step : bound.path)
    out << std::setw(12) << step.bytes << "  " << short_name(step.function) << "\n";
  for (const std::string& problem : bound.problems) out << "  unbounded: " << problem << "\n";
  if (!budget.exception || budget.exception->path.empty()) return;
  out << "  an exception adds " << (budget.exception->problems.empty() ? "at most " : "more than ")
      << budget.exception->bytes << " bytes, in " << short_name(budget.exception->path.front().function)
      << "; nested ones add theirs\n";
}

}  // namespace

std::string budget_text(const Budget& budget) {
  std::ostringstream out;
  out << budget.image->path() << " on " << budget.board->name << " (" << name(budget.board->core) << ")\n";
  write_run(out, budget);
  write_memory(out, budget);
  write_stack(out, budget);
  return out.str();
}

}  // namespace spanline::host
