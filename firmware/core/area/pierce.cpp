// Polygons that pierce one another are split along their line before the sort, which the seed leaves to its caller.
#include "core/area/area_sort.hpp"
#include "core/area/cut.hpp"

namespace spanline::area {
namespace {

// Along the larger of the line's directions, so that a piece of the line has a length.
std::int32_t place(GridPoint p, const Line& line) {
  const bool flat =
      (line.along_y < 0 ? -line.along_y : line.along_y) > (line.along_x < 0 ? -line.along_x : line.along_x);
  return flat ? p.x : p.y;
}

// Whether two sorted lists of meetings have a piece of the line in common.
bool share_a_piece(const Borders& borders, const Border& one, const Border& other, const Line& line) {
  for (std::uint16_t i = one.first; i != 0 && borders[i].next != 0; i = borders[borders[i].next].next) {
    const std::int32_t low = place(borders[i].from, line), high = place(borders[borders[i].next].from, line);
    for (std::uint16_t j = other.first; j != 0 && borders[j].next != 0; j = borders[borders[j].next].next) {
      const std::int32_t from = place(borders[j].from, line), to = place(borders[borders[j].next].from, line);
      if (low < to && from < high) return true;
    }
  }
  return false;
}

}  // namespace

// Surface detail goes with its polygon; the faces of a solid are looked at themselves.
bool AreaSort::can_pierce(const NamedPolygon& polygon) const {
  return !polygon.silhouette && (!polygon.detail || of_solid(polygon));
}

bool AreaSort::of_solid(const NamedPolygon& polygon) const {
  if (!polygon.detail || polygon.group == kBackdropGroup) return false;
  for (std::uint16_t i = 1; i <= polygons_; ++i) {
    if (pools_.polygons[i].group == polygon.group && pools_.polygons[i].silhouette) return true;
  }
  return false;
}

// Later polygons include the halves of earlier ones, which pierce none that their whole did not.
bool AreaSort::pierce_all() {
  for (std::uint16_t one = 1; one < polygons_; ++one) {
    for (std::uint16_t other = static_cast<std::uint16_t>(one + 1); other <= polygons_; ++other) {
      const NamedPolygon &a = pools_.polygons[one], &b = pools_.polygons[other];
      if (!can_pierce(a) || !can_pierce(b) || (a.group != 0 && a.group == b.group)) continue;
      if (a.bounds.overlaps(b.bounds) && !pierce(one, other)) return false;
    }
  }
  return true;
}

// The faces of a pierced solid are polygons like any other from now on.
void AreaSort::dissolve(std::uint16_t group) {
  for (std::uint16_t i = 1; i <= polygons_; ++i) {
    NamedPolygon& polygon = pools_.polygons[i];
    if (polygon.group != group) continue;
    polygon.group = 0;
    polygon.detail = false;
    if (!polygon.silhouette) continue;
    polygon.silhouette = false;
    borders_.release(polygon.border);
    polygon.bounds = Box::none();
  }
}

bool AreaSort::pierce(std::uint16_t one, std::uint16_t other) {
  const NamedPolygon &a = pools_.polygons[one], &b = pools_.polygons[other];
  const Line line = crossing_line(a.plane, b.plane);
  if (!straddles(borders_, a.border, line) || !straddles(borders_, b.border, line)) return true;
  Border of_a = meetings(borders_, a.border, line), of_b = meetings(borders_, b.border, line);
  const bool shared = share_a_piece(borders_, of_a, of_b, line);
  borders_.release(of_a);
  borders_.release(of_b);
  if (!borders_fit(a.source)) return false;
  if (!shared) return true;
  ++counts_.pierced;
  if (a.detail) dissolve(a.group);
  if (b.detail) dissolve(b.group);
  return split(one, line) && split(other, line);
}

bool AreaSort::split(std::uint16_t name, const Line& line) {
  share_meetings(name, line);
  NamedPolygon& polygon = pools_.polygons[name];
  Halves halves = cut(borders_, polygon.border, line);
  polygon.border = halves.positive;
  polygon.bounds = borders_.bounds(polygon.border);
  if (!borders_fit(polygon.source)) return false;
  const std::uint16_t other = add_polygon(polygon.source, polygon.plane, polygon.opacity, halves.negative);
  pools_.polygons[other].group = polygon.group;
  return other != 0;
}

// Neighbours of a polygon in its mesh get the points at which their common edges are split, so that no gap opens.
void AreaSort::share_meetings(std::uint16_t name, const Line& line) {
  borders_.each(pools_.polygons[name].border, [&](const BorderEdge& edge) {
    const Meeting meeting = meeting_of(edge, line);
    if (!meeting.found || meeting.at == edge.from || meeting.at == edge.to) return;
    for (std::uint16_t i = 1; i <= polygons_; ++i) {
      NamedPolygon& neighbour = pools_.polygons[i];
      if (i == name) continue;
      borders_.each(neighbour.border, [&](BorderEdge& shared) {
        const bool forth = shared.from == edge.from && shared.to == edge.to;
        const bool back = shared.from == edge.to && shared.to == edge.from;
        if (!forth && !back) return;
        const GridPoint end = shared.to;
        shared.to = meeting.at;
        borders_.append(neighbour.border, meeting.at, end);
      });
    }
  });
}

}  // namespace spanline::area
