// The limits of a board's images, kept in a file beside the board: what may be taken of flash, RAM, stack and cycles.
#pragma once

#include <string>
#include <vector>

#include "budget/budget.hpp"

namespace spanline::host {

// What `budget` exceeds of the limits for `image` in the file, one line each, and under it what grew since the limits
// were set. Empty where all is well. Throws InputError where the file is broken or does not know the image.
std::vector<std::string> exceeded_limits(const std::string& file, const std::string& image, const BudgetReport& budget);

// Sets the limits for `image` to what it takes now and a margin, and notes what that consists of. The file's other
// images stay as they are; where there is no file, one is made.
void accept_limits(const std::string& file, const std::string& image, const BudgetReport& budget);

}  // namespace spanline::host
