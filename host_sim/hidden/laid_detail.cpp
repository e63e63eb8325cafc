#include "hidden/laid_detail.hpp"

namespace spanline::host {
namespace {

// The depths are not asked for where the plane is known.
struct Collect {
  Facet& facet;

  void begin_polygon() {}
  void begin_contour() { facet.rings.emplace_back(); }
  void vertex(std::int16_t x, std::int16_t y) {
    facet.rings.back().push_back({{x, y}, 0, {}});
    facet.bounds.widen({x, y});
  }
  void end_contour() {}
  void end_polygon() {}
};

void put(area::Clipper& clipper, area::Role role, const Facet& facet) {
  for (const std::vector<FacetVertex>& ring : facet.rings) {
    clipper.begin_contour(role);
    for (const FacetVertex& v : ring) clipper.vertex(v.at.x, v.at.y);
    clipper.end_contour();
  }
}

void take(const area::Clipper& clipper, area::List list, Facet& facet) {
  facet.rings.clear();
  facet.bounds = area::Box::none();
  Collect collect{facet};
  clipper.read(list, collect);
}

area::Plane plane_of(const Facet& facet) {
  area::WidestTriangle widest;
  std::int32_t depth[3] = {};
  for (const std::vector<FacetVertex>& ring : facet.rings) {
    for (const FacetVertex& v : ring) {
      const unsigned place = widest.take({v.at.x, v.at.y});
      if (place != area::WidestTriangle::kNone) depth[place] = static_cast<std::int32_t>(v.depth);
    }
  }
  return area::Plane::through(widest.corners(), depth);
}

}  // namespace

Status DetailLayer::lay(Facet& face, std::vector<Facet>& details) {
  face.plane = plane_of(face);
  for (std::size_t i = details.size(); i-- > 0;) {
    Facet& detail = details[i];
    clipper_.clear();
    put(clipper_, area::Role::subject, face);
    put(clipper_, area::Role::clip, detail);
    if (const Status status = clipper_.clip(); !status.ok()) return status;
    detail.plane = face.plane;
    take(clipper_, area::List::inside, detail);
    take(clipper_, area::List::outside, face);
  }
  return {};
}

}  // namespace spanline::host
