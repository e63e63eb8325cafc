#include "area/solved.hpp"

#include <algorithm>
#include <memory>
#include <set>

namespace spanline::area::test {
namespace {

#ifdef SPANLINE_ROUNDS_SHARE  // an emulated microcontroller: what two polygons of 64 corners need
using Pile = PoolStorage<128, 264, 392, 80>;
#else
using Pile = PoolStorage<4000, 12000, 20000, 4000>;
#endif

struct Reading {
  Polygons& polygons;
  bool fresh = false;
  AreaRing* ring = nullptr;
  void begin_polygon() {
    polygons.emplace_back();
    fresh = true;
  }
  void begin_contour() {
    ring = fresh ? &polygons.back().main : &polygons.back().holes.emplace_back();
    fresh = false;
  }
  void vertex(std::int32_t x, std::int32_t y) { ring->push_back({x, y}); }
  void end_contour() {}
  void end_polygon() {}
};

using Edge = std::pair<AreaPoint, AreaPoint>;

std::int64_t turn(AreaPoint a, AreaPoint b, AreaPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t twice_area(const AreaRing& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += turn(ring[0], ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

void add_edges(const AreaRing& ring, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
}

std::vector<Edge> edges_of(const Polygons& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.main.size();
    for (const AreaRing& hole : polygon.holes) count += hole.size();
  }
  std::vector<Edge> edges;
  edges.reserve(count);
  for (const Polygon& polygon : polygons) {
    add_edges(polygon.main, edges);
    for (const AreaRing& hole : polygon.holes) add_edges(hole, edges);
  }
  return edges;
}

bool inside_edge(AreaPoint p, const Edge& e) {
  return turn(e.first, e.second, p) == 0 && std::min(e.first, e.second) < p && p < std::max(e.first, e.second);
}

int sign(std::int64_t value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

bool cross(const Edge& a, const Edge& b) {
  return sign(turn(a.first, a.second, b.first)) * sign(turn(a.first, a.second, b.second)) < 0 &&
         sign(turn(b.first, b.second, a.first)) * sign(turn(b.first, b.second, a.second)) < 0;
}

std::string shown(const Edge& e) {
  const auto point = [](AreaPoint p) { return "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")"; };
  return point(e.first) + "-" + point(e.second);
}

std::string flaw_of_edges(std::vector<Edge> edges) {
  for (Edge& e : edges) {
    if (e.second < e.first) std::swap(e.first, e.second);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].first.x <= edges[i].second.x; ++j) {
      const Edge &a = edges[i], &b = edges[j];
      if (cross(a, b)) return "edges cross: " + shown(a) + " " + shown(b);
      if (inside_edge(a.first, b) || inside_edge(a.second, b) || inside_edge(b.first, a) || inside_edge(b.second, a)) {
        return "an edge ends on another: " + shown(a) + " " + shown(b);
      }
    }
  }
  return "";
}

bool within_ring(const AreaRing& ring, const AreaRing& hole) {
  bool on_border = false;
  const bool inside = oracle::covers({ring}, {hole[0].x + hole[1].x, hole[0].y + hole[1].y}, on_border);
  return inside && !on_border;
}

std::string flaw_of_contours(const Polygons& polygons) {
  for (const AreaRing& ring : rings_of(polygons)) {
    if (std::set<AreaPoint>(ring.begin(), ring.end()).size() != ring.size()) return "a contour touches itself";
    if (ring.size() < 3) return "a contour without area";
  }
  for (const Polygon& polygon : polygons) {
    if (twice_area(polygon.main) >= 0) return "a main contour runs counter-clockwise";
    for (const AreaRing& hole : polygon.holes) {
      if (twice_area(hole) <= 0) return "a hole runs clockwise";
      if (!within_ring(polygon.main, hole)) return "a hole outside its main contour";
      for (const AreaRing& other : polygon.holes) {
        if (&other != &hole && within_ring(other, hole)) return "a hole in a hole";
      }
    }
  }
  return "";
}

// A piece of border may belong to one contour of each list, and then runs both ways.
std::string flaw_of_sharing(const Polygons& inside, const Polygons& outside) {
  std::vector<Edge> all = edges_of(inside), here = edges_of(outside);
  for (std::vector<Edge>* edges : {&all, &here}) {
    std::sort(edges->begin(), edges->end());
    for (const Edge& e : *edges) {
      if (std::binary_search(edges->begin(), edges->end(), Edge{e.second, e.first})) {
        return "an edge belongs to two contours: " + shown(e);
      }
    }
  }
  all.insert(all.end(), here.begin(), here.end());
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  return twice == all.end() ? "" : "an edge belongs to two contours: " + shown(*twice);
}

std::string flaw_of_links(const Clipper& clipper, std::uint16_t contour) {
  HalfEdge h = clipper.first_edge(contour);
  do {
    const HalfEdge following = clipper.next_edge(h), other = clipper.linked(h);
    if (other != 0 && !(clipper.origin(other) == clipper.origin(following))) return "a link starts elsewhere";
    if (other != 0 && clipper.linked(other) != h) return "a link does not lead back";
    h = following;
  } while (h != clipper.first_edge(contour));
  return "";
}

std::string flaw_of_links(const Clipper& clipper, List list) {
  std::string flaws;
  for (std::uint16_t main = clipper.first_main(list); main != 0; main = clipper.next_contour(main)) {
    flaws += flaw_of_links(clipper, main);
    for (std::uint16_t hole = clipper.first_hole(main); hole != 0; hole = clipper.next_contour(hole)) {
      flaws += flaw_of_links(clipper, hole);
    }
  }
  return flaws;
}

}  // namespace

void put(Clipper& clipper, Role role, const AreaRegion& region) {
  for (const AreaRing& ring : region) {
    clipper.begin_contour(role);
    for (const AreaPoint p : ring) clipper.vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
    clipper.end_contour();
  }
}

Solved read(const Clipper& clipper) {
  Solved solved;
  solved.status = clipper.status();
  solved.counts = clipper.counts();
  Reading inside{solved.inside}, outside{solved.outside};
  clipper.read(List::inside, inside);
  clipper.read(List::outside, outside);
  solved.broken_link = flaw_of_links(clipper, List::inside) + flaw_of_links(clipper, List::outside);
  return solved;
}

Solved solve(const AreaRegion& subject, const AreaRegion& clip, Operation operation) {
  static const auto pile = std::make_unique<Pile>();
  Clipper clipper(pile->refs());
  clipper.clear();
  put(clipper, Role::subject, subject);
  put(clipper, Role::clip, clip);
  switch (operation) {
    case Operation::clip:
      clipper.clip();
      break;
    case Operation::unite:
      clipper.unite();
      break;
    case Operation::differ:
      clipper.differ();
      break;
  }
  return read(clipper);
}

AreaRegion rings_of(const Polygons& polygons) {
  AreaRegion rings;
  for (const Polygon& polygon : polygons) {
    rings.push_back(polygon.main);
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return rings;
}

std::int64_t twice_area(const Polygons& polygons) {
  std::int64_t sum = 0;
  for (const AreaRing& ring : rings_of(polygons)) sum -= twice_area(ring);
  return sum;
}

Polygons canonical(Polygons polygons) {
  const auto from_least = [](AreaRing& ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  };
  for (Polygon& polygon : polygons) {
    from_least(polygon.main);
    for (AreaRing& hole : polygon.holes) from_least(hole);
    std::sort(polygon.holes.begin(), polygon.holes.end());
  }
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) { return a.main < b.main; });
  return polygons;
}

std::string flaw(const Polygons& inside, const Polygons& outside) {
  for (const Polygons* list : {&inside, &outside}) {
    if (const std::string text = flaw_of_contours(*list); !text.empty()) return text;
  }
  if (const std::string text = flaw_of_sharing(inside, outside); !text.empty()) return text;
  std::vector<Edge> edges = edges_of(inside);
  const std::vector<Edge> others = edges_of(outside);
  edges.insert(edges.end(), others.begin(), others.end());
  return flaw_of_edges(std::move(edges));
}

}  // namespace spanline::area::test
