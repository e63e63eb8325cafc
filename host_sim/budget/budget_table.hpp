#pragma once

#include <string>
#include <vector>

namespace spanline::host {

// One table of reports that `spanline budget --json` wrote: a row for each. Throws InputError where a file is no such
// report.
std::string budget_table(const std::vector<std::string>& reports);

}  // namespace spanline::host
