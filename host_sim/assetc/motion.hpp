// Key-framed motion of ten numbers: what an instance's or a camera's placement is made of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace spanline::host {

// An instance: translation 3, turn 4, scale 3. A camera: eye 3, target 3, up 3, fov 1.
using Pose = std::array<double, 10>;

struct MotionKey {
  std::int64_t frame;
  Pose pose;
};

struct Motion {
  std::vector<MotionKey> keys;  // frames strictly ascending; empty: nothing moves
  std::int64_t frames = 1;      // length of the loop, at least 1
  bool loop = true;
  bool smooth = false;

  // The pose in `frame` (>= 0), or `rest` where there are no keys. Never leaves the hull of the keys.
  Pose at(std::int64_t frame, const Pose& rest) const;
};

}  // namespace spanline::host
