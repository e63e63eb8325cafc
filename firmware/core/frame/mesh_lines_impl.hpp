// The body of MeshLines; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/facet_color.hpp"
#include "core/frame/mesh_lines.hpp"
#include "core/shade/fill_words.hpp"

namespace spanline {

template <bool kTaps>
template <bool kWide>
struct MeshLines<kTaps>::Sink {
  Painter& painter;
  std::uint8_t* out;
  FaceWords& words;
  const SpanTap& tap;
  MeshLines& mesh;
  std::uint16_t line;

  void one(std::int32_t left, std::int32_t right, FaceId face) {
    if constexpr (kTaps) {
      DepthRamp ramp;
      if (face != 0) {
        const DepthPlane plane = mesh.rows_.plane(face - 1u, mesh.points_);
        ramp = {plane.ramp.at_zero + plane.down * line, plane.ramp.slope};
      }
      report(left, right, face, ramp);
    }
    fill(left, right, face);
  }
  void front(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) {
    if constexpr (kTaps) report(left, right, face, ramp);
    fill(left, right, face);
  }
  void fill(std::int32_t left, std::int32_t right, FaceId face) {
    const auto from = static_cast<std::uint32_t>(left), to = static_cast<std::uint32_t>(right);
    if constexpr (kWide) {
      fill_span(out, from, to, words[face]);
    } else {
      painter.fill(from, to, words[face]);
    }
  }
  void report(std::int32_t left, std::int32_t right, FaceId face, const DepthRamp& ramp) {
    if (tap.span == nullptr) return;
    VisibleSpan span;
    span.line = line;
    span.left = static_cast<std::uint16_t>(left);
    span.right = static_cast<std::uint16_t>(right);
    span.face = static_cast<std::uint16_t>(face - 1);
    span.payload = words[face];
    span.depth = ramp;
    tap.span(tap.context, span);
  }
};

template <bool kTaps>
MeshLines<kTaps>::MeshLines(const MeshStorage& storage, const Screen& screen)
    : screen_(screen),
      gouraud_(storage.gouraud),
      points_(storage.walker.points),
      words_(storage.faces),
      walker_(storage.walker, screen) {}

template <bool kTaps>
Status MeshLines<kTaps>::begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top) {
  if (ready_ && top != 0 && top == line_ && &scene.scene() == &scene_.scene() && camera == camera_) return {};
  ready_ = false;
  scene_ = scene;
  camera_ = camera;
  if (const Status status = check(scene); !status.ok()) return status;
  rows_ = DepthRows(scene_.scene(), camera_, screen_);
  walker_.begin(scene_.scene(), top);
  for (InstanceCursor at(scene_.scene()); !at.at_end(); at.next()) {
    if ((at.instance().flags & InstanceRecord::kHidden) != 0) continue;  // no edge leads to its faces
    if (!project(at)) return {Code::bad_record, "InstanceRecord", "transform (beyond the view)", at.index()};
    light(at);
  }
  line_ = top;
  ready_ = true;
  return {};
}

// What the edge walker cannot draw, or not with the pools it has.
template <bool kTaps>
Status MeshLines<kTaps>::check(const SceneView& scene) const {
  const auto short_of = [](const char* pool, std::uint32_t needed, std::uint32_t capacity) {
    return Status{Code::pool_exhausted, pool, "", 0, 0, needed, capacity};
  };
  if (scene.vertex_count() > points_.capacity()) return short_of("vertices", scene.vertex_count(), points_.capacity());
  if (scene.face_count() > words_.capacity()) return short_of("facets", scene.face_count(), words_.capacity());
  for (InstanceCursor at(scene.scene()); !at.at_end(); at.next()) {
    const std::uint16_t flags = at.instance().flags;
    if ((flags & InstanceRecord::kHidden) != 0) continue;
    if ((flags & (InstanceRecord::kTwoSided | InstanceRecord::kScreen)) != 0) {
      return {Code::bad_record, "InstanceRecord", "flags", at.index(), 0, flags};
    }
    if (at.mesh().fans.empty()) return {Code::bad_record, "MeshRecord", "fans", at.instance().mesh};
    if (gouraud_ && is_gouraud(at)) return {Code::bad_record, "MaterialRecord", "shading", at.index()};
  }
  return {};
}

template <bool kTaps>
bool MeshLines<kTaps>::is_gouraud(const InstanceCursor& at) const {
  const Slice<const MaterialRecord>& materials = scene_.scene().materials;
  for (const FaceGroup& group : at.mesh().groups) {
    const bool own = at.instance().material == InstanceRecord::kOwnMaterials;
    if (materials[own ? group.material : at.instance().material].shading == MaterialRecord::kGouraud) return true;
  }
  return false;
}

// Puts the instance's vertices on the screen. False where one lies out of the view, or fronts have become backs.
template <bool kTaps>
bool MeshLines<kTaps>::project(const InstanceCursor& at) {
  const ClipMatrix matrix = compose(camera_, at.instance().transform, at.mesh());
  if (matrix.mirrored) return false;
  const Projection projection(camera_, screen_);
  std::uint32_t vertex = at.first_vertex();
  for (const Position& position : at.mesh().positions) {
    const ClipPoint clip = matrix(position);
    if (projection.outcode(clip) != 0) return false;
    points_[vertex + 1] = projection(clip).at;
    walker_.forget(vertex++);
  }
  return true;
}

// Culls the instance's faces, lights those that are left and files their vertices.
template <bool kTaps>
void MeshLines<kTaps>::light(const InstanceCursor& at) {
  const MeshRecord& mesh = at.mesh();
  const LightRig rig(scene_.scene(), at.instance().transform);
  auto id = static_cast<FaceId>(at.first_face());
  const std::uint16_t* corner = mesh.corners.data();
  for (const FaceGroup& group : mesh.groups) {
    const bool own = at.instance().material == InstanceRecord::kOwnMaterials;
    const MaterialRecord& material = scene_.scene().materials[own ? group.material : at.instance().material];
    for (std::uint32_t i = 0; i < group.face_count; ++i, corner += 3) {
      const std::uint32_t vertex[3] = {at.first_vertex() + corner[0], at.first_vertex() + corner[1],
                                       at.first_vertex() + corner[2]};
      ++id;
      if (!is_front(points_[vertex[0] + 1], points_[vertex[1] + 1], points_[vertex[2] + 1])) {
        words_.hide(id);
        continue;
      }
      const Rgb8 color = material.shading == MaterialRecord::kUnlit
                             ? material.color
                             : facet_color(mesh, group.first_face + i, corner[0], material, rig, false);
      words_.set(id, flat_payload(screen_.format, color));
      for (const std::uint32_t v : vertex) walker_.file(v);
    }
  }
}

template <bool kTaps>
Status MeshLines<kTaps>::next(std::uint16_t line, Painter& painter, const SpanTap& tap) {
  CHECK(ready_ && line == line_);
  ready_ = false;
  if (!walker_.start_edges(line, [this](FaceId face) { return words_.drawn(face); })) {
    const std::uint32_t capacity = walker_.edge_capacity();
    return {Code::pool_exhausted, "edges", "", 0, line, capacity + 1, capacity};
  }
  words_[0] = painter.background();
  const auto plane = [this](FaceId face) { return rows_.plane(face - 1u, points_); };
  const auto walk = [&]<bool kWide>(Sink<kWide> sink) { return walker_.walk(line, sink, plane); };
  const bool wide = screen_.format == PixelFormat::rgb565 && screen_.width % 2 == 0;
  if (!(wide ? walk(Sink<true>{painter, painter.out(), words_, tap, *this, line})
             : walk(Sink<false>{painter, painter.out(), words_, tap, *this, line}))) {
    return {Code::pool_exhausted, "overlaps", "", 0, line, OverlapSet::kMost + 1, OverlapSet::kMost};
  }
  ready_ = true;
  ++line_;
  return {};
}

}  // namespace spanline
