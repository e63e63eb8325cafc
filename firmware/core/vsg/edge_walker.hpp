// The edge walker: seed 1's task for facets whose edges know both their faces. One pass a line over the edges, in order
// of X, yields the visible spans and the next line's edges. What a pixel shows is the segment walker's decision in
// every bit.
#pragma once

#include <utility>

#include "core/vsg/band_start.hpp"
#include "core/vsg/overlap.hpp"
#include "core/vsg/plane_cache.hpp"

namespace spanline {

struct EdgeStorage {
  PoolRef<ScreenXY> points;        // a vertex each
  PoolRef<std::uint16_t> links;    // likewise
  PoolRef<std::uint16_t> buckets;  // a line each
  PoolRef<ActiveEdge> edges[2];    // this line's edges and those that begin on it; the next line's: one at least,
                                   // kMostEdges are used. In place: all in one, and no pool for the next line
  PoolRef<CachedPlane> planes;     // any number
  PoolRef<DepthReach> reaches;     // likewise
};

// Each face over a pixel has an edge on the line, and with more of them the sum that is a CoverKey would come round.
inline constexpr std::uint32_t kMostEdges = 3840;
static_assert(std::uint64_t{kMostEdges} * cover_of(0xffff) <= UINT32_MAX);

// Where they begin is known to others: MeshWalker, or who says start_by() or begin_start().
class EdgeWalker {
 public:
  EdgeWalker() = default;
  constexpr EdgeWalker(const EdgeStorage& storage, const Screen& screen)
      : pool_(storage.edges[0].sink()),
        capacity_(storage.edges[0].capacity() < kMostEdges ? storage.edges[0].capacity() : kMostEdges),
        screen_(screen),
        planes_(storage.planes, storage.reaches) {
    walk_.now = pool_;
    walk_.begin = storage.edges[1].sink();
    walk_.side = LineWalk::side_of(screen.width);
  }

  // Begins a frame: no edge is alive.
  void begin();
  // LineWalk::faces and LineWalk::painter of all lines.
  void paint_with(const void* faces, const void* painter) {
    walk_.faces = faces;
    walk_.painter = painter;
  }
  bool none_alive() const { return walk_.alive_end == walk_.now; }

  // The visible spans of the line. sink.start(LineWalk&) sets its pixels, begins it and
  // goes on as sink.run(LineWalk&, FaceId), which is walk_on() with a paint of its own; where it may stop at a look,
  // sink.learn(FaceId) sees to it that it does not again. sink.one(left, right, FaceId) takes the spans at the line's
  // right end, sink.rest(left), if there is one, those where nothing covers it; sink.front(left, right, FaceId, ramp)
  // those where others are behind. plane(FaceId) makes a face's depth plane. Steps the edges. False where more faces
  // cover a pixel than the overlap set holds: from there on spans of several faces are left out. again(ActiveEdge&,
  // line) begins a tall edge again; false where it has ended, and for every other edge. plane.nearest(const
  // OverlapSet&, PlaneCache&) is the face that is nearer than every other one wherever both are, or 0 where that takes
  // planes; plane.nearer(FaceId, FaceId, left, right, PlaneCache&) likewise of two, over these columns.
  template <typename Sink, typename Plane, typename Again>
  bool walk(std::int32_t line, const Sink& sink, const Plane& plane, const Again& again);

  // Starts the edges that begin on the line by start(first, last), which puts them to `first` in order, none of them to
  // `last`, and returns their end, or null where there is no room for one. first[-1].x is INT32_MIN.
  template <typename Start>
  bool start_by(const Start& start);
  // Or in place, by start_band_fans() between these two.
  void begin_start(BandStart& start);
  void end_start(const BandStart& start) { end_start(start.begin, start.out); }
  // Makes more room for them.
  void make_room(BandStart& start);
  // In place the next line's edges overwrite those that the walk has passed. Leaves room before those, so that none is
  // overwritten too soon; to be said between end_start() and walk(). False where there is too little.
  bool make_way();
  // Begins a tall edge again on `line`, by the corners of face_of_tall(edge) in the mesh's order; false where it has
  // ended.
  static bool run_tall_again(ActiveEdge& edge, std::int32_t line, const ScreenXY (&corner)[3]);
  static FaceId face_of_tall(const ActiveEdge& edge) {
    const FaceId ends = edge.ending();
    return ends == 0 ? edge.beginning() : ends;
  }
  // Forgets the planes made so far.
  void forget_planes() { planes_.clear_planes(); }

  std::uint32_t most_edges() const { return most_; }  // that a line of the frame needed room for, so far
  std::uint32_t edge_capacity() const { return capacity_; }
  const Screen& screen() const { return screen_; }

 protected:
  void end_start(ActiveEdge* first, ActiveEdge* out);

  LineWalk walk_{};
  ActiveEdge* pool_ = nullptr;
  std::uint32_t capacity_ = 0;  // of the line's edges and the next one's, and one more for the sentinel
  Screen screen_;

 private:
  static constexpr std::uint32_t kSentinels = 1;  // two, of which the pool's sink is one

  [[gnu::noinline]] void move_edges(ActiveEdge* to, ActiveEdge* end);
  bool has_long_column() const;

  template <typename Sink, typename Plane, typename Again>
  [[gnu::noinline]] WalkStop go_on(WalkStop stop, std::int32_t line, const Sink& sink, const Plane& plane,
                                   const Again& again);
  template <typename Sink, typename Plane, typename Again>
  [[gnu::cold, gnu::noinline]] void cut_off(std::int32_t line, const Sink& sink, const Plane& plane,
                                            const Again& again);
  FaceId begun_alone() const;
  [[gnu::cold]] void gather_overlap();
  template <typename Sink, typename Plane>
  FaceId front(std::int32_t line, std::int32_t right, const Sink& sink, const Plane& plane);
  template <typename Sink, typename Plane>
  [[gnu::noinline]] FaceId front_of_set(std::int32_t line, std::int32_t right, const Sink& sink, const Plane& plane);

  PlaneCache planes_;
  OverlapSet overlap_;
  std::uint32_t most_ = 0;
};
template <typename Start>
bool EdgeWalker::start_by(const Start& start) {
  ActiveEdge* const first = walk_.alive_end + 1;
  walk_.alive_end->x = INT32_MIN;
  ActiveEdge* const out = start(first, walk_.now + capacity_);
  if (out == nullptr) return false;
  end_start(first, out);
  return true;
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

// The face that is in front of the others all over the span of several faces that the walk has come to; 0: there is
// none, and the span has been shown.
template <typename Sink, typename Plane>
inline FaceId EdgeWalker::front(std::int32_t line, std::int32_t right, const Sink& sink, const Plane& plane) {
  const CoverKey key = walk_.key;
  FaceId a = key >> kCoverCount == 2 ? begun_alone() : FaceId{0}, b = static_cast<FaceId>(key - a);
  if (a != 0) [[likely]] {
    overlap_.set(a, b);
  } else {
    gather_overlap();
    if (overlap_.count() != 2) [[unlikely]]
      return front_of_set(line, right, sink, plane);
    a = overlap_[0];
    b = overlap_[1];
  }
  if (const FaceId face = plane.nearer(a, b, walk_.left, right, planes_); face != 0) [[likely]]
    return face;
  return front_of_set(line, right, sink, plane);
}

// The same where it takes planes, or there are more than two faces.
template <typename Sink, typename Plane>
FaceId EdgeWalker::front_of_set(std::int32_t line, std::int32_t right, const Sink& sink, const Plane& plane) {
  // A face that the set had no room for would be put in where it ends, and be painted from there on.
  if (overlap_.overflow()) [[unlikely]]
    return 0;
  const auto ramp_of = [&](FaceId face) {
    const DepthPlane& p = planes_.of(face, plane);
    return p.on_line(line);
  };
  if (overlap_.count() != 2) {
    if (const FaceId face = plane.nearest(overlap_, planes_); face != 0) [[likely]]
      return face;
  }
  return resolve_overlap(overlap_, walk_.left, right, ramp_of,
                         [&sink](std::int32_t begin, std::int32_t end, FaceId shown, const DepthRamp& ramp) {
                           sink.front(begin, end, shown, ramp);
                         });
}

template <typename Sink, typename Plane, typename Again>
bool EdgeWalker::walk(std::int32_t line, const Sink& sink, const Plane& plane, const Again& again) {
  LineWalk& walk = walk_;
  WalkStop stop = sink.start(walk);
  if (goes_on(stop)) stop = go_on(stop, line, sink, plane, again);
  if (stop == WalkStop::side) {
    bool through = false;
    if constexpr (requires { sink.rest(walk.left); }) {
      through = walk.is_through();
      if (through) [[likely]]
        sink.rest(walk.left);
    }
    if (!through) cut_off(line, sink, plane, again);
    walk.end_line();
  }
  return !overlap_.overflow();
}

// Goes on after a stop, up to the last one.
template <typename Sink, typename Plane, typename Again>
WalkStop EdgeWalker::go_on(WalkStop stop, std::int32_t line, const Sink& sink, const Plane& plane, const Again& again) {
  LineWalk& walk = walk_;
  FaceId shown = 0;
  do {
    if (stop == WalkStop::front) {
      const std::int32_t right = walk.edge->column();
      shown = front(line, right, sink, plane);
      if (shown == 0) [[unlikely]]
        walk.left = right;
    } else {
      if constexpr (requires { sink.learn(shown); }) {
        if (stop == WalkStop::look) {
          if (walk.key < kTwoFaces) shown = only_face(walk.key);
          sink.learn(shown);
          stop = sink.run(walk, shown);
          continue;
        }
      }
      shown = 0;
      if (again(*walk.out, line + 1)) walk.put_out();
    }
    stop = sink.run(walk, shown);
  } while (goes_on(stop));
  return stop;
}

// At the right end spans are cut off.
template <typename Sink, typename Plane, typename Again>
void EdgeWalker::cut_off(std::int32_t line, const Sink& sink, const Plane& plane, const Again& again) {
  LineWalk& walk = walk_;
  for (;;) {
    if (walk.other->x < walk.edge->x) std::swap(walk.edge, walk.other);
    const ActiveEdge* const next = walk.edge;
    std::int32_t column = next->column();
    static_assert(ActiveEdge::kNever >> ActiveEdge::kFraction > kMaxExtent, "the sentinel comes to this point");
    if (column > screen_.width) column = screen_.width;
    if (column > walk.left) {
      if (walk.key < kTwoFaces) {
        sink.one(walk.left, column, only_face(walk.key));
      } else {
        gather_overlap();
        const FaceId face = front_of_set(line, column, sink, plane);
        if (face != 0) sink.one(walk.left, column, face);
      }
      walk.left = column;
    }
    if (next->x == ActiveEdge::kNever) return;
    ++walk.edge;
    walk.key += next->toggle;
    *walk.out = *next;
    if (next->rest < ActiveEdge::kOneLine) {
      if (again(*walk.out, line + 1)) walk.put_out();
      continue;
    }
    walk.out->x += next->dx;
    walk.out->rest -= ActiveEdge::kOneLine;
    walk.put_out();
  }
}

}  // namespace spanline
