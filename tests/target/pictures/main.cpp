// The oracle's pictures on a target: one line a picture and way to draw it.
#include "boards/common/report.hpp"
#include "hal/mcu/semihosting.hpp"
#include "pictures/draw.hpp"

int main() {
  using spanline::boards::print;
  bool good = true;
  spanline::target::decide_all([&good](const auto& picture, const char* way, const auto& decided) {
    const bool same = decided.same_as(picture);
    good = good && same;
    print("picture=");
    print(picture.name);
    print(" by=");
    print(way);
    print(same ? " same\n" : decided.status.ok() ? " DIFFERS\n" : " FAILED\n");
  });
  spanline::hal::semihosting::leave(good ? 0 : 1);
}
