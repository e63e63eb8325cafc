// Patch files: read, compiled, rendered. Only an InputError may come out of it.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "assetc/input_error.hpp"
#include "assetc/patch_mesh.hpp"
#include "fuzz/render_small.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spanline::host;
  try {
    const auto patches = parse_bpt("fuzz.bpt", {reinterpret_cast<const char*>(data), size});
    SceneDescription scene;
    scene.place = "fuzz.bpt";
    scene.instances.emplace_back().cull = size % 3 == 0;
    add_patches(scene, patches, "patches", "fuzz.bpt", size % 2 == 0 ? MeshShading::automatic : MeshShading::flat);
    render_small(std::move(scene));
  } catch (const InputError&) {
  }
  return 0;
}
