#include "frame/patch_oversampled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace spanline::test {
namespace {

constexpr int kSteps = 64;

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

host::Vec3 point_at(const std::vector<host::Vec3>& control, const std::array<double, 4>& u,
                    const std::array<double, 4>& v) {
  host::Vec3 sum{};
  for (std::size_t i = 0; i < 16; ++i) sum = sum + (v[i / 4] * u[i % 4]) * control[i];
  return sum;
}

using Side = std::array<std::int32_t, 4>;

Side side_of(const host::MeshSource& mesh, std::size_t face, const Side& corners) {
  Side side;
  for (std::size_t i = 0; i < 4; ++i) {
    side[i] = mesh.corners[mesh.faces[face].first_corner + static_cast<std::size_t>(corners[i])].position;
  }
  return std::min(side, Side{side[3], side[2], side[1], side[0]});
}

// By 1 + the patch's number: the lowest such number of the part that it belongs to.
std::vector<std::uint16_t> parts_of(const host::MeshSource& mesh) {
  constexpr Side kSides[4] = {{0, 1, 2, 3}, {12, 13, 14, 15}, {0, 4, 8, 12}, {3, 7, 11, 15}};
  std::vector<std::uint16_t> part(mesh.faces.size() + 1);
  std::map<Side, std::size_t> first;  // patch that has the side
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) part[i + 1] = static_cast<std::uint16_t>(i + 1);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (const Side& corners : kSides) {
      const Side side = side_of(mesh, i, corners);
      if (side[0] == side[3] && side[0] == side[1]) continue;  // a pole joins nothing
      const auto [found, is_new] = first.try_emplace(side, i);
      const std::uint16_t a = part[i + 1], b = part[found->second + 1];
      std::replace(part.begin(), part.end(), std::max(a, b), std::min(a, b));
    }
  }
  return part;
}

}  // namespace

Oversampled::Oversampled(const host::SceneDescription& scene)
    : width_(scene.width * kSamples),
      height_(scene.height * kSamples),
      part_of_(parts_of(scene.meshes[0])),
      samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void Oversampled::draw(const host::CompiledScene& scene) {
  view_ = scene.view();
  axes_ = host::axes_of(view_);
  focal_ = height_ / 2.0 / std::tan(host::radians(view_.fov) / 2);
  std::fill(samples_.begin(), samples_.end(), Sample{});
  const host::MeshSource& mesh = scene.description().meshes[0];
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    std::vector<host::Vec3> control;
    for (std::uint32_t c = 0; c < 16; ++c) {
      const host::ObjCorner& corner = mesh.corners[mesh.faces[i].first_corner + c];
      control.push_back(mesh.positions[static_cast<std::size_t>(corner.position)]);
    }
    add(control, static_cast<std::uint16_t>(i + 1));
  }
}

Oversampled::Corner Oversampled::project(host::Vec3 p) const {
  const host::Vec3 from_eye = p - view_.eye;
  const double distance = -dot(axes_.back, from_eye);
  return {width_ / 2.0 + focal_ * dot(axes_.right, from_eye) / distance,
          height_ / 2.0 - focal_ * dot(axes_.up, from_eye) / distance, 1 / distance};
}

void Oversampled::add(const std::vector<host::Vec3>& control, std::uint16_t id) {
  std::vector<Corner> above, below;
  for (int j = 0; j <= kSteps; ++j) {
    below.clear();
    for (int i = 0; i <= kSteps; ++i) {
      below.push_back(project(point_at(control, bernstein(double(i) / kSteps), bernstein(double(j) / kSteps))));
    }
    for (std::size_t i = 0; j > 0 && i < kSteps; ++i) {
      triangle(above[i], above[i + 1], below[i + 1], id);
      triangle(above[i], below[i + 1], below[i], id);
    }
    above.swap(below);
  }
}

// Samples on an edge belong to both sides.
void Oversampled::triangle(const Corner& a, const Corner& b, const Corner& c, std::uint16_t id) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0) return;
  const auto range = [](double low, double high, int most) {
    return std::pair(std::max(0, static_cast<int>(std::ceil(low - 0.5))),
                     std::min(most - 1, static_cast<int>(std::floor(high - 0.5))));
  };
  const auto [top, bottom] = range(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height_);
  const auto [left, right] = range(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width_);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
      const double of_b = (px * (c.y - a.y) - (c.x - a.x) * py) / area;
      const double of_c = ((b.x - a.x) * py - px * (b.y - a.y)) / area;
      constexpr double kOnEdge = -1e-9;
      if (of_b < kOnEdge || of_c < kOnEdge || of_b + of_c > 1 - kOnEdge) continue;
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      const auto depth = static_cast<float>(a.depth + of_b * (b.depth - a.depth) + of_c * (c.depth - a.depth));
      Sample& sample = samples_[at];
      const bool other = part_of_[id] != part_of_[sample.id];
      if (depth > sample.depth) {
        if (other) sample.second = sample.id, sample.second_depth = sample.depth;
        sample.id = id;
        sample.depth = depth;
      } else if (other && depth > sample.second_depth) {
        sample.second = id;
        sample.second_depth = depth;
      }
    }
  }
}

template <typename Wanted>
bool Oversampled::any_near(int column, int line, double radius, const Wanted& wanted) const {
  const double cx = (column + 0.5) * kSamples - 0.5, cy = (line + 0.5) * kSamples - 0.5, r = radius * kSamples;
  for (int y = static_cast<int>(std::ceil(cy - r)); y <= cy + r; ++y) {
    for (int x = static_cast<int>(std::ceil(cx - r)); x <= cx + r; ++x) {
      if ((x - cx) * (x - cx) + (y - cy) * (y - cy) > r * r) continue;
      const bool inside = x >= 0 && x < width_ && y >= 0 && y < height_;
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      if (!inside || wanted(samples_[at])) return true;  // nobody knows what lies off the picture
    }
  }
  return false;
}

bool Oversampled::shows(std::uint32_t id, int column, int line, double radius) const {
  return any_near(column, line, radius, [id](const Sample& there) { return there.id == id; });
}

bool Oversampled::shows_any(int column, int line, double radius) const {
  return any_near(column, line, radius, [](const Sample& there) { return there.id != 0; });
}

bool Oversampled::pierced_by(std::uint32_t id, int column, int line, double radius, double depth) const {
  const double px = focal_ / kSamples;  // at distance 1
  return any_near(column, line, radius, [&](const Sample& there) {
    return there.second == id && (1 / there.second_depth - 1 / there.depth) * px * there.depth < depth;
  });
}

const Oversampled::Sample& Oversampled::middle(int column, int line) const {
  return samples_[(static_cast<std::size_t>(line) * kSamples + kSamples / 2) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(column) * kSamples + kSamples / 2];
}

std::uint32_t Oversampled::only(int column, int line, double radius) const {
  const std::uint16_t id = middle(column, line).id;
  return any_near(column, line, radius, [id](const Sample& there) { return there.id != id; }) ? kSeveral : id;
}

bool Oversampled::inside_a_part(int column, int line, double radius) const {
  const std::uint16_t part = part_of_[middle(column, line).id];
  return part != 0 && !any_near(column, line, radius, [&](const Sample& there) { return part_of_[there.id] != part; });
}

}  // namespace spanline::test
