#include "core/area/arrangement.hpp"

#include "core/area/sort.hpp"

namespace spanline::area {
namespace {

// Node::mark while segments are settled: an active pixel moves what meets it off its centre.
constexpr std::uint16_t kPassive = 0, kActive = 1;

// Counter-clockwise from straight down, which itself comes last.
bool comes_before(GridPoint around, GridPoint a, GridPoint b) {
  const bool a_late = a < around, b_late = b < around;
  return a_late != b_late ? b_late : orientation(around, a, b) > 0;
}

bool boxes_meet_in_y(const Segment& a, const Segment& b) {
  const auto least = [](const Segment& s) { return s.low.y < s.high.y ? s.low.y : s.high.y; };
  const auto most = [](const Segment& s) { return s.low.y < s.high.y ? s.high.y : s.low.y; };
  return least(a) <= most(b) && least(b) <= most(a);
}

}  // namespace

void Arrangement::clear() {
  segments_ = nodes_ = edges_ = rounded_ = 0;
  full_ = {};
}

bool Arrangement::fail(const char* pool, const Segment& of, std::uint16_t capacity) {
  full_ = {pool, of, capacity};
  return false;
}

bool Arrangement::add_segment(GridPoint low, GridPoint high, Role role) {
  CHECK(low < high);
  const Segment segment{low, high, role, Segment::State::exact};
  if (segments_ == pools_.segments.capacity()) return fail("segments", segment, segments_);
  pools_.segments[++segments_] = segment;
  return true;
}

bool Arrangement::add_node(GridPoint at, bool active, const Segment& of) {
  if (nodes_ == pools_.nodes.capacity()) {
    // Many intersections may share a grid point.
    merge_nodes();
    if (nodes_ == pools_.nodes.capacity()) return fail("nodes", of, nodes_);
  }
  pools_.nodes[++nodes_] = {at, 0, active ? kActive : kPassive};
  return true;
}

void Arrangement::merge_nodes() {
  sort_blocks(pools_.nodes, nodes_, [](const Node& a, const Node& b) { return a.at < b.at; });
  std::uint16_t kept = 0;
  for (std::uint16_t i = 1; i <= nodes_; ++i) {
    const Node& node = pools_.nodes[i];
    if (kept != 0 && pools_.nodes[kept].at == node.at) {
      pools_.nodes[kept].mark |= node.mark;
    } else {
      pools_.nodes[++kept] = node;
    }
  }
  nodes_ = kept;
}

bool Arrangement::cross(std::uint16_t one, std::uint16_t other) {
  Segment& a = pools_.segments[one];
  Segment& b = pools_.segments[other];
  const Crossing found = crossing(a.low, a.high, b.low, b.high);
  if (!found.found) return true;
  if (found.rounded) {
    a.state = b.state = Segment::State::moved;
    if (rounded_ < UINT16_MAX) ++rounded_;
  }
  return add_node(found.at, found.rounded, a);
}

void Arrangement::sort_segments() {
  sort_blocks(pools_.segments, segments_,
              [](const Segment& a, const Segment& b) { return a.low == b.low ? a.high < b.high : a.low < b.low; });
}

void Arrangement::merge_segments() {
  sort_segments();
  std::uint16_t kept = 0;
  for (std::uint16_t i = 1; i <= segments_; ++i) {
    const Segment& segment = pools_.segments[i];
    const Segment& before = pools_.segments[kept];
    if (kept != 0 && before.low == segment.low && before.high == segment.high) continue;
    pools_.segments[++kept] = segment;
  }
  segments_ = kept;
}

const Segment& Arrangement::find_segment(GridPoint low, GridPoint high) const {
  std::uint16_t least = 1, end = segments_;
  while (least < end) {
    const auto middle = static_cast<std::uint16_t>((least + end) / 2);
    const Segment& segment = pools_.segments[middle];
    const bool before = segment.low == low ? segment.high < high : segment.low < low;
    if (before) {
      least = static_cast<std::uint16_t>(middle + 1);
    } else {
      end = middle;
    }
  }
  CHECK(pools_.segments[least].low == low && pools_.segments[least].high == high);
  return pools_.segments[least];
}

bool Arrangement::intersect() {
  sort_segments();
  for (std::uint16_t i = 1; i <= segments_; ++i) {
    const Segment& segment = pools_.segments[i];
    if (!add_node(segment.low, false, segment) || !add_node(segment.high, false, segment)) return false;
  }
  merge_nodes();
  const std::uint16_t corners = nodes_;
  for (std::uint16_t i = 1; i < segments_; ++i) {
    const Segment& segment = pools_.segments[i];
    for (std::uint32_t j = i + 1u; j <= segments_ && pools_.segments[j].low.x <= segment.high.x; ++j) {
      if (boxes_meet_in_y(segment, pools_.segments[j]) && !cross(i, static_cast<std::uint16_t>(j))) return false;
    }
  }
  if (nodes_ != corners) merge_nodes();
  if (rounded_ != 0) settle();
  return true;
}

std::uint16_t Arrangement::first_node_from(std::int32_t x) const {
  std::uint16_t low = 1, high = static_cast<std::uint16_t>(nodes_ + 1);
  while (low < high) {
    const auto middle = static_cast<std::uint16_t>((low + high) / 2);
    if (pools_.nodes[middle].at.x < x) {
      low = static_cast<std::uint16_t>(middle + 1);
    } else {
      high = middle;
    }
  }
  return low;
}

bool Arrangement::meets(const Segment& s, const Node& node) const {
  if (!within(node.at.y, s.low.y, s.high.y)) return false;
  if (s.state == Segment::State::exact) return orientation(s.low, s.high, node.at) == 0;
  return passes_pixel(s.low, s.high, node.at);
}

// One segment's share in the rule above; true where more pixels have become active.
bool Arrangement::spread(Segment& s) {
  bool changed = false;
  const std::uint16_t first = first_node_from(s.low.x);
  if (s.state == Segment::State::exact) {
    for (std::uint16_t i = first; i <= nodes_ && pools_.nodes[i].at.x <= s.high.x; ++i) {
      const Node& node = pools_.nodes[i];
      if (node.mark == kActive && passes_pixel(s.low, s.high, node.at) && orientation(s.low, s.high, node.at) != 0) {
        s.state = Segment::State::moved;
        break;
      }
    }
  }
  if (s.state != Segment::State::moved) return false;
  for (std::uint16_t i = first; i <= nodes_ && pools_.nodes[i].at.x <= s.high.x; ++i) {
    Node& node = pools_.nodes[i];
    if (node.mark == kActive || !meets(s, node) || orientation(s.low, s.high, node.at) == 0) continue;
    node.mark = kActive;
    changed = true;
  }
  s.state = Segment::State::spread;
  return changed;
}

void Arrangement::settle() {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint16_t i = 1; i <= segments_; ++i) changed |= spread(pools_.segments[i]);
  }
}

std::uint16_t Arrangement::moved() const {
  std::uint16_t count = 0;
  for (std::uint16_t i = 1; i <= segments_; ++i) {
    if (pools_.segments[i].state != Segment::State::exact) ++count;
  }
  return count;
}

bool Arrangement::cut() {
  for (std::uint16_t i = 1; i <= segments_; ++i) {
    const Segment& segment = pools_.segments[i];
    std::uint16_t last = 0;
    const bool done = along(segment, false, [&](std::uint16_t node) {
      const std::uint16_t from = last;
      last = node;
      return from == 0 || add_edge(from, node, segment);
    });
    if (!done) return false;
  }
  return true;
}

// Where the edge exists already its borders are added modulo 2, which is the even-odd rule.
bool Arrangement::add_edge(std::uint16_t from, std::uint16_t to, const Segment& of) {
  if (from > to) std::swap(from, to);
  Node& least = pools_.nodes[from];
  for (std::uint16_t i = least.first; i != 0; i = pools_.edges[i].link[0]) {
    Edge& edge = pools_.edges[i];
    if (edge.end[1] != to) continue;
    edge.borders ^= cover_of(of.role);
    return true;
  }
  const std::uint16_t capacity = pools_.edges.capacity() < kMaxEdges ? pools_.edges.capacity() : kMaxEdges;
  if (edges_ == capacity) return fail("edges", of, capacity);
  pools_.edges[++edges_] = {{from, to}, {least.first, 0}, cover_of(of.role), 0};
  least.first = edges_;
  return true;
}

void Arrangement::insert_half_edge(HalfEdge h) {
  const auto far_end = [&](HalfEdge of) { return origin(pools_, partner(of)); };
  Node& node = pools_.nodes[pools_.edges[h >> 1].end[h & 1]];
  std::uint16_t* place = &node.first;
  while (*place != 0 && comes_before(node.at, far_end(*place), far_end(h))) {
    place = &pools_.edges[*place >> 1].link[*place & 1];
  }
  pools_.edges[h >> 1].link[h & 1] = *place;
  *place = h;
}

void Arrangement::spin() {
  std::uint16_t kept = 0;
  for (std::uint16_t i = 1; i <= edges_; ++i) {
    if (pools_.edges[i].borders != 0) pools_.edges[++kept] = pools_.edges[i];
  }
  edges_ = kept;
  sort_blocks(pools_.edges, edges_, [](const Edge& a, const Edge& b) {
    return a.end[0] != b.end[0] ? a.end[0] < b.end[0] : a.end[1] < b.end[1];
  });
  for (std::uint16_t i = 1; i <= nodes_; ++i) pools_.nodes[i].first = 0;
  for (std::uint16_t i = 1; i <= edges_; ++i) {
    insert_half_edge(static_cast<HalfEdge>(2 * i));
    insert_half_edge(static_cast<HalfEdge>(2 * i + 1));
  }
}

}  // namespace spanline::area
