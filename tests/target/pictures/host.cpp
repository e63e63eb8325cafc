// The oracle's pictures on the host, in the target's own words.
#include <cstdio>

#include "pictures/draw.hpp"

int main() {
  bool good = true;
  spanline::target::decide_all([&good](const auto& picture, const char* way, const auto& decided) {
    const bool same = decided.same_as(picture);
    good = good && same;
    std::printf("picture=%s by=%s%s\n", picture.name, way,
                same                  ? " same"
                : decided.status.ok() ? " DIFFERS"
                                      : " FAILED");
  });
  return good ? 0 : 1;
}
