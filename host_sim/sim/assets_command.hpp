#pragma once

#include <optional>
#include <string>

#include "assetc/compile.hpp"
#include "sim/cli_app.hpp"
#include "sim/scene_options.hpp"

namespace spanline::host {

// `spanline assets`: a scene as constexpr tables for a firmware.
class AssetsCommand {
 public:
  explicit AssetsCommand(CLI::App& app);
  bool chosen() const;

  // Throws UsageError and InputError.
  void run() const;

 private:
  std::uint32_t merge_most() const;
  void rework(CompiledScene& scene) const;

  CLI::App* verb_;
  SceneOptions scene_;
  std::string out_;
  std::optional<std::string> header_, merge_most_;
  bool no_merge_ = false, triangles_ = false, report_ = false;
};

}  // namespace spanline::host
