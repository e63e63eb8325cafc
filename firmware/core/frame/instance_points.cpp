#include "core/frame/instance_points.hpp"

#include <new>

namespace spanline {

void InstancePoints::begin(const SceneRecord& scene, const CameraRecord& camera, const Screen& screen) {
  camera_ = camera;
  for (std::uint32_t i = 0; i <= kept_.capacity(); ++i) {
    BandInstance& instance = kept_[i];
    instance.cursor = InstanceCursor(scene);
    instance.points.projection = Projection(camera, screen);
  }
  forget();
  farthest_ = 0;
  up_ = -1;
}

void InstancePoints::forget() {
  for (std::uint32_t i = 0; i <= kept_.capacity(); ++i) kept_[i].faces = kept_[i].vertices = 0;
}

// The rough rows of all instances are of the same unit.
void InstancePoints::hold(const ClipMatrix& matrix) {
  const auto farthest = static_cast<std::int32_t>(matrix.farthest(2));
  if (farthest <= farthest_) return;
  farthest_ = farthest;
  const int up = RoughRow::most_up(farthest);
  if (up == up_) return;
  up_ = up;
  near_ = (at_->points.projection.near_w << up) >> 15;
  forget();
}

// The instance at the cursor at hand; false where its positions do not fit.
bool InstancePoints::make() {
  const MeshRecord& mesh = at_->cursor.mesh();
  const ClipMatrix matrix = compose(camera_, at_->cursor.instance().transform, mesh);
  if (!matrix.fits()) return false;
  hold(matrix);
  new (&at_->points.to_clip) ClipRows(matrix);  // in their places, not copied there
  new (&at_->rough) RoughRow(matrix, 2, up_);
  at_->points.positions = mesh.positions.data();
  at_->faces = mesh.face_count;
  at_->vertices = mesh.positions.size();
  return true;
}

void InstancePoints::to_next() {
  at_ = at_ == kept_.sink() + kept_.capacity() ? kept_.sink() : at_ + 1;
  at_->faces = at_->vertices = 0;
}

// The cursor is not the caller's, whose stack is under all that is made.
bool InstancePoints::to_drawn(bool first) {
  InstanceCursor at = at_->cursor;
  if (!first) at.next();
  while (!at.at_end() && (at.instance().flags & InstanceRecord::kHidden) != 0) at.next();
  if (at.at_end()) return false;
  to_next();
  at_->cursor = at;
  return true;
}

bool InstancePoints::enter(bool& surely) {
  if (is_mirrored(instance().transform) || !make()) return false;
  surely = at_->points.projection.well_inside(mesh().box, at_->points.to_clip);
  return true;
}

// To one that is kept and holds(instance).
template <typename Holds>
bool InstancePoints::turn_back(const Holds& holds) {
  for (std::uint32_t i = 0; i <= kept_.capacity(); ++i) {
    if (!holds(kept_[i])) continue;
    at_ = &kept_[i];
    return true;
  }
  return false;
}

void InstancePoints::find_face(std::uint32_t face) {
  if (turn_back([face](const BandInstance& of) { return face - of.cursor.first_face() < of.faces; })) return;
  to_next();
  at_->cursor.to_face(face);
  make();
}

void InstancePoints::find_vertex(std::uint32_t vertex) {
  if (turn_back([vertex](const BandInstance& of) { return vertex - of.cursor.first_vertex() < of.vertices; })) return;
  to_next();
  at_->cursor.to_vertex(vertex);
  make();
}

DepthPlane InstancePoints::plane(std::uint32_t face, const ScreenXY (&corners)[3], const Screen& screen) {
  BandInstance& at = *at_;
  return corner_plane(at.corners_of(face), at.positions(), at.points.to_clip.ahead(), at.points.projection,
                      at.points.normaliser, screen, [&corners](std::uint32_t, int i) { return corners[i]; });
}

}  // namespace spanline
