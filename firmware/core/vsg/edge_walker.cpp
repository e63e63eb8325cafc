#include "core/vsg/edge_walker.hpp"

namespace spanline {

void EdgeWalker::begin(const SceneRecord& scene, std::int32_t top) {
  cursor_ = InstanceCursor(scene);
  mesh_ = {};
  buckets_.clear(top, screen_.height);
  begin();
}

void EdgeWalker::begin() {
  planes_.clear();
  CHECK(capacity_ >= kSentinels);
  most_ = kSentinels;
  overlap_.clear_overflow();
  walk_.end_alive(walk_.now);
}

// What the vertices of one instance start their edges from.
template <typename Word>
struct EdgeWalker::Fans {
  const std::uint16_t* starts;
  const FanEdge* edges;
  const ScreenXY* points;
  const Word* words;  // of the instance's faces
  std::uint32_t not_drawn;
  std::uint32_t first_id;   // of the faces
  std::uint32_t first = 0;  // vertex, as VertexBuckets names it
  std::uint32_t count = 0;  // of vertices
  const ActiveEdge* last;   // room for edges, and the sentinel
};

// Goes to the instance of a vertex, as VertexBuckets names it.
void EdgeWalker::enter(std::uint32_t vertex) {
  cursor_.to_vertex(vertex - 1);
  const MeshRecord& mesh = cursor_.mesh();
  const std::uint32_t first = cursor_.first_vertex() + 1;
  mesh_ = {mesh.fan_starts.data(), mesh.fans.data(), &points_[first], cursor_.first_face() + 1, first,
           mesh.positions.size()};
}

template <typename Word>
inline EdgeWalker::Fans<Word> EdgeWalker::fans_of_mesh(const DrawnFaces<Word>& drawn) const {
  const MeshFans& m = mesh_;
  return {m.starts,   m.edges, m.points, drawn.words + m.first_id, drawn.not_drawn,
          m.first_id, m.first, m.count,  walk_.now + capacity_};
}

void EdgeWalker::end_start(const Started& started) {
  const auto needed = static_cast<std::uint32_t>(started.out - walk_.now);
  if (needed > most_) most_ = needed;
  started.first[-1].x = started.out->x = ActiveEdge::kNever;
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
  const std::ptrdiff_t at_zero = left_of_screen(walk_.now) + left_of_screen(walk_.alive_end + 1);
  std::ptrdiff_t gap = begun + kShortColumn;
  if (at_zero > gap) gap = at_zero;
  if (has_long_column()) [[unlikely]]
    gap = alive + begun;
  const auto needed = static_cast<std::uint32_t>(gap + (end - walk_.now));
  if (needed > most_) most_ = needed;
  if (needed > capacity_) return false;
  if (walk_.now - pool_ < gap) move_edges(pool_ + capacity_ - (end - walk_.now), end + 1);
  walk_.begin = walk_.now - gap;
  return true;
}

// Edges that lie in one column, up to where the walk has come.
struct EdgeWalker::Column {
  const ActiveEdge *first, *end;  // of those alive
  const ActiveEdge *begun, *begun_end;

  // The first edge of which holds(edge).
  template <typename Holds>
  const ActiveEdge* find(const Holds& holds) const {
    for (const ActiveEdge* e = first; e != end; ++e) {
      if (holds(*e)) return e;
    }
    for (const ActiveEdge* e = begun; e != begun_end; ++e) {
      if (holds(*e)) return e;
    }
    return nullptr;
  }
  template <typename Take>
  void each(const Take& take) const {
    find([&take](const ActiveEdge& e) {
      take(e);
      return false;
    });
  }
  // A face that begins here and does not end here; 0: none.
  [[gnu::noinline]] FaceId begins() const {
    const ActiveEdge* const edge = find([this](const ActiveEdge& e) {
      const FaceId face = e.beginning();
      return face != 0 && find([face](const ActiveEdge& other) { return other.ending() == face; }) == nullptr;
    });
    return edge != nullptr ? edge->beginning() : FaceId{0};
  }
};

// Brings the set of faces up to date with the edges in the column that the walk has come to. Of two faces mostly one
// begins there, and the key knows the other.
void EdgeWalker::gather_overlap() {
  const CoverKey key = walk_.key;
  const bool two = key >> kCoverCount == 2;
  const auto pair = [this, key](FaceId face) { overlap_.set(face, static_cast<FaceId>(key - face)); };
  if (two) [[likely]] {
    if (const FaceId face = begun_alone(); face != 0) return pair(face);
  }
  const Column here = column();
  if (two) {
    if (const FaceId face = here.begins(); face != 0) return pair(face);
  }
  // The order of edges in one column is not that of their faces: only between columns is the key what it says.
  CoverKey before = key;
  here.each([&before](const ActiveEdge& e) { before -= e.toggle; });
  if (before < kTwoFaces) overlap_.set(only_face(before));
  here.each([this](const ActiveEdge& e) { overlap_.toggle(e); });
}

// The face that begins in the column that the walk has come to, where a single edge lies in it; 0: it is not so simple.
inline FaceId EdgeWalker::begun_alone() const {
  const std::int32_t left = walk_.left;
  const auto at_left = [this, left](const ActiveEdge* end) {  // before those that begin is a sentinel
    return end != walk_.now && end[-1].column() == left;
  };
  const bool of_other = at_left(walk_.other);
  const ActiveEdge* const end = of_other ? walk_.other : walk_.edge;
  if (left == 0 || at_left(of_other ? walk_.edge : end - 1)) return 0;  // what lies left of the screen is at 0, too
  return of_other && at_left(end - 1) ? FaceId{0} : end[-1].beginning();
}

// The edges in the column that the walk has come to.
inline EdgeWalker::Column EdgeWalker::column() const {
  const std::int32_t from = walk_.left == 0 ? INT32_MIN : walk_.left;
  const ActiveEdge *const alive = walk_.alive(), *const begun = walk_.begun();
  Column column{alive, alive, begun, begun};
  while (column.first != walk_.now && column.first[-1].column() >= from) --column.first;
  while (column.begun != walk_.alive_end + 1 && column.begun[-1].column() >= from) --column.begun;
  return column;
}

// Of an edge that runs down in a mesh, what it toggles and the face that ends, 0 if none.
template <typename Word>
struct EdgeWalker::Faces {
  CoverKey toggle = 0;
  std::uint32_t ending = 0;
  bool drawn;

  // The counter-clockwise face lies on the right, `twin` on the left.
  Faces(std::uint32_t face, std::uint32_t twin, const Fans<Word>& fans) {
    const bool begins = face != FanEdge::kNone && fans.words[face] != fans.not_drawn;
    const bool ends = twin != FanEdge::kNone && fans.words[twin] != fans.not_drawn;
    constexpr CoverKey kOne = CoverKey{1} << kCoverCount;
    drawn = begins || ends;
    if (ends) {
      ending = fans.first_id + twin;
      toggle = begins ? face - twin : 0 - kOne - ending;
    } else {
      toggle = kOne + fans.first_id + face;
    }
  }
};

template <typename Word>
bool EdgeWalker::start_edges(std::int32_t line, const DrawnFaces<Word>& drawn) {
  Started started{walk_.alive_end + 1};
  Fans<Word> fans = fans_of_mesh(drawn);
  for (std::uint16_t vertex = buckets_.sorted(line); vertex != VertexBuckets::kEnd; vertex = buckets_.next(vertex)) {
    if (vertex - fans.first >= fans.count) [[unlikely]] {
      enter(vertex);
      fans = fans_of_mesh(drawn);
    }
    const FromVertex from(PackedXY(points_[vertex]), line);
    const std::uint16_t* const start = fans.starts + (vertex - fans.first);
    const std::uint32_t count = std::uint32_t{start[1]} - start[0];
    const FanEdge* edge = fans.edges + start[0];
    if (static_cast<std::ptrdiff_t>(count) > fans.last - started.out &&
        !has_room(fans, edge, count, line, fans.last - started.out)) {
      return false;
    }
    const FanEdge* const end = edge + count;
    for (std::uint32_t twin = end[-1].face; edge != end; twin = edge->face, ++edge) {
      const PackedXY bottom(fans.points[edge->to]);
      if (from.has_ended(bottom)) continue;
      const Faces<Word> faces(edge->face, twin, fans);
      if (!faces.drawn) continue;
      started.out->toggle = faces.toggle;
      from.run(*started.out, bottom, faces.ending);
      started.put_out();
    }
  }
  end_start(started);
  return true;
}

// Whether there is room for those of a fan's edges that begin.
template <typename Word>
bool EdgeWalker::has_room(const Fans<Word>& fans, const FanEdge* fan, std::uint32_t count, std::int32_t line,
                          std::ptrdiff_t room) {
  const FromVertex from(PackedXY(0), line);
  const FanEdge* const end = fan + count;
  for (std::uint32_t twin = end[-1].face; fan != end; twin = fan->face, ++fan) {
    if (!from.has_ended(PackedXY(fans.points[fan->to])) && Faces<Word>(fan->face, twin, fans).drawn) --room;
  }
  return room >= 0;
}

template bool EdgeWalker::start_edges(std::int32_t, const DrawnFaces<std::uint16_t>&);
template bool EdgeWalker::start_edges(std::int32_t, const DrawnFaces<std::uint8_t>&);

// Begins a tall edge again on `line`, by point(i), the corners of the face that it begins or ends, of which it is the
// left or right edge.
template <typename Point>
static bool run_tall(ActiveEdge& edge, std::int32_t line, const Point& point) {
  const bool left = edge.ending() == 0;
  for (unsigned i = 0; i < 3; ++i) {
    ScreenXY top = point(i), bottom = point((i + 1) % 3);
    if (top.y > bottom.y) std::swap(top, bottom);
    // One that begins on this very line comes from its own vertex.
    if (first_centre(top.y) >= line || first_centre(bottom.y) <= line) continue;
    const ScreenXY third = point((i + 2) % 3);
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

bool EdgeWalker::run_tall_again(ActiveEdge& edge, std::int32_t line, const ScreenXY (&corner)[3]) {
  return run_tall(edge, line, [&corner](unsigned i) { return corner[i]; });
}

// Begins a tall edge again on `line`; false where it has ended, and for every other edge.
bool EdgeWalker::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  const std::uint32_t face = face_of_tall(edge) - 1u;
  cursor_.to_face(face);
  const std::uint16_t* const corner = cursor_.mesh().corners.data() + 3 * (face - cursor_.first_face());
  return run_tall(edge, line, [&](unsigned i) { return points_[cursor_.first_vertex() + corner[i] + 1]; });
}

}  // namespace spanline
