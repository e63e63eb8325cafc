// The body of PatchLines; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/patch_lines.hpp"
#include "core/shade/grid_walk.hpp"

namespace spanline {

// As MeshLines::Sink: which paint it is, is asked where the walk stops.
template <bool kTaps, Paint kPaint>
struct PatchLines<kTaps, kPaint>::Sink {
  PatchLines& lines;
  Painter& painter;
  const SpanTap& tap;
  std::uint16_t line;

  WalkStop start(LineWalk& walk) const {
    walk.pixels = painter.out();
    if (!kTaps && lines.words()) {
      if (lines.looks_.on()) return smooth_grid_line<GridVertex>(walk);
      return grid_line<GridVertex>(walk);
    }
    walk.begin_line();
    return run(walk, 0);
  }
  WalkStop run(LineWalk& walk, FaceId shown) const {
    if (!kTaps && lines.words()) {
      if (lines.looks_.on()) return smooth_grid_walk<GridVertex>(walk, shown);
      return grid_walk<GridVertex>(walk, shown);
    }
    return walk_on(walk, shown, [this](std::int32_t left, std::int32_t right, FaceId face) {
      one(left, right, face);
      return true;
    });
  }
  void learn(FaceId face) const { lines.looks_.learn(face, lines.grids_, lines.reader_); }
  void one(std::int32_t left, std::int32_t right, FaceId face) const {
    report_one(left, right, face);
    paint(left, right, face);
  }
  void rest(std::int32_t left) const {
    if (left < lines.screen_.width) one(left, lines.screen_.width, 0);
  }
  void front(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    if constexpr (kTaps) report(left, right, face, ramp);
    paint(left, right, face);
  }

 private:
  // Not a pixel too far.
  [[gnu::noinline]] void paint(std::int32_t left, std::int32_t right, FaceId face) const {
    const auto begin = static_cast<std::uint32_t>(left), end = static_cast<std::uint32_t>(right);
    if (lines.looks_.on() && face != 0) {
      const FaceLook& look = lines.looks_.learn(face, lines.grids_, lines.reader_);
      return painter.smooth(begin, end, look.plane, lines.looks_.colors());
    }
    painter.fill(begin, end, face != 0 ? lines.grids_.color(face) : painter.background());
  }
  void report_one(std::int32_t left, std::int32_t right, FaceId face) const {
    if constexpr (kTaps) report(left, right, face, face != 0 ? lines.grids_.ramp(face, line) : DepthRamp{});
  }
  void report(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    tap.tell(line, left, right, face != 0 ? lines.grids_.scene_face(face) : kNoFace,
             lines.looks_.on() ? std::uint16_t{0} : lines.grids_.color(face), ramp);
  }
};

// The depths of faces along a line. Between their corners depth is that of the corners, but for rounding of less than a
// unit, so that most faces need no more.
template <bool kTaps, Paint kPaint>
struct PatchLines<kTaps, kPaint>::Planes {
  PatchLines& lines;
  std::uint16_t line;

  DepthPlane operator()(FaceId face) const {
    lines.planes_made_ = true;
    return {lines.grids_.ramp(face, line), 0};
  }
  static constexpr std::uint32_t kUnit = 1u << (kDepthBits - 16);
  FaceId nearer(FaceId a, FaceId b, PlaneCache&) const {
    const PatchGrids::DepthRange of_a = lines.grids_.depth_range(a), of_b = lines.grids_.depth_range(b);
    if (of_a.least > of_b.most + kUnit) return a;
    return of_b.least > of_a.most + kUnit ? b : FaceId{0};
  }
  FaceId nearest(const OverlapSet& set, PlaneCache&) const {
    FaceId face = 0;
    std::uint32_t least = 0, most = 0, others = 0;  // the face's own depths; the largest of the others
    for (unsigned i = 0; i < set.count(); ++i) {
      const PatchGrids::DepthRange range = lines.grids_.depth_range(set[i]);
      std::uint32_t passed = range.most;
      if (range.least >= least) {
        face = set[i];
        passed = std::exchange(most, range.most);
        least = range.least;
      }
      if (passed > others) others = passed;
    }
    return least > others + kUnit ? face : FaceId{0};
  }
};

template <bool kTaps, Paint kPaint>
PatchLines<kTaps, kPaint>::PatchLines(const FrameStorage& storage)
    : screen_(storage.screen),
      looks_(storage),
      buckets_(storage.mesh.walker.buckets),
      grids_(storage.patches.grid, storage.screen, storage.patches.tolerance),
      walker_(storage.mesh.walker, storage.screen) {}

template <bool kTaps, Paint kPaint>
Status PatchLines<kTaps, kPaint>::begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top) {
  if (ready_ && top != 0 && top == line_ && &scene.scene() == &scene_.scene() && camera == camera_) return {};
  ready_ = false;
  scene_ = scene;
  camera_ = camera;
  if (const Status status = check(); !status.ok()) return status;
  if (const Status status = looks_.begin_frame(scene_); !status.ok()) return status;
  reader_ = FacetReader(scene_, camera_, screen_, {});
  runs_ = height_ = 0;
  grids_.begin_frame();
  most_edges_ = 0;
  if (const Status status = plan(top); !status.ok()) return status;
  line_ = top;
  ready_ = true;
  return {};
}

// What cannot be drawn here.
template <bool kTaps, Paint kPaint>
Status PatchLines<kTaps, kPaint>::check() const {
  if (walker_.edge_capacity() == 0) return {Code::pool_exhausted, "edges", "", 0, 0, 1, 0};
  if (!scene_.scene().reaches.empty()) return {Code::bad_record, "SceneRecord", "reaches"};
  if (scene_.layered()) return {Code::bad_record, "SceneRecord", "surface detail or see-through materials"};
  for (InstanceCursor at(scene_.scene()); !at.at_end(); at.next()) {
    const std::uint16_t flags = at.instance().flags;
    if ((flags & InstanceRecord::kHidden) != 0) continue;
    if ((flags & (InstanceRecord::kTwoSided | InstanceRecord::kScreen)) != 0) {
      return {Code::bad_record, "InstanceRecord", "flags", at.index(), 0, flags};
    }
    if (!at.mesh().of_patches()) return {Code::bad_record, "MeshRecord", "corners (no patches)", at.instance().mesh};
  }
  return {};
}

// Dices the patches for the longest run of lines from `top` on whose grids fit. The run planned last, and twice that,
// is where the search begins; where the pool overflows the run is shortened, and what it does not need any more gives
// way.
template <bool kTaps, Paint kPaint>
Status PatchLines<kTaps, kPaint>::plan(std::uint16_t top) {
  const std::int32_t rest = screen_.height - top;
  const std::int32_t lines = height_ == 0 || 2 * height_ > rest ? rest : 2 * height_;
  grids_.begin(top, top + lines);
  top_ = top;
  walker_.begin();
  if (looks_.on()) looks_.begin(grids_);
  walker_.paint_with(&grids_[0], looks_.brush());
  if (const Status status = dice_all(); !status.ok()) return status;
  grids_.file(buckets_);
  height_ = static_cast<std::uint16_t>(grids_.bottom() - top);
  ++runs_;
  return {};
}

template <bool kTaps, Paint kPaint>
Status PatchLines<kTaps, kPaint>::dice_all() {
  LightRig rig;
  std::uint32_t lit = UINT32_MAX;
  for (std::uint16_t face = 0; face < scene_.face_count(); ++face) {
    reader_.select(face);
    if ((reader_.instance().flags & InstanceRecord::kHidden) != 0) {
      face = reader_.last_face();
      continue;
    }
    if (lit != reader_.instance_index()) {
      lit = reader_.instance_index();
      rig = LightRig(scene_.scene(), reader_.instance().transform);
    }
    if (const Status status = dice(face, rig); !status.ok()) return status;
  }
  return {};
}

template <bool kTaps, Paint kPaint>
Status PatchLines<kTaps, kPaint>::dice(std::uint16_t face, const LightRig& rig) {
  if (reader_.mirrored()) return {Code::bad_record, "InstanceRecord", "transform (mirrored)", reader_.instance_index()};
  const MaterialRecord& material = scene_.scene().materials[reader_.face().material];
  const PatchLook look{&rig, &material, screen_.format, looks_.on(), false};
  for (;;) {
    PatchJob job(reader_, look, {top_, grids_.bottom(), screen_.width});
    if (job.nothing) return {};
    if (!PatchGrids::takes(job)) {
      return {Code::bad_record, "InstanceRecord", "transform (beyond the view)", reader_.instance_index()};
    }
    PatchDicer dicer(job.patch, grids_.view(reader_.projection()));
    job.dicer = &dicer;
    const PatchTangents tangents(job.shape, job.normal_grid());
    job.tangents = &tangents;
    if (grids_.dice(job, face)) return {};
    const std::int32_t lines = grids_.bottom() - top_;
    if (lines == 1) {
      const std::uint32_t all = grids_.capacity();
      return {Code::pool_exhausted, "patch_grid", "", face, top_, all + 1, all};
    }
    grids_.shrink(top_ + lines * 3 / 4);
  }
}

// A cell of a grid, as its corners look at it.
struct GridCell {
  std::uint32_t vertex = 0, parts = CellParts::kNone;

  // The face that its upper, or its lower triangle belongs to; 0 where it is not drawn.
  FaceId upper() const { return static_cast<FaceId>((parts & CellParts::kUpper) != 0 ? 2 * vertex : 0); }
  FaceId lower() const {
    static_assert(CellParts::kApart == 4);
    return static_cast<FaceId>((parts & CellParts::kLower) != 0 ? 2 * vertex + (parts >> 2) : 0);
  }
  bool apart() const { return (parts & CellParts::kApart) != 0; }
};

// The edges that begin on the line: each from its upper end to its neighbours in the grid, and in cells cut in two.
template <bool kTaps, Paint kPaint>
template <typename Add>
void PatchLines<kTaps, kPaint>::feed(std::uint16_t line, const Add& add) {
  std::uint16_t first = buckets_[static_cast<std::uint32_t>(line - top_ + 1)];
  if (line != top_) first = grids_.sorted(first);
  for (std::uint32_t v = first; v != 0; v = grids_[v].next) {
    const GridVertex* const at = &grids_[v];
    const std::uint32_t stride = at->stride;
    const FromVertex from(PackedXY(at->at), line);
    // The cells around the vertex; beyond the grid's rim they have no parts.
    const GridCell below_right{v, at->parts}, below_left{v - 1, at[-1].parts};
    GridCell above_left, above_right;
    if (at->first_row == 0) {
      above_right = {v - stride, (at - stride)->parts};
      above_left = {v - stride - 1, (at - stride)[-1].parts};
    }
    // Half of the edges run up.
    const auto runs_down = [&](const GridVertex* to) { return !from.has_ended(PackedXY(to->at)); };
    const auto edge = [&](const GridVertex* to, FaceId begins, FaceId ends) {
      if ((begins | ends) != 0) add(from, PackedXY(to->at), begins, ends);
    };
    const GridVertex *const up = at - stride, *const down = at + stride;
    if ((above_left.parts | above_right.parts) != 0 && runs_down(up)) edge(up, above_right.lower(), above_left.upper());
    if ((above_left.parts | below_left.parts) != 0 && runs_down(at - 1)) {
      edge(at - 1, above_left.lower(), below_left.upper());
    }
    if (above_left.apart() && runs_down(up - 1)) edge(up - 1, above_left.upper(), above_left.lower());
    if ((above_right.parts | below_right.parts) != 0 && runs_down(at + 1)) {
      edge(at + 1, below_right.upper(), above_right.lower());
    }
    if ((below_left.parts | below_right.parts) != 0 && runs_down(down)) {
      edge(down, below_left.upper(), below_right.lower());
    }
    if (below_right.apart() && runs_down(down + 1)) edge(down + 1, below_right.lower(), below_right.upper());
  }
}

template <bool kTaps, Paint kPaint>
bool PatchLines<kTaps, kPaint>::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  const FaceId ends = edge.ending();
  const FaceId face = ends == 0 ? edge.beginning() : ends;
  ScreenEdge e;
  if (!grids_.find_edge(face, line, ends == 0, e)) return false;
  if (first_centre(e.top.at.y) >= line) return false;  // that one comes from its own vertex
  const EdgeRun run = start_run(e.top.at, e.bottom.at, line);
  edge.x = run.x;
  edge.dx = run.dx;
  edge.rest += static_cast<std::uint32_t>(run.lines - 1) * ActiveEdge::kOneLine;
  return true;
}

template <bool kTaps, Paint kPaint>
bool PatchLines<kTaps, kPaint>::next(std::uint16_t line, Painter& painter, const SpanTap& tap) {
  CHECK(ready_ && line == line_);
  if (line == top_ + height_) {
    if (const Status status = plan(line); !status.ok()) return give_up(status);
  }
  if (looks_.on()) {
    looks_.begin_line(line, painter.background());
  } else {
    grids_.set_background(painter.background());
  }
  if (!walker_.start_fed([&](const auto& add) { feed(line, add); })) {
    const std::uint32_t capacity = walker_.edge_capacity();
    return give_up({Code::pool_exhausted, "edges", "", 0, line, capacity + 1, capacity});
  }
  if (walker_.most_edges() > most_edges_) most_edges_ = walker_.most_edges();
  if (planes_made_) walker_.forget_planes();
  planes_made_ = false;
  const auto again = [this](ActiveEdge& edge, std::int32_t next_line) { return run_again(edge, next_line); };
  if (!walker_.walk(line, Sink{*this, painter, tap, line}, Planes{*this, line}, again)) {
    return give_up({Code::pool_exhausted, "overlaps", "", 0, line, OverlapSet::kMost + 1, OverlapSet::kMost});
  }
  ++line_;
  return true;
}

template <bool kTaps, Paint kPaint>
bool PatchLines<kTaps, kPaint>::give_up(const Status& status) {
  ready_ = false;
  shortage_ = status;
  return false;
}

}  // namespace spanline
