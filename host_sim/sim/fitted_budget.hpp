// Budgets made to measure: what a scene needs is counted, not guessed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assetc/compile.hpp"
#include "core/frame/budget.hpp"

namespace spanline::host {

// The least budget that draws frames `first` to `last` of a scene at full speed, in RGB565 and at the scene's size:
// each in one band, no vertex projected twice, no hint dropped. The scene is left at frame `last`. Throws InputError
// with the scene's name where a frame cannot be drawn. With `point_lines` patches are drawn as points, in bands of so
// many lines.
Budget fitted_budget(CompiledScene& scene, std::int64_t first, std::int64_t last, std::uint16_t point_lines = 0);

// The same for the edge walker alone, or nothing where it cannot draw one of the frames.
std::optional<Budget> fitted_edge_budget(CompiledScene& scene, std::int64_t first, std::int64_t last);

// Bytes of the pools of a budget for meshes by the edge walker in one band, with their sinks.
std::uint32_t whole_bytes(const Budget& b);

// What of the fitted edge budget has to shrink so that its pools take `bytes` at most (Budget::band_vertices): the
// budget itself where it does already; nothing where not even the frame's edges have room.
std::optional<Budget> shrunk_budget(CompiledScene& scene, std::int64_t first, std::int64_t last, const Budget& fitted,
                                    std::uint32_t bytes);

// A header with that budget: kBudget in namespace `name`. `frames`: what it is fitted to, for its comment.
std::string emit_budget(const Budget& budget, const std::string& name, const std::string& frames);

}  // namespace spanline::host
