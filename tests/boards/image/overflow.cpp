// Calls itself until the stack leaves RAM.
#include "board.hpp"
#include "boards/common/report.hpp"

namespace {

[[gnu::noinline]] std::uint32_t deeper(std::uint32_t depth) {
  volatile std::uint32_t frame[16];
  frame[depth % 16] = depth;
  return depth == 0xFFFFFFFF ? 0 : deeper(depth + 1) + frame[depth % 16];
}

}  // namespace

void spanline::boards::light(bool) {}
extern "C" void tick() {}

int main() { return static_cast<int>(deeper(0)); }
