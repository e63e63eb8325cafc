// The edge walker of meshes: their vertices wait in Y-buckets, and one that is reached starts its downward edges from
// its fan.
#pragma once

#include "core/scene/instance_cursor.hpp"
#include "core/vsg/edge_walker.hpp"
#include "core/vsg/vertex_buckets.hpp"

namespace spanline {

// Which faces are drawn: those whose word, of the FaceId, is not one certain value.
template <typename Word>
struct DrawnFaces {
  const Word* words;
  Word not_drawn;
};

class MeshWalker : public EdgeWalker {
 public:
  MeshWalker() = default;
  constexpr MeshWalker(const EdgeStorage& storage, const Screen& screen)
      : EdgeWalker(storage, screen),
        buckets_(storage.buckets, storage.links, storage.points),
        points_(storage.points) {}

  // Begins a frame at line `top`: no vertex is filed, no edge alive. points[1 + vertex] are to be set and forget() said
  // before faces are filed.
  void begin(const SceneRecord& scene, std::int32_t top);
  // To file the vertices of faces that are drawn; `first` is the mesh's first over the scene.
  VertexBuckets::Mesh vertices(std::uint32_t first) { return {buckets_, first}; }

  // Whether nothing of `line` is covered.
  bool is_blank(std::int32_t line) const { return none_alive() && is_quiet(line); }
  // Whether no edge begins on `line`, which needs no start_edges() then.
  bool is_quiet(std::int32_t line) const { return buckets_.is_empty(line); }
  // Starts the edges that begin on `line`; to be called for every line from top on that is not quiet. The faces to be
  // drawn are those that are run counter-clockwise on the screen. False where there is no room for an edge.
  template <typename Word>
  bool start_edges(std::int32_t line, const DrawnFaces<Word>& drawn);
  template <typename Sink, typename Plane>
  bool walk(std::int32_t line, const Sink& sink, const Plane& plane) {
    return EdgeWalker::walk(line, sink, plane,
                            [this](ActiveEdge& edge, std::int32_t next) { return run_again(edge, next); });
  }

 private:
  [[gnu::noinline]] void enter(std::uint32_t vertex);
  bool run_again(ActiveEdge& edge, std::int32_t line);

  FanStart fans_{};      // of the mesh that was reached last
  FaceId first_id_ = 0;  // of its faces
  VertexBuckets buckets_;
  PoolRef<ScreenXY> points_;
  InstanceCursor cursor_;
};

}  // namespace spanline
