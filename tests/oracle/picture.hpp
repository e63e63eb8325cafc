// Pictures of face numbers, readable in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace spanline::oracle {

inline constexpr std::uint32_t kNone = 0xffffffff;  // no face: the background

struct Picture {
  Picture(int columns, int lines)
      : width(columns),
        height(lines),
        faces(static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines), kNone) {}

  std::uint32_t& at(int column, int line) { return faces[index(column, line)]; }
  std::uint32_t at(int column, int line) const { return faces[index(column, line)]; }

  int width;
  int height;
  std::vector<std::uint32_t> faces;  // row by row

 private:
  std::size_t index(int column, int line) const {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

// One string a line: '.' background, '#' face 0, '1' … '9' and 'a' … 'z' the next faces, '?' any other.
std::vector<std::string> to_text(const Picture& picture);

}  // namespace spanline::oracle
