// The edges that begin on a line, from the fans of its vertices, where of the vertices only a band's are kept.
#pragma once

#include "core/geom/mesh_points.hpp"
#include "core/vsg/band_vertices.hpp"
#include "core/vsg/fan_start.hpp"

namespace spanline {

// As FanStart; its members stand in the same places.
struct BandStart {
  const std::uint8_t* keys;  // of the mesh's vertices, as BandVertices has them
  const BandVertex* band;
  std::uint32_t vertex;  // the next, by its place in the band; 0, once it has begun, where there is no more
  std::int32_t line;
  ActiveEdge* out;
  const std::uint32_t* drawn;  // bits of faces, of which the mesh's
  std::uint32_t skip;          // begin with this one
  std::uint32_t first;         // BandVertex::vertex of the mesh's first
  std::uint32_t count;         // of vertices
  const std::uint16_t* starts;
  const FanEdge* fans;
  CoverKey cover;  // of the first bit's face
  std::uintptr_t last;
  ActiveEdge* begin;
  MeshPoints* points;  // the mesh

  std::uint32_t at() const { return band[vertex].vertex - first; }
  const FanEdge* fan() const { return fans + starts[at()]; }
  const FanEdge* fan_end() const { return fans + starts[at() + 1]; }
  // What its edges take where all begin.
  std::uintptr_t most() const { return static_cast<std::uintptr_t>(fan_end() - fan()) * sizeof(ActiveEdge); }
  std::uintptr_t room() const { return last - reinterpret_cast<std::uintptr_t>(out); }
  CoverKey covers(std::uint16_t face) const {
    if (face == FanEdge::kNone) return 0;
    const std::uint32_t bit = skip + face;
    return (drawn[bit / 32] >> bit % 32 & 1u) != 0 ? cover + bit : CoverKey{0};
  }
  // A lower end. What has been reached before, or is not drawn, lies above all lines.
  PackedXY bottom(std::uint32_t to) const {
    const std::uint32_t key = keys[to];
    if (key > BandVertices::kFiled) return PackedXY(band[key - BandVertices::kFiled].at);
    return key == 0 ? PackedXY(ScreenXY{0, INT16_MIN}) : place_vertex(*points, to);
  }
  template <typename BeginEdge>
  void each_to_start(const BeginEdge& begin_edge) const {
    const FromVertex from(PackedXY(band[vertex].at), line);
    const FanEdge* edge = fan();
    const FanEdge* const end = fan_end();
    for (std::uint16_t left = end[-1].face; edge != end; left = edge->face, ++edge) {
      const PackedXY to = bottom(edge->to);
      if (from.has_ended(to)) continue;
      const CoverKey ends = covers(left), begins = covers(edge->face);
      if (begins != ends) begin_edge(from, to, begins, ends);  // else both are 0
    }
  }
};

// As start_fans(): starts the edges that run down from `vertex` and those after it. For any core.
void start_band_fans_plain(BandStart& start);

#if defined(__ARM_ARCH_ISA_THUMB)
// The same in assembly.
void start_band_fans(BandStart& start) asm("spanline_start_fans_band");
#else
inline void start_band_fans(BandStart& start) { start_band_fans_plain(start); }
#endif

}  // namespace spanline
