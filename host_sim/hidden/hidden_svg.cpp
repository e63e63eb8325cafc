#include "hidden/hidden_svg.hpp"

#include <cstdio>

namespace spanline::host {
namespace {

// Sixteenths have at most four decimals.
std::string px(int v) {
  char text[24];
  std::snprintf(text, sizeof text, "%.4f", v / static_cast<double>(kSubpixels));
  std::string number = text;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

std::string point(area::GridPoint p) { return px(p.x) + " " + px(p.y); }

std::string hex(Rgb8 c) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c.r, c.g, c.b);
  return text;
}

std::string head(const SceneDescription& scene) {
  const std::string width = std::to_string(scene.width), height = std::to_string(scene.height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " +
         width + " " + height + "\">\n";
}

std::string background(const SceneDescription& scene) {
  return "<defs><linearGradient id=\"sky\" x2=\"0\" y2=\"1\"><stop stop-color=\"" + hex(scene.background.top) +
         "\"/><stop offset=\"1\" stop-color=\"" + hex(scene.background.bottom) +
         "\"/></linearGradient></defs>\n<rect width=\"100%\" height=\"100%\" fill=\"url(#sky)\"/>\n";
}

std::string strokes(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) text += "M" + point(line.from) + "L" + point(line.to) + "\n";
  return text;
}

}  // namespace

std::string surfaces_svg(const HiddenView& view, const FacetList& facets, const SceneDescription& scene) {
  // Neighbours share their edges exactly; smoothing each by itself would let the background through.
  std::string text = head(scene) + background(scene) + "<g fill-rule=\"evenodd\" shape-rendering=\"crispEdges\">\n";
  for (std::size_t i = 0; i < view.polygons.size();) {
    const VisiblePolygon& first = view.polygons[i];
    text += "<path";
    if (first.facet != area::kBackdrop) text += " data-source=\"" + std::to_string(facets[first.facet].face) + "\"";
    text += " fill=\"" + hex(first.color) + "\" d=\"";
    for (; i < view.polygons.size() && looks_like(view.polygons[i], first); ++i) {
      for (const auto& ring : view.polygons[i].rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) text += (k == 0 ? "M" : "L") + point(ring[k].at);
        text += "Z";
      }
    }
    text += "\"/>\n";
  }
  return text + "</g>\n</svg>\n";
}

std::string lines_svg(const std::vector<Line>& visible, const std::vector<Line>& hidden,
                      const SceneDescription& scene) {
  std::string text = head(scene) +
                     "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g fill=\"none\" stroke=\"#000\" "
                     "stroke-linecap=\"round\">\n";
  if (!hidden.empty()) text += "<path stroke-width=\"0.4\" stroke-dasharray=\"2 2\" d=\"" + strokes(hidden) + "\"/>\n";
  return text + "<path stroke-width=\"0.8\" d=\"" + strokes(visible) + "\"/>\n</g>\n</svg>\n";
}

}  // namespace spanline::host
