// OBJ text: read, compiled, rendered. Only an InputError may come out of it.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "assetc/input_error.hpp"
#include "assetc/obj.hpp"
#include "fuzz/render_small.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spanline::host;
  try {
    const ObjMesh obj = parse_obj("fuzz.obj", {reinterpret_cast<const char*>(data), size});
    SceneDescription scene;
    scene.place = "fuzz.obj";
    scene.instances.emplace_back();
    add_obj(scene, obj, "mesh", "fuzz.obj", size % 2 == 0 ? MeshShading::automatic : MeshShading::gouraud);
    render_small(std::move(scene));
  } catch (const InputError&) {
  }
  return 0;
}
