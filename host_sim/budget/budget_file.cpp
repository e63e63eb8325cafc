#include "budget/budget_file.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assetc/input_error.hpp"
#include "assetc/text_file.hpp"
#include "budget/plain_name.hpp"
#include "sim/output_file.hpp"

namespace spanline::host {
namespace {

using Json = nlohmann::ordered_json;

// Of each quantity: how much it is, and its parts by name.
struct Quantity {
  std::uint64_t amount = 0;
  std::map<std::string, std::uint64_t> parts;
};

// Margins in percent: code grows with every feature, a frame's time should not.
struct Margin {
  const char* quantity;
  unsigned percent;
};
constexpr Margin kMargins[] = {{"flash", 25}, {"ram", 25}, {"stack", 25}, {"cycles", 20}, {"instructions", 20}};

std::map<std::string, Quantity> quantities(const BudgetReport& budget) {
  std::map<std::string, Quantity> all;
  all["flash"].amount = budget.memory.flash;
  all["ram"].amount = budget.memory.ram;
  for (const MemoryReport::Part& room : budget.memory.rooms) {
    if (room.flash != 0) all["flash"].parts[room.name] = room.flash;
    if (room.ram != 0) all["ram"].parts[room.name] = room.ram;
  }
  if (budget.stack) {
    all["stack"].amount = budget.stack->bytes;
    for (const StackBound::Step& step : budget.stack->path) {
      if (step.bytes != 0) all["stack"].parts[plain_name(step.function)] += step.bytes;
    }
  }
  if (!budget.frames) return all;
  const bool timed = budget.run.timed;
  Quantity& time = all[timed ? "cycles" : "instructions"];
  const FrameRecord& worst = budget.run.frames[budget.frames->worst_frame];
  time.amount = timed ? worst.count.busy() : worst.count.instructions;
  for (std::size_t i = 0; i < kStages; ++i) {
    const Count& stage = worst.stages[i];
    time.parts[name(static_cast<Stage>(i))] = timed ? stage.busy() : stage.instructions;
  }
  return all;
}

Json read_limits(const std::string& file) {
  Json json = Json::parse(read_file(file), nullptr, false);
  if (!json.is_object()) throw InputError(file, "is no JSON object of limits");
  return json;
}

std::uint64_t limit_in(const Json& entry, const std::string& file, const std::string& quantity,
                       const std::string& image) {
  const Json json = entry.value("limit", Json());
  if (!json.is_number_unsigned())
    throw InputError(file, "wanted a whole number for " + quantity + "/limit of " + image);
  return json.get<std::uint64_t>();
}

// "  core/vsg 11236, was 10000", the largest growth first.
std::vector<std::string> grown_parts(const Quantity& now, const Json& before) {
  std::vector<std::pair<std::uint64_t, std::string>> grown;
  for (const auto& [part, amount] : now.parts) {
    const Json known = before.is_object() ? before.value(part, Json(0u)) : Json(0u);
    const std::uint64_t was = known.is_number_unsigned() ? known.get<std::uint64_t>() : 0;
    if (amount > was) {
      grown.emplace_back(amount - was, "  " + part + ": " + std::to_string(amount) + ", was " + std::to_string(was));
    }
  }
  std::sort(grown.rbegin(), grown.rend());
  std::vector<std::string> lines;
  lines.reserve(grown.size());
  for (auto& [growth, line] : grown) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

std::vector<std::string> exceeded_limits(const std::string& file, const std::string& image,
                                         const BudgetReport& budget) {
  const Json limits = read_limits(file);
  if (!limits.contains(image)) throw InputError(file, "has no limits for '" + printable(image) + "'");
  std::vector<std::string> lines;
  for (const auto& [quantity, now] : quantities(budget)) {
    const Json entry = limits[image].value(quantity, Json());
    if (!entry.is_object())
      throw InputError(file, "has no limit for the " + quantity + " of '" + printable(image) + "'");
    const std::uint64_t limit = limit_in(entry, file, quantity, image);
    if (now.amount <= limit) continue;
    std::ostringstream line;
    line << image << " on " << budget.board->name << ": " << quantity << " " << now.amount << " is over " << limit
         << " by " << now.amount - limit;
    lines.push_back(line.str());
    const std::vector<std::string> grown = grown_parts(now, entry.value("parts", Json()));
    lines.insert(lines.end(), grown.begin(), grown.end());
  }
  return lines;
}

void accept_limits(const std::string& file, const std::string& image, const BudgetReport& budget) {
  Json limits = std::filesystem::exists(file) ? read_limits(file) : Json::object();
  const std::map<std::string, Quantity> all = quantities(budget);
  Json& of_image = limits[image] = Json::object();
  for (const Margin& margin : kMargins) {
    const auto found = all.find(margin.quantity);
    if (found == all.end()) continue;
    const std::uint64_t limit = found->second.amount + found->second.amount * margin.percent / 100;
    of_image[margin.quantity] = {{"limit", limit}, {"measured", found->second.amount}, {"parts", found->second.parts}};
  }
  write_file(file, limits.dump(1) + "\n");
}

}  // namespace spanline::host
