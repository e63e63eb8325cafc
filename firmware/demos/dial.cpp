#include "demos/dial.hpp"

#include "demos/motion.hpp"

namespace spanline::demos {

namespace {

constexpr std::uint32_t kLoop = 360;  // frames
constexpr Turn16 kSweep{65536 * 100 / 360}, kTremble{65536 * 14 / 360};

}  // namespace

// The dial stands still, the needle swings about the top.
void pose_dial(std::uint32_t frame, const Shot& shot, const Moving& moving) {
  const Turn16 sweep = swing(kSweep, part_of_turn(frame, 1, kLoop));
  const Turn16 tremble = swing(kTremble, part_of_turn(frame, 7, kLoop));
  spin(moving.instances[1], shot.origins, Axis::z, sweep + tremble);
}

}  // namespace spanline::demos
