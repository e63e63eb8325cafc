// Draws the scenes in both budgets and prints what each took, one line a scene and budget, and what a block of each
// pool costs.
#include "boards/common/report.hpp"
#include "hal/mcu/semihosting.hpp"
#include "machine/stack.hpp"
#include "memory/budgets.hpp"
#include "memory/draw.hpp"
#include "teapot.hpp"
#include "torus.hpp"

namespace spanline::target {
namespace {

using boards::print;

void print_pair(const char* key, std::uint32_t value) {
  print(" ");
  print(key);
  print("=");
  print(value);
}

// What is measured takes no arguments, so that none of them lie on the stack.
const SceneRecord* scene_to_draw;
const CameraRecord* camera_to_draw;

// The Frame lives on the stack of draw(): `stack` contains it.
template <Budget kBudget>
bool measure(const char* name, const char* scene_name) {
  using Memory = Program<kBudget>;
  const std::uint32_t stack = stack_used_by([] { Memory::draw(*scene_to_draw, *camera_to_draw); });
  const Picture& picture = Memory::picture;
  print("budget=");
  print(name);
  print(" scene=");
  print(scene_name);
  print_pair("memory", sizeof Memory::memory);
  print_pair("lines", sizeof Memory::lines);
  print_pair("stack", stack);
  print_pair("frame", sizeof(Frame<>));
  print_pair("sum", sizeof Memory::memory + sizeof Memory::lines + stack);
  print_pair("bands", picture.bands);
  print_pair("checksum", picture.checksum);
  if (picture.status.ok()) {
    print(" status=ok\n");
    return true;
  }
  print(" status=");
  print(picture.status.where);
  print_pair("line", picture.status.line);
  print_pair("needed", picture.status.needed);
  print_pair("limit", picture.status.limit);
  print("\n");
  return false;
}

void print_pool(const char* name, std::uint32_t block, std::uint32_t in_16k, std::uint32_t in_8k) {
  print("pool=");
  print(name);
  print_pair("block", block);
  print_pair("16K", in_16k);
  print_pair("8K", in_8k);
  print("\n");
}

void print_pools() {
  print_pool("facets", sizeof(WaitingFacet), k16K.facets, k8K.facets);
  print_pool("band_lines", sizeof(std::uint16_t), k16K.height, k8K.band_lines);
  print_pool("vertices", sizeof(ScreenPoint), k16K.vertices, k8K.vertices);
  print_pool("polygons", sizeof(PolygonBlock), k16K.polygons, k8K.polygons);
  print_pool("edges", sizeof(EdgeBlock), k16K.edges, k8K.edges);
  print_pool("segments", sizeof(SegmentBlock), k16K.segments, k8K.segments);
  print_pool("colours", sizeof(SegmentShade), 0, 0);
  print_pool("active", sizeof(ActiveSegment), k16K.active, k8K.active);
  print_pool("samples", 2 * sizeof(std::int16_t), k16K.samples, k8K.samples);
  print_pool("implied", sizeof(ImpliedEdge), k16K.implied, k8K.implied);
}

}  // namespace
}  // namespace spanline::target

int main() {
  using namespace spanline::target;
  bool good = true;
  const auto measure_both = [&](const char* name, const spanline::SceneRecord& scene,
                                const spanline::CameraRecord& camera) {
    scene_to_draw = &scene;
    camera_to_draw = &camera;
    good = measure<k16K>("16K", name) && good;
    good = measure<k8K>("8K", name) && good;
  };
  measure_both("teapot", teapot::scene, teapot::camera);
  measure_both("torus", torus::scene, torus::camera);
  print_pools();
  spanline::hal::semihosting::leave(good ? 0 : 1);
}
