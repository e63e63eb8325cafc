// Pools for the area sort, as large as 16-bit indices allow.
#pragma once

#include <vector>

#include "core/area/area_sort.hpp"

namespace spanline::host {

class SortMemory {
 public:
  area::SortPools refs() {
    return {ref(polygons_), ref(borders_), ref(pieces_),
            ref(films_),    ref(frames_),  {ref(segments_), ref(nodes_), ref(edges_), ref(contours_)}};
  }

 private:
  static constexpr std::size_t kMost = UINT16_MAX;

  template <typename T>
  static PoolRef<T> ref(std::vector<T>& blocks) {
    return {blocks.data(), static_cast<std::uint16_t>(blocks.size() - 1)};
  }

  std::vector<area::NamedPolygon> polygons_{kMost};
  std::vector<area::BorderEdge> borders_{kMost};
  std::vector<area::Piece> pieces_{kMost};
  std::vector<area::Film> films_{kMost};
  std::vector<area::SortFrame> frames_{kMost};
  std::vector<area::Segment> segments_{kMost};
  std::vector<area::Node> nodes_{kMost};
  std::vector<area::Edge> edges_{std::size_t{area::kMaxEdges} + 1};
  std::vector<area::Contour> contours_{kMost};
};

}  // namespace spanline::host
