// The golden pictures on a target: one line a picture, and the exit status says whether all of them came out as
// expected.
#include "boards/common/frame_marks.hpp"
#include "golden/golden.hpp"
#include "hal/mcu/semihosting.hpp"
#include "report_sum.hpp"

namespace {

spanline::FrameMemory<spanline::golden::kBudget> memory;
constinit spanline::demos::Stage stage;
alignas(4) std::uint8_t line[spanline::golden::kMostLineBytes];

}  // namespace

int main() {
  using namespace spanline;
  bool good = true;
  for (const golden::Picture& picture : golden::kPictures) {
    std::uint32_t crc = 0;
    frame_begin_mark();
    const Status status = golden::draw(picture, memory.storage(), stage, line, crc);
    frame_end_mark();
    good = target::report_sum("golden", picture.name, status, crc, picture.crc) && good;
  }
  hal::semihosting::leave(good ? 0 : 1);
}
