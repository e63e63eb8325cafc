#pragma once

#include "sim/scene_options.hpp"

namespace spanline::host {

// `spanline hidden`: visible surfaces as polygons and lines.
class HiddenCommand {
 public:
  explicit HiddenCommand(CLI::App& app);
  bool chosen() const;

  // Throws UsageError and InputError.
  void run() const;

 private:
  CLI::App* verb_;
  SceneOptions scene_;
  std::optional<std::string> svg_, json_, window_;
  bool lines_ = false, dashed_ = false;
};

}  // namespace spanline::host
