// The options that say what is seen: shared by the verbs that take a scene.
#pragma once

#include <optional>
#include <string>

#include "assetc/scene_description.hpp"
#include "sim/cli_app.hpp"

namespace spanline::host {

class SceneOptions {
 public:
  // Adds SCENE and the options of size, camera and light to a verb.
  void add_to(CLI::App& verb);

  // Reads the scene and lays the options over it. Throws UsageError and InputError.
  SceneDescription load(bool on_screen) const;

  // The scene in a file as it is. Throws UsageError and InputError.
  static SceneDescription load_plain(const std::string& path);

  bool camera_given() const { return eye_ || target_ || up_ || fov_ || near_ || far_; }
  bool size_given() const { return size_.has_value(); }
  bool light_given() const { return light_.has_value(); }
  const std::optional<std::string>& shading() const { return shading_; }

 private:
  void lay_camera_over(CameraSpec& camera) const;
  SceneDescription read(bool on_screen) const;

  std::string scene_;
  std::optional<std::string> size_, eye_, target_, up_, fov_, near_, far_, light_, shading_;
  bool no_cull_ = false;
};

}  // namespace spanline::host
