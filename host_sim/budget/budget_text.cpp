#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "budget/budget.hpp"
#include "budget/plain_name.hpp"
#include "budget/stack_gap.hpp"

namespace spanline::host {
namespace {

constexpr std::size_t kRows = 20;

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

void write_run(std::ostream& out, const BudgetReport& budget) {
  const RunReport& run = budget.run;
  const bool timed = budget.run.timed;
  out << "run: " << run.end << "\n  " << run.total.instructions << " instructions";
  if (timed) {
    out << ", " << run.total.cycles << " core cycles at zero wait states";
    if (run.total.stalls != 0) out << ", " << run.total.stalls << " cycles of memory stalls (estimate)";
    if (run.total.waiting != 0) out << "; " << run.total.waiting << " of both in loops that wait";
    out << "\n";
  } else {
    out << (has_cycle_model(budget.board->core) ? "; time as an emulator's, no cycles"
                                                : std::string("; no cycle table for a ") + name(budget.board->core))
        << "\n";
  }
  if (run.unknown != 0) out << "  " << run.unknown << " of them unknown to the decoder, taken as one cycle each\n";
  if (run.passages.size() > 1 && !budget.frames) {
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
    out << "  " << plain_name(function_name(*budget.image, order[i])) << "\n";
  }
  if (order.size() > kRows) out << "  and " << order.size() - kRows << " more\n";
}

void write_rates(std::ostream& out, const char* what, const FrameReport::Rate& rate) {
  out << std::fixed << std::setprecision(1) << "  " << what << ": " << rate.compute << " by compute, " << rate.wire
      << " by the wire, " << rate.both << " as it ran\n";
}

void write_spread(std::ostream& out, const Spread& spread, const char* what) {
  out << std::setw(14) << spread.least << std::setw(14) << spread.median << std::setw(14) << spread.most << "  " << what
      << "\n";
}

void write_lines(std::ostream& out, const FrameReport& report) {
  if (report.worst_line) {
    const FrameReport::WorstLine& worst = *report.worst_line;
    out << "  the worst line: " << worst.line << " of frame " << worst.frame << ", " << worst.compute << " cycles: its "
        << name(worst.stage) << " takes " << worst.in_stage << " where " << worst.usual << " are usual\n";
  }
  int late = 0, sent = 0;
  std::int64_t least = INT64_MAX;
  for (const FrameReport::Line& line : report.lines) {
    sent += line.bytes == 0 ? 0 : 1;
    if (!line.slack) continue;
    late += *line.slack < 0 ? 1 : 0;
    least = std::min(least, *line.slack);
  }
  if (sent < 2) return;
  out << "  worst frame " << report.worst_frame << ": " << sent << " of " << report.lines.size()
      << " lines are sent, in part or whole; " << late << " of them come after the wire was free, the least slack is "
      << least << " cycles; ";
  if (report.ring) {
    out << *report.ring << " line buffers never let it wait\n";
  } else {
    out << "no ring of line buffers keeps it busy\n";
  }
}

void write_frames(std::ostream& out, const BudgetReport& budget) {
  const FrameReport& report = *budget.frames;
  out << "frames: " << budget.run.frames.size() << " at " << report.kilohertz / 1000 << " MHz, worst frame "
      << report.worst_frame << "; cycles without waiting, memory stalls in them\n"
      << "         least        median          most\n";
  write_spread(out, report.cycles, "cycles a frame");
  write_spread(out, report.instructions, "instructions a frame");
  if (!report.lines.empty()) {
    write_spread(out, report.prepare_cycles, "cycles before the first line");
    write_spread(out, report.line_cycles, "cycles a line");
    write_spread(out, report.line_instructions, "instructions a line");
  }
  if (report.bytes != 0) {
    write_rates(out, "frames a second", report.rate);
    write_rates(out, "of the worst frame", report.worst_rate);
    out << "  " << report.bytes << " bytes a frame at " << budget.run.panel->wire_hz / 1'000'000.0
        << " MHz; the core works in " << std::setprecision(0) << 100 * report.overlap << " % of the wire's time\n";
    if (report.pace != 0) {
      out << "  " << std::setprecision(3) << report.pace
          << " times the longer of computing and sending each line, and what comes before, at most\n";
    }
  }
  write_lines(out, report);
  out << "by stage:\n        cycles   a frame  share  waiting\n";
  for (std::size_t i = 0; i < kStages; ++i) {
    const Count& stage = report.stages[i];
    out << std::setw(14) << stage.busy() << std::setw(10) << stage.busy() / budget.run.frames.size() << std::setw(5)
        << 100 * stage.busy() / std::max<std::uint64_t>(report.total.busy(), 1) << " %" << std::setw(9) << stage.waiting
        << "  " << name(static_cast<Stage>(i)) << "\n";
  }
}

void write_pools(std::ostream& out, const RunReport& run) {
  if (run.pools.empty()) return;
  out << "pools:\n    used  capacity     bytes  pool\n";
  for (const PoolUse& pool : run.pools) {
    out << std::setw(8) << pool.used << std::setw(10) << pool.capacity << std::setw(10)
        << pool.block_bytes * (pool.capacity + 1) << "  " << pool.name << "\n";
  }
}

void write_memory(std::ostream& out, const BudgetReport& budget) {
  const MemoryReport& memory = budget.memory;
  out << "memory: flash " << memory.flash << " of " << memory.flash_of_board << " bytes, RAM " << memory.ram << " of "
      << memory.ram_of_board << "\n       flash       RAM  section\n";
  const auto row = [&](const MemoryReport::Part& part) {
    out << std::setw(12) << part.flash << std::setw(10) << part.ram << "  " << plain_name(part.name) << "\n";
  };
  for (const MemoryReport::Part& part : memory.sections) row(part);
  out << "       flash       RAM  room\n";
  for (const MemoryReport::Part& part : memory.rooms) row(part);
  out << "       flash       RAM  symbol\n";
  for (std::size_t i = 0; i < memory.symbols.size() && i < kRows; ++i) row(memory.symbols[i]);
  if (memory.symbols.size() > kRows) out << "  and " << memory.symbols.size() - kRows << " more\n";
}

void write_stack(std::ostream& out, const BudgetReport& budget) {
  out << "stack: " << budget.run.stack_reached << " bytes reached, in " << plain_name(budget.run.stack_deepest) << "\n";
  if (!budget.stack) return;
  const StackBound& bound = *budget.stack;
  out << (bound.problems.empty() ? "  bound: " : "  no bound; at least ") << bound.bytes << " bytes by the code";
  if (bound.problems.empty() && bound.bytes >= budget.run.stack_reached) {
    out << ", " << bound.bytes - budget.run.stack_reached << " more than the run reached";
  }
  out << "; the deepest path:\n";
  for (const StackBound::Step& step : bound.path)
    out << std::setw(12) << step.bytes << "  " << plain_name(step.function) << "\n";
  out << "  " << explain_gap(bound, budget.run) << "\n";
  for (const std::string& problem : bound.problems) out << "  unbounded: " << problem << "\n";
  if (!budget.exception || budget.exception->path.empty()) return;
  out << "  of these an exception's: " << (budget.exception->problems.empty() ? "at most " : "more than ")
      << budget.exception->bytes << " bytes, in " << plain_name(budget.exception->path.front().function)
      << "; nested ones add theirs\n";
}

}  // namespace

std::string budget_text(const BudgetReport& budget) {
  std::ostringstream out;
  out << budget.image->path() << " on " << budget.board->name << " (" << name(budget.board->core) << ")\n";
  write_run(out, budget);
  if (budget.frames) write_frames(out, budget);
  write_memory(out, budget);
  write_pools(out, budget.run);
  write_stack(out, budget);
  return out.str();
}

}  // namespace spanline::host
