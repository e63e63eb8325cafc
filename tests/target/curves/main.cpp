// The pictures of what is curved on a target: one line a picture, and the exit status says whether all of them came out
// as expected.
#include "curves/draw.hpp"
#include "hal/mcu/semihosting.hpp"
#include "report_sum.hpp"

int main() {
  bool good = true;
  spanline::target::draw_all([&good](const auto& picture, const auto& drawn) {
    good = spanline::target::report_sum("curves", picture.name, drawn.status, drawn.crc, picture.crc) && good;
  });
  spanline::hal::semihosting::leave(good ? 0 : 1);
}
