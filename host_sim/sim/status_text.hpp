#pragma once

#include <string>

#include "core/base/status.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline::host {

// A status as a sentence for a person: which pool, line, record and field, and the figures.
std::string status_text(const Status& status);

// The scene's records, validated. Throws InputError with `place` and the record that is wrong.
SceneView validated(const SceneRecord& record, const std::string& place);

}  // namespace spanline::host
