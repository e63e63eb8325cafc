#include "core/geom/facet.hpp"

namespace spanline {

namespace {

// Bounds and doubled signed area, over all contours.
class ExtentSink {
 public:
  void begin_contour() { any_ = false; }
  void vertex(const FacetVertex& v) {
    if (any_) {
      add_edge(previous_, v.at);
    } else {
      first_ = v.at;
      any_ = true;
    }
    previous_ = v.at;
    widen(v.at);
  }
  void end_contour() {
    if (any_) add_edge(previous_, first_);
  }

  FacetExtent extent() const {
    FacetExtent e;
    if (low_.x > high_.x) return e;
    e.first_line = first_centre(low_.y);
    e.end_line = first_centre(high_.y);
    e.left = first_centre(low_.x);
    e.right = first_centre(high_.x);
    e.area = area_;
    return e;
  }

 private:
  void add_edge(ScreenXY a, ScreenXY b) { area_ += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y; }
  void widen(ScreenXY p) {
    if (p.x < low_.x) low_.x = p.x;
    if (p.y < low_.y) low_.y = p.y;
    if (p.x > high_.x) high_.x = p.x;
    if (p.y > high_.y) high_.y = p.y;
  }

  ScreenXY first_, previous_, low_{INT16_MAX, INT16_MAX}, high_{INT16_MIN, INT16_MIN};
  std::int64_t area_ = 0;
  bool any_ = false;
};

}  // namespace

FacetReader::FacetReader(const SceneView& scene, const CameraRecord& camera, const Screen& screen,
                         PoolRef<ScreenPoint> cache)
    : scene_(&scene.scene()), view_(&scene), camera_(&camera), projection_(camera, screen), cache_(cache) {
  if (!scene_->instances.empty()) enter_instance(0, 0, 0);
}

void FacetReader::enter_instance(std::uint16_t instance, std::uint16_t first_face, std::uint16_t first_vertex) {
  instance_ = instance;
  first_face_ = first_face;
  first_vertex_ = first_vertex;
  group_ = 0;
  if (on_screen()) return;
  matrix_ = compose(*camera_, this->instance().transform, mesh());
  fits_ = matrix_.fits();
  mirrored_ = is_mirrored(this->instance().transform);
}

void FacetReader::control_points(ClipPoint (&out)[4][4]) const {
  const Position* const positions = mesh().positions.data();
  const std::uint16_t* corner = face_.corners.data();
  const auto take = [&](const auto& to_clip) {
    for (ClipPoint* p = &out[0][0]; p != &out[0][0] + 16; ++p) *p = to_clip(positions[*corner++]);
  };
  if (fits_) {
    take(ClipRows(matrix_));
  } else {
    take(matrix_);
  }
}

ScreenPoint FacetReader::compute(std::uint16_t vertex) const {
  const Position& p = mesh().positions[vertex];
  ScreenPoint out;
  if (on_screen()) {
    out.at = {p.x, p.y};
    out.depth = static_cast<std::uint32_t>((p.z + 32768) << (kDepthBits - 16)) & 0xffffffu;
    out.outcode = 0;
    return out;
  }
  const ClipPoint clip = matrix_(p);
  const std::uint8_t code = projection_.outcode(clip);
  if (code == 0) return projection_(clip);
  out.depth = 0;
  out.outcode = code;
  return out;
}

std::uint16_t FacetReader::fill_cache() {
  cached_ = 0;
  std::uint32_t filled = 0;
  std::uint32_t first_face = 0;
  for (std::uint32_t i = 0; i < scene_->instances.size(); ++i) {
    const std::uint32_t first_vertex = filled;
    enter_instance(static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(first_face),
                   static_cast<std::uint16_t>(first_vertex));
    const std::uint32_t count = vertices_of(mesh());
    for (std::uint16_t v = 0; v < count && filled < cache_.capacity(); ++v) cache_[++filled] = compute(v);
    if (filled == cache_.capacity()) break;
    first_face += mesh().face_count;
  }
  if (!scene_->instances.empty()) enter_instance(0, 0, 0);
  cached_ = filled;
  return static_cast<std::uint16_t>(filled);
}

void FacetReader::select(std::uint16_t face) {
  CHECK(face < view_->face_count());
  if (face < first_face_) enter_instance(0, 0, 0);
  if (face - first_face_ >= mesh().face_count) {
    std::uint32_t first_face = first_face_, first_vertex = first_vertex_;
    std::uint16_t i = instance_;
    while (face - first_face >= scene_->meshes[scene_->instances[i].mesh].face_count) {
      const MeshRecord& passed = scene_->meshes[scene_->instances[i].mesh];
      first_face += passed.face_count;
      first_vertex += vertices_of(passed);
      ++i;
    }
    enter_instance(i, static_cast<std::uint16_t>(first_face), static_cast<std::uint16_t>(first_vertex));
  }
  locate(static_cast<std::uint16_t>(face - first_face_));
}

void FacetReader::locate(std::uint16_t mesh_face) {
  const Slice<const FaceGroup>& groups = mesh().groups;
  while (mesh_face < groups[group_].first_face) --group_;
  while (mesh_face - groups[group_].first_face >= groups[group_].face_count) ++group_;
  const FaceGroup& group = groups[group_];
  const std::uint32_t index = mesh_face - std::uint32_t{group.first_face};
  face_.corners = {mesh().corners.data() + group.first_corner + index * group.corners_per_face, group.corners_per_face};
  face_.contours = {};
  if (group.rings() > 1) face_.contours = {mesh().contours.data() + group.first_contour, group.rings()};
  face_.curved = group.curved();
  face_.mesh_face = mesh_face;
  face_.material = instance().material == InstanceRecord::kOwnMaterials ? group.material : instance().material;
  if (!is_patch()) note_outcodes();
}

void FacetReader::note_outcodes() {
  face_.outside_any = 0;
  face_.outside_all = 0xff;
  for (const std::uint16_t corner : face_.corners) {
    const auto code = static_cast<std::uint8_t>(point(corner).outcode);
    face_.outside_any |= code;
    face_.outside_all &= code;
  }
}

FacetVertex FacetReader::project_clipped(const ClipVertex& v) const {
  const ScreenPoint s = projection_.clamped(v.at);
  return {s.at, s.depth, v.color};
}

FacetExtent FacetReader::extent() {
  if ((instance().flags & InstanceRecord::kHidden) != 0 || face_.outside_all != 0) return {};
  const bool culls = !on_screen() && (instance().flags & InstanceRecord::kTwoSided) == 0;
  FacetExtent e;
  if (face_.corners.size() == 3 && !clipped()) {
    e = triangle_extent();
  } else {
    ExtentSink sink;
    read([](std::uint16_t) { return Rgb8{}; }, sink);
    e = sink.extent();
    // A curve stays within its control points, but not within what clipping leaves of the polygon between them.
    if (face_.curved && clipped()) e = {0, kMaxExtent, 0, kMaxExtent, e.area};
  }
  if (mirrored()) e.area = -e.area;
  return culls && !e.front() ? FacetExtent{} : e;
}

// What ExtentSink would find.
FacetExtent FacetReader::triangle_extent() const {
  const ScreenXY a = point(face_.corners[0]).at, b = point(face_.corners[1]).at, c = point(face_.corners[2]).at;
  FacetExtent e;
  e.area = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
  const auto low = [](std::int32_t p, std::int32_t q) { return p < q ? p : q; };
  const auto high = [](std::int32_t p, std::int32_t q) { return p < q ? q : p; };
  e.first_line = first_centre(low(low(a.y, b.y), c.y));
  e.end_line = first_centre(high(high(a.y, b.y), c.y));
  e.left = first_centre(low(low(a.x, b.x), c.x));
  e.right = first_centre(high(high(a.x, b.x), c.x));
  return e;
}

}  // namespace spanline
