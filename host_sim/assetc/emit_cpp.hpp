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

// What the tables of a scene occupy on a 32-bit target, in bytes, and how many things there are.
struct TableSizes {
  std::size_t faces = 0, corners = 0, most_corners = 0;  // most_corners: of one face
  std::size_t positions = 0, normals = 0, indices = 0, groups = 0, fans = 0, curves = 0, records = 0;
  std::size_t total() const { return positions + normals + indices + groups + fans + curves + records; }
};
TableSizes table_sizes(const CompiledScene& scene);

// The sizes in lines of text; `before`: the same scene's before its faces were merged.
std::string emit_report(const CompiledScene& scene, const TableSizes& before);

}  // namespace spanline::host
