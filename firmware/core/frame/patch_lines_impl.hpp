// The body of PatchLines; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/patch_lines.hpp"
#include "core/shade/grid_walk.hpp"
#include "core/vsg/grid_start.hpp"

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
  FaceId nearer(FaceId a, FaceId b, std::int32_t left, std::int32_t right, PlaneCache& cache) const {
    const DepthReach& of_a = reach_of(a, cache);
    const std::int32_t nearest = of_a.nearest, farthest = of_a.farthest;  // the other one may take its place
    const DepthReach& of_b = reach_of(b, cache);
    if (apart(farthest, of_b.nearest)) return a;
    if (apart(of_b.farthest, nearest)) return b;
    return nearer_on_span(a, b, left, right);
  }
  FaceId nearest(const OverlapSet& set, PlaneCache& cache) const {
    FaceId front = 0;
    std::int32_t farthest = INT16_MIN, nearest = INT16_MIN, others = INT16_MIN;  // as in DepthRows::nearest()
    for (unsigned i = 0; i < set.count(); ++i) {
      const DepthReach& of = reach_of(set[i], cache);
      std::int32_t passed = of.nearest;
      if (of.farthest > farthest) {
        front = set[i];
        farthest = of.farthest;
        passed = std::exchange(nearest, passed);
      }
      if (passed > others) others = passed;
    }
    return apart(farthest, others) ? front : FaceId{0};
  }

 private:
  const DepthReach& reach_of(FaceId face, PlaneCache& cache) const {
    // Most cells are one face, whose number is even.
    return cache.reach_at(face / 2u, face, [this, face](DepthReach& to) { lines.grids_.reach(face, to); });
  }
  // Likewise by where they run along the line, which is linear: who is ahead at both ends of the span is ahead between
  // them.
  [[gnu::noinline]] FaceId nearer_on_span(FaceId a, FaceId b, std::int32_t left, std::int32_t right) const {
    const GridChord of_a = lines.grids_.chord(a, line), of_b = lines.grids_.chord(b, line);
    const std::int32_t off = kOff + of_a.steepness() + of_b.steepness();
    const std::int32_t at_left = of_a.depth_at(left) - of_b.depth_at(left);
    const std::int32_t at_right = of_a.depth_at(right - 1) - of_b.depth_at(right - 1);
    if (at_left > off && at_right > off) return a;
    return at_left < -off && at_right < -off ? b : FaceId{0};
  }
  // Of two chords one is three units too far off and the other two too near at most, but for their steepness, and ramps
  // are off by less than half a unit each.
  static constexpr std::int32_t kOff = 6;
  // Reaches are cut down to units of depth.
  static bool apart(std::int32_t farthest, std::int32_t nearest) { return farthest > nearest + 1; }
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
  if (const Status status = looks_.begin_frame(scene_); !status.ok()) return status;
  if (const Status status = check(); !status.ok()) return status;
  reader_ = FacetReader(scene_, camera_, screen_, {});
  both_sides_ = false;
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
    if ((flags & InstanceRecord::kScreen) != 0 || (looks_.on() && (flags & InstanceRecord::kTwoSided) != 0)) {
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
  FacetLight light;
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
      light = FacetLight(rig, reader_.matrix(), reader_.mirrored());
    }
    if (const Status status = dice(face, rig, light); !status.ok()) return status;
  }
  return {};
}

template <bool kTaps, Paint kPaint>
Status PatchLines<kTaps, kPaint>::dice(std::uint16_t face, const LightRig& rig, const FacetLight& light) {
  const bool two_sided = (reader_.instance().flags & InstanceRecord::kTwoSided) != 0;
  if (reader_.mirrored() && !two_sided)
    return {Code::bad_record, "InstanceRecord", "transform (mirrored)", reader_.instance_index()};
  const MaterialRecord& material = scene_.scene().materials[reader_.face().material];
  const PatchLook look{&rig, &material, screen_.format, looks_.on(), two_sided};
  both_sides_ = both_sides_ || two_sided;
  for (;;) {
    PatchJob job(reader_, look, {top_, grids_.bottom(), screen_.width});
    if (job.nothing) return {};
    if (!PatchGrids::takes(job)) {
      return {Code::bad_record, "InstanceRecord", "transform (beyond the view)", reader_.instance_index()};
    }
    PatchDicer dicer = job.make_dicer(grids_.view(camera_));
    job.dicer = &dicer;
    if (grids_.dice(job, light, face)) return {};
    const std::int32_t lines = grids_.bottom() - top_;
    if (lines == 1) {
      const std::uint32_t all = grids_.capacity();
      return {Code::pool_exhausted, "patch_grid", "", face, top_, all + 1, all};
    }
    grids_.shrink(top_ + lines * 3 / 4);
  }
}

// Starts the edges that begin on the line, from a list of its vertices; false where there is no room for one.
template <bool kTaps, Paint kPaint>
bool PatchLines<kTaps, kPaint>::start_edges(std::uint16_t line, std::uint16_t vertex) {
  return walker_.start_by([this, line, vertex](ActiveEdge* first, const ActiveEdge* last) {
    return both_sides_ ? GridStart<GridVertex, true>(&grids_[0], line).start(vertex, first, last)
                       : GridStart<GridVertex>(&grids_[0], line).start(vertex, first, last);
  });
}

template <bool kTaps, Paint kPaint>
bool PatchLines<kTaps, kPaint>::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  const FaceId ends = edge.ending();
  const FaceId face = ends == 0 ? edge.beginning() : ends;
  const bool back = both_sides_ && grids_.is_back(face);
  ScreenEdge e;
  if (!grids_.find_edge(face, line, (ends == 0) != back, e)) return false;
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
  const Sink sink{*this, painter, tap, line};
  const std::uint16_t first = buckets_[static_cast<std::uint32_t>(line - top_ + 1)];
  if (first == 0 && walker_.none_alive()) {
    sink.rest(0);
    ++line_;
    return true;
  }
  if (first != 0 && !start_edges(line, first)) {
    const std::uint32_t capacity = walker_.edge_capacity();
    return give_up({Code::pool_exhausted, "edges", "", 0, line, capacity + 1, capacity});
  }
  if (walker_.most_edges() > most_edges_) most_edges_ = walker_.most_edges();
  if (planes_made_) walker_.forget_planes();
  planes_made_ = false;
  const auto again = [this](ActiveEdge& edge, std::int32_t next_line) { return run_again(edge, next_line); };
  if (!walker_.walk(line, sink, Planes{*this, line}, again)) {
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
