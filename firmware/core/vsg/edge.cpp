#include "core/vsg/edge.hpp"

#include "core/fx/bits.hpp"

namespace spanline {

namespace {

// 28.4 from the edge's upper end to the centre of `line`.
std::int32_t below_top(const ScreenEdge& edge, std::int32_t line) {
  return line * kSubpixels + kSubpixels / 2 - edge.top.at.y;
}

template <typename Wide>
void start_depth_in(const ScreenEdge& edge, std::int32_t line, SegmentHalf& half) {
  const Wide rise = (Wide{static_cast<std::int32_t>(edge.bottom.depth)} - static_cast<std::int32_t>(edge.top.depth)) *
                    (1 << kRampShift);  // below 2^29
  const Wide dy = edge.height();
  const std::int32_t first = edge.first_line();
  const Wide start = round_div<Wide>(rise * below_top(edge, first), dy);
  half.depth_step = static_cast<std::int32_t>(round_div<Wide>(rise * kSubpixels, dy));
  half.depth = (edge.top.depth << kRampShift) + static_cast<std::uint32_t>(start) +
               static_cast<std::uint32_t>(half.depth_step) * static_cast<std::uint32_t>(line - first);
}

// Mostly 32 bits are wide enough.
void start_depth(const ScreenEdge& edge, std::int32_t line, SegmentHalf& half) {
  constexpr std::uint32_t kMost = 1 << 21;
  static_assert((std::int64_t{kMost} << kRampShift) * kSubpixels + UINT16_MAX / 2 <= INT32_MAX, "rise * a line");
  const bool gentle = edge.bottom.depth - edge.top.depth + kMost <= 2 * kMost;
  gentle ? start_depth_in<std::int32_t>(edge, line, half) : start_depth_in<std::int64_t>(edge, line, half);
}

}  // namespace

SegmentHalf start_edge(const ScreenEdge& edge, std::int32_t line, bool with_depth) {
  CHECK(line >= edge.first_line() && line < edge.end_line());
  const std::int32_t dx = edge.bottom.at.x - edge.top.at.x;
  const std::int32_t dy = edge.height();
  SegmentHalf half;
  const std::int32_t quotient = floor_div(dx, dy);
  const auto remainder = static_cast<std::uint32_t>(dx - quotient * dy);
  half.quotient = static_cast<std::int16_t>(quotient);
  half.remainder = static_cast<std::uint16_t>(remainder);
  half.height = static_cast<std::uint16_t>(dy);
  half.lines = static_cast<std::uint16_t>(edge.end_line() - line);
  half.unused = 0;

  // N = u * dy + m * t with u = x0 - 8 + q * t = 16 * a + b, so N / D = a + (b * dy + m * t) / D.
  const std::int32_t t = below_top(edge, line);
  const std::int32_t u = edge.top.at.x - kSubpixels / 2 + quotient * t;
  const std::uint32_t denominator = half.denominator();
  std::uint32_t along = remainder * static_cast<std::uint32_t>(t);  // m < dy <= 65535, t < dy: fits
  std::uint32_t whole = 0;
  if (t >= kSubpixels) {  // else m * t < D
    whole = along / denominator;
    along -= whole * denominator;
  }
  along += static_cast<std::uint32_t>(u & (kSubpixels - 1)) * static_cast<std::uint32_t>(dy);  // < 2 D
  const std::uint32_t up = along == 0 ? 0u : along <= denominator ? 1u : 2u;
  half.column = static_cast<std::int16_t>((u >> 4) + static_cast<std::int32_t>(whole + up));
  half.error = up * denominator - along;
  half.depth = 0;
  half.depth_step = 0;
  if (with_depth) start_depth(edge, line, half);
  return half;
}

std::strong_ordering order(const SegmentHalf& a, const SegmentHalf& b) {
  if (a.column != b.column) return a.column <=> b.column;
  // In the same column the larger e / D lies further left.
  const std::uint64_t left_a = std::uint64_t{a.error} * b.height, left_b = std::uint64_t{b.error} * a.height;
  if (left_a != left_b) return left_b <=> left_a;
  if (a.quotient != b.quotient) return a.quotient <=> b.quotient;
  const std::uint32_t slope_a = std::uint32_t{a.remainder} * b.height, slope_b = std::uint32_t{b.remainder} * a.height;
  if (slope_a != slope_b) return slope_a <=> slope_b;
  return a.depth != b.depth ? a.depth <=> b.depth : a.depth_step <=> b.depth_step;
}

EdgeShade shade_edge(const ScreenEdge& edge) {
  const auto dy = static_cast<std::uint32_t>(edge.height());
  const std::int32_t first = edge.first_line();
  const auto start = static_cast<std::int32_t>((static_cast<std::uint32_t>(below_top(edge, first)) << 15) / dy);  // Q15
  // An edge with two lines is a pixel tall at least; a shorter one never steps.
  const auto line = dy >= kSubpixels ? static_cast<std::int32_t>((std::uint32_t{kSubpixels} << 15) / dy) : 0;
  const std::uint8_t top[3] = {edge.top.color.r, edge.top.color.g, edge.top.color.b};
  const std::uint8_t bottom[3] = {edge.bottom.color.r, edge.bottom.color.g, edge.bottom.color.b};
  EdgeShade shade;
  for (int i = 0; i < 3; ++i) {
    const std::int32_t rise = bottom[i] - top[i];
    // Cut off towards zero, so that no line of the edge leaves the range of its two ends.
    shade.color[i] = static_cast<std::int16_t>(top[i] * 128 + rise * start / 256);
    shade.step[i] = static_cast<std::int16_t>(rise * line / 256);
  }
  shade.first_line_from_top = static_cast<std::uint16_t>(first + 2048);
  return shade;
}

}  // namespace spanline
