// The edges that begin on a line, from the fans of its vertices: the loop of EdgeWalker::start_edges().
#pragma once

#include "core/scene/format.hpp"
#include "core/vsg/active_edge.hpp"
#include "core/vsg/line_walk.hpp"

namespace spanline {

// Where it stands, and what it reads. Words tell which faces are drawn: those whose word is not one certain value.
// Assembly knows where each member stands.
struct FanStart {
  const ScreenXY* points;  // of the mesh's vertices
  const void* words;       // of the mesh's faces
  std::uint32_t vertex;    // the next; a number that is none of the mesh where there is no more
  std::int32_t line;
  ActiveEdge* out;  // behind the last edge that begins; out[-1].x is that of a sentinel, INT32_MIN, to start with
  std::uint32_t not_drawn;
  CoverKey cover;               // of the mesh's first face
  std::uint32_t first;          // vertex of the mesh
  std::uint32_t count;          // of vertices
  const std::uint16_t* starts;  // MeshRecord::fan_starts
  const FanEdge* fans;
  const std::uint16_t* links;  // to the vertex after
  std::uintptr_t last;         // that out may come to
  ActiveEdge* begin;           // the first edge that begins

  std::uint32_t at() const { return vertex - first; }
  // The vertex's fan.
  const FanEdge* fan() const { return fans + starts[at()]; }
  const FanEdge* fan_end() const { return fans + starts[at() + 1]; }
  // What a face of the mesh covers, or none.
  template <typename Word>
  CoverKey covers(std::uint16_t face) const {
    const bool drawn = face != FanEdge::kNone && static_cast<const Word*>(words)[face] != not_drawn;
    return drawn ? cover + face : CoverKey{0};
  }
  // begin_edge(FromVertex, bottom, begins, ends) for each of the vertex's edges that begin, as long as it returns true.
  template <typename Word, typename BeginEdge>
  bool each_to_start(const BeginEdge& begin_edge) const {
    const FromVertex from(PackedXY(points[at()]), line);
    const FanEdge* edge = fan();
    const FanEdge* const end = fan_end();
    // The face counter-clockwise of an edge lies on its right.
    for (std::uint16_t left = end[-1].face; edge != end; left = edge->face, ++edge) {
      const PackedXY bottom(points[edge->to]);
      if (from.has_ended(bottom)) continue;
      const CoverKey ends = covers<Word>(left), begins = covers<Word>(edge->face);
      if (begins != ends && !begin_edge(from, bottom, begins, ends)) return false;  // else both are 0
    }
    return true;
  }
};

// Starts the edges that run down from the vertices of the mesh, and stops before the first one that is not of it. Where
// there is no room for an edge it stops, and `vertex` is left as it was. The faces to be drawn are those that are run
// counter-clockwise on the screen. For any core.
template <typename Word>
void start_fans_plain(FanStart& start) {
  const std::uint32_t first = start.vertex;
  const auto begin = [&start](const FromVertex& from, PackedXY bottom, CoverKey begins, CoverKey ends) {
    if (reinterpret_cast<std::uintptr_t>(start.out) >= start.last) return false;
    ActiveEdge* const out = start.out++;
    out->toggle = begins - ends;
    from.run(*out, bottom, static_cast<FaceId>(ends));
    // They come nearly in order.
    if (out->x < out[-1].x) [[unlikely]]
      insert_back(start.begin, out, ActiveEdge{*out});
    return true;
  };
  for (; start.at() < start.count; start.vertex = start.links[start.vertex]) {
    if (start.each_to_start<Word>(begin)) continue;
    start.vertex = first;
    return;
  }
}

#if defined(__ARM_ARCH_ISA_THUMB)
// The same in assembly.
void start_fans(FanStart& start, const std::uint16_t* words) asm("spanline_start_fans_words");
void start_fans(FanStart& start, const std::uint8_t* words) asm("spanline_start_fans_bytes");
#else
template <typename Word>
void start_fans(FanStart& start, const Word*) {
  start_fans_plain<Word>(start);
}
#endif

}  // namespace spanline
