#include <CLI/CLI.hpp>

#include "budget/mcu_verbs.hpp"

namespace spanline::host {

struct McuVerbs::Verbs {};

McuVerbs::McuVerbs(CLI::App& app) {
  app.footer("The verbs `run` and `budget` are not built in: unicorn, capstone, libelf or libdw was missing.");
}
McuVerbs::~McuVerbs() = default;
bool McuVerbs::chosen() const { return false; }
void McuVerbs::run() const {}

}  // namespace spanline::host
