#pragma once

#include "sim/cli_app.hpp"
#include "sim/scene_options.hpp"

namespace spanline::host {

// `spanline view`: a live window.
class ViewCommand {
 public:
  explicit ViewCommand(CLI::App& app);
  bool chosen() const;

  // Returns when the window is closed. Throws UsageError where this build has no SDL2, InputError where there is no
  // display.
  void run() const;

 private:
  CLI::App* verb_;
  SceneOptions scene_;
};

}  // namespace spanline::host
