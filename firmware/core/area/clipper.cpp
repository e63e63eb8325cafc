#include "core/area/clipper.hpp"

namespace spanline::area {
namespace {

constexpr std::uint16_t kMaxBlocks = UINT16_MAX - 1;  // one past the last block is still an index

const char* text_of(Role role) { return role == Role::subject ? "subject" : "clip"; }

Pools within_reach(Pools pools) {
  pools.segments.limit(kMaxBlocks);
  pools.nodes.limit(kMaxBlocks);
  pools.edges.limit(kMaxEdges);
  pools.contours.limit(kMaxBlocks);
  return pools;
}

}  // namespace

Clipper::Clipper(Pools pools) : pools_(within_reach(pools)), arrangement_(pools_), tracer_(pools_) {}

void Clipper::clear(std::uint32_t subject_name, std::uint32_t clip_name) {
  arrangement_.clear();
  status_ = {};
  counts_ = {};
  names_[0] = subject_name;
  names_[1] = clip_name;
  solved_ = false;
}

void Clipper::refuse(const char* axis, std::int32_t value) {
  if (!status_.ok()) return;
  status_ = {Code::bad_argument,
             text_of(role_),
             axis,
             names_[static_cast<unsigned>(role_)],
             0,
             static_cast<std::uint32_t>(value),
             static_cast<std::uint32_t>(kMaxCoordinate)};
}

void Clipper::exhausted(const char* pool, Role role, std::uint16_t capacity) {
  if (!status_.ok()) return;
  status_ = {Code::pool_exhausted, pool,    text_of(role), names_[static_cast<unsigned>(role)], 0,
             capacity + 1u,        capacity};
}

void Clipper::begin_contour(Role role) {
  role_ = role;
  points_ = 0;
  has_area_ = false;
  before_contour_ = arrangement_.segments();
}

void Clipper::vertex(std::int32_t x, std::int32_t y) {
  if (!within(x, -kMaxCoordinate, kMaxCoordinate)) return refuse("x", x);
  if (!within(y, -kMaxCoordinate, kMaxCoordinate)) return refuse("y", y);
  const GridPoint at{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
  if (points_ == 0) {
    start_ = last_ = at;
    points_ = 1;
    return;
  }
  if (at == last_) {
    ++counts_.merged_points;
    return;
  }
  if (points_ == 1) {
    apart_ = at;
  } else if (orientation(start_, apart_, at) != 0) {
    has_area_ = true;
  }
  ++points_;
  add_segment(last_, at);
  last_ = at;
}

void Clipper::end_contour() {
  if (points_ > 1) {
    if (last_ == start_) {
      ++counts_.merged_points;
    } else {
      add_segment(last_, start_);
    }
  }
  if (has_area_) return;
  ++counts_.dropped_contours;
  arrangement_.drop_segments_from(before_contour_);
}

void Clipper::edge(Role role, GridPoint from, GridPoint to) {
  role_ = role;
  if (!(from == to)) add_segment(from, to);
}

void Clipper::add_segment(GridPoint from, GridPoint to) {
  const bool forth = from < to;
  if (status_.ok() && !arrangement_.add_segment(forth ? from : to, forth ? to : from, role_)) {
    exhausted(arrangement_.full().pool, role_, arrangement_.full().capacity);
  }
}

Status Clipper::solve(CoverSet inside, CoverSet outside) {
  CHECK(!solved_);
  if (!status_.ok()) return status_;
  if (!arrangement_.intersect() || !arrangement_.cut()) {
    const Arrangement::Full& full = arrangement_.full();
    exhausted(full.pool, full.segment.role, full.capacity);
    return status_;
  }
  arrangement_.spin();
  solved_ = tracer_.trace(arrangement_.nodes(), arrangement_.edges(), inside, outside);
  if (!solved_) exhausted("contours", Role::subject, pools_.contours.capacity());
  counts_.rounded = arrangement_.rounded();
  counts_.moved = arrangement_.moved();
  counts_.segments = arrangement_.segments();
  counts_.nodes = arrangement_.nodes();
  counts_.edges = arrangement_.edges();
  counts_.contours = tracer_.contours();
  return status_;
}

}  // namespace spanline::area
