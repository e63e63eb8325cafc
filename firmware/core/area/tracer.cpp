#include "core/area/tracer.hpp"

namespace spanline::area {
namespace {

constexpr std::uint16_t kBottom = UINT16_MAX;  // Node::mark: visited; the last of the stack, or taken from it

}  // namespace

bool Tracer::trace(std::uint16_t nodes, std::uint16_t edges, CoverSet inside, CoverSet outside) {
  CHECK((inside & outside) == 0 && ((inside | outside) & 1) == 0);
  nodes_ = nodes;
  edges_ = edges;
  contours_ = first_[0] = first_[1] = 0;
  for (unsigned cover = 0; cover < 4; ++cover) {
    const unsigned bit = 1u << cover;
    list_of_[cover] = (inside & bit) != 0 ? 1 : (outside & bit) != 0 ? 2 : 0;
  }
  find_covers();
  for (std::uint16_t i = 1; i <= nodes_; ++i) {
    link_contours(pools_.nodes[i]);
    pools_.nodes[i].mark = 0;
  }
  for (std::uint16_t i = 1; i <= edges_; ++i) {
    for (std::uint16_t direction = 0; direction < 2; ++direction) {
      const auto h = static_cast<HalfEdge>(2 * i + direction);
      if (list_bounded_by(h) != 0 && !has(h, kTraced) && !walk(h)) return false;
    }
  }
  attach_holes();
  chain_lists();
  return true;
}

std::uint8_t Tracer::list_bounded_by(HalfEdge h) const {
  const std::uint8_t list = list_of_[right(h)];
  return list != list_of_[right(partner(h))] ? list : 0;
}

// Covers are carried from edge to edge around the nodes; only each connected piece needs a look at the others, once.
void Tracer::find_covers() {
  for (std::uint16_t i = 1; i <= nodes_; ++i) pools_.nodes[i].mark = 0;
  for (std::uint16_t i = 1; i <= nodes_; ++i) {
    if (pools_.nodes[i].mark != 0 || pools_.nodes[i].first == 0) continue;
    // The least node of its piece: all its edges lie to the right, so straight down and left of it is one place.
    std::uint16_t stack = kBottom;
    pools_.nodes[i].mark = kBottom;
    cover_around(i, cover_left_of(pools_.nodes[i].at), stack);
    while (stack != kBottom) {
      const std::uint16_t node = stack;
      stack = pools_.nodes[node].mark;
      pools_.nodes[node].mark = kBottom;
      cover_around(node, cover_below_first(pools_.nodes[node]), stack);
    }
  }
}

// The cover just left of a node that no edge enters from the left: what lies below decides.
Cover Tracer::cover_left_of(GridPoint at) const {
  Cover cover = 0;
  for (std::uint16_t i = 1; i <= edges_; ++i) {
    const Edge& edge = pools_.edges[i];
    const GridPoint a = pools_.nodes[edge.end[0]].at, b = pools_.nodes[edge.end[1]].at;
    if (a.x < at.x && at.x <= b.x && orientation(a, b, at) > 0) cover ^= edge.borders;
  }
  return cover;
}

// The cover right of a node's first half-edge, from any edge there that is known.
Cover Tracer::cover_below_first(const Node& node) const {
  Cover crossed = 0;
  HalfEdge h = node.first;
  for (; (pools_.edges[h >> 1].bits & kKnown) == 0; h = pools_.edges[h >> 1].link[h & 1]) {
    crossed ^= pools_.edges[h >> 1].borders;
  }
  return static_cast<Cover>(crossed ^ right(h));
}

void Tracer::cover_around(std::uint16_t node, Cover below_first, std::uint16_t& stack) {
  Cover cover = below_first, owners = 0;
  for (HalfEdge h = pools_.nodes[node].first; h != 0; h = pools_.edges[h >> 1].link[h & 1]) {
    Edge& edge = pools_.edges[h >> 1];
    const Cover right_of_zero = (h & 1) == 0 ? cover : static_cast<Cover>(cover ^ edge.borders);
    CHECK((edge.bits & kKnown) == 0 || (edge.bits & 3) == right_of_zero);
    edge.bits = static_cast<std::uint8_t>((edge.bits & ~3) | right_of_zero | kKnown);
    cover ^= edge.borders;
    owners |= edge.borders;
    Node& far = pools_.nodes[node_of(partner(h))];
    if (far.mark == 0) {
      far.mark = stack;
      stack = node_of(partner(h));
    }
  }
  CHECK(cover == below_first);
  if (owners != 3) return;
  for (HalfEdge h = pools_.nodes[node].first; h != 0; h = pools_.edges[h >> 1].link[h & 1]) set(h, kIntersection);
}

// Counter-clockwise around a node the places of a list open and close in turn. Where one opens a contour arrives, where
// it closes the contour leaves: the turn to the right at every intersection (seed 2, Fig. 6).
void Tracer::link_contours(const Node& node) {
  HalfEdge open[3] = {}, first_close[3] = {};
  for (HalfEdge h = node.first; h != 0;) {
    const HalfEdge following = pools_.edges[h >> 1].link[h & 1];
    if (const std::uint8_t list = list_bounded_by(h); list != 0) {
      if (open[list] != 0) {
        set_next(partner(open[list]), h);
        open[list] = 0;
      } else {
        first_close[list] = h;
      }
    }
    if (const std::uint8_t list = list_bounded_by(partner(h)); list != 0) open[list] = h;
    h = following;
  }
  for (unsigned list = 1; list < 3; ++list) {
    if (open[list] != 0) set_next(partner(open[list]), first_close[list]);
  }
}

// Follows the border of one place and cuts off a contour wherever a node comes up again, so that contours touch one
// another, but none itself. Node::mark is the half-edge that arrived there, or kBottom where the walk began.
bool Tracer::walk(HalfEdge start) {
  Walk walk{static_cast<std::uint16_t>(contours_ + 1), 0, static_cast<std::uint8_t>(list_bounded_by(start) - 1)};
  const HalfEdge last_next = start;
  HalfEdge arrived = 0, h = start;
  do {
    set(h, kTraced);
    std::uint16_t& mark = pools_.nodes[node_of(h)].mark;
    if (mark == 0) {
      mark = arrived == 0 ? kBottom : arrived;
    } else {
      const HalfEdge before = mark;
      const HalfEdge loop = before == kBottom ? start : next(before);
      set_next(arrived, loop);
      if (before == kBottom) {
        start = h;
      } else {
        set_next(before, h);
      }
      if (!add_contour(loop, walk)) return false;
      pools_.nodes[node_of(h)].mark = before;
    }
    arrived = h;
    h = next(h);
  } while (h != last_next);
  set_next(arrived, start);
  if (!add_contour(start, walk)) return false;
  close_walk(walk);
  return true;
}

// Takes the marks off a closed contour, and finds its least vertex and its direction.
bool Tracer::add_contour(HalfEdge start, Walk& walk) {
  if (contours_ == pools_.contours.capacity()) return false;
  const GridPoint pivot = origin(start);
  HalfEdge least = start, h = start;
  std::int64_t area = 0;  // twice; at most 2 · 65534²
  do {
    pools_.nodes[node_of(h)].mark = 0;
    if (origin(h) < origin(least)) least = h;
    area += orientation(pivot, origin(h), origin(next(h)));
    h = next(h);
  } while (h != start);
  CHECK(area != 0);
  pools_.contours[++contours_] = {least, 0, 0, walk.list, area > 0};
  if (area < 0) {
    CHECK(walk.main == 0);
    walk.main = contours_;
  }
  return true;
}

// Contours of one walk border one place: its holes belong to its main contour. A walk of holes only names the leftmost
// of them (itself, if it is that) and attach_holes() sees to it.
void Tracer::close_walk(const Walk& walk) {
  std::uint16_t leader = walk.main;
  if (leader == 0) {
    leader = walk.first_contour;
    for (std::uint16_t i = leader; i <= contours_; ++i) {
      if (origin(pools_.contours[i].first) < origin(pools_.contours[leader].first)) leader = i;
    }
  }
  for (std::uint16_t i = walk.first_contour; i <= contours_; ++i) {
    if (pools_.contours[i].hole) pools_.contours[i].relation = leader;
  }
}

// The contour that passes next below the least vertex of a hole, just left of it; both border the same place.
std::uint16_t Tracer::contour_below(std::uint16_t hole) const {
  const GridPoint at = origin(pools_.contours[hole].first);
  HalfEdge best = 0;
  GridPoint best_from, best_to;
  for (std::uint16_t i = 1; i <= edges_; ++i) {
    const auto upper = static_cast<HalfEdge>(2 * i + 1);  // runs to the left, so its right is above
    const GridPoint a = origin(partner(upper)), b = origin(upper);
    if (!(a.x < at.x && at.x <= b.x) || orientation(a, b, at) <= 0) continue;
    if (list_bounded_by(upper) != pools_.contours[hole].list + 1) continue;
    if (best != 0) {
      // Edges do not cross, so either's end shows which is higher.
      const std::int64_t side = best_from.x <= a.x ? orientation(best_from, best_to, a) : -orientation(a, b, best_from);
      const std::int64_t other = best_to.x < b.x ? -orientation(a, b, best_to) : orientation(best_from, best_to, b);
      if (side < 0 || (side == 0 && other <= 0)) continue;
    }
    best = upper;
    best_from = a;
    best_to = b;
  }
  CHECK(best != 0);
  return contour_through(best);
}

std::uint16_t Tracer::contour_through(HalfEdge h) const {
  HalfEdge least = h;
  for (HalfEdge i = next(h); i != h; i = next(i)) {
    if (origin(i) < origin(least)) least = i;
  }
  for (std::uint16_t i = 1; i <= contours_; ++i) {
    if (pools_.contours[i].first == least) return i;
  }
  CHECK(false);
  return 0;
}

void Tracer::attach_holes() {
  for (std::uint16_t i = 1; i <= contours_; ++i) {
    if (pools_.contours[i].hole && pools_.contours[i].relation == i) pools_.contours[i].relation = contour_below(i);
  }
  // Each step leads to a contour that reaches farther left, until it is a main contour.
  for (std::uint16_t i = 1; i <= contours_; ++i) {
    Contour& contour = pools_.contours[i];
    while (contour.hole && pools_.contours[contour.relation].hole) {
      contour.relation = pools_.contours[contour.relation].relation;
    }
  }
}

void Tracer::chain_lists() {
  for (std::uint16_t i = contours_; i != 0; --i) {
    Contour& contour = pools_.contours[i];
    std::uint16_t& head = contour.hole ? pools_.contours[contour.relation].relation : first_[contour.list];
    contour.next = head;
    head = i;
  }
}

}  // namespace spanline::area
