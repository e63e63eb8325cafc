#include "assetc/merge_outline.hpp"

#include <algorithm>
#include <cstdlib>

namespace spanline::host {
namespace {

// A position in the plane that is left when the normal's largest component is dropped; areas keep the normal's sign.
struct GridPoint {
  std::int64_t u, v;
};

class Flattened {
 public:
  explicit Flattened(GridVector normal) {
    const std::int64_t along[3] = {normal.x, normal.y, normal.z};
    for (int i = 1; i < 3; ++i) {
      if (std::abs(along[i]) > std::abs(along[dropped_])) dropped_ = i;
    }
    flipped_ = along[dropped_] < 0;
  }
  GridPoint operator()(const Position& p) const {
    const std::int64_t all[3] = {p.x, p.y, p.z};
    const std::int64_t u = all[(dropped_ + 1) % 3], v = all[(dropped_ + 2) % 3];
    return flipped_ ? GridPoint{v, u} : GridPoint{u, v};
  }

 private:
  int dropped_ = 0;
  bool flipped_ = false;
};

struct Segment {
  GridPoint from, to;
};

// Twice the area of the triangle a, b, c; positive where it runs counter-clockwise.
std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

bool same(GridPoint a, GridPoint b) { return a.u == b.u && a.v == b.v; }

bool in_box(GridPoint p, const Segment& s) {
  return std::min(s.from.u, s.to.u) <= p.u && p.u <= std::max(s.from.u, s.to.u) && std::min(s.from.v, s.to.v) <= p.v &&
         p.v <= std::max(s.from.v, s.to.v);
}

// Whether `p` lies on `s` but is not an end of it.
bool inside(GridPoint p, const Segment& s) {
  return turn(s.from, s.to, p) == 0 && in_box(p, s) && !same(p, s.from) && !same(p, s.to);
}

// Whether the two have more in common than ends.
bool collide(const Segment& a, const Segment& b) {
  if (inside(a.from, b) || inside(a.to, b) || inside(b.from, a) || inside(b.to, a)) return true;
  if (same(a.from, b.from) && same(a.to, b.to)) return true;
  const int across_a = sign(turn(a.from, a.to, b.from)) * sign(turn(a.from, a.to, b.to));
  const int across_b = sign(turn(b.from, b.to, a.from)) * sign(turn(b.from, b.to, a.to));
  return across_a < 0 && across_b < 0;
}

std::vector<Segment> segments_of(const std::vector<Ring>& rings, const std::vector<Position>& positions,
                                 const Flattened& flat) {
  std::vector<Segment> segments;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments.push_back({flat(positions[ring[i]]), flat(positions[ring[(i + 1) % ring.size()]])});
    }
  }
  return segments;
}

// No two segments cross or overlap. Sorted by their left ends, so that only neighbours are compared.
bool disjoint(std::vector<Segment> segments) {
  const auto left = [](const Segment& s) { return std::min(s.from.u, s.to.u); };
  const auto right = [](const Segment& s) { return std::max(s.from.u, s.to.u); };
  std::sort(segments.begin(), segments.end(), [&](const Segment& a, const Segment& b) { return left(a) < left(b); });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size() && left(segments[j]) <= right(segments[i]); ++j) {
      if (collide(segments[i], segments[j])) return false;
    }
  }
  return true;
}

}  // namespace

GridVector newell(const Ring& ring, const std::vector<Position>& positions) {
  GridVector sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum = sum + cross(positions[ring[i]] - positions[ring[0]], positions[ring[i + 1]] - positions[ring[0]]);
  }
  return sum;
}

void EdgeSet::add(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
    const auto opposite = edges_.find({edge.second, edge.first});
    if (opposite == edges_.end()) {
      ++edges_[edge];
      continue;
    }
    cancelled_ = true;
    if (--opposite->second == 0) edges_.erase(opposite);
  }
}

// Follows the edges; whenever a vertex comes up again, what lies between is a ring of its own.
std::optional<std::vector<Ring>> EdgeSet::rings() const {
  std::multimap<std::uint16_t, std::uint16_t> next;
  for (const auto& [edge, count] : edges_) {
    if (count > 1) return std::nullopt;
    next.insert(edge);
  }
  std::vector<Ring> rings;
  while (!next.empty()) {
    Ring path = {next.begin()->first};
    while (!path.empty()) {
      const auto edge = next.find(path.back());
      if (edge == next.end()) break;  // the path came back to where it began, and that has become a ring
      const std::uint16_t to = edge->second;
      next.erase(edge);
      const auto before = std::find(path.begin(), path.end(), to);
      if (before == path.end()) {
        path.push_back(to);
        continue;
      }
      rings.emplace_back(before, path.end());
      path.erase(before + 1, path.end());
    }
  }
  return rings;
}

std::optional<std::vector<Ring>> EdgeSet::outline(const std::vector<Position>& positions, GridVector normal) const {
  std::optional<std::vector<Ring>> found = rings();
  if (!found) return std::nullopt;
  const Flattened flat(normal);
  const auto runs_around = [&](const Ring& ring) {
    std::int64_t doubled_area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      doubled_area += turn(flat(positions[ring[0]]), flat(positions[ring[i]]), flat(positions[ring[i + 1]]));
    }
    return doubled_area > 0;
  };
  if (std::count_if(found->begin(), found->end(), runs_around) != 1) return std::nullopt;
  std::partition(found->begin(), found->end(), runs_around);
  // One outline, holes in it, nothing crosses: the winding number is 1 inside and 0 outside, which even-odd filling
  // agrees to.
  if (!disjoint(segments_of(*found, positions, flat))) return std::nullopt;
  return found;
}

}  // namespace spanline::host
