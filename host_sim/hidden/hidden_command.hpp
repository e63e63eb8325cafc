#pragma once

#include "sim/scene_options.hpp"
#include "sim/verb.hpp"

namespace spanline::host {

// `spanline hidden`: visible surfaces as polygons and lines.
class HiddenCommand : public Verb {
 public:
  explicit HiddenCommand(CLI::App& app);

  // Throws UsageError and InputError.
  void run() const;

 private:
  SceneOptions scene_;
  std::optional<std::string> svg_, json_, window_;
  bool lines_ = false, dashed_ = false;
};

}  // namespace spanline::host
