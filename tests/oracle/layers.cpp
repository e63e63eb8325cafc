#include "oracle/layers.hpp"

#include <algorithm>

namespace spanline::oracle {
namespace {

// What a surface shows at a pixel: itself, or its topmost detail there.
std::uint32_t shown_on(std::uint32_t surface, const std::vector<Candidate>& candidates, const FacetsByFace& facets) {
  std::uint32_t top = surface;
  for (const Candidate& each : candidates) {
    const bool lies_on = facets.at(each.face)->parent == surface;
    if (lies_on && (top == surface || each.face > top)) top = each.face;
  }
  return top;
}

std::vector<Candidate> surfaces_of(const std::vector<Candidate>& candidates, const FacetsByFace& facets) {
  std::vector<Candidate> surfaces;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(surfaces),
               [&](const Candidate& each) { return facets.at(each.face)->parent == kNone; });
  std::sort(surfaces.begin(), surfaces.end(), [](const Candidate& a, const Candidate& b) {
    const int order = compare_depths(a.depth, b.depth);
    return order != 0 ? order > 0 : a.face < b.face;
  });
  return surfaces;
}

std::string number(std::uint32_t face) { return std::to_string(face); }

}  // namespace

FacetsByFace by_face(const std::vector<Facet>& facets) {
  FacetsByFace all;
  for (const Facet& facet : facets) all[facet.face] = &facet;
  return all;
}

std::vector<std::uint32_t> stack_of(const std::vector<Candidate>& candidates, const FacetsByFace& facets) {
  std::vector<std::uint32_t> stack;
  for (const Candidate& surface : surfaces_of(candidates, facets)) {
    stack.push_back(shown_on(surface.face, candidates, facets));
    if (!facets.at(surface.face)->see_through || !facets.at(stack.back())->see_through) break;
  }
  return stack;
}

std::string wrong_stack(const std::vector<std::uint32_t>& drawn, const std::vector<Candidate>& candidates,
                        const FacetsByFace& facets, std::int64_t tolerance) {
  const std::vector<Candidate> surfaces = surfaces_of(candidates, facets);
  const auto behind = [tolerance](const Candidate& a, const Candidate& b) {  // surely
    if (tolerance != 0 && closer_than(a.depth, b.depth, tolerance)) return false;
    const int order = compare_depths(a.depth, b.depth);
    return order != 0 ? order < 0 : a.face > b.face;
  };
  std::vector<Candidate> chosen;
  bool ended = false;
  for (const std::uint32_t face : drawn) {
    const auto facet = facets.find(face);
    if (facet == facets.end()) return "face " + number(face) + " does not exist";
    const std::uint32_t root = facet->second->parent == kNone ? face : facet->second->parent;
    const auto surface =
        std::find_if(surfaces.begin(), surfaces.end(), [root](const Candidate& each) { return each.face == root; });
    if (surface == surfaces.end()) return "face " + number(root) + " does not cover it";
    if (shown_on(root, candidates, facets) != face) return "face " + number(root) + " shows another detail";
    if (ended) return "face " + number(face) + " is hidden by an opaque one";
    for (const Candidate& other : chosen) {
      if (other.face == root) return "face " + number(root) + " stands twice";
      if (behind(other, *surface)) return "face " + number(root) + " is nearer than " + number(other.face);
    }
    chosen.push_back(*surface);
    ended = !facet->second->see_through;
  }
  for (const Candidate& surface : surfaces) {
    const bool there = std::any_of(chosen.begin(), chosen.end(),
                                   [&surface](const Candidate& each) { return each.face == surface.face; });
    if (!there && (!ended || !behind(surface, chosen.back())) &&
        (!ended || tolerance == 0 || !closer_than(surface.depth, chosen.back().depth, tolerance))) {
      return "face " + number(surface.face) + " is missing";
    }
  }
  return {};
}

}  // namespace spanline::oracle
