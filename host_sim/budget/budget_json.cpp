#include <nlohmann/json.hpp>

#include "budget/budget.hpp"
#include "budget/stack_gap.hpp"

namespace spanline::host {
namespace {

using Json = nlohmann::ordered_json;

Json count_json(const Count& count, bool timed) {
  return {{"instructions", count.instructions},
          {"cycles", timed ? Json(count.cycles) : Json()},
          {"stalls_estimate", timed ? Json(count.stalls) : Json()},
          {"waiting", timed ? Json(count.waiting) : Json()}};
}

Json spread_json(const Spread& spread) {
  return {{"least", spread.least}, {"median", spread.median}, {"most", spread.most}};
}

Json rate_json(const FrameReport::Rate& rate) {
  return {{"compute", rate.compute}, {"wire", rate.wire}, {"both", rate.both}};
}

Json stages_json(const StageCounts& stages, bool timed) {
  Json list = Json::array();
  for (std::size_t i = 0; i < kStages; ++i) {
    Json entry = {{"name", name(static_cast<Stage>(i))}};
    entry.update(count_json(stages[i], timed));
    list.push_back(entry);
  }
  return list;
}

// `frames` of the report, of which the lines are those of the worst frame.
Json frames_json(const FrameReport& report, const RunReport& run, bool timed) {
  Json json = {{"count", run.frames.size()},
               {"kilohertz", report.kilohertz},
               {"cycles", spread_json(report.cycles)},
               {"instructions", spread_json(report.instructions)},
               {"prepare_cycles", spread_json(report.prepare_cycles)},
               {"line_cycles", spread_json(report.line_cycles)},
               {"line_instructions", spread_json(report.line_instructions)},
               {"worst_frame", report.worst_frame},
               {"frames_a_second", rate_json(report.rate)},
               {"frames_a_second_worst", rate_json(report.worst_rate)},
               {"dma_overlap", report.overlap},
               {"pace", report.pace == 0 ? Json() : Json(report.pace)},
               {"bytes", report.bytes},
               {"ring_lines", report.ring ? Json(*report.ring) : Json()},
               {"stages", stages_json(report.stages, timed)}};
  if (report.worst_line) {
    const FrameReport::WorstLine& worst = *report.worst_line;
    json["worst_line"] = {{"frame", worst.frame},       {"line", worst.line},         {"cycles", worst.compute},
                          {"stage", name(worst.stage)}, {"in_stage", worst.in_stage}, {"usual", worst.usual}};
  }
  json["lines"] = Json::array();
  for (const FrameReport::Line& line : report.lines) {
    json["lines"].push_back({{"compute", line.compute},
                             {"bytes", line.bytes},
                             {"wire", line.wire},
                             {"slack", line.slack ? Json(*line.slack) : Json()}});
  }
  return json;
}

Json pools_json(const RunReport& run) {
  Json list = Json::array();
  for (const PoolUse& pool : run.pools) {
    list.push_back(
        {{"name", pool.name}, {"block_bytes", pool.block_bytes}, {"capacity", pool.capacity}, {"used", pool.used}});
  }
  return list;
}

Json panel_json(const PanelReport& panel) {
  return {{"wire_hz", panel.wire_hz}, {"bytes", panel.bytes}, {"dma_bytes", panel.dma_bytes}};
}

Json parts_json(const std::vector<MemoryReport::Part>& parts) {
  Json list = Json::array();
  for (const MemoryReport::Part& part : parts) {
    list.push_back({{"name", part.name}, {"flash", part.flash}, {"ram", part.ram}});
  }
  return list;
}

Json functions_json(const BudgetReport& budget, bool timed) {
  Json list = Json::array();
  for (std::size_t i = 0; i < budget.run.functions.size(); ++i) {
    if (budget.run.functions[i].instructions == 0) continue;
    Json entry = {{"name", i < budget.image->functions().size() ? Json(budget.image->functions()[i].name) : Json()}};
    entry.update(count_json(budget.run.functions[i], timed));
    list.push_back(entry);
  }
  return list;
}

Json stack_json(const BudgetReport& budget) {
  Json stack = {{"reached", budget.run.stack_reached},
                {"reached_in", budget.run.stack_deepest},
                {"reached_path", budget.run.stack_path}};
  if (!budget.stack) return stack;
  stack["bound"] = budget.stack->problems.empty() ? Json(budget.stack->bytes) : Json();
  stack["path"] = Json::array();
  for (const StackBound::Step& step : budget.stack->path) {
    stack["path"].push_back({{"function", step.function}, {"bytes", step.bytes}});
  }
  stack["problems"] = budget.stack->problems;
  stack["gap"] = explain_gap(*budget.stack, budget.run);
  if (budget.exception && !budget.exception->path.empty()) {
    stack["exception"] = {{"handler", budget.exception->path.front().function},
                          {"bytes", budget.exception->bytes},
                          {"problems", budget.exception->problems}};
  }
  return stack;
}

}  // namespace

std::string budget_json(const BudgetReport& budget) {
  const bool timed = budget.run.timed;
  const std::string& path = budget.image->path();
  Json json = {{"image", path.substr(path.find_last_of('/') + 1)},
               {"board", budget.board->name},
               {"core", name(budget.board->core)},
               {"end", budget.run.end}};
  json.update(count_json(budget.run.total, timed));
  json["passages"] = Json::array();
  for (const Count& passage : budget.run.passages) json["passages"].push_back(count_json(passage, timed));
  json["functions"] = functions_json(budget, timed);
  if (budget.frames) json["frames"] = frames_json(*budget.frames, budget.run, timed);
  if (budget.run.panel) json["panel"] = panel_json(*budget.run.panel);
  json["pools"] = pools_json(budget.run);
  json["memory"] = {{"flash", budget.memory.flash},
                    {"ram", budget.memory.ram},
                    {"rooms", parts_json(budget.memory.rooms)},
                    {"sections", parts_json(budget.memory.sections)},
                    {"symbols", parts_json(budget.memory.symbols)}};
  json["stack"] = stack_json(budget);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace spanline::host
