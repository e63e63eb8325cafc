// The body of Frame; include it only where a Frame with options of one's own is instantiated.
#pragma once

#include "core/frame/frame.hpp"
#include "core/frame/mesh_frame_impl.hpp"

namespace spanline {

template <FrameOptions kOptions>
struct Frame<kOptions>::Sink {
  Painter& painter;
  const SpanTap& tap;
  Frame& frame;
  void span(const VisibleSpan& s) {
    if constexpr (kOptions.points) {
      if (frame.plots()) return span_among_points(frame.patches_, s);
    }
    whole_span(s);
  }
  // What of a span lies behind points is theirs.
  template <typename Points>
  void span_among_points(const Points& points, VisibleSpan s) {
    const auto point = [&](std::uint32_t x, std::uint16_t payload, std::uint16_t face, std::uint32_t depth) {
      VisibleSpan p;
      p.line = s.line;
      p.left = static_cast<std::uint16_t>(x);
      p.right = static_cast<std::uint16_t>(x + 1);
      p.face = face;
      p.payload = payload;
      p.depth = {depth << 13, 0};
      whole_span(p);
    };
    const auto rest = [&](std::uint32_t left, std::uint32_t right) {
      s.left = static_cast<std::uint16_t>(left);
      s.right = static_cast<std::uint16_t>(right);
      whole_span(s);
    };
    points.show(s.line, s.left, s.right, s.face != kNoFace, s.depth, point, rest);
  }
  void whole_span(const VisibleSpan& s) {
    if constexpr (kOptions.taps) {
      if (tap.span != nullptr) tap.span(tap.context, s);
    }
    if constexpr (kDices) {
      if (s.smooth && s.payload != 0) return smooth_facet(frame.patches_, s);
    }
    if (s.smooth) {
      const FaceLook& look = frame.smooth_.look(static_cast<FaceId>(s.face + 1), [this](FaceId face) {
        return frame.look_of(static_cast<std::uint16_t>(face - 1));
      });
      return painter.smooth(s.left, s.right, look.plane, frame.smooth_.colors(look.material, frame.scene_.scene()));
    }
    painter.span(s);
  }
  // Of a patch, whose facet the payload names.
  template <typename Patches>
  void smooth_facet(const Patches& patches, const VisibleSpan& s) {
    const SceneRecord& scene = frame.scene_.scene();
    const DicedFacet& facet = patches[s.payload];
    frame.reader_.select(s.face);
    const LightRig& rig = frame.lights();
    const bool flip = frame.shows_back(patches, facet);
    const BrightnessPlane plane =
        patches.plane(facet, [&](const Normal10& normal) { return rig.brightness(normal, flip); });
    painter.smooth(s.left, s.right, plane, frame.smooth_.colors(frame.reader_.face().material, scene));
  }
  void layers(const LayeredSpan& s) {
    if constexpr (kOptions.taps) {
      if (tap.layers != nullptr) tap.layers(tap.context, s);
    }
    painter.layers(s);
  }
};

template <FrameOptions kOptions>
Frame<kOptions>::Frame(const FrameStorage& storage)
    : screen_(storage.screen),
      facets_(storage.facets),
      buckets_(storage.buckets),
      cache_(storage.vertices),
      mesh_(storage),
      smooth_(storage.smooth, storage.screen.format),
      vsg_(storage.vsg, storage.screen, &reader_),
      painter_(storage.screen),
      curves_(storage.curves, storage.screen),
      fitting_(storage.screen.height),
      changes_(storage.changes, storage.screen) {
  if constexpr (kDices) patches_ = PatchSource(storage.patches, storage.screen);
  if constexpr (kOptions.points) patches_ = PointSource(storage.points, storage.screen);
}

template <FrameOptions kOptions>
bool Frame<kOptions>::same_frame(const SceneView& scene, const CameraRecord& camera, Band rest) const {
  return rest.top != 0 && rest.top == band_.bottom && &scene.scene() == &scene_.scene() && camera == camera_;
}

template <FrameOptions kOptions>
Band Frame<kOptions>::prepare(const SceneView& scene, const CameraRecord& camera, Band rest) {
  const bool again = same_frame(scene, camera, rest);
  if (rest.top == 0) {
    status_ = {};
    vsg_.clear_status();
    if constexpr (kOptions.statistics) vsg_.clear_statistics();
    if constexpr (kOptions.patches) patches_.clear_statistics();
    bands_ = most_facets_ = 0;
  }
  band_ = {};
  Status status = check_band(rest, screen_);
  if (status.ok() && !kOptions.patches && scene.has_patches()) {
    status = {Code::bad_argument, "FrameOptions", "patches (not set)", 0, 0, 0, 0};
  }
  if (status.ok() && !kOptions.layers && scene.layered()) {
    status = {Code::bad_argument, "FrameOptions", "layers (not set)", 0, 0, 0, 0};
  }
  if (status.ok()) status = check_camera(camera);
  if (!status.ok()) {
    note(status);
    return {};
  }
  if (rest.top == 0) changes_.begin_frame(scene, camera);
  rest = changes_.next(rest);
  if (rest.empty()) return rest;
  const bool had_segments = again && !has_mesh_lines();
  scene_ = scene;
  camera_ = camera;
  painter_.begin_lines(scene_.scene().background);
  if constexpr (kOptions.points) {
    if (scene_.has_patches() && !plots()) note_full("point_lines", 1, 0, rest.top);
  }
  begin_curves(rest);
  if constexpr (kOptions.walker == Walker::both) {
    if (!had_segments && mesh_.begin(scene_, camera_, rest.top, changes_).ok()) return band_ = rest;
  }
  if (!had_segments) read_vertices();
  band_ = {rest.top, plan(rest.top, rest.bottom)};
  return band_;
}

template <FrameOptions kOptions>
void Frame<kOptions>::begin_curves(Band rest) {
  note(curves_.begin(scene_, camera_, rest.top, rest.bottom));
}

template <FrameOptions kOptions>
void Frame<kOptions>::read_vertices() {
  lights_.forget();
  one_hue_ = LightHue::is_one(scene_.scene());
  smooth_.clear();
  reader_ = FacetReader(scene_, camera_, screen_, cache_);
  vertices_ = reader_.fill_cache();
}

// Where the edge walker gave up the segment walker goes on, from the line's beginning.
template <FrameOptions kOptions>
bool Frame<kOptions>::mesh_line(std::uint16_t line) {
  if constexpr (kOptions.walker == Walker::both) {
    if (!mesh_.ready()) return false;
    if (mesh_.next(line, painter_, tap_)) return true;
    read_vertices();
    plan(line, band_.bottom);
  }
  return false;
}

// Files the facets of the longest run of lines that begins at `top` and fits; returns its end. The longest that was
// known to fit, and twice that, is where the search begins; a run that was to be short says nothing of others.
template <FrameOptions kOptions>
std::uint16_t Frame<kOptions>::plan(std::uint16_t top, std::uint16_t bottom) {
  std::uint32_t lines = static_cast<std::uint32_t>(bottom - top);
  if (lines > 2u * fitting_) lines = 2u * fitting_;
  if (lines > buckets_.capacity()) lines = buckets_.capacity();
  if constexpr (kOptions.points) {
    if (plots() && lines > patches_.lines()) lines = patches_.lines();
  }
  const std::uint32_t tried = lines;
  while (!file_facets(top, static_cast<std::uint16_t>(top + lines))) lines /= 2;
  height_ = static_cast<std::uint16_t>(lines);
  if (lines != tried || lines > fitting_) fitting_ = height_;
  planned_ = static_cast<std::uint16_t>(top + lines);
  vsg_.begin_band(planned_);
  if constexpr (kOptions.points) {
    if (plots()) plot_points(patches_, top, planned_);
  }
  ++bands_;
  return planned_;
}

// False where the waiting facets do not fit and the band has lines to give up.
template <FrameOptions kOptions>
bool Frame<kOptions>::file_facets(std::uint16_t top, std::uint16_t bottom) {
  for (std::uint16_t i = 1; i <= bottom - top; ++i) buckets_[i] = 0;
  std::uint16_t count = 0;
  std::uint32_t refused = 0;
  for (std::uint16_t face = 0; face < scene_.face_count(); ++face) {
    if (file_facet(face, top, bottom, count)) continue;
    if (bottom - top > 1) return false;
    ++refused;
  }
  if (refused != 0) note_full("facets", facets_.capacity() + refused, facets_.capacity(), top);
  if constexpr (kDices) {
    if (!file_patches(patches_, top, bottom, count)) return false;
  }
  if (count > most_facets_) most_facets_ = count;
  return true;
}

// Dices the patches and files their facets behind those of polygons. False as file_facets().
template <FrameOptions kOptions>
template <typename Patches>
bool Frame<kOptions>::file_patches(Patches& patches, std::uint16_t top, std::uint16_t bottom, std::uint16_t& count) {
  polygons_filed_ = count;
  patches.begin_band(top, bottom);
  if (!scene_.has_patches()) return true;
  bool all = true;
  std::uint32_t refused = 0;
  for (std::uint16_t face = 0; face < scene_.face_count(); ++face) {
    reader_.select(face);
    if (!reader_.is_patch() || (reader_.instance().flags & InstanceRecord::kHidden) != 0) {
      face = reader_.last_face();
      continue;
    }
    const MaterialRecord& material = scene_.scene().materials[reader_.face().material];
    const bool two_sided = (reader_.instance().flags & InstanceRecord::kTwoSided) != 0;
    all = patches.dice(reader_, {&lights(), &material, screen_.format, keeps_normals(patches, material), two_sided}) &&
          all;
    if (!all && bottom - top > 1) return false;
    for (auto next = static_cast<std::uint16_t>(count - polygons_filed_ + 1); next <= patches.count(); ++next) {
      if (wait(face, patches.first_line(patches[next]), top, count)) continue;
      if (bottom - top > 1) return false;
      refused = patches.count() - next + 1u;
      break;
    }
  }
  if (refused != 0) note_full("facets", facets_.capacity() + refused, facets_.capacity(), top);
  if (!all) {
    const PatchSource::Shortage shortage = patches.shortage();
    note_full(shortage.pool, shortage.needed, shortage.limit, top);
  }
  return true;
}

// Nearer ones first, by slices of distance: pieces behind them are then not lit and stepped.
template <FrameOptions kOptions>
template <typename Points>
void Frame<kOptions>::plot_points(Points& points, std::uint16_t top, std::uint16_t bottom) {
  points.begin_band(top, bottom);
  std::int64_t nearest = INT32_MAX, farthest = INT32_MIN;
  each_patch([&](std::uint16_t) {
    const std::int32_t distance = Points::distance(reader_);
    nearest = distance < nearest ? distance : nearest;
    farthest = distance > farthest ? distance : farthest;
  });
  constexpr std::int64_t kSlices = 8;
  for (std::int64_t slice = 0; slice < kSlices; ++slice) {
    const std::int64_t first = nearest + (farthest + 1 - nearest) * slice / kSlices;
    const std::int64_t end = nearest + (farthest + 1 - nearest) * (slice + 1) / kSlices;
    each_patch([&](std::uint16_t face) {
      const std::int32_t distance = Points::distance(reader_);
      if (distance < first || distance >= end) return;
      const MaterialRecord& material = scene_.scene().materials[reader_.face().material];
      const bool two_sided = (reader_.instance().flags & InstanceRecord::kTwoSided) != 0;
      points.plot(reader_, face,
                  {&lights(), &material, screen_.format, material.shading == MaterialRecord::kGouraud, two_sided});
    });
  }
}

// Makes every patch that is drawn the reader's current face.
template <FrameOptions kOptions>
template <typename Use>
void Frame<kOptions>::each_patch(const Use& use) {
  for (std::uint16_t face = 0; face < scene_.face_count(); ++face) {
    reader_.select(face);
    if (!reader_.is_patch() || (reader_.instance().flags & InstanceRecord::kHidden) != 0) {
      face = reader_.last_face();
      continue;
    }
    use(face);
  }
}

template <FrameOptions kOptions>
bool Frame<kOptions>::file_facet(std::uint16_t face, std::uint16_t top, std::uint16_t bottom, std::uint16_t& count) {
  reader_.select(face);
  if (reader_.is_patch()) return true;
  const FacetExtent extent = reader_.extent();
  if (extent.empty() || extent.end_line <= top || extent.first_line >= bottom) return true;
  if (extent.right <= 0 || extent.left >= screen_.width) return true;
  return wait(face, extent.first_line, top, count);
}

// Files a facet under its first line in the band. False where there is no room.
template <FrameOptions kOptions>
bool Frame<kOptions>::wait(std::uint16_t face, std::int32_t first_line, std::uint16_t top, std::uint16_t& count) {
  if (count == facets_.capacity()) return false;
  const std::int32_t first = first_line > top ? first_line : top;
  std::uint16_t& bucket = buckets_[static_cast<std::uint32_t>(first - top + 1)];
  facets_[++count] = {bucket, face};
  bucket = count;
  return true;
}

template <FrameOptions kOptions>
bool Frame<kOptions>::next_line(Slice<std::uint8_t> out) {
  if (band_.empty()) return false;
  if (!takes_line(out, line_bytes())) {
    note(line_refused(out, line_bytes(), band_.top));
    return false;
  }
  const std::uint16_t line = band_.top;
  painter_.begin_line(line, out.data());
  if (mesh_line(line)) return end_line();
  if (line == planned_) plan(line, band_.bottom);
  vsg_.begin_line(line);
  // Where the edges of the facets alive do not fit, a run that ends sooner files fewer of them; a run of one line files
  // none.
  while (!begin_facets(line)) {
    fitting_ = static_cast<std::uint16_t>((planned_ - line + 1) / 4 + 1);
    plan(line, static_cast<std::uint16_t>(line + (planned_ - line) / 2));
  }
  Sink sink{painter_, tap_, *this};
  vsg_.run(line, sink);
  note(vsg_.status());
  return end_line();
}

// Draws what lies over the faces.
template <FrameOptions kOptions>
bool Frame<kOptions>::end_line() {
  note(curves_.draw(band_.top, painter_));
  if (status_.ok()) changes_.drawn(band_.top);
  ++band_.top;
  return true;
}

// Puts in the facets whose first line this is. False where the edge pool is full.
template <FrameOptions kOptions>
bool Frame<kOptions>::begin_facets(std::uint16_t line) {
  const auto bucket = static_cast<std::uint32_t>(line - (planned_ - height_) + 1);
  for (std::uint16_t at = buckets_[bucket]; at != 0; at = facets_[at].next) {
    Room room = Room::enough;
    if constexpr (kDices) {
      room = at <= polygons_filed_ ? begin_facet(facets_[at].face, line) : begin_patch_facet(patches_, at, line);
    } else {
      room = begin_facet(facets_[at].face, line);
    }
    if (room == Room::no_edges) return false;
  }
  return true;
}

template <FrameOptions kOptions>
template <typename Patches>
Room Frame<kOptions>::begin_patch_facet(const Patches& patches, std::uint16_t waiting, std::uint16_t line) {
  const std::uint16_t face = facets_[waiting].face;
  const auto index = static_cast<std::uint16_t>(waiting - polygons_filed_);
  const DicedFacet& facet = patches[index];
  const auto add = [&](const auto& look, const auto& colour) {
    return vsg_.add({face, facet.part}, false, line, look, [&](auto& sink) { patches.read(facet, colour, sink); });
  };
  reader_.select(face);
  const MaterialRecord& material = scene_.scene().materials[reader_.face().material];
  if (!keeps_normals(patches, material)) {
    const Rgb8 color = payload_color(screen_.format, facet.payload);
    return add(layered({facet.payload, false}, color, material), [](const Normal10&) { return Rgb8{}; });
  }
  const LightRig& rig = lights();
  if (Patches::has_plane(facet) && is_plain(material)) {
    return add(layered({index, false, true}, {}, material), [](const Normal10&) { return Rgb8{}; });
  }
  const bool flip = shows_back(patches, facet);
  return add(layered({0, true}, {}, material),
             [&](const Normal10& normal) { return rig.shade(normal, material, flip); });
}

// Whether the reader's current face shows its back in a facet of it.
template <FrameOptions kOptions>
template <typename Patches>
bool Frame<kOptions>::shows_back(const Patches& patches, const DicedFacet& facet) const {
  const bool two_sided = (reader_.instance().flags & InstanceRecord::kTwoSided) != 0;
  return two_sided && !patches.front(facet, reader_.mirrored());
}

// Whether brightness alone tells the colours of a Gouraud material; layers are made of colours along edges.
template <FrameOptions kOptions>
bool Frame<kOptions>::is_plain(const MaterialRecord& material) const {
  const bool alone = !kOptions.layers || !scene_.layered();
  return alone && smooth_.on() && one_hue_ && material.reach == MaterialRecord::kAllLight;
}

template <FrameOptions kOptions>
Room Frame<kOptions>::begin_facet(std::uint16_t face, std::uint16_t line) {
  reader_.select(face);
  const MeshRecord& mesh = reader_.mesh();
  const MaterialRecord& material = scene_.scene().materials[reader_.face().material];
  const bool two_sided = (reader_.instance().flags & InstanceRecord::kTwoSided) != 0;
  const bool flip = two_sided && !reader_.extent().front();
  const bool curved = reader_.face().curved;
  if (material.shading == MaterialRecord::kGouraud && vsg_.has_colours() && !curved) {
    const LightRig& rig = lights();
    if (is_plain(material) && reader_.face().corners.size() == 3 && !reader_.clipped()) {
      return vsg_.add(face, line, layered({.smooth = true}, {}, material), [](std::uint16_t) { return Rgb8{}; });
    }
    const auto colour = [&](std::uint16_t corner) { return rig.shade(mesh.vertex_normals[corner], material, flip); };
    return vsg_.add(face, line, layered({0, true}, {}, material), colour);
  }
  Rgb8 color = material.color;
  if (material.shading != MaterialRecord::kUnlit) {
    // Without room for colours a Gouraud facet is flat; where the mesh has no face normals its first corner's serves.
    const FaceRef& ref = reader_.face();
    const Normal10& normal =
        mesh.face_normals.empty() ? mesh.vertex_normals[ref.corners[0]] : mesh.face_normals[ref.mesh_face];
    color = lights().shade(normal, material, flip);
  }
  const auto look = layered({flat_payload(screen_.format, color), false}, color, material);
  if (curved) return begin_outline(face, line, look);
  return vsg_.add(face, line, look, [](std::uint16_t) { return Rgb8{}; });
}

template <FrameOptions kOptions>
Room Frame<kOptions>::begin_outline(std::uint16_t face, std::uint16_t line,
                                    const typename VisibleSegments<kOptions>::Look& look) {
  const OutlineReader outline(reader_, screen_);
  return vsg_.add({face}, false, line, look, [&](auto& sink) { outline.read(sink); });
}

// Of the reader's current facet.
template <FrameOptions kOptions>
typename VisibleSegments<kOptions>::Look Frame<kOptions>::layered(const FacetLook& look, const Rgb8& color,
                                                                  const MaterialRecord& material) const {
  if constexpr (kOptions.layers) {
    return {look, {color, material.transmission, reader_.parent()}};
  } else {
    return look;
  }
}

// The look of a smooth triangle.
template <FrameOptions kOptions>
FaceLook Frame<kOptions>::look_of(std::uint16_t face) {
  struct Corners {
    ScreenXY at[3];
    unsigned count = 0;
    void begin_contour() {}
    void vertex(const FacetVertex& v) { at[count++] = v.at; }
    void end_contour() {}
  } corners;
  reader_.select(face);
  reader_.read([](std::uint16_t) { return Rgb8{}; }, corners);
  const bool two_sided = (reader_.instance().flags & InstanceRecord::kTwoSided) != 0;
  const bool flip = two_sided && !reader_.extent().front();
  const LightRig& rig = lights();
  Brightness level[3];
  for (unsigned i = 0; i < 3; ++i) {
    level[i] = rig.brightness(reader_.mesh().vertex_normals[reader_.face().corners[i]], flip);
  }
  return {brightness_plane(corners.at, level), 0, reader_.face().material};
}

}  // namespace spanline
