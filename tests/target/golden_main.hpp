// What the images of golden pictures do: one line a picture, and the exit status says whether all of them came out as
// expected.
#pragma once

#include "boards/common/frame_marks.hpp"
#include "golden/golden.hpp"
#include "hal/mcu/semihosting.hpp"
#include "report_sum.hpp"

namespace spanline::target {

// Draws them in the pools of `storage`; `image` names them in the report. Ends the run.
template <std::size_t kCount, typename Storage>
[[noreturn]] void report_pictures(const char* image, const golden::Picture (&pictures)[kCount],
                                  const Storage& storage) {
  static constinit demos::Stage stage;
  alignas(4) static std::uint8_t line[golden::kMostLineBytes];
  bool good = true;
  for (const golden::Picture& picture : pictures) {
    std::uint32_t crc = 0;
    frame_begin_mark();
    const Status status = draw(picture, storage, stage, line, crc);
    frame_end_mark();
    good = report_sum(image, picture.name, status, crc, picture.crc) && good;
  }
  hal::semihosting::leave(good ? 0 : 1);
}

}  // namespace spanline::target
