#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "assetc/compile.hpp"
#include "sim/engine.hpp"
#include "sim/panel_options.hpp"
#include "sim/scene_options.hpp"
#include "sim/stats_json.hpp"
#include "sim/verb.hpp"

namespace spanline::host {

// `spanline render`: pictures of a scene in files.
class RenderCommand : public Verb {
 public:
  explicit RenderCommand(CLI::App& app);

  // Throws UsageError, and InputError for what went wrong: a picture unlike the one that --expect names, too.
  void run() const;

 private:
  struct Frames {
    std::int64_t first = 0, last = 0;
    bool numbered = false;
  };

  void check_outputs() const;
  Frames frames() const;
  SceneDescription description(const PanelOutput* panel) const;
  EngineOptions engine_options(const SceneDescription& scene) const;
  void write_outputs(const Rendering& rendering, const SceneCounts& counts, const PoolSizes& pools, const Frames& range,
                     std::int64_t frame) const;
  void compare_with_expected(const Picture& picture) const;

  SceneOptions scene_;
  bool on_screen_ = false;
  std::optional<std::string> out_, ids_, depth_, stats_, expect_;
  PanelOptions panel_;
  std::optional<std::string> frame_, frames_, comparator_, walker_, surface_, bands_, pools_, tolerance_, format_;
};

}  // namespace spanline::host
