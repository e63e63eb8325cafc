#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "sim/scene_options.hpp"

namespace spanline::host {

// `spanline assets`: a scene as constexpr tables for a firmware.
class AssetsCommand {
 public:
  explicit AssetsCommand(CLI::App& app);
  bool chosen() const { return verb_->parsed(); }

  // Throws UsageError and InputError.
  void run() const;

 private:
  CLI::App* verb_;
  SceneOptions scene_;
  std::string out_;
  std::optional<std::string> header_;
  bool report_ = false;
};

}  // namespace spanline::host
