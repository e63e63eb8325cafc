#include <nlohmann/json.hpp>

#include "budget/budget.hpp"

namespace spanline::host {
namespace {

using Json = nlohmann::ordered_json;

Json count_json(const Count& count, bool timed) {
  return {{"instructions", count.instructions}, {"cycles", timed ? Json(count.cycles) : Json()}};
}

Json parts_json(const std::vector<MemoryReport::Part>& parts) {
  Json list = Json::array();
  for (const MemoryReport::Part& part : parts) {
    list.push_back({{"name", part.name}, {"flash", part.flash}, {"ram", part.ram}});
  }
  return list;
}

Json functions_json(const Budget& budget, bool timed) {
  Json list = Json::array();
  for (std::size_t i = 0; i < budget.run.functions.size(); ++i) {
    if (budget.run.functions[i].instructions == 0) continue;
    Json entry = {{"name", i < budget.image->functions().size() ? Json(budget.image->functions()[i].name) : Json()}};
    entry.update(count_json(budget.run.functions[i], timed));
    list.push_back(entry);
  }
  return list;
}

Json stack_json(const Budget& budget) {
  Json stack = {{"reached", budget.run.stack_reached}, {"reached_in", budget.run.stack_deepest}};
  if (!budget.stack) return stack;
  stack["bound"] = budget.stack->problems.empty() ? Json(budget.stack->bytes) : Json();
  stack["path"] = Json::array();
  for (const StackBound::Step& step : budget.stack->path) {
    stack["path"].push_back({{"function", step.function}, {"bytes", step.bytes}});
  }
  stack["problems"] = budget.stack->problems;
  if (budget.exception && !budget.exception->path.empty()) {
    stack["exception"] = {{"handler", budget.exception->path.front().function},
                          {"bytes", budget.exception->bytes},
                          {"problems", budget.exception->problems}};
  }
  return stack;
}

}  // namespace

std::string budget_json(const Budget& budget) {
  const bool timed = has_cycle_model(budget.board->core);
  Json json = {{"board", budget.board->name}, {"core", name(budget.board->core)}, {"end", budget.run.end}};
  json.update(count_json(budget.run.total, timed));
  json["passages"] = Json::array();
  for (const Count& passage : budget.run.passages) json["passages"].push_back(count_json(passage, timed));
  json["functions"] = functions_json(budget, timed);
  json["memory"] = {{"flash", budget.memory.flash},
                    {"ram", budget.memory.ram},
                    {"sections", parts_json(budget.memory.sections)},
                    {"symbols", parts_json(budget.memory.symbols)}};
  json["stack"] = stack_json(budget);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace spanline::host
