#pragma once

#include <string>

#include "mcu/machine.hpp"

namespace spanline::host {

// The call tree for a flame graph: nested {"name", "file", "stage", "self", "waiting", "instructions", "children"},
// what is inlined included; self: cycles with stalls and without waiting, or instructions on cores without a cycle
// table.
std::string profile_json(const RunReport& run);

}  // namespace spanline::host
