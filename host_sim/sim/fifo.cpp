#include "sim/fifo.hpp"

#include <algorithm>
#include <cmath>

namespace spanline::host {
namespace {

constexpr double kReferenceSeconds = 200e-9;
constexpr double kFramesPerSecond = 30;

}  // namespace

std::uint32_t fifo_segments(const std::vector<LineLoad>& lines) {
  const std::size_t height = lines.size();
  if (height == 0) return 1;
  const double line_time = 1 / (kFramesPerSecond * static_cast<double>(height));
  std::vector<double> segments(height + 1, 0);  // put out before line i begins
  for (std::size_t i = 0; i < height; ++i) segments[i + 1] = segments[i] + lines[i].segments;

  // What the display has taken at a time.
  const auto taken = [&](double time) {
    const double place = std::clamp(time / line_time, 0.0, static_cast<double>(height));
    const auto line = std::min(static_cast<std::size_t>(place), height - 1);
    return segments[line] + (place - static_cast<double>(line)) * lines[line].segments;
  };

  // start: the latest moment to begin work on line i, the display's own and early enough for the lines behind.
  double start = static_cast<double>(height) * line_time;
  double most = 1;
  for (std::size_t i = height; i-- > 0;) {
    const double work = lines[i].references * kReferenceSeconds;
    start = std::min(static_cast<double>(i) * line_time, start - work);
    most = std::max(most, segments[i + 1] - taken(start + work));
  }
  return static_cast<std::uint32_t>(std::ceil(most - 1e-9));
}

}  // namespace spanline::host
