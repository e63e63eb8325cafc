#include "oracle/renderer.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace spanline::oracle {
namespace {

constexpr int kMaxExtent = 2046;

struct Edge {
  Vertex top, bottom;  // top.y < bottom.y
  std::int64_t height() const { return bottom.y - top.y; }
};

// Where an edge meets a line's centre: x = x_times_h / h in 1/16 px, z = z_times_h / h, slope = run / h.
struct Crossing {
  std::int64_t x_times_h;
  std::int64_t z_times_h;
  std::int64_t run;
  std::int64_t h;
};

void require_in_range(const Vertex& vertex) {
  constexpr int kLow = std::numeric_limits<std::int16_t>::min();
  constexpr int kHigh = std::numeric_limits<std::int16_t>::max();
  const bool on_grid = kLow <= vertex.x && vertex.x <= kHigh && kLow <= vertex.y && vertex.y <= kHigh;
  if (!on_grid || vertex.z < -kMaxDepth || vertex.z > kMaxDepth) {
    throw std::invalid_argument("oracle: a vertex is out of range");
  }
}

std::vector<Edge> edges_of(const Facet& facet) {
  std::vector<Edge> edges;
  for (const std::vector<Vertex>& contour : facet.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vertex& from = contour[i];
      const Vertex& to = contour[i + 1 == contour.size() ? 0 : i + 1];
      require_in_range(from);
      if (from.y < to.y) edges.push_back({from, to});
      if (to.y < from.y) edges.push_back({to, from});
    }
  }
  return edges;
}

constexpr std::int64_t centre_of(int pixel) { return 16 * std::int64_t{pixel} + 8; }

constexpr std::int64_t ceil_div(std::int64_t value, std::int64_t divisor) {
  return value / divisor + (value % divisor > 0 ? 1 : 0);
}

// First pixel whose centre is not left of `numerator / divisor` 1/16 px: 16 p + 8 >= numerator / divisor.
constexpr std::int64_t first_centre(std::int64_t numerator, std::int64_t divisor) {
  return ceil_div(numerator - 8 * divisor, 16 * divisor);
}

int clamped(std::int64_t value, int limit) {
  return static_cast<int>(std::clamp(value, std::int64_t{0}, std::int64_t{limit}));
}

Crossing cross(const Edge& edge, std::int64_t y) {
  const std::int64_t h = edge.height();
  const std::int64_t below = y - edge.top.y;
  const std::int64_t run = edge.bottom.x - edge.top.x;
  return {edge.top.x * h + run * below, edge.top.z * h + (edge.bottom.z - edge.top.z) * below, run, h};
}

bool left_of(const Crossing& a, const Crossing& b) {
  const std::int64_t ax = a.x_times_h * b.h;
  const std::int64_t bx = b.x_times_h * a.h;
  return ax != bx ? ax < bx : a.run * b.h < b.run * a.h;
}

// With x in both edges' scale: z = (zl (xr - x) + zr (x - xl)) / (xr - xl), numerator and denominator times both
// heights.
Depth depth_at(const Crossing& left, const Crossing& right, std::int64_t x) {
  const Wide to_right = right.x_times_h - x * right.h;
  const Wide to_left = x * left.h - left.x_times_h;
  return {left.z_times_h * to_right + right.z_times_h * to_left, right.x_times_h * left.h - left.x_times_h * right.h};
}

void cover_chord(Rendering& rendering, std::uint32_t face, int line, const Crossing& left, const Crossing& right) {
  const int begin = clamped(first_centre(left.x_times_h, left.h), rendering.width());
  const int end = clamped(first_centre(right.x_times_h, right.h), rendering.width());
  for (int column = begin; column < end; ++column) {
    rendering.cover(column, line, {face, depth_at(left, right, centre_of(column))});
  }
}

void cover_facet(Rendering& rendering, const Facet& facet) {
  const std::vector<Edge> edges = edges_of(facet);
  if (edges.empty()) return;
  std::int64_t top = edges.front().top.y;
  std::int64_t bottom = edges.front().bottom.y;
  for (const Edge& edge : edges) {
    top = std::min<std::int64_t>(top, edge.top.y);
    bottom = std::max<std::int64_t>(bottom, edge.bottom.y);
  }
  std::vector<Crossing> crossings;
  const int end = clamped(first_centre(bottom, 1), rendering.height());
  for (int line = clamped(first_centre(top, 1), rendering.height()); line < end; ++line) {
    const std::int64_t y = centre_of(line);
    crossings.clear();
    for (const Edge& edge : edges) {
      if (edge.top.y <= y && y < edge.bottom.y) crossings.push_back(cross(edge, y));
    }
    std::sort(crossings.begin(), crossings.end(), left_of);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      cover_chord(rendering, facet.face, line, crossings[i], crossings[i + 1]);
    }
  }
}

bool hides(const Candidate& a, const Candidate& b) {
  const int order = compare_depths(a.depth, b.depth);
  return order != 0 ? order > 0 : a.face < b.face;
}

}  // namespace

Rendering::Rendering(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::size_t Rendering::index(int column, int line) const {
  return static_cast<std::size_t>(line) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
}

std::uint32_t Rendering::face(int column, int line) const {
  const std::vector<Candidate>& all = candidates(column, line);
  return all.empty() ? kNone : all.front().face;
}

Picture Rendering::picture() const {
  Picture picture(width_, height_);
  for (int line = 0; line < height_; ++line) {
    for (int column = 0; column < width_; ++column) picture.at(column, line) = face(column, line);
  }
  return picture;
}

void Rendering::cover(int column, int line, const Candidate& candidate) {
  std::vector<Candidate>& pixel = pixels_[index(column, line)];
  pixel.push_back(candidate);
  if (hides(pixel.back(), pixel.front())) std::swap(pixel.back(), pixel.front());
}

Rendering render(int width, int height, const std::vector<Facet>& facets) {
  if (width < 1 || width > kMaxExtent || height < 1 || height > kMaxExtent) {
    throw std::invalid_argument("oracle: the size is out of range");
  }
  Rendering rendering(width, height);
  for (const Facet& facet : facets) cover_facet(rendering, facet);
  return rendering;
}

}  // namespace spanline::oracle
