// The body of BandLines; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/band_lines.hpp"
#include "core/frame/facet_color.hpp"
#include "core/shade/band_walk.hpp"

namespace spanline {

template <bool kTaps, Paint kPaint, bool kPlain>
struct BandLines<kTaps, kPaint, kPlain>::Sink {
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
  void one(std::int32_t left, std::int32_t right, FaceId face) const {
    if constexpr (kTaps) report_alone(left, right, face);
    paint(left, right, face);
  }
  void rest(std::int32_t left) const {
    if (!kTaps && mesh.paint() != Paint::any) {
      fill_exactly(painter.out(), left, mesh.screen().width, painter.background());
    } else if (left < mesh.screen().width) {
      one(left, mesh.screen().width, 0);
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
    if constexpr (kSmooths) {
      if (mesh.smooth()) {
        const FaceLook& look = mesh.looks_.brush.learned(face);
        return look.smooth() ? painter.smooth(from, to, look.plane, mesh.looks_.brush.colors())
                             : painter.fill(from, to, look.color());
      }
    }
    painter.fill(from, to, mesh.colors_[face]);
  }
  void report_alone(std::int32_t left, std::int32_t right, FaceId face) const {
    report(left, right, face, face != 0 ? mesh.plane(face).on_line(line) : DepthRamp{});
  }
  void report(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    const std::uint16_t payload = mesh.smooth() ? std::uint16_t{0}
                                  : face != 0   ? mesh.colors_[face]
                                                : painter.background();
    tap.tell(line, left, right, static_cast<std::uint16_t>(face - 1), payload, ramp);
  }
};

template <bool kTaps, Paint kPaint, bool kPlain>
struct BandLines<kTaps, kPaint, kPlain>::Planes {
  BandLines& mesh;

  DepthPlane operator()(FaceId face) const { return mesh.plane(face); }
  FaceId nearest(const OverlapSet& set, PlaneCache& cache) const { return mesh.points_.nearest(set, cache); }
  FaceId nearer(FaceId a, FaceId b, std::int32_t, std::int32_t, PlaneCache& cache) const {
    return mesh.points_.nearer(a, b, cache);
  }
};

template <bool kTaps, Paint kPaint, bool kPlain>
BandLines<kTaps, kPaint, kPlain>::BandLines(const FrameStorage& storage)
    : points_(storage.bands.instances),
      vertices_(storage.bands.vertices, storage.bands.keys, storage.bands.buckets),
      culled_(storage.mesh.walker.points),
      drawn_(storage.bands.drawn),
      colors_(storage.bands.colors, learn_color, this),
      walker_(storage.mesh.walker, storage.screen) {
  if constexpr (kSmooths) {
    looks_.cache = SmoothCache(storage.smooth, storage.screen.format);
    looks_.chains = LookChains(storage.smooth.looks, storage.bands.heads, storage.bands.links);
  }
  if constexpr (kPaint == Paint::any) {
    if (storage.screen.format == PixelFormat::rgb565) found_ = smooth() ? Paint::smooth_words : Paint::flat_words;
  }
}

template <bool kTaps, Paint kPaint, bool kPlain>
template <typename Changes>
Status BandLines<kTaps, kPaint, kPlain>::begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top,
                                               Changes& changes) {
  if (ready_ && changes.still() && top != 0 && top == line_ && &scene.scene() == &points_.scene() &&
      camera == points_.camera())
    return {};
  ready_ = false;
  if (const Status status = check(scene); !status.ok()) return status;
  clear(scene, camera, top);
  for (bool first = true; points_.to_drawn(first); first = false) {
    bool surely;
    if (!points_.enter(surely) || !cull(surely)) return beyond_view(points_.index());
    if constexpr (kPlain) {
      if (!lights().fits() || (!smooth() && points_.mesh().face_normals.empty())) {
        return bad_argument("plain", "transform or normals", 0, points_.index());
      }
    }
  }
  begin_lines(top);
  changes.geometry_kept();
  ready_ = true;
  return {};
}

// What the edge walker cannot draw, or not with the pools it has.
template <bool kTaps, Paint kPaint, bool kPlain>
Status BandLines<kTaps, kPaint, kPlain>::check(const SceneView& scene) const {
  if (kPaint != Paint::any && screen().format != PixelFormat::rgb565) return bad_argument("screen", "format");
  if (smooth() && !looks_.on()) return pool_exhausted("looks", 0, 1, 0);
  if (scene.vertex_count() > vertices_.capacity()) {
    return pool_exhausted("vertices", 0, scene.vertex_count(), vertices_.capacity());
  }
  std::uint32_t faces = drawn_.capacity();
  if constexpr (kSmooths) {
    if (smooth() && looks_.chains.most_faces() < faces) faces = looks_.chains.most_faces();
  }
  if (scene.face_count() > faces) return pool_exhausted("facets", 0, scene.face_count(), faces);
  if (walker_.edge_capacity() == 0) return pool_exhausted("edges", 0, 1, 0);
  if constexpr (kPlain) {
    const char* const other = scene.not_plain(smooth());
    return other == nullptr ? Status{} : bad_argument("plain", other);
  } else {
    if (smooth()) {
      if (const Status status = check_smooth(scene.scene()); !status.ok()) return status;
    }
    return check_meshes(scene);
  }
}

// Forgets the frame before. What may lie over points that are culled is that until begin_lines().
template <bool kTaps, Paint kPaint, bool kPlain>
void BandLines<kTaps, kPaint, kPlain>::clear(const SceneView& scene, const CameraRecord& camera, std::uint16_t top) {
  lights_.forget();
  at_hand_ = {};
  points_.begin(scene.scene(), camera, screen());
  drawn_.clear(scene.face_count());
  vertices_.begin(scene.vertex_count(), top, screen().height);
  bands_ = 0;
}

template <bool kTaps, Paint kPaint, bool kPlain>
void BandLines<kTaps, kPaint, kPlain>::begin_lines(std::uint16_t top) {
  colors_.clear();
  walker_.begin();
  walker_.paint_with(nullptr, &colors_);
  if constexpr (kSmooths) {
    if (smooth()) {
      looks_.cache.clear();
      looks_.chains.clear();
      looks_.brush = BandBrush(looks_.chains.looks(), {looks_.chains.heads()}, learn_look<Looks>, this);
      walker_.paint_with(nullptr, &looks_.brush);
    }
  }
  background_ = -1;
  line_ = top;
  plan(top);
}

// Notes the faces of the instance at hand that are seen from their fronts, and their vertices. False where a vertex
// lies out of the view; `surely`: none does.
template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::cull(bool surely) {
  return points_.mesh().positions.size() <= culled_.capacity() ? cull_placed(surely) : cull_by_places(surely);
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::cull_placed(bool surely) {
  if (!surely && !points_.all_inside()) return false;
  ScreenXY* const points = culled_.sink() + 1;
  points_.place_all(points);
  cull_by([points](std::uint32_t vertex) { return points[vertex]; });
  return true;
}

// Where there is no room for the mesh's vertices those met lately are kept where the bands' will be.
template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::cull_by_places(bool surely) {
  vertices_.forget_places();
  bool inside = true;
  const auto project = [&](std::uint32_t vertex, BandVertex & kept) __attribute__((noinline)) {
    // What lies behind the viewer has no place, and the answer is no.
    const bool seen = surely || !points_.outside(vertex);
    inside = inside && seen;
    kept.at = seen ? points_[vertex] : ScreenXY{};
    kept.vertex = static_cast<std::uint16_t>(1 + vertex);
  };
  cull_by([&](std::uint32_t vertex) __attribute__((always_inline)) {
    BandVertex& kept = vertices_.place(vertex);
    if (kept.vertex != 1 + vertex) [[unlikely]]
      project(vertex, kept);
    return kept.at;
  });
  return inside;
}

// place(vertex) is where a vertex of the mesh lies.
template <bool kTaps, Paint kPaint, bool kPlain>
template <typename Place>
void BandLines<kTaps, kPaint, kPlain>::cull_by(const Place& place) {
  const MeshRecord& mesh = points_.mesh();
  const BandVertices::Mesh vertices(vertices_, points_.first_vertex());
  BitPool drawn = drawn_;
  const std::uint16_t* corner = mesh.corners.data();
  for (std::uint32_t face = points_.first_face(), end = face + mesh.face_count; face != end; ++face, corner += 3) {
    const std::uint32_t a = corner[0], b = corner[1], c = corner[2];
    if (doubled_area_near(PackedXY(place(a)), PackedXY(place(b)), PackedXY(place(c))) >= 0) continue;
    drawn.put(face);
    vertices.mark(a);
    vertices.mark(b);
    vertices.mark(c);
  }
  vertices.wait(mesh.positions.size(), place);
}

// Files the vertices of the longest band from `top` on that they fit.
template <bool kTaps, Paint kPaint, bool kPlain>
void BandLines<kTaps, kPaint, kPlain>::plan(std::uint16_t top) {
  vertices_.begin_band(top, [this](std::uint32_t vertex) { return project(vertex); });
  crowded_ = vertices_.end() == top;
  end_ = static_cast<std::uint16_t>(crowded_ ? top + 1 : vertices_.end());
  ++bands_;
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::start_edges(std::int32_t line) {
  if (!crowded_ && vertices_.is_empty(line)) return true;
  BandStart start;
  start.line = line;
  walker_.begin_start(start);
  if (!(crowded_ ? start_crowded_line(start) : start_fans(start, vertices_.first_of(line)))) return false;
  walker_.end_start(start);
  return true;
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::start_crowded_line(BandStart& start) {
  const std::uint32_t end = vertices_.last();
  for (std::uint32_t vertex = vertices_.first(); (vertex = vertices_.next_to_reach(vertex, start.line)) != end;
       ++vertex) {
    const ScreenXY at = project(vertex);
    if (vertices_.first_line(at) != start.line) continue;
    vertices_.reach(vertex);
    if (!start_fans(start, vertices_.alone(vertex, at))) return false;
  }
  return true;
}

// Starts the edges that run down from a vertex that the lines have come to, and from those after it; false where there
// is no room. Those that run up come from vertices that do not wait any more.
template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::start_fans(BandStart& start, std::uint32_t first) {
  start.band = vertices_.band();
  start.vertex = first;
  do {
    points_.to_vertex(start.band[start.vertex].vertex - 1u);
    const MeshRecord& mesh = points_.mesh();
    const std::uint32_t first_face = points_.first_face();
    start.keys = vertices_.keys(points_.first_vertex());
    start.drawn = drawn_.word(first_face);
    start.skip = first_face % 32;
    start.cover = cover_of(static_cast<FaceId>(first_face - start.skip + 1));
    start.first = points_.first_vertex() + 1;
    start.count = mesh.positions.size();
    start.starts = mesh.fan_starts.data();
    start.fans = mesh.fans.data();
    start.points = &points_.points();
    if (start.most() > start.room()) [[unlikely]] {
      walker_.make_room(start);
      if (start.most() > start.room()) {
        if (!start_crowded(start)) return false;
        continue;
      }
    }
    start_band_fans(start);
  } while (start.vertex != 0);
  return true;
}

// Starts the edges of a vertex whose fan has more than there is room for; false where those that begin are, too.
template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::start_crowded(BandStart& start) {
  std::uintptr_t needed = 0;
  start.each_to_start([&needed](const auto&...) { needed += sizeof(ActiveEdge); });
  if (needed > start.room()) return false;
  const BandVertex vertex = start.band[start.vertex];
  const std::uintptr_t last = std::exchange(start.last, UINTPTR_MAX);
  start.vertex = vertices_.alone(vertex.vertex - 1u, vertex.at);
  start_band_fans(start);
  start.last = last;
  start.vertex = vertex.next;
  return true;
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  ScreenXY at[3];
  corners(EdgeWalker::face_of_tall(edge), at);
  return EdgeWalker::run_tall_again(edge, line, at);
}

template <bool kTaps, Paint kPaint, bool kPlain>
DepthPlane BandLines<kTaps, kPaint, kPlain>::plane(FaceId face) {
  ScreenXY at[3];
  corners(face, at);
  return points_.plane(face - 1u, at, screen());
}

// On the screen; the face's instance becomes that of `points_`.
template <bool kTaps, Paint kPaint, bool kPlain>
void BandLines<kTaps, kPaint, kPlain>::corners(FaceId face, ScreenXY (&at)[3]) {
  points_.to_face(face - 1u);
  const std::uint16_t* const corner = points_.mesh().corners.data() + 3 * (face - 1u - points_.first_face());
  for (unsigned i = 0; i < 3; ++i) at[i] = place(corner[i]);
}

// The face's group becomes the one at hand.
template <bool kTaps, Paint kPaint, bool kPlain>
void BandLines<kTaps, kPaint, kPlain>::turn_to(FaceId face) {
  points_.to_face(face - 1u);
  const MeshRecord& mesh = points_.mesh();
  const std::uint32_t before = points_.first_face() + 1;
  const FaceGroup* group = mesh.groups.data();
  while (face - before - group->first_face >= group->face_count) ++group;
  const std::uint16_t number = material_of(points_.instance(), *group);
  const MaterialRecord& material = points_.scene().materials[number];
  const Lights& rig = lights();
  const bool smooth_ones = smooth() && (kPlain || material.shading == MaterialRecord::kGouraud);
  const bool quick = smooth_ones ? rig.single()
                                 : material.shading != MaterialRecord::kUnlit && rig.quick() &&
                                       !mesh.face_normals.empty() && (kPlain || screen().format == PixelFormat::rgb565);
  at_hand_ = {before,
              before + group->first_face,
              group->face_count,
              number,
              &material,
              !quick        ? nullptr
              : smooth_ones ? mesh.vertex_normals.data()
                            : mesh.face_normals.data() - before};
}

// Of a face that is at hand, drawn flat.
template <bool kTaps, Paint kPaint, bool kPlain>
std::uint16_t BandLines<kTaps, kPaint, kPlain>::flat_color(FaceId face) {
  const MaterialRecord& material = *at_hand_.look;
  if (at_hand_.normals != nullptr) {
    return lit_rgb565_wire(material.color, lights_.last().one().sum(at_hand_.normals[face]));
  }
  points_.to_face(face - 1u);
  const std::uint32_t number = face - at_hand_.before;
  const MeshRecord& mesh = points_.mesh();
  if constexpr (kPlain) {
    const LightRig::One light = lights().on(material);
    return lit_rgb565_wire(material.color, light.sum(facet_normal(mesh, number, mesh.corners[3 * number])));
  } else {
    const Rgb8 color = material.shading == MaterialRecord::kUnlit
                           ? material.color
                           : facet_color(mesh, number, mesh.corners[3 * number], material, lights(), false);
    return flat_payload(screen().format, color);
  }
}

template <bool kTaps, Paint kPaint, bool kPlain>
std::uint16_t BandLines<kTaps, kPaint, kPlain>::learn_color(void* self, FaceId face) {
  BandLines& mesh = *static_cast<BandLines*>(self);
  auto color = static_cast<std::uint16_t>(mesh.background_);
  if (face != 0) [[likely]] {
    mesh.bring_to_hand(face);
    color = mesh.flat_color(face);
  }
  mesh.colors_.put(face, color);
  return color;
}

template <bool kTaps, Paint kPaint, bool kPlain>
template <typename AnyLooks>
void BandLines<kTaps, kPaint, kPlain>::learn_look(void* self, FaceId face) {
  BandLines& mesh = *static_cast<BandLines*>(self);
  AnyLooks& looks = mesh.looks_;
  const FaceLook& look = looks.chains.look(face, [&mesh, &looks, face](FaceLook& made) {
    face != 0 ? mesh.make_look(looks, face, made)
              : void(made = FaceLook::flat(static_cast<std::uint16_t>(mesh.background_)));
  });
  if (look.smooth() && !looks.brush.knows(face, look)) {
    looks.brush.dip(look.material, mesh.colors_of(looks, look.material));
  }
}

template <bool kTaps, Paint kPaint, bool kPlain>
template <typename AnyLooks>
void BandLines<kTaps, kPaint, kPlain>::make_look(AnyLooks& looks, FaceId face, FaceLook& look) {
  bring_to_hand(face);
  if (!kPlain && at_hand_.look->shading != MaterialRecord::kGouraud) {
    look = FaceLook::flat(flat_color(face));
    return;
  }
  points_.to_face(face - 1u);
  const MeshRecord& mesh = points_.mesh();
  const auto brightness = [&](std::uint32_t vertex) {
    if constexpr (!kPlain) {
      if (at_hand_.normals == nullptr) return lights().brightness(mesh.vertex_normals[vertex], false);
    }
    return LightRig::brightness(lights_.last().one().sum(at_hand_.normals[vertex]));
  };
  const std::uint16_t* const corner = mesh.corners.data() + 3 * (face - at_hand_.before);
  ScreenXY at[3];
  Brightness level[3];
  for (unsigned i = 0; i < 3; ++i) {
    const std::uint32_t vertex = corner[i];
    if (BandVertex* const kept = vertices_.find(points_.first_vertex() + vertex); kept != nullptr) {
      if (kept->level == BandVertex::kNoLevel) kept->level = brightness(vertex);
      at[i] = kept->at;
      level[i] = kept->level;
    } else {
      at[i] = place_vertex(points_.points(), vertex).unpacked();
      level[i] = brightness(vertex);
    }
  }
  const std::uint16_t material = at_hand_.material;
  const BrightnessPlane plane = brightness_plane(at, level);
  if ((plane.right | plane.down) != 0) {
    look.plane = plane;
    look.material = material;
    return;
  }
  const std::uint16_t* const colors = colors_of(looks, material);
  looks.brush.dip(material, colors);
  look = FaceLook::flat(colors[BrightnessPlane::entry(plane.at_zero)]);
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::next(std::uint16_t line, Painter& painter, const SpanTap& tap) {
  CHECK(ready_ && line == line_);
  if (line == end_) plan(line);
  if (!kTaps && walker_.none_alive() && !crowded_ && vertices_.is_empty(line)) {
    painter.fill(0, screen().width, painter.background());
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

template <bool kTaps, Paint kPaint, bool kPlain>
bool BandLines<kTaps, kPaint, kPlain>::give_up(bool overlaps) {
  ready_ = false;
  overlaps_short_ = overlaps;
  return false;
}

template <bool kTaps, Paint kPaint, bool kPlain>
Status BandLines<kTaps, kPaint, kPlain>::shortage() const {
  return walker_shortage(walker_, overlaps_short_, line_);
}

}  // namespace spanline
