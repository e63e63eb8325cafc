// Flash records as C++ source.
#pragma once

#include <string>

#include "core/fx/fixed.hpp"
#include "core/scene/format.hpp"

namespace spanline::host {

// Tables without linkage, and the definitions of `scene` and `camera` that refer to them: what stands inside one
// namespace of a source that includes core/scene/format.hpp. The records may come from elsewhere than the scene
// compiler.
std::string emit_records(const SceneRecord& scene, const CameraRecord& camera);

// "{{1}, {2}, {3}}": the raw values.
template <int F>
std::string fixed3(const Fixed<F> (&v)[3]) {
  return "{{" + std::to_string(v[0].raw) + "}, {" + std::to_string(v[1].raw) + "}, {" + std::to_string(v[2].raw) + "}}";
}

}  // namespace spanline::host
