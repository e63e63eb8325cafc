// From decimals to the clipper's whole coordinates and back.
#pragma once

#include <cstdint>
#include <vector>

namespace spanline::host {

// A coordinate of an input file as a multiple of `step / per_unit` from an origin on that same raster. One of the two
// is 1 and both are whole, so that what comes back is the shortest decimal.
class WorkingGrid {
 public:
  struct Point {
    double x, y;
  };

  // Whole coordinates within ±32767 keep their values. Otherwise the coarsest power of ten that holds all decimals
  // exactly, or, where that does not fit the clipper's range, the finest raster of 1, 2 or 5 times a power of ten that
  // does; the origin moves off 0 only where the coordinates would not fit else. |x|, |y| at most 1e12.
  static WorkingGrid holding(const std::vector<Point>& points);

  double scale() const { return per_unit_ / step_; }  // grid units in one input unit

  struct Cell {
    std::int32_t x, y;
  };
  Cell to_grid(Point point) const { return {whole(point.x, origin_x_), whole(point.y, origin_y_)}; }
  double x_of(std::int32_t x) const { return (origin_x_ + x) * step_ / per_unit_; }
  double y_of(std::int32_t y) const { return (origin_y_ + y) * step_ / per_unit_; }

 private:
  std::int32_t whole(double value, double origin) const;

  double per_unit_ = 1, step_ = 1;
  double origin_x_ = 0, origin_y_ = 0;  // grid units, whole
};

}  // namespace spanline::host
