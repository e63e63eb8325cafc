#include "hidden/hidden_command.hpp"

#include <CLI/CLI.hpp>

#include "assetc/input_error.hpp"
#include "hidden/hidden_json.hpp"
#include "hidden/hidden_svg.hpp"
#include "sim/arguments.hpp"
#include "sim/output_file.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {

HiddenCommand::HiddenCommand(CLI::App& app)
    : Verb(app.add_subcommand("hidden", "remove hidden surfaces and lines: polygons out (SVG, JSON)")) {
  scene_.add_to(*verb_);
  verb_->add_option("--svg", svg_, "a drawing: filled surfaces, or lines with --lines");
  verb_->add_option("--json", json_, "a scene file of what is visible, in world and screen coordinates");
  verb_->add_flag("--lines", lines_, "draw lines instead of surfaces: every visible edge once");
  verb_->add_flag("--dashed", dashed_, "with --lines: hidden edges, too, dashed");
  verb_->add_option("--window", window_, "quarter the screen until a window has at most so many polygons");
  verb_->footer("At least one of --svg and --json is needed. A Gouraud face has the colour of its plane.");
}

void HiddenCommand::run() const {
  if (!svg_ && !json_) throw UsageError("nothing to do: give --svg or --json");
  if (lines_ && !svg_) throw UsageError("--lines: needs --svg");
  if (dashed_ && !lines_) throw UsageError("--dashed: needs --lines");
  const auto window = window_ ? parse_integer("--window", *window_, 1, 65535) : 0;
  const CompiledScene scene = compile(scene_.load(false));
  const SceneDescription& description = scene.description();
  const FacetList facets(scene, Facing::as_culled);
  const auto view_with = [&](area::Panes panes) {
    return remove_hidden(facets, description, static_cast<std::uint32_t>(window), panes);
  };
  if (json_) write_file(*json_, hidden_json(view_with(area::Panes::shown), facets, scene));
  if (!svg_) return;
  const HiddenView view = view_with(area::Panes::named);
  if (!lines_) return write_file(*svg_, surfaces_svg(view, facets, description));
  const std::vector<Line> visible = visible_lines(view);
  std::vector<Line> hidden;
  if (dashed_) hidden = hidden_lines(FacetList(scene, Facing::all), visible, description.width, description.height);
  write_file(*svg_, lines_svg(visible, hidden, description));
}

}  // namespace spanline::host
