#include "core/geom/gradient.hpp"

namespace spanline {

ExactGradient::ExactGradient(const ScreenXY (&at)[3], std::int32_t rise1, std::int32_t rise2) {
  const std::int32_t dx1 = at[1].x - at[0].x, dx2 = at[2].x - at[0].x;
  const std::int32_t dy1 = at[1].y - at[0].y, dy2 = at[2].y - at[0].y;
  const auto cross = [](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    return std::int64_t{a} * b - std::int64_t{c} * d;
  };
  area = cross(dx1, dy2, dx2, dy1);
  if (area < 0) {  // the other way round
    area = -area;
    rise1 = -rise1;
    rise2 = -rise2;
  }
  along_x = cross(rise1, dy2, rise2, dy1);
  along_y = cross(rise2, dx1, rise1, dx2);
}

}  // namespace spanline
