#include "demos/gears.hpp"

#include "demos/motion.hpp"

namespace spanline::demos {

namespace {

// 3 turns of 20 teeth are 5 turns of 12: both wheels stand as they began after so many frames.
constexpr std::uint32_t kLoop = 600;

}  // namespace

void pose_gears(std::uint32_t frame, const Shot& shot, const Moving& moving) {
  spin(moving.instances[0], shot.origins, Axis::z, part_of_turn(frame, 3, kLoop));
  const Turn16 driven = part_of_turn(frame, 5, kLoop);
  spin(moving.instances[1], shot.origins, Axis::z, {static_cast<std::uint16_t>(-driven.raw)});
}

}  // namespace spanline::demos
