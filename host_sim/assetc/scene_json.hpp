// The scene files of docs/scene.md.
#pragma once

#include <string>
#include <string_view>

#include "assetc/scene_description.hpp"

namespace spanline::host {

// Reads a scene file and the OBJ files it names. Throws InputError: one line with the file and the place in it, and for
// an inner file that file and its line.
SceneDescription read_scene(const std::string& path);

// The same from text in memory; `name` stands for the file in messages and its folder is where OBJ files are.
SceneDescription parse_scene(const std::string& name, std::string_view text);

}  // namespace spanline::host
