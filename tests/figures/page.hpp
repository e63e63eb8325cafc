#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace spanline::figures {

// docs/figure-33.md as Markdown, of what measure_all() returned.
std::string figure_page(const std::vector<ObjectFigures>& all);

}  // namespace spanline::figures
