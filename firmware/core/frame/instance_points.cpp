#include "core/frame/instance_points.hpp"

namespace spanline {

ClipMatrix InstancePoints::enter() {
  const MeshRecord& mesh = cursor_.mesh();
  const ClipMatrix matrix = compose(*camera_, cursor_.instance().transform, mesh);
  points_.to_clip = ClipRows(matrix);
  points_.positions = mesh.positions.data();
  faces_ = mesh.face_count;
  vertices_ = mesh.positions.size();
  return matrix;
}

bool InstancePoints::enter(const InstanceCursor& at, DepthRows& rows, bool& surely) {
  cursor_ = at;
  const ClipMatrix matrix = enter();
  if (is_mirrored(at.instance().transform) || !matrix.fits()) return false;
  rows.hold(matrix);
  surely = points_.projection.well_inside(mesh().box, points_.to_clip);
  return true;
}

}  // namespace spanline
