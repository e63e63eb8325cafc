#include "clip/working_grid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/area/predicates.hpp"

namespace spanline::host {
namespace {

constexpr double kMost = area::kMaxCoordinate;
constexpr int kFinest = 12, kCoarsest = -9;  // powers of ten: 1e-12 units, and 1e12 units into 65534
constexpr double kExactInDouble = 9007199254740992.0;

struct Extent {
  double low, high;
  double middle() const { return (low + high) / 2; }
  double half() const { return (high - low) / 2; }
  double farthest() const { return std::max(std::fabs(low), std::fabs(high)); }
};

bool holds(double value, double per_unit) {
  const double whole = std::round(value * per_unit);
  return std::fabs(whole) < kExactInDouble && whole / per_unit == value;
}

// The least power of ten that makes every coordinate whole.
std::optional<double> exact_scale(const std::vector<WorkingGrid::Point>& points) {
  double per_unit = 1;
  for (int digits = 0; digits <= kFinest; ++digits, per_unit *= 10) {
    const bool all = std::all_of(points.begin(), points.end(), [&](const WorkingGrid::Point& p) {
      return holds(p.x, per_unit) && holds(p.y, per_unit);
    });
    if (all) return per_unit;
  }
  return std::nullopt;
}

}  // namespace

WorkingGrid WorkingGrid::holding(const std::vector<Point>& points) {
  WorkingGrid grid;
  if (points.empty()) return grid;
  Extent x{points[0].x, points[0].x}, y{points[0].y, points[0].y};
  for (const Point& p : points) {
    x = {std::min(x.low, p.x), std::max(x.high, p.x)};
    y = {std::min(y.low, p.y), std::max(y.high, p.y)};
  }
  // An origin in the middle is rounded to the raster: one unit to spare.
  const auto fits = [&](double per_unit, double step) {
    return std::max(x.half(), y.half()) * per_unit / step <= kMost - 1 ||
           std::max(x.farthest(), y.farthest()) * per_unit / step <= kMost;
  };
  const std::optional<double> exact = exact_scale(points);
  if (exact && fits(*exact, 1)) {
    grid.per_unit_ = *exact;
  } else {
    bool found = false;
    for (int power = kFinest; power >= kCoarsest && !found; --power) {
      for (const double digit : {5.0, 2.0, 1.0}) {
        if (found) break;
        // 1, 2 and 5 times a negative power are 1 / 10, 1 / 5 and 1 / 2 of a whole step.
        const double whole = std::pow(10.0, std::abs(power));
        grid.per_unit_ = power >= 0 ? digit * whole : 1;
        grid.step_ = power >= 0 ? 1 : whole / digit;
        found = fits(grid.per_unit_, grid.step_);
      }
    }
  }
  if (std::max(x.farthest(), y.farthest()) * grid.per_unit_ / grid.step_ > kMost) {
    grid.origin_x_ = std::round(x.middle() * grid.per_unit_ / grid.step_);
    grid.origin_y_ = std::round(y.middle() * grid.per_unit_ / grid.step_);
  }
  return grid;
}

std::int32_t WorkingGrid::whole(double value, double origin) const {
  return static_cast<std::int32_t>(std::round(value * per_unit_ / step_) - origin);
}

}  // namespace spanline::host
