// Scene JSON: read, compiled, rendered. Only an InputError may come out of it.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "assetc/input_error.hpp"
#include "assetc/scene_json.hpp"
#include "fuzz/render_small.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spanline::host;
  try {
    render_small(parse_scene("fuzz.json", {reinterpret_cast<const char*>(data), size}));
  } catch (const InputError&) {
  }
  return 0;
}
