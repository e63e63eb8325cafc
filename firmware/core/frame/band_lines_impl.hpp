// The body of BandLines; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/band_lines.hpp"
#include "core/frame/facet_color.hpp"
#include "core/shade/band_walk.hpp"

namespace spanline {

template <bool kTaps, Paint kPaint>
struct BandLines<kTaps, kPaint>::Sink {
  BandLines& mesh;
  Painter& painter;
  const SpanTap& tap;
  std::uint16_t line;

  WalkStop start(LineWalk& walk) const {
    walk.pixels = painter.out();
    walk.begin_line();
    return run(walk, 0);
  }
  WalkStop run(LineWalk& walk, FaceId shown) const {
    if (!kTaps && mesh.paint() == Paint::flat_words) return band_flat_walk(walk, shown);
    if (!kTaps && mesh.paint() == Paint::smooth_words) return band_smooth_walk(walk, shown);
    return walk_on(walk, shown, [this](std::int32_t left, std::int32_t right, FaceId face) {
      one(left, right, face);
      return true;
    });
  }
  // Sees to the look of a face, and that the brush knows it where it is smooth.
  void learn(FaceId face) const {
    if (!mesh.smooth()) return face == 0 ? mesh.begin_line(line, painter.background()) : mesh.learn_color(face);
    const FaceLook& look = mesh.looks_.look(
        face, [this](FaceId f) { return f == 0 ? FaceLook::flat(painter.background()) : mesh.look_of(f); });
    if (look.smooth() && !mesh.brush_.knows(face, look)) mesh.brush_.dip(look.material, mesh.colors_of(look.material));
  }
  void one(std::int32_t left, std::int32_t right, FaceId face) const {
    if constexpr (kTaps) report_alone(left, right, face);
    paint(left, right, face);
  }
  void rest(std::int32_t left) const {
    if (!kTaps && mesh.paint() != Paint::any) {
      fill_exactly(painter.out(), left, mesh.screen_.width, painter.background());
    } else if (left < mesh.screen_.width) {
      one(left, mesh.screen_.width, 0);
    }
  }
  void front(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    if constexpr (kTaps) report(left, right, face, ramp);
    paint(left, right, face);
  }

 private:
  // Not a pixel too far.
  [[gnu::noinline]] void paint(std::int32_t left, std::int32_t right, FaceId face) const {
    const auto from = static_cast<std::uint32_t>(left), to = static_cast<std::uint32_t>(right);
    if (face == 0) return painter.fill(from, to, painter.background());
    if (!mesh.smooth()) return painter.fill(from, to, mesh.color(face));
    learn(face);
    const FaceLook& look = mesh.brush_.look(face);
    if (!look.smooth()) return painter.fill(from, to, look.color());
    painter.smooth(from, to, look.plane, mesh.brush_.colors());
  }
  void report_alone(std::int32_t left, std::int32_t right, FaceId face) const {
    report(left, right, face, face != 0 ? mesh.plane(face).on_line(line) : DepthRamp{});
  }
  void report(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    const std::uint16_t payload = mesh.smooth() ? std::uint16_t{0}
                                  : face != 0   ? mesh.color(face)
                                                : painter.background();
    tap.tell(line, left, right, static_cast<std::uint16_t>(face - 1), payload, ramp);
  }
};

template <bool kTaps, Paint kPaint>
struct BandLines<kTaps, kPaint>::Planes {
  BandLines& mesh;

  DepthPlane operator()(FaceId face) const { return mesh.plane(face); }
  FaceId nearest(const OverlapSet& set, PlaneCache& cache) const { return mesh.rows_.nearest(set, cache); }
  FaceId nearer(FaceId a, FaceId b, PlaneCache& cache) const { return mesh.rows_.nearer(a, b, cache); }
};

template <bool kTaps, Paint kPaint>
BandLines<kTaps, kPaint>::BandLines(const FrameStorage& storage)
    : screen_(storage.screen),
      vertices_(storage.bands.vertices, storage.bands.keys, storage.bands.buckets),
      drawn_(storage.bands.drawn),
      colors_(storage.bands.colors),
      smooth_(storage.smooth, storage.screen.format),
      looks_(storage.smooth.looks, storage.bands.heads, storage.bands.links),
      walker_(storage.mesh.walker, storage.screen) {
  if constexpr (kPaint == Paint::any) {
    if (storage.screen.format == PixelFormat::rgb565) found_ = smooth() ? Paint::smooth_words : Paint::flat_words;
  }
}

template <bool kTaps, Paint kPaint>
template <typename Changes>
Status BandLines<kTaps, kPaint>::begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top,
                                       Changes& changes) {
  if (ready_ && changes.still() && top != 0 && top == line_ && &scene.scene() == &scene_.scene() && camera == camera_)
    return {};
  ready_ = false;
  scene_ = scene;
  camera_ = camera;
  if (const Status status = check(); !status.ok()) return status;
  clear(top);
  for (InstanceCursor at(scene_.scene()); !at.at_end(); at.next()) {
    if ((at.instance().flags & InstanceRecord::kHidden) == 0 && !cull(at)) {
      return beyond_view(at.index());
    }
  }
  line_ = top;
  plan(top);
  changes.geometry_kept();
  ready_ = true;
  return {};
}

// What the edge walker cannot draw, or not with the pools it has.
template <bool kTaps, Paint kPaint>
Status BandLines<kTaps, kPaint>::check() const {
  if (kPaint != Paint::any && screen_.format != PixelFormat::rgb565) return bad_argument("screen", "format");
  if (smooth() && !smooth_.on()) return pool_exhausted("looks", 0, 1, 0);
  if (scene_.vertex_count() > vertices_.capacity()) {
    return pool_exhausted("vertices", 0, scene_.vertex_count(), vertices_.capacity());
  }
  const std::uint32_t faces =
      smooth() && looks_.most_faces() < drawn_.capacity() ? looks_.most_faces() : drawn_.capacity();
  if (scene_.face_count() > faces) return pool_exhausted("facets", 0, scene_.face_count(), faces);
  if (walker_.edge_capacity() == 0) return pool_exhausted("edges", 0, 1, 0);
  if (smooth()) {
    if (const Status status = check_smooth(scene_.scene()); !status.ok()) return status;
  }
  return check_meshes(scene_);
}

// Forgets the frame before.
template <bool kTaps, Paint kPaint>
void BandLines<kTaps, kPaint>::clear(std::uint16_t top) {
  colors_.clear();
  smooth_.clear();
  if (smooth()) {
    looks_.clear();
    brush_ = BandBrush(looks_.looks(), {looks_.heads()});
  }
  lights_.forget();
  at_hand_ = {};
  new (&points_) InstancePoints(scene_.scene(), camera_, screen_);
  rows_.begin(scene_.scene(), camera_, screen_, 0);
  drawn_.clear(scene_.face_count());
  vertices_.begin(scene_.vertex_count(), top, screen_.height);
  walker_.begin();
  smooth() ? walker_.paint_with(nullptr, &brush_) : walker_.paint_with(nullptr, &colors_);
  bands_ = 0;
}

// Notes the faces of an instance that are seen from their fronts, and their vertices. False where a vertex lies out of
// the view, or fronts have become backs. Vertices met lately are kept where those of bands will be.
template <bool kTaps, Paint kPaint>
bool BandLines<kTaps, kPaint>::cull(const InstanceCursor& at) {
  bool surely;
  if (!points_.enter(at, rows_, surely)) return false;
  const std::uint32_t first = at.first_vertex();
  bool inside = true;
  const auto project = [&](std::uint32_t vertex, BandVertex & kept) __attribute__((noinline)) {
    // What lies behind the viewer has no place, and the answer is no.
    const bool seen = surely || !points_.outside(vertex);
    inside = inside && seen;
    kept.at = seen ? points_[vertex] : ScreenXY{};
    kept.vertex = static_cast<std::uint16_t>(1 + first + vertex);
  };
  const auto place = [&](std::uint32_t vertex) __attribute__((always_inline)) {
    BandVertex& kept = vertices_.place(first + vertex);
    if (kept.vertex != 1 + first + vertex) [[unlikely]]
      project(vertex, kept);
    return kept.at;
  };
  const std::uint16_t* corner = at.mesh().corners.data();
  for (std::uint32_t face = at.first_face(), end = face + at.mesh().face_count; face != end; ++face, corner += 3) {
    const ScreenXY a = place(corner[0]), b = place(corner[1]), c = place(corner[2]);
    if (!is_front(a, b, c)) continue;
    drawn_.put(face);
    vertices_.wait(first + corner[0], a);
    vertices_.wait(first + corner[1], b);
    vertices_.wait(first + corner[2], c);
  }
  return inside;
}

// Files the vertices of the longest band from `top` on that they fit.
template <bool kTaps, Paint kPaint>
void BandLines<kTaps, kPaint>::plan(std::uint16_t top) {
  vertices_.begin_band(top);
  const std::uint32_t end = vertices_.count();
  for (std::uint32_t vertex = vertices_.first(); (vertex = vertices_.next_to_file(vertex)) != end; ++vertex) {
    vertices_.file(vertex, project(vertex));
  }
  crowded_ = vertices_.end() == top;
  end_ = static_cast<std::uint16_t>(crowded_ ? top + 1 : vertices_.end());
  ++bands_;
}

template <bool kTaps, Paint kPaint>
bool BandLines<kTaps, kPaint>::start_edges(std::int32_t line) {
  if (!crowded_ && vertices_.is_empty(line)) return true;
  return walker_.start_fed<true>([&](const auto& add) {
    if (!crowded_) {
      while (!vertices_.is_empty(line)) {
        const BandVertex& next = vertices_.pop(line);
        feed(next.vertex - 1u, FromVertex(PackedXY(next.at), line), add);
      }
      return;
    }
    const std::uint32_t end = vertices_.count();
    for (std::uint32_t vertex = vertices_.first(); (vertex = vertices_.next_to_reach(vertex, line)) != end; ++vertex) {
      const ScreenXY at = project(vertex);
      if (vertices_.first_line(at) != line) continue;
      vertices_.reach(vertex);
      feed(vertex, FromVertex(PackedXY(at), line), add);
    }
  });
}

// The edges that run down from a vertex that the lines have come to. Those that run up come from vertices that do not
// wait any more.
template <bool kTaps, Paint kPaint>
template <typename Add>
void BandLines<kTaps, kPaint>::feed(std::uint32_t vertex, const FromVertex& from, const Add& add) {
  points_.to_vertex(vertex);
  const MeshRecord& mesh = points_.mesh();
  const std::uint32_t first = points_.first_vertex(), first_face = points_.first_face();
  const std::uint16_t* const start = mesh.fan_starts.data() + (vertex - first);
  const FanEdge* edge = mesh.fans.data() + start[0];
  const auto shown = [&](std::uint16_t face) {
    const bool drawn = face != FanEdge::kNone && drawn_.has(first_face + face);
    return static_cast<FaceId>(drawn ? first_face + face + 1 : 0);
  };
  const FanEdge* const end = mesh.fans.data() + start[1];
  for (std::uint16_t twin = end[-1].face; edge != end; twin = edge->face, ++edge) {
    const std::uint32_t to = edge->to;
    if (!vertices_.known(first + to)) continue;
    const BandVertex* const kept = vertices_.find(first + to);
    if (kept != nullptr && kept->reached()) continue;
    const PackedXY bottom(kept != nullptr ? kept->at : points_[to]);
    if (from.has_ended(bottom)) continue;
    const FaceId begins = shown(edge->face), ends = shown(twin);
    if ((begins | ends) != 0) add(from, bottom, begins, ends);
  }
}

template <bool kTaps, Paint kPaint>
bool BandLines<kTaps, kPaint>::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  ScreenXY at[3];
  corners(EdgeWalker::face_of_tall(edge), at);
  return EdgeWalker::run_tall_again(edge, line, at);
}

template <bool kTaps, Paint kPaint>
DepthPlane BandLines<kTaps, kPaint>::plane(FaceId face) {
  ScreenXY at[3];
  corners(face, at);
  return rows_.plane(face - 1u, at);
}

// On the screen; the face's instance becomes that of `points_`.
template <bool kTaps, Paint kPaint>
void BandLines<kTaps, kPaint>::corners(FaceId face, ScreenXY (&at)[3]) {
  points_.to_face(face - 1u);
  const std::uint16_t* const corner = points_.mesh().corners.data() + 3 * (face - 1u - points_.first_face());
  for (unsigned i = 0; i < 3; ++i) at[i] = place(corner[i]);
}

// The face's group becomes the one at hand.
template <bool kTaps, Paint kPaint>
void BandLines<kTaps, kPaint>::turn_to(FaceId face) {
  points_.to_face(face - 1u);
  const MeshRecord& mesh = points_.mesh();
  const std::uint32_t before = points_.first_face() + 1;
  const FaceGroup* group = mesh.groups.data();
  while (face - before - group->first_face >= group->face_count) ++group;
  const std::uint16_t number = material_of(points_.instance(), *group);
  const MaterialRecord& material = scene_.scene().materials[number];
  const LightRig& rig = lights();
  const bool quick = material.shading != MaterialRecord::kUnlit && rig.quick() && !mesh.face_normals.empty() &&
                     screen_.format == PixelFormat::rgb565;
  at_hand_ = {before,
              before + group->first_face,
              group->face_count,
              number,
              &material,
              quick ? mesh.face_normals.data() - before : nullptr,
              quick ? rig.one() : LightRig::One{}};
}

// Of a face that is at hand, drawn flat.
template <bool kTaps, Paint kPaint>
std::uint16_t BandLines<kTaps, kPaint>::flat_color(FaceId face) {
  const MaterialRecord& material = *at_hand_.look;
  if (at_hand_.normals != nullptr) return lit_rgb565_wire(material.color, at_hand_.one.sum(at_hand_.normals[face]));
  points_.to_face(face - 1u);
  const std::uint32_t number = face - at_hand_.before;
  const MeshRecord& mesh = points_.mesh();
  const Rgb8 color = material.shading == MaterialRecord::kUnlit
                         ? material.color
                         : facet_color(mesh, number, mesh.corners[3 * number], material, lights(), false);
  return flat_payload(screen_.format, color);
}

template <bool kTaps, Paint kPaint>
void BandLines<kTaps, kPaint>::learn_color(FaceId face) {
  bring_to_hand(face);
  colors_.put(face, flat_color(face));
}

template <bool kTaps, Paint kPaint>
FaceLook BandLines<kTaps, kPaint>::look_of(FaceId face) {
  bring_to_hand(face);
  const std::uint16_t material = at_hand_.material;
  if (at_hand_.look->shading != MaterialRecord::kGouraud) return FaceLook::flat(flat_color(face));
  points_.to_face(face - 1u);
  const LightRig& rig = lights();
  const std::uint16_t* const corner = points_.mesh().corners.data() + 3 * (face - at_hand_.before);
  ScreenXY at[3];
  Brightness level[3];
  for (unsigned i = 0; i < 3; ++i) {
    const Normal10& normal = points_.mesh().vertex_normals[corner[i]];
    if (BandVertex* const kept = vertices_.find(points_.first_vertex() + corner[i]); kept != nullptr) {
      if (kept->level == BandVertex::kNoLevel) kept->level = rig.brightness(normal, false);
      at[i] = kept->at;
      level[i] = kept->level;
    } else {
      at[i] = points_[corner[i]];
      level[i] = rig.brightness(normal, false);
    }
  }
  const BrightnessPlane plane = brightness_plane(at, level);
  if ((plane.right | plane.down) != 0) return {plane, 0, material};
  const std::uint16_t* const colors = colors_of(material);
  brush_.dip(material, colors);
  return FaceLook::flat(colors[BrightnessPlane::entry(plane.at_zero)]);
}

template <bool kTaps, Paint kPaint>
bool BandLines<kTaps, kPaint>::next(std::uint16_t line, Painter& painter, const SpanTap& tap) {
  CHECK(ready_ && line == line_);
  if (line == end_) plan(line);
  if (!kTaps && walker_.none_alive() && !crowded_ && vertices_.is_empty(line)) {
    painter.fill(0, screen_.width, painter.background());
    ++line_;
    return true;
  }
  if (!start_edges(line) || !walker_.make_way()) return give_up(false);
  begin_line(line, painter.background());
  const bool whole = walker_.walk(line, Sink{*this, painter, tap, line}, Planes{*this},
                                  [this](ActiveEdge& edge, std::int32_t below) { return run_again(edge, below); });
  if (!whole) return give_up(true);
  ++line_;
  return true;
}

template <bool kTaps, Paint kPaint>
bool BandLines<kTaps, kPaint>::give_up(bool overlaps) {
  ready_ = false;
  overlaps_short_ = overlaps;
  return false;
}

template <bool kTaps, Paint kPaint>
Status BandLines<kTaps, kPaint>::shortage() const {
  return walker_shortage(walker_, overlaps_short_, line_);
}

}  // namespace spanline
