// Holding a picture against the oracle's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oracle/renderer.hpp"

namespace spanline::oracle {

inline constexpr std::int64_t kOneUnit = 256;  // one --screen unit in the oracle's Q16.8

struct WrongPixel {
  int column, line;
  std::uint32_t expected, actual;        // faces, or kNone
  std::optional<double> expected_depth;  // units; none: background expected
  std::optional<double> actual_depth;    // units; none: the face drawn does not cover this centre, or is the background
};

// The pixels of `picture` that show another face than the oracle's, save those whose own face covers the centre at a
// depth less than `tolerance` (1/256 unit) from the visible one. Tolerance 0 asks for the very face, ties by number
// included. Throws std::invalid_argument when the sizes differ.
std::vector<WrongPixel> compare(const Picture& picture, const Rendering& truth, std::int64_t tolerance = kOneUnit);

// One line of text a wrong pixel, the first `limit` of them; for test messages.
std::string describe(const std::vector<WrongPixel>& wrong, std::size_t limit = 5);

}  // namespace spanline::oracle
