#pragma once

#include "demos/cubes.hpp"
#include "demos/dial.hpp"
#include "demos/gauges.hpp"
#include "demos/gears.hpp"
#include "demos/patches.hpp"
#include "demos/plot.hpp"
#include "demos/still_life.hpp"
#include "demos/teapot.hpp"

namespace spanline::demos {

// Every demo, in the order in which they are listed.
inline constexpr const Layouts* kAll[] = {&teapot, &cubes, &gears, &gauges, &patches,
                                          &dice,   &house, &panes, &plot,   &dial};

}  // namespace spanline::demos
