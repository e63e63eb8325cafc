#include "hidden/line_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace spanline::host {
namespace {

using area::GridPoint;
using Ends = std::pair<GridPoint, GridPoint>;  // lesser first

Ends ends_of(GridPoint a, GridPoint b) { return a < b ? Ends{a, b} : Ends{b, a}; }

bool strictly_within(GridPoint p, const Ends& e) {
  return area::orientation(e.first, e.second, p) == 0 && e.first < p && p < e.second;
}

// Every vertex of the view by x, then y.
std::vector<GridPoint> vertices_of(const HiddenView& view) {
  std::vector<GridPoint> all;
  for (const VisiblePolygon& polygon : view.polygons) {
    for (const auto& ring : polygon.rings) {
      for (const ScreenVertex& v : ring) all.push_back(v.at);
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

constexpr int kNobody = -1;
struct Sides {
  int left = kNobody, right = kNobody;  // which facet through which films, seen from the lesser end
};
using Borders = std::map<Ends, Sides>;

// An edge is cut where corners of others lie on it, so that both of its sides are the same pieces of border.
void add_edge(Borders& borders, const std::vector<GridPoint>& vertices, GridPoint from, GridPoint to, int facet) {
  const Ends whole = ends_of(from, to);
  GridPoint last = whole.first;
  const auto add = [&](GridPoint next) {
    Sides& sides = borders[{last, next}];
    (whole.first == from ? sides.right : sides.left) = facet;
    last = next;
  };
  for (auto v = std::upper_bound(vertices.begin(), vertices.end(), whole.first);
       v != vertices.end() && *v < whole.second; ++v) {
    if (strictly_within(*v, whole)) add(*v);
  }
  add(whole.second);
}

// Joins pieces that follow one another straight on.
std::vector<Line> joined(std::vector<Ends> pieces) {
  std::sort(pieces.begin(), pieces.end());
  std::map<GridPoint, std::vector<std::size_t>> starting;
  for (std::size_t i = 0; i < pieces.size(); ++i) starting[pieces[i].first].push_back(i);
  std::vector<bool> used(pieces.size());
  std::vector<Line> lines;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (used[i]) continue;
    Ends line = pieces[i];
    for (bool grown = true; grown;) {
      grown = false;
      const auto found = starting.find(line.second);
      if (found == starting.end()) break;
      for (const std::size_t next : found->second) {
        if (used[next] || area::orientation(line.first, line.second, pieces[next].second) != 0) continue;
        line.second = pieces[next].second;
        used[next] = grown = true;
        break;
      }
    }
    lines.push_back({line.first, line.second});
  }
  return lines;
}

// The shares [0, 1] of a straight edge that lines within a unit of it run along.
std::vector<std::pair<double, double>> covered(const Ends& edge, const std::vector<Line>& lines) {
  const double dx = edge.second.x - edge.first.x, dy = edge.second.y - edge.first.y, square = dx * dx + dy * dy;
  const auto place = [&](GridPoint p) { return ((p.x - edge.first.x) * dx + (p.y - edge.first.y) * dy) / square; };
  const auto beside = [&](GridPoint p) {
    return std::fabs((p.x - edge.first.x) * dy - (p.y - edge.first.y) * dx) <= 1.5 * std::sqrt(square);
  };
  std::vector<std::pair<double, double>> parts;
  for (const Line& line : lines) {
    if (!beside(line.from) || !beside(line.to)) continue;
    const double a = place(line.from), b = place(line.to);
    const double low = std::max(0.0, std::min(a, b)), high = std::min(1.0, std::max(a, b));
    if (low < high) parts.emplace_back(low, high);
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

void add_gaps(std::vector<Line>& lines, const Ends& edge, const std::vector<std::pair<double, double>>& parts) {
  const auto at = [&](double share) {
    return GridPoint{static_cast<std::int16_t>(std::lround(edge.first.x + share * (edge.second.x - edge.first.x))),
                     static_cast<std::int16_t>(std::lround(edge.first.y + share * (edge.second.y - edge.first.y)))};
  };
  const double unit =
      1.5 / std::max(1, std::abs(edge.second.x - edge.first.x) + std::abs(edge.second.y - edge.first.y));
  double reached = 0;
  const auto gap_to = [&](double end) {
    if (end - reached > unit) lines.push_back({at(reached), at(end)});
  };
  for (const auto& [low, high] : parts) {
    gap_to(low);
    reached = std::max(reached, high);
  }
  gap_to(1);
}

}  // namespace

std::vector<Line> visible_lines(const HiddenView& view) {
  const std::vector<GridPoint> vertices = vertices_of(view);
  Borders borders;
  std::map<std::pair<std::uint16_t, std::vector<std::uint16_t>>, int> looks;
  for (const VisiblePolygon& polygon : view.polygons) {
    const auto number = static_cast<int>(looks.size());
    const int look = looks.try_emplace({polygon.facet, polygon.films}, number).first->second;
    for (const auto& ring : polygon.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        add_edge(borders, vertices, ring[i].at, ring[(i + 1) % ring.size()].at, look);
    }
  }
  std::vector<Ends> pieces;
  for (const auto& [ends, sides] : borders) {
    if (sides.left != sides.right) pieces.push_back(ends);
  }
  return joined(std::move(pieces));
}

std::vector<Line> hidden_lines(const FacetList& all, const std::vector<Line>& visible, std::uint16_t width,
                               std::uint16_t height) {
  std::set<Ends> edges;
  for (const Facet& facet : all.facets()) {
    for (const auto& ring : facet.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const ScreenXY a = ring[i].at, b = ring[(i + 1) % ring.size()].at;
        if (!(a == b)) edges.insert(ends_of({a.x, a.y}, {b.x, b.y}));
      }
    }
  }
  const auto on_screen = [&](GridPoint p) {
    return p.x >= 0 && p.y >= 0 && p.x <= width * kSubpixels && p.y <= height * kSubpixels;
  };
  std::vector<Line> lines;
  for (const Ends& edge : edges) {
    if (on_screen(edge.first) && on_screen(edge.second)) add_gaps(lines, edge, covered(edge, visible));
  }
  return lines;
}

}  // namespace spanline::host
