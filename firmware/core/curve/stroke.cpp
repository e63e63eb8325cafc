#include "core/curve/stroke.hpp"

#include "core/fx/root.hpp"

namespace spanline {
namespace {

// A row of samples: its height on the screen and what the discs cover of it so far, 28.4.
struct Row {
  static constexpr std::int32_t kNowhere = 4 * kMaxCurve;  // beyond any disc

  std::int32_t y;
  std::int32_t left = kNowhere, right = -kNowhere;

  void add(CurvePoint centre, std::int32_t radius) {
    const std::int32_t to_left = centre.x - left, to_right = right - centre.x;
    if (to_left >= radius && to_right >= radius) return;
    const std::int32_t off = centre.y - y, square = radius * radius - off * off;
    // Most chords are no longer than what is covered: squares tell without a root.
    const auto within = [&](std::int32_t side) { return side >= 0 && (side >= radius || side * side >= square); };
    if (square < 0 || (within(to_left) && within(to_right))) return;
    const auto half = static_cast<std::int32_t>(square_root(static_cast<std::uint32_t>(square)));
    if (centre.x - half < left) left = centre.x - half;
    if (centre.x + half > right) right = centre.x + half;
  }
};

// The rows of samples of a line: four, each a quarter of a pixel high, or one, through the pixels' centres.
constexpr unsigned kRows = 4;
constexpr std::int32_t row_height(std::int32_t line, unsigned row, bool smooth) {
  return line * kSubpixels + (smooth ? 2 + 4 * static_cast<std::int32_t>(row) : kSubpixels / 2);
}

// The first of the samples `spacing` apart, from spacing / 2 on, that is not left of x.
constexpr std::int32_t first_sample(std::int32_t x, int log_spacing) {
  return (x + (1 << (log_spacing - 1)) - 1) >> log_spacing;
}

}  // namespace

bool Stroke::draw(std::int32_t line, LineCoverage& coverage) {
  return pen_.radius == 0 ? draw_pixels(line, coverage) : draw_discs(line, coverage);
}

bool Stroke::draw_pixels(std::int32_t line, LineCoverage& coverage) {
  for (;;) {
    const CurvePoint at = walk_.at();
    if (at.y >> 4 > line) return true;
    if (at.y >> 4 == line) coverage.pixel(at.x >> 4);
    if (walk_.done()) return false;
    walk_.next();
  }
}

bool Stroke::draw_discs(std::int32_t line, LineCoverage& coverage) {
  const unsigned count = pen_.smooth ? kRows : 1;
  const std::int32_t radius = pen_.radius;
  Row rows[kRows];
  for (unsigned i = 0; i < count; ++i) rows[i] = {row_height(line, i, pen_.smooth)};
  const std::int32_t top = rows[0].y - radius, bottom = rows[count - 1].y + radius;

  while (walk_.at().y < top) {
    if (walk_.done()) return false;
    walk_.next();
  }
  for (StrandWalk walk = walk_; walk.at().y <= bottom; walk.next()) {
    for (unsigned i = 0; i < count; ++i) rows[i].add(walk.at(), radius);
    if (walk.done()) break;
  }
  for (unsigned i = 0; i < count; ++i) {
    if (rows[i].left > rows[i].right) continue;
    if (pen_.smooth) {
      coverage.samples(first_sample(rows[i].left, 2), first_sample(rows[i].right + 1, 2), i);
    } else {
      coverage.pixels(first_sample(rows[i].left, 4), first_sample(rows[i].right + 1, 4));
    }
  }
  return true;
}

}  // namespace spanline
