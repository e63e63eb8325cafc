#include "core/vsg/active_edge.hpp"

namespace spanline {

EdgeRun start_run(ScreenXY top, ScreenXY bottom, std::int32_t line) {
  const std::int32_t dx = bottom.x - top.x, dy = bottom.y - top.y;
  const std::int32_t below = line * kSubpixels + kSubpixels / 2 - top.y;  // 0 <= below < dy <= 2^15
  CHECK(below >= 0 && below < dy);
  const std::int32_t left = first_centre(bottom.y) - line;
  EdgeRun run;
  run.lines = dy <= kTallEdge || left < exact_lines(dy) ? left : exact_lines(dy);

  const std::int32_t along = dx * below;  // |dx| <= 2^15
  const std::int32_t whole = floor_div(along, dy);
  const auto part = static_cast<std::uint32_t>(along - whole * dy);  // < dy
  const auto height = static_cast<std::uint32_t>(dy);
  run.x = (top.x - kSubpixels / 2 + whole) * (1 << 16) + static_cast<std::int32_t>((part << 16) / height) +
          ((1 << ActiveEdge::kFraction) - 1);

  // In two steps, as a remainder of 15 bits leaves room for 17. An edge so flat that the slope does not fit has one
  // line.
  const std::int32_t quotient = floor_div(dx, dy);
  const std::uint32_t remainder = static_cast<std::uint32_t>(dx - quotient * dy) << 16;
  const std::uint32_t fraction = remainder / height << 4 | (remainder % height << 4) / height;
  run.dx = static_cast<std::int32_t>((static_cast<std::uint32_t>(quotient) << ActiveEdge::kFraction) + fraction);
  return run;
}

constinit const std::array<std::uint32_t, SlopeByTable::kTallest> SlopeByTable::kReciprocals = [] {
  std::array<std::uint32_t, kTallest> table{};
  for (std::uint32_t dy = 1; dy < kTallest; ++dy) table[dy] = reciprocal(dy);
  return table;
}();

static_assert(kSubpixels == 16);
void FromVertex::run_far(ActiveEdge& edge, std::uint32_t from, std::int32_t centre) {
  if constexpr (!kDivides) {  // one divide is less than those below
    const FromVertex vertex(PackedXY(from), centre >> 4);
    const PackedXY end(static_cast<std::uint32_t>(edge.x));
    if (is_short<true>((end.word << 16) - vertex.x_, end.y() - PackedXY(from).y())) {
      return vertex.run<true>(edge, end, edge.rest);
    }
  }
  const ScreenXY top = PackedXY(from).unpacked(), bottom = PackedXY(static_cast<std::uint32_t>(edge.x)).unpacked();
  const EdgeRun run = start_run(top, bottom, centre >> 4);
  edge.x = run.x;
  edge.dx = run.dx;
  edge.rest += static_cast<std::uint32_t>(run.lines - 1) * ActiveEdge::kOneLine;
  if (bottom.y - top.y > kTallEdge) edge.rest += ActiveEdge::kTall;
}

}  // namespace spanline
