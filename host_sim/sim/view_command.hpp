#pragma once

#include "sim/scene_options.hpp"
#include "sim/verb.hpp"

namespace spanline::host {

// `spanline view`: a live window.
class ViewCommand : public Verb {
 public:
  explicit ViewCommand(CLI::App& app);

  // Returns when the window is closed. Throws UsageError where this build has no SDL2, InputError where there is no
  // display.
  void run() const;

 private:
  SceneOptions scene_;
};

}  // namespace spanline::host
