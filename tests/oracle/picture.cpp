#include "oracle/picture.hpp"

#include <string_view>

namespace spanline::oracle {

std::vector<std::string> to_text(const Picture& picture) {
  constexpr std::string_view kGlyphs = "#123456789abcdefghijklmnopqrstuvwxyz";
  std::vector<std::string> lines(static_cast<std::size_t>(picture.height));
  for (int line = 0; line < picture.height; ++line) {
    for (int column = 0; column < picture.width; ++column) {
      const std::uint32_t face = picture.at(column, line);
      const char glyph = face == kNone ? '.' : face < kGlyphs.size() ? kGlyphs[face] : '?';
      lines[static_cast<std::size_t>(line)].push_back(glyph);
    }
  }
  return lines;
}

}  // namespace spanline::oracle
