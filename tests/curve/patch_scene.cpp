#include "curve/patch_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geom/camera.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

constexpr double kRadius = 800;    // world units
constexpr double kFocal = 1.2071;  // screen heights: 45 degrees

Fx16 fx(double v) { return Fx16::from_raw(static_cast<std::int32_t>(std::lround(v * Fx16::kOne))); }

struct Direction {
  double x, y, z;
};
Direction random_direction(oracle::Random& random) {
  const double turn = random.below(1 << 20) * 2 * std::numbers::pi / (1 << 20);
  const double z = random.below(1 << 20) * 2.0 / (1 << 20) - 1;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

}  // namespace

std::vector<PatchPoints> random_patches(std::uint64_t seed, int size) {
  oracle::Random random(seed);
  const auto side = static_cast<std::size_t>(size) * 3 + 1;
  std::vector<Position> net(side * side);
  const auto any = [&] { return static_cast<std::int16_t>(random.between(-30'000, 30'000)); };
  for (Position& p : net) p = {any(), any(), any()};
  std::vector<PatchPoints> out;
  for (std::size_t row = 0; row + 1 < side; row += 3) {
    for (std::size_t column = 0; column + 1 < side; column += 3) {
      PatchPoints& points = out.emplace_back();
      const bool turned = random.percent(50), transposed = random.percent(50);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          const Position& p = net[(row + i) * side + column + j];
          const std::size_t to_i = turned ? 3 - i : i;
          (transposed ? points[j][to_i] : points[to_i][j]) = p;
        }
      }
    }
  }
  return out;
}

ClipPatch PatchView::patch(const PatchPoints& points) const {
  ClipPatch out;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) out.at[i][j] = matrix(points[i][j]);
  }
  return out;
}

PatchView random_view(std::uint64_t seed, double distance, std::uint32_t tolerance, const Screen& screen) {
  oracle::Random random(seed);
  const Direction from = random_direction(random), up = random_direction(random), at = random_direction(random);
  const double away = distance * kRadius / (0.9 * std::sin(std::numbers::pi / 8));
  const double aside = kRadius * random.below(100) / 400;
  const Fx16 target[3] = {fx(at.x * aside), fx(at.y * aside), fx(at.z * aside)};
  const Fx16 eye[3] = {fx(at.x * aside + from.x * away), fx(at.y * aside + from.y * away),
                       fx(at.z * aside + from.z * away)};
  const Fx16 upwards[3] = {fx(up.x), fx(up.y), fx(up.z)};
  CameraRecord camera{};
  const auto focal = Fx12::from_raw(static_cast<std::int32_t>(std::lround(kFocal * screen.height * Fx12::kOne)));
  const Status status = look_at(eye, target, upwards, focal, fx(8), fx(20'000), camera);
  if (!status.ok()) return random_view(seed + 1'000'003, distance, tolerance, screen);  // up along the view
  MeshRecord mesh{};
  mesh.unit = static_cast<std::int32_t>(std::lround(kRadius / kPatchReach * 2147483648.0));
  const Projection projection(camera, screen);
  return {projection, compose(camera, Transform::identity(), mesh), DiceView(camera, screen, tolerance)};
}

}  // namespace spanline::test
