#include "core/vsg/edge_walker.hpp"

namespace spanline {

void EdgeWalker::begin() {
  planes_.clear();
  CHECK(capacity_ >= kSentinels);
  most_ = kSentinels;
  overlap_.clear_overflow();
  walk_.end_alive(walk_.now);
}

void EdgeWalker::begin_start(BandStart& start) {
  start.begin = start.out = walk_.alive_end + 1;
  start.last = reinterpret_cast<std::uintptr_t>(pool_ + capacity_);
  walk_.alive_end->x = INT32_MIN;
}

void EdgeWalker::end_start(ActiveEdge* first, ActiveEdge* out) {
  const auto needed = static_cast<std::uint32_t>(out - walk_.now);
  if (needed > most_) most_ = needed;
  first[-1].x = out->x = ActiveEdge::kNever;
}

void EdgeWalker::make_room(BandStart& start) {
  const std::ptrdiff_t down = walk_.now - pool_;
  move_edges(pool_, start.out);
  start.begin -= down;
  start.out -= down;
}

// Moves the line's edges, those alive and those that begin, up to `end`.
void EdgeWalker::move_edges(ActiveEdge* to, ActiveEdge* end) {
  const std::ptrdiff_t by = to - walk_.now;
  if (by < 0) {
    for (ActiveEdge* edge = walk_.now; edge != end; ++edge) edge[by] = *edge;
  } else {
    for (ActiveEdge* edge = end; edge != walk_.now;) {
      --edge;
      edge[by] = *edge;
    }
  }
  walk_.now = to;
  walk_.alive_end += by;
}

// Fewer of those alive lie in one column where has_long_column() says no.
static constexpr std::ptrdiff_t kColumnStep = 4, kShortColumn = 3 * kColumnStep;
static constexpr std::ptrdiff_t kTwoSentinels = 2;

bool EdgeWalker::has_long_column() const {
  for (const ActiveEdge* edge = walk_.now; walk_.alive_end - edge > 2 * kColumnStep; edge += kColumnStep) {
    if (edge->column() == edge[2 * kColumnStep].column()) return true;
  }
  return false;
}

// When the walk has taken i edges of those alive and j of those that begin it has put out i + j at most. So with as
// many places before those alive as begin, and some more, that many of those that it took last are still there: those
// of the column that it has come to, which gather_overlap() looks at again, and one more. At column 0 these are all so
// far.
bool EdgeWalker::make_way() {
  const auto left_of_screen = [](const ActiveEdge* edge) {
    const ActiveEdge* const first = edge;
    while (edge->column() <= 0) ++edge;
    return edge - first;
  };
  ActiveEdge* end = walk_.alive_end + 1;
  while (end->x != ActiveEdge::kNever) ++end;
  const std::ptrdiff_t alive = walk_.alive_end - walk_.now, begun = end - walk_.alive_end - 1;
  // Where there was room for as many twice on a line before, the next ones mostly need not overwrite any.
  if (2 * (alive + begun) + kTwoSentinels <= static_cast<std::ptrdiff_t>(most_)) {
    if (walk_.now - pool_ >= alive + begun) {
      walk_.begin = pool_;
      return true;
    }
    if (pool_ + capacity_ - end >= alive + begun + kTwoSentinels) {
      walk_.begin = end + 1;
      return true;
    }
  }
  const std::ptrdiff_t at_zero = left_of_screen(walk_.now) + left_of_screen(walk_.alive_end + 1);
  std::ptrdiff_t gap = begun + kShortColumn;
  if (at_zero > gap) gap = at_zero;
  if (gap > alive + begun || has_long_column()) gap = alive + begun;
  const auto needed = static_cast<std::uint32_t>(gap + (end - walk_.now));
  if (needed > most_) most_ = needed;
  if (needed > capacity_) return false;
  if (walk_.now - pool_ < gap) move_edges(pool_ + capacity_ - (end - walk_.now), end + 1);
  walk_.begin = walk_.now - gap;
  return true;
}

// Brings the set of faces up to date with the edges in the column that the walk has come to, which are several: the
// last that it has taken of those alive, and of those that begin.
void EdgeWalker::gather_overlap() {
  const std::int32_t from = walk_.left == 0 ? INT32_MIN : walk_.left;
  const ActiveEdge* const begin[2] = {walk_.now, walk_.alive_end + 1};
  const ActiveEdge* const end[2] = {walk_.alive(), walk_.begun()};
  const ActiveEdge* first[2];
  // The order of edges in one column is not that of their faces: only between columns is the key what it says.
  CoverKey before = walk_.key;
  for (int i = 0; i < 2; ++i) {
    const ActiveEdge* edge = end[i];
    for (; edge != begin[i] && edge[-1].column() >= from; --edge) before -= edge[-1].toggle;
    first[i] = edge;
  }
  if (before < kTwoFaces) overlap_.set(only_face(before));
  for (int i = 0; i < 2; ++i) {
    for (const ActiveEdge* edge = first[i]; edge != end[i]; ++edge) overlap_.toggle(*edge);
  }
}

bool EdgeWalker::run_tall_again(ActiveEdge& edge, std::int32_t line, const ScreenXY (&corner)[3]) {
  const bool left = edge.ending() == 0;  // of its face
  for (unsigned i = 0, j = 1, k = 2; i < 3; j = k, k = i++) {
    ScreenXY top = corner[i], bottom = corner[j];
    if (top.y > bottom.y) std::swap(top, bottom);
    // One that begins on this very line comes from its own vertex.
    if (first_centre(top.y) >= line || first_centre(bottom.y) <= line) continue;
    const ScreenXY third = corner[k];
    const std::int32_t side = (bottom.x - top.x) * (third.y - top.y) - (bottom.y - top.y) * (third.x - top.x);
    if ((side < 0) != left) continue;
    const EdgeRun run = start_run(top, bottom, line);
    edge.x = run.x;
    edge.dx = run.dx;
    edge.rest += static_cast<std::uint32_t>(run.lines - 1) * ActiveEdge::kOneLine;
    return true;
  }
  return false;
}

}  // namespace spanline
