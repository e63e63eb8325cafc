#include "core/vsg/mesh_walker.hpp"

namespace spanline {

void MeshWalker::begin(const SceneRecord& scene, std::int32_t top) {
  cursor_.begin(scene);
  fans_.count = 0;
  buckets_.clear(top, screen_.height);
  EdgeWalker::begin();
}

// Goes to the instance of a vertex, as VertexBuckets names it.
void MeshWalker::enter(std::uint32_t vertex) {
  cursor_.to_vertex(vertex - 1);
  const MeshRecord& mesh = cursor_.mesh();
  const std::uint32_t first = cursor_.first_vertex() + 1;
  first_id_ = static_cast<FaceId>(cursor_.first_face() + 1);
  fans_.points = &points_[first];
  fans_.cover = cover_of(first_id_);
  fans_.first = first;
  fans_.count = mesh.positions.size();
  fans_.starts = mesh.fan_starts.data();
  fans_.fans = mesh.fans.data();
}

template <typename Word>
bool MeshWalker::start_edges(std::int32_t line, const DrawnFaces<Word>& drawn) {
  FanStart& fans = fans_;
  fans.line = line;
  fans.not_drawn = drawn.not_drawn;
  fans.links = buckets_.links();
  fans.last = reinterpret_cast<std::uintptr_t>(walk_.now + capacity_);
  fans.begin = fans.out = walk_.alive_end + 1;
  walk_.alive_end->x = INT32_MIN;
  for (fans.vertex = buckets_.sorted(line);;) {
    fans.words = drawn.words + first_id_;
    start_fans(fans, drawn.words);
    if (fans.vertex == VertexBuckets::kEnd) break;
    if (fans.vertex - fans.first < fans.count) return false;  // there was no room
    enter(fans.vertex);
  }
  end_start(fans.begin, fans.out);
  return true;
}

template bool MeshWalker::start_edges(std::int32_t, const DrawnFaces<std::uint16_t>&);
template bool MeshWalker::start_edges(std::int32_t, const DrawnFaces<std::uint8_t>&);

// Begins a tall edge again on `line`; false where it has ended, and for every other edge.
bool MeshWalker::run_again(ActiveEdge& edge, std::int32_t line) {
  if ((edge.rest & ActiveEdge::kTall) == 0) return false;
  const std::uint32_t face = face_of_tall(edge) - 1u;
  cursor_.to_face(face);
  const std::uint16_t* const corner = cursor_.mesh().corners.data() + 3 * (face - cursor_.first_face());
  const auto point = [&](unsigned i) { return points_[cursor_.first_vertex() + corner[i] + 1]; };
  return run_tall_again(edge, line, {point(0), point(1), point(2)});
}

}  // namespace spanline
