#include "budget/frame_report.hpp"

#include <algorithm>

#include "budget/line_ring.hpp"

namespace spanline::host {
namespace {

// Cores without a cycle model have their instructions only.
std::uint64_t busy(const Count& count) { return count.cycles == 0 ? count.instructions : count.busy(); }

std::vector<FrameReport::Line> lines_of(const FrameRecord& frame) {
  std::vector<FrameReport::Line> lines;
  std::optional<std::uint64_t> sent;
  for (const FrameRecord::Line& line : frame.lines) {
    lines.push_back({busy(line.count), line.bytes, line.end - line.begin, std::nullopt});
    if (line.bytes == 0) continue;
    if (sent) lines.back().slack = static_cast<std::int64_t>(*sent - line.ready);
    sent = line.end;
  }
  return lines;
}

// A line of which nothing is sent leaves its buffer to the next one: to the wire the two are one.
std::vector<LineTime> times_of(const std::vector<FrameReport::Line>& lines) {
  std::vector<LineTime> times;
  std::uint64_t compute = 0;
  for (const FrameReport::Line& line : lines) {
    compute += line.compute;
    if (line.bytes == 0) continue;
    times.push_back({compute, line.wire});
    compute = 0;
  }
  return times;
}

// The line that takes longest, and the stage that sets it apart from the usual line.
std::optional<FrameReport::WorstLine> worst_line(const std::vector<FrameRecord>& frames) {
  std::optional<FrameReport::WorstLine> worst;
  StageCounts of_worst{};
  std::vector<std::uint64_t> by_stage[kStages];
  for (std::size_t f = 0; f < frames.size(); ++f) {
    for (std::size_t l = 0; l < frames[f].lines.size(); ++l) {
      const FrameRecord::Line& line = frames[f].lines[l];
      for (std::size_t s = 0; s < kStages; ++s) by_stage[s].push_back(busy(line.stages[s]));
      if (worst && busy(line.count) <= worst->compute) continue;
      worst = {f, l, busy(line.count), Stage::other, 0, 0};
      of_worst = line.stages;
    }
  }
  std::uint64_t most_above = 0;
  for (std::size_t s = 0; worst && s < kStages; ++s) {
    const std::uint64_t usual = spread_of(by_stage[s]).median, here = busy(of_worst[s]);
    if (here < usual + most_above) continue;
    most_above = here - usual;
    worst->stage = static_cast<Stage>(s);
    worst->in_stage = here;
    worst->usual = usual;
  }
  return worst;
}

// Of a frame's time what no overlap can save: all before the first line, and the longer of each line's two parts.
std::uint64_t least_time(const FrameRecord& frame) {
  std::uint64_t time = busy(frame.prepare);
  for (const FrameRecord::Line& line : frame.lines) time += std::max(busy(line.count), line.end - line.begin);
  return time;
}

FrameReport::Rate rate_of(double compute, double wire, double time, double frames, std::uint32_t kilohertz) {
  const auto rate = [&](double cycles) { return cycles > 0 ? frames * kilohertz * 1000.0 / cycles : 0.0; };
  return {rate(compute), rate(wire), rate(time)};
}

}  // namespace

Spread spread_of(std::vector<std::uint64_t> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

std::optional<FrameReport> frame_report(const RunReport& run, std::uint32_t kilohertz) {
  if (run.frames.empty() || run.frames.back().count.instructions == 0) return std::nullopt;
  FrameReport report;
  report.kilohertz = kilohertz;
  std::vector<std::uint64_t> cycles, instructions, prepare, line_cycles, line_instructions;
  std::uint64_t wire = 0, overlapped = 0, time = 0;
  for (const FrameRecord& frame : run.frames) {
    cycles.push_back(busy(frame.count));
    instructions.push_back(frame.count.instructions);
    prepare.push_back(busy(frame.prepare));
    for (const FrameRecord::Line& line : frame.lines) {
      line_cycles.push_back(busy(line.count));
      line_instructions.push_back(line.count.instructions);
    }
    for (std::size_t s = 0; s < kStages; ++s) report.stages[s] += frame.stages[s];
    report.total += frame.count;
    wire += frame.wire;
    overlapped += frame.overlapped;
    time += frame.end - frame.begin;
    report.bytes = std::max(report.bytes, frame.bytes);
    if (run.timed && !frame.lines.empty()) {
      report.pace =
          std::max(report.pace, static_cast<double>(frame.end - frame.begin) / static_cast<double>(least_time(frame)));
    }
  }
  report.cycles = spread_of(cycles);
  report.instructions = spread_of(instructions);
  report.prepare_cycles = spread_of(prepare);
  report.line_cycles = spread_of(line_cycles);
  report.line_instructions = spread_of(line_instructions);
  report.worst_frame = static_cast<std::size_t>(std::max_element(cycles.begin(), cycles.end()) - cycles.begin());
  report.worst_line = worst_line(run.frames);
  report.overlap = wire == 0 ? 0 : static_cast<double>(overlapped) / static_cast<double>(wire);
  const FrameRecord& worst = run.frames[report.worst_frame];
  const auto real = [](std::uint64_t value) { return static_cast<double>(value); };
  report.rate = rate_of(real(busy(report.total)), real(wire), real(time), real(run.frames.size()), kilohertz);
  report.worst_rate = rate_of(real(busy(worst.count)), real(worst.wire), real(worst.end - worst.begin), 1, kilohertz);
  report.lines = lines_of(worst);
  report.ring = smallest_ring(times_of(report.lines));
  return report;
}

}  // namespace spanline::host
