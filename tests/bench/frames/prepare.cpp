#include "frames/prepare.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "assetc/compile.hpp"
#include "assetc/emit_cpp.hpp"
#include "assetc/input_error.hpp"
#include "assetc/merge.hpp"
#include "assetc/text_file.hpp"
#include "sim/engine.hpp"
#include "sim/fitted_budget.hpp"
#include "sim/output_file.hpp"
#include "sim/status_text.hpp"

namespace spanline::bench {
namespace {

using namespace host;

nlohmann::ordered_json units_json(const Units& units) {
  return {{"vertices", units.vertices},      {"faces", units.faces},
          {"fronts", units.fronts},          {"edges", units.edges},
          {"edge_lines", units.edge_lines},  {"overlaps", units.overlaps},
          {"overlapping", units.overlapping}};
}

Units units_from(const nlohmann::json& json) {
  return {json.at("vertices"),   json.at("faces"),    json.at("fronts"),     json.at("edges"),
          json.at("edge_lines"), json.at("overlaps"), json.at("overlapping")};
}

// The picture of the very records that the image draws.
Expected draw(const CompiledScene& scene, std::uint16_t point_lines) {
  const std::string stem = std::filesystem::path(scene.description().place).stem().string();
  Expected seen{point_lines == 0 ? stem : stem + "-points", "as written", 2166136261u, 0, 0, 0, {}};
  EngineOptions options;
  options.width = scene.description().width;
  options.height = scene.description().height;
  options.observe = true;
  if (point_lines != 0) options.surface = Surface::points;
  options.on_line = [&seen](const FinishedLine& line) {
    for (const std::uint8_t byte : line.wire) seen.checksum = (seen.checksum ^ byte) * 16777619u;
  };
  Rendering rendering;
  const SceneRecord record = scene.record();
  const SceneView view = validated(record, scene.description().place);
  const Status status = Engine::make(options)->render(view, scene.camera(), rendering);
  if (!status.ok()) throw InputError(scene.description().place, status_text(status));
  seen.faces = static_cast<std::uint32_t>(table_sizes(scene).faces);
  seen.edge_crossings = rendering.statistics.edge_crossings;
  seen.output_segments = rendering.statistics.output_segments;
  seen.units = units_of(view, scene.camera(), {options.width, options.height, options.format});
  return seen;
}

}  // namespace

PrepareCommand::PrepareCommand(CLI::App& app)
    : verb_(app.add_subcommand("prepare", "compile a scene for an image that draws it, with a budget that fits")) {
  scene_.add_to(*verb_);
  verb_->add_option("--out", out_, "the folder")->required();
  verb_->add_option("--point-lines", point_lines_, "draw patches as points, in bands of so many lines (default: dice)");
}

void PrepareCommand::run() const {
  CompiledScene scene = compile(scene_.load(false));
  // Larger faces are fewer, but the edge walker draws triangles.
  scene.triangulate();
  std::optional<Budget> budget = fitted_edge_budget(scene, 0, 0);
  if (!budget) {
    scene = compile(scene_.load(false));
    scene.merge_coplanar(kMostMergedCorners);
    budget = fitted_budget(scene, 0, 0, point_lines_);
  }
  Expected expected = draw(scene, point_lines_);
  if (scene_.shading()) expected.shading = *scene_.shading();

  std::filesystem::create_directories(out_);
  write_file(out_ + "/shown.cpp", emit_source(scene, "shown", "shown.hpp"));
  write_file(out_ + "/shown.hpp", emit_header(scene, "shown"));
  write_file(out_ + "/budget.hpp", emit_budget(*budget, "shown", "frame 0 of " + expected.scene));
  const nlohmann::ordered_json json = {{"scene", expected.scene},
                                       {"shading", expected.shading},
                                       {"checksum", expected.checksum},
                                       {"faces", expected.faces},
                                       {"edge_crossings", expected.edge_crossings},
                                       {"output_segments", expected.output_segments},
                                       {"units", units_json(expected.units)}};
  write_file(out_ + "/expected.json", json.dump(2) + "\n");
}

Expected read_expected(const std::string& folder) {
  const std::string path = folder + "/expected.json";
  const nlohmann::json json = nlohmann::json::parse(read_file(path));
  return {json.at("scene"),          json.at("shading"),         json.at("checksum"),         json.at("faces"),
          json.at("edge_crossings"), json.at("output_segments"), units_from(json.at("units"))};
}

}  // namespace spanline::bench
