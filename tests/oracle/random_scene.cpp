#include "oracle/random_scene.hpp"

#include <algorithm>
#include <cstddef>

#include "oracle/random_polygon.hpp"

namespace spanline::oracle {
namespace {

constexpr int kPixel = 16;
constexpr int kWidth = 64 * kPixel;
constexpr int kHeight = 48 * kPixel;
constexpr int kMaxPolygons = 60;
constexpr int kMaxZ = 65535;

struct DepthRange {
  int low, high;  // units
};

// What all polygons of a scene have in common.
struct Style {
  int snap;          // corners on multiples of this, 1/16 px
  int twisted;       // percent of polygons that are no planes
  DepthRange depth;  // of the whole scene
  int size;          // percent: from scattered to crowded
  bool layers;
};

Style random_style(Random& random, bool layers) {
  constexpr int kSnaps[] = {1, 1, 1, 8, 16, 4};
  constexpr int kSizes[] = {60, 100, 200, 300, 500};
  constexpr int kSpreads[] = {30, 1000, 20000, 32767, 32767};
  Style style{};
  style.snap = kSnaps[random.below(6)];
  style.twisted = random.percent(30) ? random.between(10, 60) : 0;
  const int spread = layers ? 32767 : kSpreads[random.below(5)];
  const int middle = random.between(spread, kMaxZ - spread);
  style.depth = {middle - spread, middle + spread};
  style.size = kSizes[random.below(5)];
  style.layers = layers;
  return style;
}

Place random_place(Random& random, int size) {
  const Point on_picture{random.between(-64, kWidth + 64), random.between(-64, kHeight + 64)};
  switch (random.below(16)) {
    case 0:  // far out on all sides, or on a few
      return {{random.between(-3000, 3000), random.between(-3000, 3000)}, random.between(2000, 60000)};
    case 1:  // wholly beside the picture, most of the time
      return {{random.between(-30000, 30000), random.between(-30000, 30000)}, random.between(10, 3000)};
    case 2:
    case 3:
    case 4:
      return {on_picture, random.between(200, 900) * size / 100};
    case 5:
    case 6:
      return {on_picture, random.between(4, 60)};
    default:
      return {on_picture, random.between(40, 400) * size / 100};
  }
}

// Depths of one polygon (or of a fan that lies in one plane): a plane through the middle of `range`, steep enough to
// use a random share of it, rounded to units.
class DepthField {
 public:
  DepthField(Random& random, const DepthRange& range, bool steep, bool twisted) : twisted_(twisted) {
    const int height = range.high - range.low;
    const int rim = steep ? height * 2 / 5 : 0;  // steep planes start near the middle and reach far, so they cross
    middle_ = random.between(range.low + rim, range.high - rim);
    const int room = std::min(middle_ - range.low, range.high - middle_);
    amplitude_ = random.between(steep ? room / 2 : 0, room);
    if (random.percent(10)) amplitude_ = 0;
    gx_ = random.between(-1000, 1000);
    gy_ = random.between(-1000, 1000);
  }

  void apply(Random& random, std::vector<std::vector<Vertex>>& contours) const {
    const Vertex anchor = contours[0][0];
    std::int64_t steepest = 1;
    for (const auto& contour : contours) {
      for (const Vertex& vertex : contour) steepest = std::max(steepest, std::abs(rise(anchor, vertex)));
    }
    for (auto& contour : contours) {
      for (Vertex& vertex : contour) {
        const std::int64_t offset =
            twisted_ ? random.between(-amplitude_, amplitude_) : rounded(rise(anchor, vertex) * amplitude_, steepest);
        vertex.z = (middle_ + offset) * 256;
      }
    }
  }

 private:
  std::int64_t rise(const Vertex& anchor, const Vertex& vertex) const {
    return gx_ * (std::int64_t{vertex.x} - anchor.x) + gy_ * (std::int64_t{vertex.y} - anchor.y);
  }

  static std::int64_t rounded(std::int64_t value, std::int64_t divisor) {
    return (2 * value + (value < 0 ? -divisor : divisor)) / (2 * divisor);
  }

  int middle_;
  int amplitude_;
  std::int64_t gx_, gy_;
  bool twisted_;
};

std::vector<std::vector<Vertex>> to_vertices(const std::vector<Contour>& contours) {
  std::vector<std::vector<Vertex>> result;
  for (const Contour& contour : contours) {
    std::vector<Vertex>& ring = result.emplace_back();
    for (const Point& p : contour) ring.push_back({p.x, p.y, 0});
  }
  return result;
}

Contour to_points(const std::vector<Vertex>& ring) {
  Contour points;
  for (const Vertex& vertex : ring) points.push_back({vertex.x, vertex.y});
  return points;
}

class Maker {
 public:
  Maker(std::uint64_t seed, bool layers)
      : random_(seed), style_(random_style(random_, layers)), wanted_(random_.between(1, kMaxPolygons)) {}

  std::vector<Facet> make() {
    while (missing() > 0) {
      switch (random_.below(20)) {
        case 0:
          add_fan();
          break;
        case 1:
          add_strip();
          break;
        case 2:
          add_double();
          break;
        default:
          add_polygon();
          break;
      }
    }
    return std::move(facets_);
  }

 private:
  int missing() const { return wanted_ - static_cast<int>(facets_.size()); }

  // The next layer, a unit apart from its neighbours, or the whole scene's range.
  DepthRange next_range() {
    if (!style_.layers) return style_.depth;
    const int height = kMaxZ / wanted_;
    const int layer = static_cast<int>(facets_.size()) * 61 % wanted_;
    return {layer * height, layer * height + height - 2};
  }

  DepthField next_field() {
    return {random_, next_range(), !style_.layers && random_.percent(60), random_.percent(style_.twisted)};
  }

  void add(std::vector<std::vector<Vertex>> contours) {
    facets_.push_back({static_cast<std::uint32_t>(facets_.size()), std::move(contours)});
  }

  void add_polygon() {
    auto contours = to_vertices(random_polygon(random_, random_place(random_, style_.size), style_.snap));
    next_field().apply(random_, contours);
    if (random_.percent(5)) contours[0].insert(contours[0].begin(), contours[0].front());
    if (random_.percent(50)) std::reverse(contours[0].begin(), contours[0].end());
    add(std::move(contours));
  }

  // Triangles round one corner: all share edges with their neighbours.
  void add_fan() {
    const Place place = random_place(random_, style_.size);
    const int count = std::min(missing(), random_.between(3, 11));
    const int whole = random_.percent(50) ? 1024 : 700;
    std::vector<std::vector<Vertex>> ring(1);
    ring[0].push_back({place.centre.x, place.centre.y, 0});
    for (int i = 0; i <= count; ++i) {
      const Point p = circle_point(whole * i / count);
      ring[0].push_back({clamped(place.centre.x + p.x / 128 * place.radius / 128),
                         clamped(place.centre.y + p.y / 128 * place.radius / 128), 0});
    }
    next_field().apply(random_, ring);
    if (whole == 1024) ring[0].back() = ring[0][1];
    for (std::size_t i = 1; i + 1 < ring[0].size(); ++i) add({{ring[0][0], ring[0][i], ring[0][i + 1]}});
  }

  // Quads or triangles in a row, bent at every rung.
  void add_strip() {
    const Place place = random_place(random_, style_.size);
    const DepthRange range = next_range();
    const int rungs = random_.between(3, 8);
    const bool triangles = random_.percent(50);
    std::vector<Vertex> near_side, far_side;
    for (int i = 0; i < rungs; ++i) {
      const int x = place.centre.x + (2 * i - rungs) * place.radius / rungs;
      near_side.push_back(strip_corner(x, place.centre.y, place.radius, range));
      far_side.push_back(strip_corner(x, place.centre.y + place.radius / 2, place.radius, range));
    }
    for (std::size_t i = 0; i + 1 < near_side.size() && missing() > 1; ++i) {
      const std::vector<Vertex> quad{near_side[i], near_side[i + 1], far_side[i + 1], far_side[i]};
      if (triangles || !is_simple({to_points(quad)})) {
        add({{quad[0], quad[1], quad[3]}});
        add({{quad[1], quad[2], quad[3]}});
      } else {
        add({quad});
      }
    }
    if (missing() == 1) add_polygon();
  }

  Vertex strip_corner(int x, int y, int radius, const DepthRange& range) {
    const int jitter = radius / 20;
    return {clamped(x + random_.between(-jitter, jitter)), clamped(y + random_.between(-jitter, jitter)),
            std::int64_t{random_.between(range.low, range.high)} * 256};
  }

  // The same polygon again, begun at another corner: equal depths everywhere, so the lower number wins.
  void add_double() {
    if (facets_.empty()) return;
    auto contours = facets_[static_cast<std::size_t>(random_.below(static_cast<int>(facets_.size())))].contours;
    if (random_.percent(50)) std::rotate(contours[0].begin(), contours[0].begin() + 1, contours[0].end());
    if (random_.percent(50)) std::reverse(contours[0].begin(), contours[0].end());
    add(std::move(contours));
  }

  static int clamped(int value) { return std::clamp(value, -32768, 32767); }

  Random random_;
  Style style_;
  int wanted_;
  std::vector<Facet> facets_;
};

}  // namespace

std::vector<Facet> random_screen_facets(std::uint64_t seed) { return Maker(seed, seed % 2 == 0).make(); }

std::vector<Facet> random_level_facets(std::uint64_t seed) {
  std::vector<Facet> facets = random_screen_facets(seed);
  Random random(~seed);
  for (Facet& facet : facets) {
    const std::int64_t level = std::int64_t{random.below(12)} * 2 * 256 + 32768 * 256;
    for (auto& contour : facet.contours) {
      for (Vertex& vertex : contour) vertex.z = level;
    }
  }
  return facets;
}

std::vector<Facet> random_crossed_facets(std::uint64_t seed) {
  std::vector<Facet> facets = random_screen_facets(seed);
  Random random(~seed);
  for (std::size_t i = 0; i < facets.size(); i += 2) {
    auto& contour = facets[i].contours[0];
    for (std::size_t corner = contour.size(); corner > 1; --corner) {
      std::swap(contour[corner - 1], contour[static_cast<std::size_t>(random.below(static_cast<int>(corner)))]);
    }
  }
  return facets;
}

Layout random_layout(std::uint64_t seed) { return {seed / 2 % 2 == 0, seed / 4 % 2 == 0}; }

}  // namespace spanline::oracle
