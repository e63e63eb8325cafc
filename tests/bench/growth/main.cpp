// Sorts a scene of SPANLINE_GROWTH polygons in windows of at most SPANLINE_WINDOW and prints what was done.
#include "bench/growth/scatter.hpp"
#include "boards/common/report.hpp"
#include "core/area/window_sort.hpp"
#include "hal/mcu/semihosting.hpp"

namespace spanline::bench {
namespace {

// With windows the pools hold one window; without, everything.
constexpr bool kWindows = SPANLINE_WINDOW != 0;
constexpr std::uint16_t kPolygons = kWindows ? 2 * SPANLINE_WINDOW : SPANLINE_GROWTH + 1;
constexpr std::uint16_t kPieces = kWindows ? 64 : 2 * SPANLINE_GROWTH;
constexpr std::uint16_t kBorders = kWindows ? 1024 : 40 * SPANLINE_GROWTH < 32000 ? 40 * SPANLINE_GROWTH : 32000;

area::SortStorage<kPolygons, kBorders, kPieces, 1> storage;
// More where one window holds everything: half of all intersections are between hidden edges.
Pool<area::BorderEdge, kWindows ? 1 : 65000> borders;
Pool<area::Node, kWindows ? 1 : 65000> nodes;
Pool<std::uint16_t, 2 * SPANLINE_GROWTH + 1000> names;

// A timer of Arm's MPS2 boards that counts down at 25 MHz. The emulator lets an instruction take 1 ns (-icount
// shift=0), so a tick is 40 instructions.
constexpr std::uint32_t kInstructionsATick = 40;
volatile std::uint32_t* const timer = reinterpret_cast<volatile std::uint32_t*>(0x40000000u);
enum Timer { kControl, kValue, kReload };

void start_timer() {
  timer[kReload] = UINT32_MAX;
  timer[kValue] = UINT32_MAX;
  timer[kControl] = 1;
}
std::uint32_t ticks() { return UINT32_MAX - timer[kValue]; }

}  // namespace
}  // namespace spanline::bench

int main() {
  using namespace spanline;
  using namespace spanline::bench;
  area::SortPools pools = storage.refs();
  if (!kWindows) {
    pools.borders = borders.ref();
    pools.clipper.nodes = nodes.ref();
  }
  area::AreaSort sort(pools);
  area::WindowSort<Scatter> windows(sort, names.ref(), SPANLINE_WINDOW);
  CountPieces count;
  start_timer();
  const Status status = windows.solve(Scatter(SPANLINE_GROWTH), kGrowthScreen, count);
  const std::uint32_t taken = ticks();
  const area::WindowCounts& counts = windows.counts();
  boards::print_pair("pairs", counts.sort.pairs);
  boards::print_pair("clips", counts.sort.clips);
  boards::print_pair("windows", counts.windows);
  boards::print_pair("pieces", count.pieces);
  boards::print_pair(
      "memory", static_cast<std::uint32_t>(kWindows ? sizeof storage : sizeof storage + sizeof borders + sizeof nodes));
  boards::print_pair("thousands", static_cast<std::uint32_t>(std::uint64_t{taken} * kInstructionsATick / 1000));
  hal::semihosting::leave(status.ok() ? 0 : 1);
}
