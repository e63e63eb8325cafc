// Scenes of patches and random views of them, for the tests of how they are drawn.
#pragma once

#include <string>

#include "assetc/compile.hpp"
#include "oracle/random.hpp"
#include "sim/engine.hpp"

namespace spanline::test {

// The teapot seen by the default camera; z is up.
host::CompiledScene teapot_scene(host::MeshShading shading, std::uint16_t width = 320, std::uint16_t height = 240);

// A scene file in memory; paths are relative to the assets.
host::CompiledScene scene_of(const std::string& json);

// Looks at the scene from a random side, `distance` times as far off as the default camera stands, past its middle by
// up to a quarter of its radius.
void look_from_anywhere(host::CompiledScene& scene, oracle::Random& random, double distance);

// Renders with `options`, whose size becomes the scene's; expects that nothing is refused.
host::Rendering render(const host::CompiledScene& scene, host::EngineOptions options, bool observe = true);

}  // namespace spanline::test
