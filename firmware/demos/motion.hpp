// How demos move: everything from the frame number, nothing from the frame before, so that no error adds up.
#pragma once

#include <cstdint>

#include "core/fx/fixed.hpp"
#include "core/scene/format.hpp"

namespace spanline::demos {

enum class Axis : std::uint8_t { x, y, z };

// The angle in frame `frame` of a motion that makes `turns` turns in `frames` frames and then repeats.
constexpr Turn16 part_of_turn(std::uint64_t frame, std::uint32_t turns, std::uint32_t frames) {
  return {static_cast<std::uint16_t>(frame % frames * turns * 65536u / frames)};
}

// Turns an instance about an axis of the world's direction through the origin of its mesh's own coordinates,
// counter-clockwise seen from the axis' tip. `origins`: of these coordinates, for each mesh of the scene
// (Shot::origins).
void spin(InstanceRecord& instance, const Fx16 (*origins)[3], Axis axis, Turn16 angle);

// `amplitude` * sine(phase), rounded to nearest.
Turn16 swing(Turn16 amplitude, Turn16 phase);

// Carries the camera round `target` about the vertical by `aside` and keeps looking there.
void orbit(CameraRecord& camera, const Fx16 (&target)[3], Turn16 aside);

}  // namespace spanline::demos
