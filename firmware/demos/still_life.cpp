#include "demos/still_life.hpp"

#include "demos/motion.hpp"

namespace spanline::demos {

namespace {

constexpr std::uint32_t kLoop = 240;  // frames
constexpr Turn16 kSway{65536 * 14 / 360};

}  // namespace

void pose_still_life(std::uint32_t frame, const Shot& shot, const Moving& moving) {
  orbit(moving.camera, *shot.target, swing(kSway, part_of_turn(frame, 1, kLoop)));
}

}  // namespace spanline::demos
