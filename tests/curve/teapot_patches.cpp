#include <algorithm>
#include <cmath>
#include <string>

#include "assetc/bpt.hpp"
#include "curve/patch_scene.hpp"

namespace spanline::test {

std::vector<PatchPoints> teapot_patches() {
  const auto patches = host::read_bpt(std::string(SPANLINE_ASSETS) + "/teapot.bpt");
  double farthest = 0;
  for (const auto& patch : patches) {
    for (const auto& row : patch.points) {
      for (const host::Vec3 p : row) farthest = std::max(farthest, host::largest(p));
    }
  }
  const auto grid = [&](double v) { return static_cast<std::int16_t>(std::lround(v * kPatchReach / farthest)); };
  std::vector<PatchPoints> out;
  for (const auto& patch : patches) {
    PatchPoints& points = out.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const host::Vec3 p = patch.points[i][j];
        points[i][j] = {grid(p.x), grid(p.y), grid(p.z)};
      }
    }
  }
  return out;
}

}  // namespace spanline::test
