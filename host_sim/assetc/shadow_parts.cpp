#include "assetc/shadow_parts.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

constexpr std::uint8_t kAll = 255;

// Less than a hundredth of a unit along a whole face: rounding, nothing to be seen.
constexpr std::int64_t kDust = 2 * 600;

bool overlap(const Region& a, const Region& b) {
  const auto span = [](const Region& region, auto coordinate) {
    std::pair<int, int> range(INT16_MAX, INT16_MIN);
    for (const GridRing& ring : region) {
      for (const area::GridPoint& p : ring) {
        range.first = std::min<int>(range.first, coordinate(p));
        range.second = std::max<int>(range.second, coordinate(p));
      }
    }
    return range;
  };
  const auto meet = [&](auto coordinate) {
    const auto [a_low, a_high] = span(a, coordinate);
    const auto [b_low, b_high] = span(b, coordinate);
    return a_low < b_high && b_low < a_high;
  };
  return meet([](const area::GridPoint& p) { return p.x; }) && meet([](const area::GridPoint& p) { return p.y; });
}

}  // namespace

ShadowParts::ShadowParts(Region face, const FacePlane& plane, RegionClipper& clipper)
    : face_(std::move(face)), clipper_(clipper) {
  Reach whole;
  whole.fill({kAll, kAll, kAll});
  parts_[whole] = plane.with_margin(face_, clipper_);
}

template <typename Key>
void ShadowParts::add(std::map<Key, Region>& to, const Key& key, const Region& region) {
  if (doubled_area(region) < kDust) return;
  Region& all = to[key];
  all = all.empty() ? region : clipper_.unite(all, region);
}

void ShadowParts::begin_light(std::size_t light) {
  light_ = light;
  lit_.clear();
  Region whole;
  for (const auto& [reach, region] : parts_) whole = whole.empty() ? region : clipper_.unite(whole, region);
  lit_[{kAll, kAll, kAll}] = std::move(whole);
}

void ShadowParts::shade(const Region& shadow, Color transmission) {
  std::map<Part, Region> after;
  for (const auto& [part, region] : lit_) {
    if (part == Part{} || !overlap(region, shadow)) {
      add(after, part, region);
      continue;
    }
    const auto [inside, outside] = clipper_.split(region, shadow);
    const auto through = [](unsigned light, unsigned glass) {
      return static_cast<std::uint8_t>((light * glass + 127) / 255);
    };
    add(after, part, outside);
    add(after,
        Part{through(part[0], transmission.r), through(part[1], transmission.g), through(part[2], transmission.b)},
        inside);
  }
  lit_ = std::move(after);
}

void ShadowParts::end_light() {
  if (lit_.size() == 1 && lit_.begin()->first == Part{kAll, kAll, kAll}) return;
  std::map<Reach, Region> after;
  for (const auto& [reach, region] : parts_) {
    Region rest = region;
    for (const auto& [part, where] : lit_) {
      Reach key = reach;
      key[light_] = part;
      RegionClipper::Split split = clipper_.split(rest, where);
      add(after, key, split.inside);
      rest = std::move(split.outside);
    }
  }
  parts_ = std::move(after);
}

std::vector<ShadowPart> ShadowParts::finish() {
  std::vector<std::pair<std::int64_t, ShadowPart>> seen;
  for (auto& [reach, region] : parts_) {
    const std::int64_t size = doubled_area(clipper_.split(face_, region).inside);
    if (size < kDust) continue;
    ShadowPart part{{}, std::move(region)};
    for (std::size_t l = 0; l < reach.size(); ++l) part.reach.light[l] = {reach[l][0], reach[l][1], reach[l][2]};
    seen.emplace_back(size, std::move(part));
  }
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<ShadowPart> parts;
  for (auto& [size, part] : seen) parts.push_back(std::move(part));
  return parts;
}

}  // namespace spanline::host
