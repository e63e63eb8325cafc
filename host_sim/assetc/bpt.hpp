// A strict reader of Bezier patch files (.bpt).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "assetc/vec.hpp"

namespace spanline::host {

struct BptPatch {
  std::array<std::array<Vec3, 4>, 4> points;  // the file's order: four rows of four
  std::size_t line = 0;                       // where its first number stands, from 1
};

// Reads bicubic patches in the three layouts in use. The first line is the number of patches; then come, with blanks,
// commas or line ends between the numbers,
//  - per patch its degrees, `3 3`, alone on a line, and 16 points;
//  - per patch 16 points, without degrees;
//  - per patch 16 numbers of vertices on a line, counted from 1; then the number of vertices and their points.
// `#` begins a comment. Throws InputError with file and line: for numbers that are not finite or beyond 1e12, other
// degrees, more or fewer numbers than the counts say, more than 65,535 patches, or none.
std::vector<BptPatch> read_bpt(const std::string& path);

// The same from text in memory; `name` stands for the file in messages.
std::vector<BptPatch> parse_bpt(const std::string& name, std::string_view text);

}  // namespace spanline::host
