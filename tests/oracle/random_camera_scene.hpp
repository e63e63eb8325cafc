// Seeded random scenes in space, for what lies before the screen: transforms, projection and clipping.
#pragma once

#include <cstdint>

#include "oracle/random.hpp"
#include "oracle/scene_store.hpp"

namespace spanline::oracle {

// Rows of a rotation, each entry a fraction of `divisor`, exactly orthogonal: from a quaternion of small integers.
struct Rotation {
  std::int64_t entry[3][3];
  std::int64_t divisor;  // > 0
};

Rotation random_rotation(Random& random);

struct CameraScene {
  SceneStore scene;
  CameraRecord camera;
};

// 1 … 60 plane polygons of every kind in 1 … 3 meshes and 1 … 4 turned, scaled and moved instances, seen from among
// them: some behind the eye, across the near plane, far beside the picture, beyond the far plane; some two-sided, some
// one-sided. Meant for a picture of 64 x 48 px.
CameraScene random_camera_scene(std::uint64_t seed);

}  // namespace spanline::oracle
