// The golden pictures in lines on a target, as tests/target/golden has the others.
#include "boards/common/frame_marks.hpp"
#include "golden/lines.hpp"
#include "hal/mcu/semihosting.hpp"
#include "report_sum.hpp"

namespace {

spanline::LineMemory<spanline::golden::kLineBudget> memory;
constinit spanline::demos::Stage stage;
alignas(4) std::uint8_t line[spanline::golden::kMostLineBytes];

}  // namespace

int main() {
  using namespace spanline;
  bool good = true;
  for (const golden::Picture& picture : golden::kLinePictures) {
    std::uint32_t crc = 0;
    frame_begin_mark();
    const Status status = golden::draw_lines(picture, memory.storage(), stage, line, crc);
    frame_end_mark();
    good = target::report_sum("lines", picture.name, status, crc, picture.crc) && good;
  }
  hal::semihosting::leave(good ? 0 : 1);
}
