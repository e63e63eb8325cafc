#include "budget/budget.hpp"
#include "budget/page.hpp"
#include "budget/picture_url.hpp"
#include "budget/profile_json.hpp"

namespace spanline::host {
namespace {

// Inside a script element nothing may look like its end.
std::string quoted(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::string replaced(std::string text, const std::string& key, const std::string& value) {
  return text.replace(text.find(key), key.size(), value);
}

}  // namespace

std::string budget_html(const BudgetReport& budget) {
  const std::string page = replaced(kPage, "@REPORT@", quoted(budget_json(budget)));
  const std::string shown = budget.run.panel ? picture_url(budget.run.panel->picture) : "";
  return replaced(replaced(page, "@PROFILE@", quoted(profile_json(budget.run))), "@SHOWN@", shown);
}

}  // namespace spanline::host
