#include "hidden/hidden_view.hpp"

#include <algorithm>

#include "assetc/input_error.hpp"
#include "core/area/window_sort.hpp"

namespace spanline::host {
namespace {

// Pools as large as 16-bit indices allow.
class HeapPools {
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

struct Collect {
  std::vector<VisiblePolygon>& polygons;
  area::Plane plane;

  void begin_piece(std::uint16_t source, const area::Plane& of) {
    polygons.push_back({source, {}});
    plane = of;
  }
  void film(std::uint16_t) {}
  void begin_contour() { polygons.back().rings.emplace_back(); }
  void vertex(area::GridPoint p) {
    // A plane that is hardly seen from the side may leave the range beside its polygon.
    constexpr double kUnit = 1 << (area::kPlaneBits + 8);
    polygons.back().rings.back().push_back({p, std::clamp(static_cast<double>(plane.value(p)) / kUnit, 0.0, 65536.0)});
  }
  void end_contour() {}
  void end_piece() {}
};

}  // namespace

HiddenView remove_hidden(const FacetList& facets, std::uint16_t width, std::uint16_t height, std::uint32_t window,
                         const std::string& place) {
  HeapPools pools;
  std::vector<std::uint16_t> names(UINT16_MAX);
  area::AreaSort sort(pools.refs());
  area::WindowSort<FacetList> windows(sort, {names.data(), UINT16_MAX - 1}, window);
  const area::Box screen{
      {0, 0}, {static_cast<std::int16_t>(width * kSubpixels), static_cast<std::int16_t>(height * kSubpixels)}};
  HiddenView view;
  Collect collect{view.polygons, {}};
  const Status status = windows.solve(facets, screen, collect);
  if (!status.ok()) {
    throw InputError(place, "is too intricate for the area sort: face " + std::to_string(facets[status.index].face) +
                                " needs more than " + std::to_string(status.limit) + " " + status.where);
  }
  std::stable_sort(view.polygons.begin(), view.polygons.end(),
                   [](const VisiblePolygon& a, const VisiblePolygon& b) { return a.facet < b.facet; });
  view.clips = windows.counts().sort.clips;
  view.windows = windows.counts().windows;
  return view;
}

}  // namespace spanline::host
