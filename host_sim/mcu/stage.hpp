// The stages of a frame, told by the source file that code comes from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "mcu/count.hpp"

namespace spanline::host {

enum class Stage : std::uint8_t { transform, dice, edges, segment, depth, shade, scan_out, other };

inline constexpr std::size_t kStages = 8;

using StageCounts = std::array<Count, kStages>;

// "edge set-up".
const char* name(Stage stage);

// Nothing for helpers, which belong to whoever calls them, and for files that are not ours.
std::optional<Stage> stage_of(const std::string& file);

}  // namespace spanline::host
