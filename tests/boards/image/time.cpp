// Whether the board's clock goes: prints what a delay of 5 ms took.
#include "board.hpp"
#include "boards/common/report.hpp"

namespace {

spanline::boards::Board board;

}  // namespace

void spanline::boards::light(bool) {}
extern "C" void tick() { spanline::boards::Board::tick(); }

int main() {
  using namespace spanline::boards;
  static_cast<void>(board.begin());
  const Board::Time time;
  const std::uint32_t from = time.now_us();
  time.delay_us(5000);
  print("slept ");
  print(time.now_us() - from);
  print(" us\n");
  return 0;
}
