#include "oracle/compare.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace spanline::oracle {
namespace {

const Candidate* find(const std::vector<Candidate>& candidates, std::uint32_t face) {
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [face](const Candidate& each) { return each.face == face; });
  return found == candidates.end() ? nullptr : &*found;
}

std::string face_text(std::uint32_t face, const std::optional<double>& depth) {
  if (face == kNone) return "background";
  std::ostringstream text;
  text << "face " << face;
  if (depth) {
    text.precision(12);
    text << " at depth " << *depth;
  } else {
    text << ", which does not cover it";
  }
  return text.str();
}

}  // namespace

std::vector<WrongPixel> compare(const Picture& picture, const Rendering& truth, std::int64_t tolerance) {
  if (picture.width != truth.width() || picture.height != truth.height()) {
    throw std::invalid_argument("oracle: pictures of different sizes");
  }
  std::vector<WrongPixel> wrong;
  for (int line = 0; line < picture.height; ++line) {
    for (int column = 0; column < picture.width; ++column) {
      const std::uint32_t actual = picture.at(column, line);
      const std::uint32_t expected = truth.face(column, line);
      if (actual == expected) continue;
      const std::vector<Candidate>& candidates = truth.candidates(column, line);
      const Candidate* drawn = find(candidates, actual);
      if (drawn && closer_than(drawn->depth, candidates.front().depth, tolerance)) continue;
      WrongPixel pixel{column, line, expected, actual, std::nullopt, std::nullopt};
      if (!candidates.empty()) pixel.expected_depth = in_units(candidates.front().depth);
      if (drawn) pixel.actual_depth = in_units(drawn->depth);
      wrong.push_back(pixel);
    }
  }
  return wrong;
}

std::string describe(const std::vector<WrongPixel>& wrong, std::size_t limit) {
  std::ostringstream text;
  text << wrong.size() << " wrong pixels\n";
  for (std::size_t i = 0; i < std::min(limit, wrong.size()); ++i) {
    const WrongPixel& pixel = wrong[i];
    text << "  column " << pixel.column << ", line " << pixel.line << ": expected "
         << face_text(pixel.expected, pixel.expected_depth) << ", drawn " << face_text(pixel.actual, pixel.actual_depth)
         << "\n";
  }
  return text.str();
}

}  // namespace spanline::oracle
