#include "mcu/stage.hpp"

namespace spanline::host {
namespace {

struct Rule {
  const char* part;  // of the file's path
  Stage stage;
};

// The first that matches holds. base and fx are helpers.
constexpr Rule kRules[] = {{"core/geom/", Stage::transform},
                           {"core/scene/", Stage::transform},
                           {"core/curve/", Stage::dice},
                           {"core/frame/", Stage::edges},
                           {"core/vsg/edge_walker", Stage::segment},
                           {"core/vsg/edge", Stage::edges},
                           {"core/vsg/polygons", Stage::edges},
                           {"core/vsg/depth", Stage::depth},
                           {"core/vsg/comparator", Stage::depth},
                           {"core/vsg/", Stage::segment},
                           {"core/area/", Stage::segment},
                           {"core/shade/", Stage::shade},
                           {"firmware/hal/", Stage::scan_out},
                           {"firmware/boards/", Stage::scan_out},
                           {"firmware/demos/", Stage::other}};

}  // namespace

const char* name(Stage stage) {
  constexpr std::array<const char*, kStages> kNames = {"transform", "dice",  "edge set-up", "segment",
                                                       "depth",     "shade", "scan-out",    "other"};
  return kNames[static_cast<std::size_t>(stage)];
}

std::optional<Stage> stage_of(const std::string& file) {
  for (const Rule& rule : kRules) {
    if (file.find(rule.part) != std::string::npos) return rule.stage;
  }
  return std::nullopt;
}

}  // namespace spanline::host
