#include "demos/teapot.hpp"

#include "demos/motion.hpp"

namespace spanline::demos {

void pose_teapot(std::uint32_t frame, const Shot& shot, const Moving& moving) {
  spin(moving.instances[0], shot.origins, Axis::y, part_of_turn(frame, 1, 180));
}

}  // namespace spanline::demos
