#include "demos/gauges.hpp"

#include "demos/motion.hpp"

namespace spanline::demos {

namespace {

constexpr std::uint32_t kLoop = 360;  // frames
constexpr Turn16 degrees(std::uint32_t d) { return {static_cast<std::uint16_t>(d * 65536u / 360)}; }

// A needle's way about the middle of its scale: a slow sweep and a faster tremble on it.
struct Needle {
  Turn16 sweep, tremble;
  std::uint32_t sweep_turns, tremble_turns;
  Turn16 phase;
};
constexpr Needle kNeedles[] = {{degrees(105), degrees(12), 1, 5, degrees(0)},
                               {degrees(80), degrees(20), 2, 7, degrees(140)},
                               {degrees(50), degrees(8), 1, 9, degrees(250)}};

}  // namespace

// A gauge is a needle, then what stands still.
void pose_gauges(std::uint32_t frame, const Shot& shot, const Moving& moving) {
  constexpr std::uint32_t kParts = 4;
  for (std::uint32_t i = 0; i * kParts < moving.instances.size(); ++i) {
    const Needle& needle = kNeedles[i];
    const Turn16 sweep = swing(needle.sweep, part_of_turn(frame, needle.sweep_turns, kLoop) + needle.phase);
    const Turn16 tremble = swing(needle.tremble, part_of_turn(frame, needle.tremble_turns, kLoop));
    spin(moving.instances[i * kParts], shot.origins, Axis::z, sweep + tremble);
  }
}

}  // namespace spanline::demos
