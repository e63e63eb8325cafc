// Stands for window.cpp in builds without SDL2.
#include "sim/usage_error.hpp"
#include "sim/window.hpp"

namespace spanline::host {

void refuse_without_window() { throw UsageError("view: this build has no SDL2"); }

void show_in_window(CompiledScene&, double) { refuse_without_window(); }

}  // namespace spanline::host
