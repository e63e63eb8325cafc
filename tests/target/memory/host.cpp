// The same scenes on the host, in a budget that lacks nothing: the checksums that the target has to reach.
#include <cstdio>

#include "memory/draw.hpp"
#include "teapot.hpp"
#include "torus.hpp"

namespace {

using Ample = spanline::target::Program<spanline::Budget{
    .facets = 1024, .vertices = 1024, .polygons = 256, .edges = 256, .segments = 256, .samples = 320, .implied = 64}>;

bool draw(const char* name, const spanline::SceneRecord& scene, const spanline::CameraRecord& camera) {
  Ample::draw(scene, camera);
  const spanline::target::Picture& picture = Ample::picture;
  std::printf("scene=%s bands=%u checksum=%u status=%s\n", name, picture.bands, picture.checksum,
              picture.status.ok() ? "ok" : picture.status.where);
  return picture.status.ok();
}

}  // namespace

int main() {
  const bool teapot = draw("teapot", teapot::scene, teapot::camera);
  const bool torus = draw("torus", torus::scene, torus::camera);
  return teapot && torus ? 0 : 1;
}
