#pragma once

#include "core/base/status.hpp"
#include "core/scene/format.hpp"

namespace spanline {

inline constexpr std::int32_t kMaxFocalPx = 4096;  // px; 3.4 degrees over 240 lines

// A camera at `eye` that looks at `target` with `up` as nearly upwards as can be. eye, target in world units; up needs
// no unit length; focal in px. Rows of the result are orthonormal within 2^-28. Integer arithmetic only, the same on
// every core. Fails with bad_argument (field "target" or "up") where eye and target coincide or up is parallel to the
// view, and as check_camera does.
Status look_at(const Fx16 (&eye)[3], const Fx16 (&target)[3], const Fx16 (&up)[3], Fx12 focal, Fx16 near_plane,
               Fx16 far_plane, CameraRecord& camera);

// Checks the ranges that the projection relies on: |eye| <= 2 * kMaxWorld, rows of unit length, 0 < focal <=
// kMaxFocalPx, 0 < near < far. The status names the field.
Status check_camera(const CameraRecord& camera);

// Whether two are the same; a comparison in few bytes for what is asked once a band.
bool same_camera(const CameraRecord& a, const CameraRecord& b);

}  // namespace spanline
