#include "core/area/cut.hpp"

#include <utility>

namespace spanline::area {
namespace {

// Along the line; points of equal rank lie within a unit of each other, and either order makes a closed border.
bool comes_first(GridPoint a, GridPoint b, const Line& line) {
  const bool flat =
      (line.along_y < 0 ? -line.along_y : line.along_y) > (line.along_x < 0 ? -line.along_x : line.along_x);
  return flat ? a < b : a.y != b.y ? a.y < b.y : a.x < b.x;
}

void sort_points(Borders& borders, const Border& points, const Line& line) {
  for (std::uint16_t i = points.first; i != 0; i = borders[i].next) {
    for (std::uint16_t j = borders[i].next; j != 0; j = borders[j].next) {
      if (comes_first(borders[j].from, borders[i].from, line)) std::swap(borders[i].from, borders[j].from);
    }
  }
}

void append_unless_empty(Borders& borders, Border& to, GridPoint a, GridPoint b) {
  if (!(a == b)) borders.append(to, a, b);
}

}  // namespace

bool straddles(const Borders& borders, const Border& border, const Line& line) {
  bool positive = false, negative = false;
  borders.each_end(border, [&](GridPoint p) {
    const int side = line.side(p);
    positive |= side > 0;
    negative |= side < 0;
  });
  return positive && negative;
}

Meeting meeting_of(const BorderEdge& edge, const Line& line) {
  const int from = line.side(edge.from), to = line.side(edge.to);
  if ((from < 0) == (to < 0)) return {};
  if (from == 0) return {true, edge.from};
  if (to == 0) return {true, edge.to};
  return {true, edge.from < edge.to ? meeting(edge.from, edge.to, line) : meeting(edge.to, edge.from, line)};
}

Border meetings(Borders& borders, const Border& border, const Line& line) {
  Border points;
  borders.each(border, [&](const BorderEdge& edge) {
    if (const Meeting meeting = meeting_of(edge, line); meeting.found) borders.append(points, meeting.at, meeting.at);
  });
  sort_points(borders, points, line);
  return points;
}

Halves cut(Borders& borders, Border& border, const Line& line) {
  Halves halves;
  Border points = meetings(borders, border, line);
  const auto half_of = [&](GridPoint p) -> Border& { return line.side(p) < 0 ? halves.negative : halves.positive; };
  borders.each(border, [&](const BorderEdge& edge) {
    const Meeting meeting = meeting_of(edge, line);
    if (!meeting.found) return borders.append(half_of(edge.from), edge.from, edge.to);
    append_unless_empty(borders, half_of(edge.from), edge.from, meeting.at);
    append_unless_empty(borders, half_of(edge.to), meeting.at, edge.to);
  });
  for (std::uint16_t i = points.first; i != 0;) {
    const std::uint16_t other = borders[i].next;
    if (other == 0) break;  // points were lost: the pool is full
    append_unless_empty(borders, halves.positive, borders[i].from, borders[other].from);
    append_unless_empty(borders, halves.negative, borders[other].from, borders[i].from);
    i = borders[other].next;
  }
  borders.release(points);
  borders.release(border);
  return halves;
}

void cut_to(Borders& borders, Border& border, const Box& box) {
  const Line sides[] = {{1, 0, -box.low.x}, {-1, 0, box.high.x}, {0, 1, -box.low.y}, {0, -1, box.high.y}};
  for (const Line& side : sides) {
    bool outside = false;
    borders.each_end(border, [&](GridPoint p) { outside |= side.side(p) < 0; });
    if (!outside) continue;
    Halves halves = cut(borders, border, side);
    borders.release(halves.negative);
    border = halves.positive;
  }
}

}  // namespace spanline::area
