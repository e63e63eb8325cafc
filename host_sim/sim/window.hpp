#pragma once

#include "assetc/compile.hpp"

namespace spanline::host {

// Throws UsageError where this build has no SDL2.
void refuse_without_window();

// Shows the scene until the window is closed; the viewer stays within `reach` bounding radii of its centre. Throws
// InputError where no window can be opened.
void show_in_window(CompiledScene& scene, double reach);

}  // namespace spanline::host
