#include "core/vsg/edge_walker.hpp"

namespace spanline {

void EdgeWalker::begin(const SceneRecord& scene, std::int32_t top) {
  cursor_ = InstanceCursor(scene);
  buckets_.clear(top, screen_.height);
  begin();
}

void EdgeWalker::begin() {
  planes_.clear();
  alive_ = most_ = 0;
}

// Begins a tall edge again on `line`; false where it has ended, and for every other edge. Of the face that it begins
// or ends the edge is the left or right one.
bool EdgeWalker::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  const bool left = edge.ending() == 0;
  const std::uint32_t face = (left ? edge.beginning() : edge.ending()) - 1u;
  cursor_.to_face(face);
  const std::uint16_t* const corner = cursor_.mesh().corners.data() + 3 * (face - cursor_.first_face());
  const auto point = [&](unsigned i) { return points_[cursor_.first_vertex() + corner[i % 3] + 1]; };
  for (unsigned i = 0; i < 3; ++i) {
    ScreenXY top = point(i), bottom = point(i + 1);
    if (top.y > bottom.y) std::swap(top, bottom);
    // One that begins on this very line comes from its own vertex.
    if (first_centre(top.y) >= line || first_centre(bottom.y) <= line) continue;
    const ScreenXY third = point(i + 2);
    const std::int32_t side = (bottom.x - top.x) * (third.y - top.y) - (bottom.y - top.y) * (third.x - top.x);
    if ((side < 0) != left) continue;
    const EdgeRun run = start_run(top, bottom, line);
    edge.x = run.x;
    edge.dx = run.dx;
    edge.rest += static_cast<std::uint32_t>(run.lines - 1) * ActiveEdge::kOneLine;
    return true;
  }
  return false;
}

}  // namespace spanline
