#include "core/curve/outline.hpp"

namespace spanline {

namespace {

// On the screen a point stands for the clip point at distance 1 that is projected there: 2^14 units of 28.4 are 1.
constexpr int kScreenShift = 2;

}  // namespace

ClipPoint OutlineReader::point(std::uint32_t corner) const {
  if (!reader_.on_screen()) return reader_.control_point(corner);
  const Position& p = reader_.mesh().positions[reader_.face().corners[corner]];
  const Projection& projection = reader_.projection();
  return {(p.x - projection.centre_x) * (1 << kScreenShift), (p.y - projection.centre_y) * (1 << kScreenShift),
          kScreenDistance};
}

FacetVertex OutlineReader::projected(const ClipPoint& p) const {
  const Projection& projection = reader_.projection();
  if (reader_.on_screen()) {
    const Position& first = reader_.mesh().positions[reader_.face().corners[0]];
    return {{static_cast<std::int16_t>(projection.centre_x + shift_round(p.x, kScreenShift)),
             static_cast<std::int16_t>(projection.centre_y + shift_round(p.y, kScreenShift))},
            static_cast<std::uint32_t>((first.z + 32768) << (kDepthBits - 16)),
            {}};
  }
  const ScreenPoint s = projection.clamped(p);
  return {s.at, s.depth, {}};
}

}  // namespace spanline
