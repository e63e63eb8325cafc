#include "demos/cubes.hpp"

#include "demos/motion.hpp"

namespace spanline::demos {

namespace {

constexpr std::uint32_t kLoop = 360;  // frames; every motion makes whole turns in them

struct Tumble {
  Axis first, second;
  std::uint32_t first_turns, second_turns;
};
constexpr Tumble kTumbles[] = {{Axis::y, Axis::x, 2, 1}, {Axis::z, Axis::y, 1, 2}, {Axis::x, Axis::z, 3, 1}};

constexpr Turn16 kSway{65536 * 15 / 360};

}  // namespace

void pose_cubes(std::uint32_t frame, const Shot& shot, const Moving& moving) {
  for (std::uint32_t i = 0; i < moving.instances.size(); ++i) {
    const Tumble& tumble = kTumbles[i % 3];
    InstanceRecord& cube = moving.instances[i];
    spin(cube, shot.origins, tumble.first, part_of_turn(frame, tumble.first_turns, kLoop));
    spin(cube, shot.origins, tumble.second, part_of_turn(frame, tumble.second_turns, kLoop));
  }
  orbit(moving.camera, *shot.target, swing(kSway, part_of_turn(frame, 1, kLoop)));
}

}  // namespace spanline::demos
