#include "frame/patch_views.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "assetc/patch_mesh.hpp"
#include "assetc/scene_json.hpp"
#include "sim/status_text.hpp"

namespace spanline::test {
namespace {

constexpr double kReach = 12;  // bounding radii within which eyes stand

host::Vec3 random_direction(oracle::Random& random) {
  const double turn = random.below(1 << 20) * 2 * std::numbers::pi / (1 << 20);
  const double z = random.below(1 << 20) * 2.0 / (1 << 20) - 1;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

}  // namespace

host::CompiledScene teapot_scene(host::MeshShading shading, std::uint16_t width, std::uint16_t height) {
  host::SceneDescription scene = host::describe_bpt(std::string(SPANLINE_ASSETS) + "/teapot.bpt", shading);
  scene.width = width;
  scene.height = height;
  return compile(std::move(scene), kReach);
}

host::CompiledScene scene_of(const std::string& json) {
  return compile(host::parse_scene(std::string(SPANLINE_ASSETS) + "/test.json", json), kReach);
}

void look_from_anywhere(host::CompiledScene& scene, oracle::Random& random, double distance) {
  const host::Sphere bounds = scene.bounds();
  host::CameraSpec camera;
  camera.has_eye = camera.has_target = true;
  const double away = distance * bounds.radius / (0.9 * std::sin(std::numbers::pi / 8));
  do {
    camera.target = bounds.centre + (0.25 * bounds.radius * random.below(100) / 100) * random_direction(random);
    camera.eye = camera.target + away * random_direction(random);
    camera.up = random_direction(random);
  } while (host::view_fault(camera.eye, camera.target, camera.up) != nullptr);
  scene.look(host::view_in_frame(camera, bounds, scene.description().height, 0, "view"));
}

host::Rendering render(const host::CompiledScene& scene, host::EngineOptions options, bool observe) {
  options.width = scene.description().width;
  options.height = scene.description().height;
  options.observe = observe;
  host::Rendering out;
  const SceneRecord record = scene.record();
  const Status status = host::Engine::make(options)->render(host::validated(record, "s"), scene.camera(), out);
  EXPECT_TRUE(status.ok()) << host::status_text(status);
  return out;
}

}  // namespace spanline::test
