// The pictures of what is curved on the host: the checksums that the targets expect, too.
#include <cstdio>

#include "curves/draw.hpp"

int main() {
  bool good = true;
  spanline::target::draw_all([&good](const auto& picture, const auto& drawn) {
    const bool same = drawn.status.ok() && drawn.crc == picture.crc;
    good = good && same;
    std::printf("curves=%s crc=%08x expected=%08x%s\n", picture.name, drawn.crc, picture.crc,
                same ? " same" : " DIFFERS");
    if (!drawn.status.ok()) std::printf("%s: %u of %u\n", drawn.status.where, drawn.status.needed, drawn.status.limit);
  });
  return good ? 0 : 1;
}
