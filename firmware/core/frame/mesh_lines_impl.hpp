// The body of MeshLines; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/facet_color.hpp"
#include "core/frame/mesh_lines.hpp"
#include "core/shade/fill_words.hpp"
#include "core/shade/flat_walk.hpp"
#include "core/shade/smooth_walk.hpp"

namespace spanline {

// Which paint it is, is asked where spans of several faces stop the walk, so that only the walk itself is
// there three times.
template <bool kTaps, Paint kPaint, bool kPlain>
struct MeshLines<kTaps, kPaint, kPlain>::Sink {
  MeshLines& mesh;
  Painter& painter;
  const SpanTap& tap;
  std::uint16_t line;

  WalkStop start(LineWalk& walk) const {
    walk.pixels = painter.out();
    if (!kTaps && mesh.paint() == Paint::flat_words) return flat_line(walk);
    if (!kTaps && mesh.paint() == Paint::smooth_words) return smooth_line(walk);
    walk.begin_line();
    return run(walk, 0);
  }
  WalkStop run(LineWalk& walk, FaceId shown) const {
    if (!kTaps && mesh.paint() == Paint::flat_words) return flat_walk(walk, shown);
    if (!kTaps && mesh.paint() == Paint::smooth_words) return smooth_walk(walk, shown);
    return walk_on(walk, shown, [this](std::int32_t left, std::int32_t right, FaceId face) {
      one(left, right, face);
      return true;
    });
  }
  void one(std::int32_t left, std::int32_t right, FaceId face) const {
    if constexpr (kTaps) report_alone(left, right, face);
    paint(static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(right), face);
  }
  void blank() const {
    if (!kTaps && mesh.paint() != Paint::any) {
      fill(0, mesh.screen_.width, painter.background());
    } else {
      one(0, mesh.screen_.width, 0);
    }
  }
  void front(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    if constexpr (kTaps) report(left, right, face, ramp);
    paint(static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(right), face);
  }

 private:
  // Not a pixel too far.
  [[gnu::noinline]] void paint(std::uint32_t left, std::uint32_t right, FaceId face) const {
    if (face == 0 || !mesh.smooth()) return fill(left, right, mesh.words_[face]);
    const FaceLook& look = mesh.brush_.learned(face);
    if (!look.smooth()) return fill(left, right, look.color());
    if constexpr (kPaint == Paint::any) return painter.smooth(left, right, look.plane, mesh.brush_.colors());
    smooth_exactly(painter.out(), left, right, look.plane, line, mesh.brush_.colors());
  }
  [[gnu::noinline]] void fill(std::uint32_t left, std::uint32_t right, std::uint16_t color) const {
    if constexpr (kPaint == Paint::any) return painter.fill(left, right, color);
    fill_exactly(painter.out(), static_cast<std::int32_t>(left), static_cast<std::int32_t>(right), color);
  }
  void report_alone(std::int32_t left, std::int32_t right, FaceId face) const {
    report(left, right, face, face != 0 ? mesh.rows_.plane(face - 1u, mesh.points_).on_line(line) : DepthRamp{});
  }
  void report(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) const {
    tap.tell(line, left, right, static_cast<std::uint16_t>(face - 1),
             mesh.smooth() ? std::uint16_t{0} : mesh.words_[face], ramp);
  }
};

template <bool kTaps, Paint kPaint, bool kPlain>
struct MeshLines<kTaps, kPaint, kPlain>::Planes {
  MeshLines& mesh;

  DepthPlane operator()(FaceId face) const { return mesh.rows_.plane(face - 1u, mesh.points_); }
  FaceId nearest(const OverlapSet& set, PlaneCache& cache) const { return mesh.rows_.nearest(set, cache); }
  FaceId nearer(FaceId a, FaceId b, std::int32_t, std::int32_t, PlaneCache& cache) const {
    return mesh.rows_.nearer(a, b, cache);
  }
};

template <bool kTaps, Paint kPaint, bool kPlain>
template <typename Changes>
Status MeshLines<kTaps, kPaint, kPlain>::begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top,
                                               Changes& changes) {
  ready_ = ready_ && changes.still() && goes_on(scene, camera, top);
  Status status = ready_ ? Status{} : take(scene, camera);
  if (ready_ || !status.ok()) return status;
  // What has not moved is not projected again, but as far away as it was.
  clear(top, Changes::kKeepsGeometry ? rows_.farthest() : 0);
  for (InstanceCursor at(scene_.scene()); !at.at_end(); at.next()) {
    if ((at.instance().flags & InstanceRecord::kHidden) != 0) continue;  // no edge leads to its faces
    const bool moved = changes.moved(at.index());
    if (moved && !project(at)) {
      status = beyond_view(at.index());
      return status;
    }
    if (moved) cull(at);
    walker_.vertices(at.first_vertex()).file(at.mesh().positions.size());
    if constexpr (kPlain) {
      if (!lights(at).fits() || (!smooth() && at.mesh().face_normals.empty())) {
        status = bad_argument("plain", "transform or normals", 0, at.index());
        return status;
      }
    }
    if (moved) smooth() ? light_vertices(at) : light_faces(at);
  }
  changes.geometry_kept();
  line_ = top;
  ready_ = true;
  return status;
}

// Whether the lines from `top` on follow those made last.
template <bool kTaps, Paint kPaint, bool kPlain>
bool MeshLines<kTaps, kPaint, kPlain>::goes_on(const SceneView& scene, const CameraRecord& camera,
                                               std::uint16_t top) const {
  return top != 0 && top == line_ && &scene.scene() == &scene_.scene() && same_camera(camera, camera_);
}

// Forgets the frame before. Apart, for the sake of the stack: what is called from begin() goes deepest.
template <bool kTaps, Paint kPaint, bool kPlain>
[[gnu::cold]] void MeshLines<kTaps, kPaint, kPlain>::clear(std::uint16_t top, std::int32_t farthest) {
  lights_.forget();
  if (smooth()) {
    smooth_faces_.count = 0;
    smooth_.clear();
    slots_[0] = 0;
    brush_ = SmoothBrush(smooth_.looks(), {&slots_[0]}, learn_look, this);
  }
  rows_.begin(scene_.scene(), camera_, screen_, farthest);
  walker_.begin(scene_.scene(), top);
  walker_.paint_with(&words_[0], &brush_);
}

// Makes it the scene to draw; fails where the edge walker cannot, or not with the pools it has.
template <bool kTaps, Paint kPaint, bool kPlain>
Status MeshLines<kTaps, kPaint, kPlain>::take(const SceneView& scene, const CameraRecord& camera) {
  scene_ = scene;
  camera_ = camera;
  if (kPaint != Paint::any && screen_.format != PixelFormat::rgb565) return bad_argument("screen", "format");
  std::uint32_t needed = 0, room = 0;
  const auto lacks = [&needed, &room](std::uint32_t of, std::uint32_t capacity) {
    needed = of;
    room = capacity;
    return of > capacity;
  };
  const char* const pool = smooth() && lacks(1, smooth_.on())                                            ? "looks"
                           : lacks(scene.vertex_count(), points_.capacity())                             ? "vertices"
                           : lacks(scene.face_count(), smooth() ? slots_.capacity() : words_.capacity()) ? "facets"
                           : lacks(1, walker_.edge_capacity())                                           ? "edges"
                           : smooth() && lacks(scene.vertex_count(), levels_.capacity())                 ? "levels"
                                                                                                         : nullptr;
  if (pool != nullptr) return pool_exhausted(pool, 0, needed, room);
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

// Sees to the look of a face, and that the brush knows it where it is smooth.
template <bool kTaps, Paint kPaint, bool kPlain>
void MeshLines<kTaps, kPaint, kPlain>::learn_look(void* self, FaceId face) {
  MeshLines& mesh = *static_cast<MeshLines*>(self);
  const auto make = [&mesh](FaceId f, FaceLook& to) { mesh.make_look(f, to); };
  const FaceLook& look = mesh.smooth_.look(face, mesh.slots_[face], make);
  if (look.smooth() && !mesh.brush_.knows(face, look)) mesh.dip(look.material);
}

// How a face looks in a smooth scene, where its word is not a colour.
template <bool kTaps, Paint kPaint, bool kPlain>
[[gnu::always_inline]] inline void MeshLines<kTaps, kPaint, kPlain>::make_look(FaceId face, FaceLook& look) {
  const SmoothFaces& of = smooth_faces_;
  if (std::uint32_t{face} - of.first >= of.count) [[unlikely]] {
    if (!turn_to(face, look)) return;
  }
  const std::uint32_t number = std::uint32_t{face} - of.first;
  const std::uint16_t* const corner = of.corners + 3 * number;
  const std::uint32_t a = corner[0], b = corner[1], c = corner[2];
  const BrightnessPlane plane =
      brightness_plane({of.points[a], of.points[b], of.points[c]}, {of.levels[a], of.levels[b], of.levels[c]});
  look.plane.at_zero = plane.at_zero;  // singly: as a whole they would go by way of the stack
  look.plane.right = plane.right;
  look.plane.down = plane.down;
  look.face = face;
  look.material = of.material;
  if ((plane.right | plane.down) != 0) [[likely]]
    return;
  dip(of.material);
  look = FaceLook::flat(brush_.colors()[BrightnessPlane::entry(plane.at_zero)], face);
}

// The face and its group become the faces at hand; false where they are flat, and look so.
template <bool kTaps, Paint kPaint, bool kPlain>
bool MeshLines<kTaps, kPaint, kPlain>::turn_to(FaceId face, FaceLook& flat) {
  InstanceCursor at(scene_.scene());
  at.to_face(face - 1u);
  const MeshRecord& mesh = at.mesh();
  const std::uint32_t mesh_face = face - 1u - at.first_face();
  const FaceGroup* group = mesh.groups.data();
  while (mesh_face - group->first_face >= group->face_count) ++group;
  const std::uint16_t number = material_of(at.instance(), *group);
  const MaterialRecord& material = scene_.scene().materials[number];
  if (!kPlain && material.shading != MaterialRecord::kGouraud) {
    flat = FaceLook::flat(flat_color(at, mesh_face, material), face);
    return false;
  }
  const std::uint32_t vertex = at.first_vertex() + 1;
  smooth_faces_ = {static_cast<FaceId>(at.first_face() + 1 + group->first_face),
                   group->face_count,
                   number,
                   mesh.corners.data() + 3u * group->first_face,
                   &points_[vertex],
                   &levels_[vertex]};
  return true;
}

// The colour of a face drawn flat.
template <bool kTaps, Paint kPaint, bool kPlain>
std::uint16_t MeshLines<kTaps, kPaint, kPlain>::flat_color(const InstanceCursor& at, std::uint32_t mesh_face,
                                                           const MaterialRecord& material) {
  const std::uint16_t first_corner = at.mesh().corners[3 * mesh_face];
  if constexpr (kPlain) {
    const LightRig::One light = lights(at).on(material);
    return lit_rgb565_wire(material.color, light.sum(facet_normal(at.mesh(), mesh_face, first_corner)));
  } else {
    const Rgb8 color = material.shading == MaterialRecord::kUnlit
                           ? material.color
                           : facet_color(at.mesh(), mesh_face, first_corner, material, lights(at), false);
    return flat_payload(format(), color);
  }
}

// Puts the instance's vertices on the screen. False where one lies out of the view, or fronts have become backs.
template <bool kTaps, Paint kPaint, bool kPlain>
bool MeshLines<kTaps, kPaint, kPlain>::project(const InstanceCursor& at) {
  const ClipMatrix matrix = compose(camera_, at.instance().transform, at.mesh());
  if (!matrix.fits()) return false;
  if constexpr (!kPlain) {  // of a plain scene its light asks
    if (is_mirrored(at.instance().transform)) return false;
  }
  rows_.hold(matrix);
  const Projection projection(camera_, screen_);
  const ClipRows to_clip(matrix);
  const auto& positions = at.mesh().positions;
  constexpr std::uint32_t kFew = 8;  // that are looked at sooner than the box
  if ((positions.size() <= kFew || !projection.well_inside(at.mesh().box, to_clip)) &&
      !projection.well_inside(positions, to_clip)) {
    return false;
  }
  projection.place(positions, to_clip, &points_[at.first_vertex() + 1]);
  walker_.vertices(at.first_vertex()).forget(positions.size());
  return true;
}

// Culls the instance's faces and marks the vertices of those that are left.
template <bool kTaps, Paint kPaint, bool kPlain>
void MeshLines<kTaps, kPaint, kPlain>::cull(const InstanceCursor& at) {
  const auto first = static_cast<FaceId>(at.first_face() + 1u);
  smooth() ? cull(at, slots_.cull(first)) : cull(at, words_.cull(first));
}

template <bool kTaps, Paint kPaint, bool kPlain>
template <typename Culled>
void MeshLines<kTaps, kPaint, kPlain>::cull(const InstanceCursor& at, Culled faces) {
  const ScreenXY* const points = &points_[at.first_vertex() + 1];
  VertexBuckets::Mesh vertices = walker_.vertices(at.first_vertex());
  const std::uint16_t* corner = at.mesh().corners.data();
  for (const std::uint16_t* const end = corner + 3u * at.mesh().face_count; corner != end; corner += 3) {
    const std::uint32_t a = corner[0], b = corner[1], c = corner[2];
    if (doubled_area_near(PackedXY(points[a]), PackedXY(points[b]), PackedXY(points[c])) >= 0) {
      faces.hide();
      continue;
    }
    faces.show();
    vertices.mark(a);
    vertices.mark(b);
    vertices.mark(c);
  }
}

// Gives the faces that are drawn their colours.
template <bool kTaps, Paint kPaint, bool kPlain>
void MeshLines<kTaps, kPaint, kPlain>::light_faces(const InstanceCursor& at) {
  const MeshRecord& mesh = at.mesh();
  const auto& rig = lights(at);
  const bool quick = kPlain || (rig.quick() && !mesh.face_normals.empty() && format() == PixelFormat::rgb565);
  const std::uint32_t before = at.first_face() + 1u;
  for (const FaceGroup& group : mesh.groups) {
    const MaterialRecord& material = scene_.scene().materials[material_of(at.instance(), group)];
    const auto first = static_cast<FaceId>(before + group.first_face);
    if (quick) {
      words_.color(
          first, group.face_count,
          [light = rig.on(material), color = material.color, normals = mesh.face_normals.data() + group.first_face](
              std::uint32_t face) { return lit_rgb565_wire(color, light.sum(normals[face])); });
    } else {
      words_.color(first, group.face_count,
                   [&](std::uint32_t face) { return flat_color(at, group.first_face + face, material); });
    }
  }
}

// Gives the vertices of faces that are drawn their brightness.
template <bool kTaps, Paint kPaint, bool kPlain>
void MeshLines<kTaps, kPaint, kPlain>::light_vertices(const InstanceCursor& at) {
  const MeshRecord& mesh = at.mesh();
  if (mesh.vertex_normals.empty()) return;
  const auto& rig = lights(at);
  const VertexBuckets::Mesh vertices = walker_.vertices(at.first_vertex());
  Brightness* const level = &levels_[at.first_vertex() + 1];
  const Normal10* const normal = mesh.vertex_normals.data();
  const auto each = [&](const auto& brightness) {
    for (std::uint32_t v = 0, count = mesh.positions.size(); v != count; ++v) {
      if (vertices.marked(v)) level[v] = brightness(normal[v]);
    }
  };
  if (kPlain || rig.single()) {
    each([one = rig.one()](const Normal10& n) { return LightRig::brightness(one.sum(n)); });
  } else if constexpr (!kPlain) {
    each([&rig](const Normal10& n) { return LightRig::brightness(rig.sum(n, false)); });
  }
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool MeshLines<kTaps, kPaint, kPlain>::next(std::uint16_t line, Painter& painter, const SpanTap& tap) {
  CHECK(ready_ && line == line_);
  words_[0] = painter.background();
  if (!kTaps && walker_.is_blank(line)) {
    Sink{*this, painter, tap, line}.blank();
    ++line_;
    return true;
  }
  if (!walker_.is_quiet(line)) {
    const bool room = smooth() ? walker_.start_edges(line, slots_.drawn()) : walker_.start_edges(line, words_.drawn());
    if (!room) return give_up(false);
  }
  if (paint() == Paint::smooth_words) brush_.begin_line(line, painter.background());
  if (!walker_.walk(line, Sink{*this, painter, tap, line}, Planes{*this})) return give_up(true);
  ++line_;
  return true;
}

template <bool kTaps, Paint kPaint, bool kPlain>
bool MeshLines<kTaps, kPaint, kPlain>::give_up(bool overlaps) {
  ready_ = false;
  overlaps_short_ = overlaps;
  return false;
}

template <bool kTaps, Paint kPaint, bool kPlain>
[[gnu::cold]] Status MeshLines<kTaps, kPaint, kPlain>::shortage() const {
  return walker_shortage(walker_, overlaps_short_, line_);
}

}  // namespace spanline
