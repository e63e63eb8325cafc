// Polygons put in, and what is done to them before they are sorted.
#include "core/area/area_sort.hpp"
#include "core/area/cut.hpp"
#include "core/area/sort.hpp"

namespace spanline::area {

AreaSort::AreaSort(const SortPools& pools, Panes panes)
    : pools_(pools),
      clipper_(pools.clipper),
      borders_(pools.borders),
      pieces_(pools.pieces),
      films_(pools.films),
      panes_(panes) {
  pools_.polygons.limit(UINT16_MAX - 1);
}

void AreaSort::clear(const Box& window, const Slab& slab) {
  borders_.clear();
  pieces_.clear();
  films_.clear();
  polygons_ = depth_ = 0;
  visible_ = {};
  window_ = window;
  slab_ = slab;
  status_ = {};
  counts_ = {};
  translucent_ = false;
  group_ = groups_ = host_ = 0;
}

void AreaSort::refuse(const char* field, std::int32_t value, std::int32_t limit) {
  if (!status_.ok()) return;
  status_ = {Code::bad_argument,
             "polygon",
             field,
             source_,
             0,
             static_cast<std::uint32_t>(value),
             static_cast<std::uint32_t>(limit)};
}

bool AreaSort::exhausted(const char* pool, std::uint16_t capacity, std::uint16_t source) {
  for (std::uint16_t i = polygons_; source == kBackdrop && i != 0; --i) source = pools_.polygons[i].source;
  if (status_.ok()) status_ = {Code::pool_exhausted, pool, "polygon", source, 0, capacity + 1u, capacity};
  return false;
}

bool AreaSort::borders_fit(std::uint16_t source) {
  return !borders_.full() || exhausted("borders", borders_.capacity(), source);
}

void AreaSort::begin_polygon(std::uint16_t source, Opacity opacity) {
  CHECK(source != kBackdrop);
  source_ = source;
  opacity_ = opacity;
  border_ = {};
  widest_.clear();
  plane_given_ = detail_ = false;
}

void AreaSort::begin_detail(std::uint16_t source) {
  CHECK(group_ == 0);
  begin_polygon(source, pools_.polygons[host_].plane);
  detail_ = true;
}

void AreaSort::begin_polygon(std::uint16_t source, const Plane& plane, Opacity opacity) {
  begin_polygon(source, opacity);
  given_plane_ = plane;
  plane_given_ = true;
}

void AreaSort::vertex(std::int32_t x, std::int32_t y, std::int32_t depth) {
  if (!within(x, -kMaxCoordinate, kMaxCoordinate)) return refuse("x", x, kMaxCoordinate);
  if (!within(y, -kMaxCoordinate, kMaxCoordinate)) return refuse("y", y, kMaxCoordinate);
  if (!within(depth, 0, kMaxDepth)) return refuse("depth", depth, kMaxDepth);
  const GridPoint at{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
  if (const unsigned place = widest_.take(at); place != WidestTriangle::kNone) widest_depth_[place] = depth;
  if (corners_++ == 0) {
    start_ = at;
  } else if (!(at == last_)) {
    borders_.append(border_, last_, at);
  }
  last_ = at;
}

void AreaSort::end_contour() {
  if (corners_ > 1 && !(last_ == start_)) borders_.append(border_, last_, start_);
}

void AreaSort::end_polygon() {
  if (!detail_) host_ = 0;
  if (widest_.flat()) ++counts_.dropped;
  if (widest_.flat() || !status_.ok() || (detail_ && host_ == 0)) return borders_.release(border_);
  const Plane plane = plane_given_ ? given_plane_ : Plane::through(widest_.corners(), widest_depth_);
  cut_to(borders_, border_, window_);
  const bool within = group_ == kBackdropGroup || cut_to_slab(plane);
  if (!borders_fit(source_)) return;
  if (!within || border_.first == 0) return borders_.release(border_);
  translucent_ |= opacity_ == Opacity::translucent;
  const std::uint16_t name = add_polygon(source_, plane, opacity_, border_);
  if (name == 0) return;
  if (detail_) {
    NamedPolygon& host = pools_.polygons[host_];
    if (host.group == 0) host.group = ++groups_;
    pools_.polygons[name].group = host.group;
    pools_.polygons[name].detail = true;
    return;
  }
  host_ = name;
  if (group_ == 0) return;
  CHECK(opacity_ == Opacity::opaque);
  pools_.polygons[name].group = group_;
  pools_.polygons[name].detail = true;
  if (group_ != kBackdropGroup) borders_.join(silhouette_, borders_.copy(border_));
}

bool AreaSort::cut_to_slab(const Plane& plane) {
  return (slab_.low <= 0 || cut_at(plane, slab_.low, true)) &&
         (slab_.high > kMaxDepth || cut_at(plane, slab_.high, false));
}

// Neighbouring slabs cut a polygon at the same points. One that only touches their border, or lies along it, belongs to
// the nearer one. False where nothing is left.
bool AreaSort::cut_at(const Plane& plane, std::int32_t depth, bool keep_nearer) {
  const Line line = crossing_line(plane, Plane::level(depth));
  if (straddles(borders_, border_, line)) {
    Halves halves = cut(borders_, border_, line);
    border_ = keep_nearer ? halves.positive : halves.negative;
    borders_.release(keep_nearer ? halves.negative : halves.positive);
    return true;
  }
  bool farther = false;
  borders_.each_end(border_, [&](GridPoint p) { farther |= line.side(p) < 0; });
  return farther != keep_nearer;
}

void AreaSort::begin_group() {
  group_ = ++groups_;
  silhouette_ = {};
}

void AreaSort::begin_backdrop() { group_ = kBackdropGroup; }

// The window is the silhouette of its details.
void AreaSort::end_backdrop() {
  group_ = 0;
  if (!status_.ok()) return;
  const std::uint16_t name = add_backdrop();
  if (name == 0) return;
  pools_.polygons[name].group = kBackdropGroup;
  pools_.polygons[name].silhouette = true;
}

// The silhouette has no plane: its depth is its members'.
void AreaSort::end_group() {
  const std::uint16_t source = polygons_ != 0 ? pools_.polygons[polygons_].source : kBackdrop;
  if (silhouette_.first != 0 && borders_fit(source) && status_.ok()) {
    const std::uint16_t name = add_polygon(source, {}, Opacity::opaque, silhouette_);
    pools_.polygons[name].group = group_;
    pools_.polygons[name].silhouette = true;
  }
  group_ = 0;
}

std::uint16_t AreaSort::add_polygon(std::uint16_t source, const Plane& plane, Opacity opacity, const Border& border) {
  if (polygons_ == pools_.polygons.capacity()) {
    exhausted("polygons", polygons_, source);
    return 0;
  }
  pools_.polygons[++polygons_] = {plane, 0, border, borders_.bounds(border), source, opacity, false, 0, false,
                                  false, 0, 0};
  counts_.polygons = polygons_;
  return polygons_;
}

// Far behind everything, and never a clip polygon.
std::uint16_t AreaSort::add_backdrop() {
  const GridPoint a = window_.low, c = window_.high;
  const GridPoint b{c.x, a.y}, d{a.x, c.y};
  const GridPoint corners[] = {a, d, c, b};
  Border border;
  for (unsigned i = 0; i < 4; ++i) borders_.append(border, corners[i], corners[(i + 1) % 4]);
  if (!borders_fit(kBackdrop)) return 0;
  const std::uint16_t name = add_polygon(kBackdrop, Plane{0, 0, -(std::int64_t{1} << 58)}, Opacity::opaque, border);
  if (name != 0) pools_.polygons[name].on_stack = true;
  return name;
}

void AreaSort::sort_by_source() {
  sort_blocks(pools_.polygons, polygons_,
              [](const NamedPolygon& a, const NamedPolygon& b) { return a.source < b.source; });
}

// Leads all borders through the points where they cross.
bool AreaSort::settle() {
  Arrangement arrangement(clipper_.pools());
  for (std::uint16_t name = 1; name <= polygons_; ++name) {
    const NamedPolygon& polygon = pools_.polygons[name];
    bool fits = true;
    borders_.each(polygon.border, [&](const BorderEdge& edge) {
      const bool forth = edge.from < edge.to;
      fits = fits && arrangement.add_segment(forth ? edge.from : edge.to, forth ? edge.to : edge.from, Role::subject);
    });
    if (!fits) return exhausted("segments", arrangement.full().capacity, polygon.source);
  }
  arrangement.merge_segments();
  if (!arrangement.intersect()) {
    const Arrangement::Full& full = arrangement.full();
    return exhausted(full.pool, full.capacity, owner_of(full.segment));
  }
  for (std::uint16_t name = 1; name <= polygons_; ++name) {
    NamedPolygon& polygon = pools_.polygons[name];
    Border led;
    borders_.each(polygon.border, [&](const BorderEdge& edge) {
      GridPoint from = edge.from;
      arrangement.lead(edge.from, edge.to, [&](GridPoint through) {
        borders_.append(led, from, through);
        from = through;
        return true;
      });
      borders_.append(led, from, edge.to);
    });
    borders_.release(polygon.border);
    polygon.border = led;
    if (!borders_fit(polygon.source)) return false;
  }
  return true;
}

// The source of the first polygon that the segment borders.
std::uint16_t AreaSort::owner_of(const Segment& segment) const {
  for (std::uint16_t name = 1; name <= polygons_; ++name) {
    bool found = false;
    borders_.each(pools_.polygons[name].border, [&](const BorderEdge& edge) {
      found |= edge.from == segment.low ? edge.to == segment.high : edge.from == segment.high && edge.to == segment.low;
    });
    if (found) return pools_.polygons[name].source;
  }
  return kBackdrop;
}

// Makes proper contours of a polygon's border, and its pieces, which are several where it has folded or touches itself.
bool AreaSort::resolve(std::uint16_t name) {
  NamedPolygon& polygon = pools_.polygons[name];
  clipper_.clear();
  borders_.each(polygon.border, [&](const BorderEdge& edge) { clipper_.edge(Role::subject, edge.from, edge.to); });
  if (const Status status = clipper_.unite(); !status.ok()) {
    return exhausted(status.where, static_cast<std::uint16_t>(status.limit), polygon.source);
  }
  CHECK(clipper_.counts().rounded == 0);
  borders_.release(polygon.border);
  PieceList pieces;
  if (!take_pieces(List::inside, {{}, {}, name, 0, 0}, pieces)) return false;
  for (std::uint16_t i = pieces.first; i != 0; i = pieces_[i].next) {
    borders_.join(polygon.border, borders_.copy(pieces_[i].border));
  }
  if (!borders_fit(polygon.source)) return false;
  SortFrame& base = pools_.frames[1];
  for (std::uint16_t i = pieces.first; i != 0;) {
    const std::uint16_t next = pieces_[i].next;
    append(base.inside, i);
    i = next;
  }
  polygon.bounds = borders_.bounds(polygon.border);
  return true;
}

// Detail follows what is sorted, group by group, the topmost first.
void AreaSort::order_by_depth() {
  for (std::uint16_t name = 1; name <= polygons_; ++name) {
    NamedPolygon& polygon = pools_.polygons[name];
    polygon.nearest = INT64_MIN;
    if (polygon.silhouette) continue;
    borders_.each_end(polygon.border, [&](GridPoint p) {
      const std::int64_t value = polygon.plane.value(p);
      if (value > polygon.nearest) polygon.nearest = value;
    });
  }
  sort_blocks(pools_.polygons, polygons_, [](const NamedPolygon& a, const NamedPolygon& b) {
    if (a.detail != b.detail) return b.detail;
    if (a.detail) return a.group != b.group ? a.group < b.group : a.source > b.source;
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.source < b.source;
  });
}

// Both halves of a polygon that is pierced have the same detail.
void AreaSort::find_details() {
  std::uint16_t first = 1;
  while (first <= polygons_ && !pools_.polygons[first].detail) ++first;
  for (std::uint16_t name = 1; name < first; ++name) {
    NamedPolygon& host = pools_.polygons[name];
    if (host.group == 0) continue;
    std::uint16_t i = first;
    while (i <= polygons_ && pools_.polygons[i].group != host.group) ++i;
    host.first_detail = i;
    for (; i <= polygons_ && pools_.polygons[i].group == host.group; ++i) {
      ++host.details;
      const std::int64_t nearest = pools_.polygons[i].nearest;
      if (host.silhouette && host.source != kBackdrop && nearest > host.nearest) host.nearest = nearest;
    }
  }
  // Silhouettes have found their place only now.
  sort_blocks(pools_.polygons, static_cast<std::uint16_t>(first - 1), [](const NamedPolygon& a, const NamedPolygon& b) {
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.source < b.source;
  });
}

bool AreaSort::make_pieces() {
  order_by_depth();
  find_details();
  for (std::uint16_t name = 1; name <= polygons_ && !pools_.polygons[name].detail; ++name) {
    if (!resolve(name)) return false;
  }
  return true;
}

}  // namespace spanline::area
