// Golden pictures in lines: the demo `plot`, whose hidden lines the area sort takes away on the board. An image of
// their own shows them on emulated cores: beside all other demos the smallest one's flash has no room.
#pragma once

#include "core/frame/line_frame.hpp"
#include "golden/golden.hpp"

namespace spanline::golden {

inline constexpr Picture kLinePictures[] = {
    {"plot-oled-30", demos::plot, 30, kOled, 0xf8e65704},
    {"plot-mono-200", demos::plot, 200, kMono, 0x9f88dfcd},
};

inline constexpr Budget kLineBudget = demos::budget_for(demos::plot.framed_for(kOled), kOled);

// As that of golden.hpp.
inline Status draw(const Picture& picture, LineStorage storage, demos::Stage& stage, Slice<std::uint8_t> line,
                   std::uint32_t& crc) {
  if (const Status status = pose(picture, stage); !status.ok()) return status;
  storage.screen = picture.screen;
  LineFrame frame(storage);
  return draw_by(frame, picture.screen, stage, line, crc);
}

}  // namespace spanline::golden
