#include "frames/prepare.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
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
Expected draw(const CompiledScene& scene, std::uint16_t point_lines, std::uint32_t memory) {
  std::string name = std::filesystem::path(scene.description().place).stem().string();
  if (point_lines != 0) name += "-points";
  if (memory != 0) name += "-in-" + std::to_string(memory);
  Expected seen{name, "as written", 2166136261u, 0, 0, 0, 0, {}};
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
  seen.depth_tests = rendering.statistics.comparator_cycles;
  seen.units = units_of(view, scene.camera(), {options.width, options.height, options.format});
  return seen;
}

// What a frame and its stack take on an M0+. Where faces overlap the stack is deeper, deepest where exact planes are
// made of large or narrow ones.
std::uint32_t frame_and_stack(const Budget& budget, bool whole, bool overlaps) {
  if (whole) return (budget.plain ? 756u : 804u) + (overlaps ? 988u : 572u);
  return (budget.gouraud ? 492u : 436u) + (budget.plain ? 0u : 48u) + (overlaps ? 964u : 488u);
}

// The budget that draws the scene in so many bytes, with two line buffers if it can be whole then, else with one.
std::pair<Budget, unsigned> within(CompiledScene& scene, const Budget& fitted, std::uint32_t memory, bool overlaps) {
  const std::uint32_t line = bytes_per_line(fitted.format, fitted.width);
  const auto left = [&](bool whole, unsigned lines) {
    const std::uint32_t rest = frame_and_stack(fitted, whole, overlaps) + lines * line;
    return memory < rest ? 0 : memory - rest;
  };
  if (fitted.walker == Walker::edges && fitted.patch_grid == 0) {
    for (const unsigned lines : {2u, 1u}) {
      if (whole_bytes(fitted) <= left(true, lines)) return {fitted, lines};
    }
    const std::uint32_t of_bands = std::min(left(false, 1), whole_bytes(fitted) - 1);
    if (const auto budget = shrunk_budget(scene, 0, 0, fitted, of_bands)) return {*budget, 1u};
  }
  throw InputError(scene.description().place, "cannot be drawn in " + std::to_string(memory) + " bytes");
}

// Whether faces lie before others.
bool has_overlaps(const CompiledScene& scene) {
  const SceneRecord record = scene.record();
  const SceneDescription& description = scene.description();
  const SceneView view = validated(record, description.place);
  return units_of(view, scene.camera(), {description.width, description.height, PixelFormat::rgb565}).overlaps != 0;
}

}  // namespace

PrepareCommand::PrepareCommand(CLI::App& app)
    : Verb(app.add_subcommand("prepare", "compile a scene for an image that draws it, with a budget that fits")) {
  scene_.add_to(*verb_);
  verb_->add_option("--out", out_, "the folder")->required();
  verb_->add_option("--point-lines", point_lines_, "draw patches as points, in bands of so many lines (default: dice)");
  verb_->add_option("--memory", memory_, "bytes for everything: pools, line buffers, stack (default: what it takes)");
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
  unsigned line_buffers = 2;
  if (memory_ != 0) {
    std::tie(*budget, line_buffers) = within(scene, *budget, memory_, has_overlaps(scene));
  }
  Expected expected = draw(scene, point_lines_, memory_);
  if (scene_.shading()) expected.shading = *scene_.shading();

  std::filesystem::create_directories(out_);
  write_file(out_ + "/shown.cpp", emit_source(scene, "shown", "shown.hpp"));
  write_file(out_ + "/shown.hpp", emit_header(scene, "shown"));
  write_file(out_ + "/budget.hpp", emit_budget(*budget, "shown", "frame 0 of " + expected.scene) +
                                       "\nnamespace shown {\ninline constexpr unsigned kLineBuffers = " +
                                       std::to_string(line_buffers) + ";\n}\n");
  const nlohmann::ordered_json json = {{"scene", expected.scene},
                                       {"shading", expected.shading},
                                       {"checksum", expected.checksum},
                                       {"faces", expected.faces},
                                       {"edge_crossings", expected.edge_crossings},
                                       {"output_segments", expected.output_segments},
                                       {"depth_tests", expected.depth_tests},
                                       {"units", units_json(expected.units)}};
  write_file(out_ + "/expected.json", json.dump(2) + "\n");
}

Expected read_expected(const std::string& folder) {
  const std::string path = folder + "/expected.json";
  const nlohmann::json json = nlohmann::json::parse(read_file(path));
  return {json.at("scene"),          json.at("shading"),         json.at("checksum"),    json.at("faces"),
          json.at("edge_crossings"), json.at("output_segments"), json.at("depth_tests"), units_from(json.at("units"))};
}

}  // namespace spanline::bench
