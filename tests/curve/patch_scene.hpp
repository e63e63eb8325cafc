// Patches and random views of them, for the tests of dicing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/curve/dice.hpp"
#include "core/scene/format.hpp"

namespace spanline::test {

using PatchPoints = std::array<std::array<Position, 4>, 4>;  // rows of control points, mesh units

inline constexpr double kPatchReach = 30'000;  // mesh units

// The teapot's 32 patches, kPatchReach to its farthest control point.
std::vector<PatchPoints> teapot_patches();

// size x size patches over one net of random control points: neighbours share their sides' control points, half of the
// patches are turned over, so that they run along shared sides in both directions.
std::vector<PatchPoints> random_patches(std::uint64_t seed, int size);

inline constexpr Screen kPatchScreen{320, 240, PixelFormat::rgb565};

struct PatchView {
  Projection projection;
  ClipMatrix matrix;
  DiceView dice;

  ClipPatch patch(const PatchPoints& points) const;
};

// A camera somewhere about the model, 800 world units across its half. `distance` is a multiple of the one from which
// the model fills 90 % of the screen's height.
PatchView random_view(std::uint64_t seed, double distance, std::uint32_t tolerance,
                      const Screen& screen = kPatchScreen);

}  // namespace spanline::test
