#include "hidden/hidden_view.hpp"

#include <algorithm>
#include <tuple>

#include "assetc/input_error.hpp"
#include "assetc/sort_memory.hpp"
#include "core/area/window_sort.hpp"

namespace spanline::host {
namespace {

struct Collect {
  std::vector<VisiblePolygon>& polygons;
  area::Plane plane;

  void begin_piece(std::uint16_t source, const area::Plane& of) {
    polygons.push_back({source, {}, {}, {}, {}});
    plane = of;
  }
  void film(std::uint16_t source) { polygons.back().films.push_back(source); }
  void begin_contour() { polygons.back().rings.emplace_back(); }
  void vertex(area::GridPoint p) {
    // A plane that is hardly seen from the side may leave the range beside its polygon.
    constexpr double kUnit = 1 << (area::kPlaneBits + 8);
    polygons.back().rings.back().push_back({p, std::clamp(static_cast<double>(plane.value(p)) / kUnit, 0.0, 65536.0)});
  }
  void end_contour() {}
  void end_piece() {}
};

// The background has one colour a line: the one in the middle of the polygon.
Rgb8 background_behind(const VisiblePolygon& polygon, const SceneDescription& scene) {
  int low = INT16_MAX, high = INT16_MIN;
  for (const ScreenVertex& v : polygon.rings[0]) {
    low = std::min<int>(low, v.at.y);
    high = std::max<int>(high, v.at.y);
  }
  const int at = (low + high) / 2, whole = scene.height * kSubpixels;
  const auto mix = [&](std::uint8_t top, std::uint8_t bottom) {
    return static_cast<std::uint8_t>((top * (whole - at) + bottom * at + whole / 2) / whole);
  };
  const BackgroundRecord& sky = scene.background;
  return {mix(sky.top.r, sky.bottom.r), mix(sky.top.g, sky.bottom.g), mix(sky.top.b, sky.bottom.b)};
}

Rgb8 seen_colour(const VisiblePolygon& polygon, const FacetList& facets, const SceneDescription& scene) {
  Rgb8 color = polygon.facet == area::kBackdrop ? background_behind(polygon, scene) : facets[polygon.facet].color;
  for (std::size_t i = polygon.films.size(); i > 0; --i) {
    const Facet& film = facets[polygon.films[i - 1]];
    const Rgb8 own = film.color, through = film.transmission;
    const auto mix = [](int front, int behind, int t) {
      return static_cast<std::uint8_t>((front * (255 - t) + behind * t + 127) / 255);
    };
    color = {mix(own.r, color.r, through.r), mix(own.g, color.g, through.g), mix(own.b, color.b, through.b)};
  }
  return color;
}

std::tuple<std::uint16_t, std::uint8_t, std::uint8_t, std::uint8_t> key_of(const VisiblePolygon& p) {
  return {p.facet, p.color.r, p.color.g, p.color.b};
}

}  // namespace

HiddenView remove_hidden(const FacetList& facets, const SceneDescription& scene, std::uint32_t window,
                         area::Panes panes) {
  SortMemory pools;
  std::vector<std::uint16_t> names(UINT16_MAX);
  area::AreaSort sort(pools.refs(), panes);
  area::WindowSort<FacetList> windows(sort, {names.data(), UINT16_MAX - 1}, window);
  const area::Box screen{
      {0, 0},
      {static_cast<std::int16_t>(scene.width * kSubpixels), static_cast<std::int16_t>(scene.height * kSubpixels)}};
  HiddenView view;
  Collect collect{view.polygons, {}};
  const Status status = windows.solve(facets, screen, collect);
  if (!status.ok()) {
    const std::string face =
        status.index < facets.facets().size() ? "face " + std::to_string(facets[status.index].face) : "it";
    throw InputError(scene.place, "is too intricate for the area sort: " + face + " needs more than " +
                                      std::to_string(status.limit) + " " + status.where);
  }
  if (panes == area::Panes::shown) {
    std::erase_if(view.polygons, [](const VisiblePolygon& polygon) { return polygon.facet == area::kBackdrop; });
  }
  for (VisiblePolygon& polygon : view.polygons) {
    if (panes == area::Panes::shown) {
      polygon.color = facets[polygon.facet].color;
      polygon.transmission = facets[polygon.facet].transmission;
    } else {
      polygon.color = seen_colour(polygon, facets, scene);
    }
  }
  std::stable_sort(view.polygons.begin(), view.polygons.end(),
                   [](const VisiblePolygon& a, const VisiblePolygon& b) { return key_of(a) < key_of(b); });
  view.clips = windows.counts().sort.clips + windows.counts().sort.details;
  view.windows = windows.counts().windows;
  return view;
}

}  // namespace spanline::host
