#pragma once

#include <functional>

#include "sim/cli_app.hpp"

namespace spanline::host {

// Does `work` and returns what the program exits with: 0 done, 1 the work failed, 2 wrong usage; an exception's message
// goes to standard error in one line.
int exit_code_of(CLI::App& app, const std::function<void()>& work);

}  // namespace spanline::host
