// Compiled scenes as C++ source: constexpr tables that live in a firmware's flash.
#pragma once

#include <string>

#include "assetc/compile.hpp"

namespace spanline::host {

// A C++ identifier made from a file's name: "tea-pot.cpp" gives "tea_pot".
std::string identifier_from(const std::string& path);

// The header: namespace `name` with `scene`, `camera`, `kWidth`, `kHeight`, `kTarget` (what the camera looks at) and
// `kOrigins` (of the meshes).
std::string emit_header(const CompiledScene& scene, const std::string& name);

// The source. `header` is what it includes, or empty: then it declares what it defines itself.
std::string emit_source(const CompiledScene& scene, const std::string& name, const std::string& header);

// What the tables occupy on a 32-bit target, one line a kind, in bytes.
std::string emit_report(const CompiledScene& scene);

}  // namespace spanline::host
