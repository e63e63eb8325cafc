#include "curve/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spanline::test {
namespace {

double distance(Place p, Place a, Place b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// From the upper to the lower end, so that both users of an edge find the same crossing.
std::pair<Place, Place> downwards(Place a, Place b) {
  return b.y < a.y || (b.y == a.y && b.x < a.x) ? std::pair(b, a) : std::pair(a, b);
}

double crossing(Place a, Place b, double y) { return a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y); }

}  // namespace

void Coverage::add(const std::vector<Place>& polygon) {
  polygons_.push_back(polygon);
  double top = height_, bottom = 0;
  for (const Place& p : polygon) {
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  std::vector<double> crossings;
  const int last = std::min(height_ - 1, static_cast<int>(std::floor(bottom)));
  for (int line = std::max(0, static_cast<int>(std::floor(top))); line <= last; ++line) {
    const double y = line + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto [a, b] = downwards(polygon[i], polygon[(i + 1) % polygon.size()]);
      if (a.y <= y && y < b.y) crossings.push_back(crossing(a, b, y));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double left = std::clamp(std::ceil(crossings[i] - 0.5), 0.0, static_cast<double>(width_));
      const double right = std::clamp(std::ceil(crossings[i + 1] - 0.5), 0.0, static_cast<double>(width_));
      if (left >= right) continue;
      left_ = std::min(left_, static_cast<int>(left));
      right_ = std::max(right_, static_cast<int>(right));
      top_ = std::min(top_, line);
      bottom_ = std::max(bottom_, line + 1);
      for (int x = static_cast<int>(left); x < static_cast<int>(right); ++x) {
        covered_[index(x, line)] = true;
      }
    }
  }
}

void Coverage::add(int x, int y) {
  if (x < 0 || x >= width_ || y < 0 || y >= height_) return;
  covered_[index(x, y)] = true;
  left_ = std::min(left_, x);
  right_ = std::max(right_, x + 1);
  top_ = std::min(top_, y);
  bottom_ = std::max(bottom_, y + 1);
}

bool Coverage::any_beside(int x, int y, bool wanted) const {
  const auto is = [&](int u, int v) {
    return u >= 0 && u < width_ && v >= 0 && v < height_ && covered(u, v) == wanted;
  };
  return is(x - 1, y) || is(x + 1, y) || is(x, y - 1) || is(x, y + 1);
}

bool Coverage::covers(Place p) const {
  for (const auto& polygon : polygons_) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto [a, b] = downwards(polygon[i], polygon[(i + 1) % polygon.size()]);
      if (a.y <= p.y && p.y < b.y && p.x >= crossing(a, b, p.y)) inside = !inside;
    }
    if (inside) return true;
  }
  return false;
}

bool Coverage::covers_about(Place p, int eighths) const {
  for (int v = -eighths; v <= eighths; ++v) {
    for (int u = -eighths; u <= eighths; ++u) {
      if (u * u + v * v <= eighths * eighths && !covers({p.x + u / 8.0, p.y + v / 8.0})) return false;
    }
  }
  return true;
}

int Coverage::far_from(const Coverage& other) const {
  int count = 0;
  for (int y = top_; y < bottom_; ++y) {
    for (int x = left_; x < right_; ++x) {
      if (!covered(x, y) || other.covered(x, y) || other.any_beside(x, y, true)) continue;
      if (other.distance_to_outlines({x + 0.5, y + 0.5}) > 1) ++count;
    }
  }
  return count;
}

double Coverage::distance_to_outlines(Place p) const {
  double nearest = HUGE_VAL;
  for (const auto& polygon : polygons_) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      nearest = std::min(nearest, distance(p, polygon[i], polygon[(i + 1) % polygon.size()]));
    }
  }
  return nearest;
}

int Coverage::holes_against(const Coverage& other, int inside) const {
  int count = 0;
  for (int y = other.top_; y < other.bottom_; ++y) {
    for (int x = other.left_; x < other.right_; ++x) {
      if (covered(x, y) || !other.covered(x, y)) continue;
      if (inside >= 8 && other.any_beside(x, y, false)) continue;
      if (other.covers_about({x + 0.5, y + 0.5}, inside)) ++count;
    }
  }
  return count;
}

}  // namespace spanline::test
