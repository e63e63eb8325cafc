#include "core/frame/instance_points.hpp"

namespace spanline {

ClipMatrix InstancePoints::enter() {
  const MeshRecord& mesh = cursor_.mesh();
  const ClipMatrix matrix = compose(*camera_, cursor_.instance().transform, mesh);
  x_ = ClipRow(matrix, 0);
  y_ = ClipRow(matrix, 1);
  w_ = ClipRow(matrix, 2);
  positions_ = mesh.positions.data();
  faces_ = mesh.face_count;
  vertices_ = mesh.positions.size();
  return matrix;
}

bool InstancePoints::enter(const InstanceCursor& at, DepthRows& rows, bool& surely) {
  cursor_ = at;
  const ClipMatrix matrix = enter();
  if (matrix.mirrored || !matrix.fits()) return false;
  rows.hold(matrix);
  surely = projection_.holds(matrix);
  return true;
}

}  // namespace spanline
