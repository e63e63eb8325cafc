// The demo of a firmware image: SPANLINE_DEMO names it at build time.
#pragma once

#ifndef SPANLINE_DEMO
#error "SPANLINE_DEMO is not defined: teapot, cubes, gears, gauges, patches, dice, house, panes, plot or dial"
#endif

#include "demos/all.hpp"

namespace spanline::demos {

// Decided at compile time, so that only the chosen scene's tables are linked.
consteval Demo chosen(const Screen& screen) { return SPANLINE_DEMO.framed_for(screen); }

}  // namespace spanline::demos
