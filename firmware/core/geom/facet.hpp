// Facets: the faces of a scene as polygons on the screen, read from the records in place. This is what the visible
// segment generator consumes, and the hook that the tests' oracle starts from.
#pragma once

#include <cstdint>

#include "core/base/pool.hpp"
#include "core/geom/clip.hpp"
#include "core/geom/projection.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline {

// A corner of a facet after projection and clipping.
struct FacetVertex {
  ScreenXY at;          // 28.4 px
  std::uint32_t depth;  // Q16.8, larger is nearer
  Rgb8 color;           // what the reader's colour function gave
};

// Where a face's records lie.
struct FaceRef {
  Slice<const std::uint16_t> corners;
  Slice<const std::uint16_t> contours;  // ring lengths; empty: one ring
  std::uint16_t mesh_face = 0;
  std::uint16_t material = 0;
  bool curved = false;              // FaceGroup::kCurved: corners are control points
  std::uint8_t outside_any = 0;     // planes (Outcode) that some corner lies outside of
  std::uint8_t outside_all = 0xff;  // planes that all of them do
};

// What the first look at a facet yields.
struct FacetExtent {
  std::int32_t first_line = 0;             // of the screen, not clipped to it
  std::int32_t end_line = 0;               // one past the last
  std::int32_t left = 0;                   // first column that can be covered
  std::int32_t right = 0;                  // one past the last
  std::int64_t area = 0;                   // doubled, signed, 28.4 squared; y points down, so fronts have it negative
  bool front() const { return area < 0; }  // counter-clockwise in the world
  bool empty() const { return first_line >= end_line || left >= right; }
};

// Reads faces by number. Keeps the matrices of the instance that was read last, so reading in order is cheap.
class FacetReader {
 public:
  FacetReader() = default;
  // `cache` may hold fewer vertices than the scene; the rest are projected at each use.
  FacetReader(const SceneView& scene, const CameraRecord& camera, const Screen& screen, PoolRef<ScreenPoint> cache);

  // Projects the vertices that the cache holds, control points of patches excepted. Returns how many.
  std::uint16_t fill_cache();

  // Makes `face` (below SceneView::face_count) current.
  void select(std::uint16_t face);
  const FaceRef& face() const { return face_; }
  const InstanceRecord& instance() const { return scene_->instances[instance_]; }
  std::uint16_t instance_index() const { return instance_; }
  const MeshRecord& mesh() const { return scene_->meshes[instance().mesh]; }
  // The last face of the current instance.
  std::uint16_t last_face() const { return static_cast<std::uint16_t>(first_face_ + mesh().face_count - 1); }
  const CameraRecord& camera() const { return *camera_; }
  const Projection& projection() const { return projection_; }
  const ClipMatrix& matrix() const { return matrix_; }
  bool mirrored() const { return !on_screen() && mirrored_; }
  bool on_screen() const { return (instance().flags & InstanceRecord::kScreen) != 0; }
  // The face that the current one is surface detail of; kNoFace where it is none.
  std::uint16_t parent() const {
    const std::uint32_t first_detail = mesh().face_count - mesh().parents.size();
    if (face_.mesh_face < first_detail) return kNoFace;
    return static_cast<std::uint16_t>(first_face_ + mesh().parents[face_.mesh_face - first_detail]);
  }

  // Whether the current face is a patch. Then there is nothing of it to read but this: its control points in clip
  // space, four rows of four.
  bool is_patch() const { return mesh().of_patches(); }
  ClipPoint control_point(std::uint32_t index) const { return clip_point(face_.corners[index]); }
  void control_points(ClipPoint (&out)[4][4]) const;

  // Whether the current face crosses a plane of the view, so that read() hands out other corners than its own.
  bool clipped() const { return face_.outside_any != 0; }

  // Extent and facing of the current face after clipping; an empty extent where nothing of it can be seen. The outline
  // of a curved face may cover less of it.
  FacetExtent extent();

  // Hands the current face's contours to the sink after clipping: begin_contour(), vertex(const FacetVertex&) in order,
  // end_contour(). Of a curved face these are its control polygons. `colour` maps a position index to the Rgb8 of that
  // corner; clipped corners get what lies between.
  template <typename Colour, typename Sink>
  void read(const Colour& colour, Sink& sink);

 private:
  void note_outcodes();
  FacetExtent triangle_extent() const;
  FacetVertex project_clipped(const ClipVertex& v) const;
  template <typename Colour, typename Sink>
  [[gnu::noinline]]  // keeps the clipper's 500 bytes off the stack of the common path
  void
  read_clipped(std::uint32_t begin, std::uint32_t end, std::uint8_t planes, const Colour& colour, Sink& sink);

  void enter_instance(std::uint16_t instance, std::uint16_t first_face, std::uint16_t first_vertex);
  void locate(std::uint16_t mesh_face);
  static std::uint32_t vertices_of(const MeshRecord& mesh) { return mesh.of_patches() ? 0 : mesh.positions.size(); }
  ClipPoint clip_point(std::uint16_t vertex) const { return matrix_(mesh().positions[vertex]); }
  ScreenPoint compute(std::uint16_t vertex) const;
  ScreenPoint point(std::uint16_t vertex) const {
    const std::uint32_t global = std::uint32_t{first_vertex_} + vertex;
    return global < cached_ ? cache_[global + 1] : compute(vertex);
  }

  const SceneRecord* scene_ = nullptr;
  const SceneView* view_ = nullptr;
  const CameraRecord* camera_ = nullptr;
  Projection projection_{CameraRecord{}, Screen{}};
  PoolRef<ScreenPoint> cache_;
  std::uint32_t cached_ = 0;
  ClipMatrix matrix_{};
  bool fits_ = false;      // matrix_.fits()
  bool mirrored_ = false;  // is_mirrored()
  std::uint16_t instance_ = 0;
  std::uint16_t first_face_ = 0;    // of the current instance, over the scene
  std::uint16_t first_vertex_ = 0;  // likewise, control points not counted
  std::uint16_t group_ = 0;
  FaceRef face_;
};

template <typename Colour, typename Sink>
void FacetReader::read(const Colour& colour, Sink& sink) {
  if (face_.outside_all != 0) return;
  const std::uint32_t rings = face_.contours.empty() ? 1 : face_.contours.size();
  std::uint32_t next = 0;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const std::uint32_t end = face_.contours.empty() ? face_.corners.size() : next + face_.contours[ring];
    sink.begin_contour();
    if (face_.outside_any == 0) {
      for (; next < end; ++next) {
        const std::uint16_t corner = face_.corners[next];
        const ScreenPoint p = point(corner);
        sink.vertex(FacetVertex{p.at, p.depth, colour(corner)});
      }
    } else {
      read_clipped(next, end, face_.outside_any, colour, sink);
      next = end;
    }
    sink.end_contour();
  }
}

template <typename Colour, typename Sink>
void FacetReader::read_clipped(std::uint32_t begin, std::uint32_t end, std::uint8_t planes, const Colour& colour,
                               Sink& sink) {
  ContourClipper clipper(projection_, planes);
  ClipVertex out;
  for (std::uint32_t i = begin; i <= end; ++i) {
    if (i < end) {
      const std::uint16_t corner = face_.corners[i];
      clipper.feed({clip_point(corner), colour(corner)});
    } else {
      clipper.finish();
    }
    while (clipper.next(out)) sink.vertex(project_clipped(out));
  }
}

}  // namespace spanline
