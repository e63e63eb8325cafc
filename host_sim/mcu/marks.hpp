// Addresses at which a run is looked at more closely.
#pragma once

#include <cstdint>

#include "mcu/image.hpp"

namespace spanline::host {

struct RunOptions;

// Where the image or the options name no such place, kNowhere.
struct Marks {
  static constexpr std::uint32_t kNowhere = 1;  // odd: no instruction lies there
  std::uint32_t from = kNowhere, until = kNowhere;
  std::uint32_t main = kNowhere;
  std::uint32_t frame_begin = kNowhere, frame_end = kNowhere;
  std::uint32_t next_line = kNowhere;  // a frame's next_line(), or a function of that name that calls it

  bool any(std::uint32_t address) const {
    return address == from || address == until || address == main || address == frame_begin || address == frame_end ||
           address == next_line;
  }
};

// Throws InputError where the options name a symbol that the image lacks.
Marks find_marks(const Image& image, const RunOptions& options);

}  // namespace spanline::host
