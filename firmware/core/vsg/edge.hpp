// Edges: how one is stepped from line to line without error, and the blocks of those that wait for their first line.
#pragma once

#include <compare>
#include <cstdint>

#include "core/base/pool.hpp"
#include "core/geom/facet.hpp"

namespace spanline {

// An edge of a facet, upper end first (ordered by y, then x), so that both faces of an edge compute one line.
struct ScreenEdge {
  FacetVertex top, bottom;

  ScreenEdge() = default;
  ScreenEdge(const FacetVertex& a, const FacetVertex& b) : top(a), bottom(b) {
    if (b.at.y < a.at.y || (b.at.y == a.at.y && b.at.x < a.at.x)) {
      top = b;
      bottom = a;
    }
  }
  std::int32_t first_line() const { return first_centre(top.at.y); }
  std::int32_t end_line() const { return first_centre(bottom.at.y); }  // half-open: horizontal edges have no line
  std::int32_t height() const { return bottom.at.y - top.at.y; }       // 28.4
};

// One half of a segment block: an edge at a scan line.
//
// The edge x(line) = N / D px with D = 16 * dy and N = (x0 - 8) * dy + dx * t, t = 16 * line + 8 - y0 (28.4). The pixel
// column is c = ceil(N / D), the first centre at or right of the edge, and e = c * D - N, 0 <= e < D, how far that
// centre lies from the edge in 1/D px. A line down N grows by 16 * dx = D * q + 16 * m: c += q, e -= 16 * m, and c + 1,
// e + D when e < 0. Quotient and remainder, one divide an edge, no error ever (vsg.md).
struct SegmentHalf {
  std::int16_t column;      // c of the line to come
  std::int16_t quotient;    // q = floor(dx / dy)
  std::uint16_t remainder;  // m = dx mod dy
  std::uint16_t height;     // dy, 28.4
  std::uint16_t lines;      // lines still to come; 0: this half is empty
  std::uint16_t unused;
  std::uint32_t error;      // e
  std::uint32_t depth;      // Q16.13 at the line to come; only facets that are no triangles keep it
  std::int32_t depth_step;  // a line

  bool empty() const { return lines == 0; }
  std::uint32_t denominator() const { return std::uint32_t{height} * kSubpixels; }

  // To the next line.
  void step() {
    column = static_cast<std::int16_t>(column + quotient);
    const std::uint32_t back = std::uint32_t{remainder} * kSubpixels;
    if (error < back) {
      ++column;
      error += denominator();
    }
    error -= back;
    depth += static_cast<std::uint32_t>(depth_step);
    --lines;
  }

  // Back by one line: what this half was when it was stepped last.
  SegmentHalf stepped_back() const {
    SegmentHalf h = *this;
    h.column = static_cast<std::int16_t>(h.column - quotient);
    h.error += std::uint32_t{remainder} * kSubpixels;
    if (h.error >= denominator()) {
      --h.column;
      h.error -= denominator();
    }
    h.depth -= static_cast<std::uint32_t>(depth_step);
    ++h.lines;
    return h;
  }
};

inline constexpr int kRampBits = 13;  // fraction bits of depth ramps, Q16.13
inline constexpr int kRampShift = kRampBits - (kDepthBits - 16);

// Sets up an edge at `line`, one of its own lines. Depth is set where asked for; from the edge's own first line, so
// that it does not depend on where a band begins.
SegmentHalf start_edge(const ScreenEdge& edge, std::int32_t line, bool with_depth);

// The order of two edges on the line to come: by place; in the same place the one that runs further left comes first;
// edges on one line by their depth, so that the order never depends on the history. equal: nothing but colours can
// differ.
std::strong_ordering order(const SegmentHalf& a, const SegmentHalf& b);
inline bool comes_before(const SegmentHalf& a, const SegmentHalf& b) { return order(a, b) < 0; }

// Gouraud's colours along an edge: the payload that vsg carries beside a segment half and never looks into.
struct EdgeShade {
  std::int16_t color[3];              // Q8.7 at the edge's own first line
  std::int16_t step[3];               // Q8.7 a line
  std::uint16_t first_line_from_top;  // the edge's own first line plus 2048, so that it is never negative
  friend constexpr auto operator<=>(const EdgeShade&, const EdgeShade&) = default;
};
EdgeShade shade_edge(const ScreenEdge& edge);

// An edge block: an edge of one polygon or of two that share it, waiting for its first line.
struct EdgeBlock {
  std::uint16_t next;
  std::uint16_t polygons[2];  // 0: none
  ScreenEdge edge;
};

}  // namespace spanline
