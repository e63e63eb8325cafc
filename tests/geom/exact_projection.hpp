// The slow twin of transform and projection: from the records, in long double (64 bits of fraction: errors far below
// the 1/16 px that are compared), sharing no code with the engine.
#pragma once

#include "core/scene/format.hpp"

namespace spanline::test {

struct EyePoint {
  long double right, up, ahead;  // world units from the eye
};

struct ExactPoint {
  long double x, y;   // 1/16 px, y down
  long double depth;  // --screen units: 65536 * near / distance
};

EyePoint seen_from(const CameraRecord& camera, const InstanceRecord& instance, const MeshRecord& mesh,
                   const Position& position);

// `point` must lie ahead of the eye.
ExactPoint project(const EyePoint& point, const CameraRecord& camera, int width, int height);

}  // namespace spanline::test
