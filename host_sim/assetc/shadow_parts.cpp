#include "assetc/shadow_parts.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

constexpr std::uint8_t kAll = 255;

}  // namespace

ShadowParts::ShadowParts(Region face, RegionClipper& clipper) : face_(std::move(face)), clipper_(clipper) {
  Reach whole;
  whole.fill({kAll, kAll, kAll});
  parts_[whole] = clipper_.unite(face_, FacePlane::margin_along(face_, face_, FacePlane::kMargin, clipper_));
}

Region ShadowParts::joined(const Region& a, const Region& b) { return a.empty() ? b : clipper_.unite(a, b); }

// The face among the parts of one light, dark ones last but one and the largest lit one last. All but that reach into
// the margin; it gets what the others leave, so no crack opens between what was rounded apart.
ShadowParts::Shared ShadowParts::share(const std::vector<LitPart>& lit, std::int32_t grain) {
  std::map<Part, Region> regions;
  for (const LitPart& part : lit) {
    Region& all = regions[{part.light.r, part.light.g, part.light.b}];
    all = joined(all, part.region);
  }
  Region dark = face_;
  for (const auto& [part, region] : regions) {
    dark = clipper_.split(dark, region).outside;
    dark = clipper_.split(dark, FacePlane::margin_along(region, face_, grain, clipper_)).outside;
  }
  dark = clipper_.without_slivers(dark, grain);
  Shared shared(regions.begin(), regions.end());
  std::stable_sort(shared.begin(), shared.end(),
                   [](const auto& a, const auto& b) { return doubled_area(a.second) < doubled_area(b.second); });
  if (!dark.empty() || shared.empty()) shared.insert(shared.begin(), {Part{}, std::move(dark)});
  for (std::size_t i = 0; i + 1 < shared.size(); ++i) {
    Region& region = shared[i].second;
    region = joined(
        region, clipper_.split(FacePlane::margin_along(region, face_, FacePlane::kMargin, clipper_), face_).outside);
  }
  return shared;
}

void ShadowParts::add_light(std::size_t light, const std::vector<LitPart>& lit, std::int32_t grain) {
  grain_ = std::max(grain_, grain);
  divide(light, share(lit, grain));
}

void ShadowParts::divide(std::size_t light, const Shared& shared) {
  std::map<Reach, Region> after;
  const auto add = [&](Reach reach, const Part& part, const Region& region) {
    if (region.empty()) return;
    reach[light] = part;
    Region& all = after[reach];
    all = joined(all, region);
  };
  for (const auto& [reach, region] : parts_) {
    Region rest = region;
    for (std::size_t i = 0; i + 1 < shared.size(); ++i) {
      RegionClipper::Split split = clipper_.split(rest, shared[i].second);
      add(reach, shared[i].first, split.inside);
      rest = std::move(split.outside);
    }
    add(reach, shared.back().first, rest);
  }
  parts_ = std::move(after);
}

std::vector<ShadowPart> ShadowParts::finish() {
  std::vector<std::pair<std::int64_t, ShadowPart>> seen;
  for (auto& [reach, region] : parts_) {
    const Region inside = clipper_.without_slivers(clipper_.split(face_, region).inside, grain_);
    if (inside.empty()) continue;
    ShadowPart part{{}, std::move(region)};
    for (std::size_t l = 0; l < reach.size(); ++l) part.reach.light[l] = {reach[l][0], reach[l][1], reach[l][2]};
    seen.emplace_back(doubled_area(inside), std::move(part));
  }
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<ShadowPart> parts;
  parts.reserve(seen.size());
  for (auto& [size, part] : seen) parts.push_back(std::move(part));
  return parts;
}

}  // namespace spanline::host
