// The same teapot on the host, in a budget that lacks nothing: the checksum that the target has to reach.
#include <cstdio>

#include "memory/draw.hpp"
#include "teapot.hpp"

int main() {
  using Ample = spanline::target::Program<spanline::Budget{
      .facets = 1024, .vertices = 1024, .polygons = 256, .edges = 256, .segments = 256, .samples = 320, .implied = 64}>;
  Ample::draw(teapot::scene, teapot::camera);
  const spanline::target::Picture& picture = Ample::picture;
  std::printf("bands=%u checksum=%u status=%s\n", picture.bands, picture.checksum,
              picture.status.ok() ? "ok" : picture.status.where);
  return picture.status.ok() ? 0 : 1;
}
