#pragma once

#include <optional>
#include <string>

#include "assetc/compile.hpp"
#include "sim/scene_options.hpp"
#include "sim/verb.hpp"

namespace spanline::host {

// `spanline assets`: a scene as constexpr tables for a firmware.
class AssetsCommand : public Verb {
 public:
  explicit AssetsCommand(CLI::App& app);

  // Throws UsageError and InputError.
  void run() const;

 private:
  std::uint32_t merge_most() const;
  void rework(CompiledScene& scene) const;

  SceneOptions scene_;
  std::string out_;
  std::optional<std::string> header_, merge_most_;
  bool no_merge_ = false, triangles_ = false, report_ = false;
};

}  // namespace spanline::host
