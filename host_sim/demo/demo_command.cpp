#include "demo/demo_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "demo/boards.hpp"
#include "demo/line_memory.hpp"
#include "demo/names.hpp"
#include "demos/all.hpp"
#include "sim/arguments.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

const demos::Layouts& find_demo(const std::string& name) {
  return *by_name("NAME", demos::kAll, name, [](const demos::Layouts* demo) { return demo->name; });
}

void require(bool ok, const Status& status, const std::string& name) {
  if (!ok) throw InputError(name, status_text(status));
}

// A line frame's picture.
Status draw_lines(const demos::Demo& demo, const demos::Stage& stage, const EngineOptions& options, Picture& picture) {
  const Screen screen{options.width, options.height, options.format};
  HostLineMemory memory(screen, demo.budget);
  LineFrame frame(memory.storage());
  picture = Picture(screen.width, screen.height);
  std::vector<std::uint8_t> wire(frame.line_bytes());
  const Slice<std::uint8_t> out(wire.data(), frame.line_bytes());
  if (frame.prepare(stage.view(), stage.camera(), {0, screen.height}).empty()) return frame.status();
  for (std::uint16_t line = 0; frame.next_line(out); ++line) {
    decode_line(screen.format, wire.data(), screen.width, picture.rgb.data() + std::size_t{3} * screen.width * line);
    if (options.on_line) options.on_line({line, {wire.data(), frame.line_bytes()}});
  }
  return frame.status();
}

Status draw_surfaces(const demos::Demo& demo, const demos::Stage& stage, const EngineOptions& given, Picture& picture) {
  EngineOptions options = given;
  options.pools = pools_of(demo.budget);
  // Of the host's engines, the one with both walkers draws patches by edges.
  options.walker = demo.budget.patch_grid != 0 ? Walker::both : demo.budget.walker;
  Rendering rendering;
  const Status drawn = Engine::make(options)->render(stage.view(), stage.camera(), rendering);
  picture = std::move(rendering.picture);
  return drawn.ok() ? rendering.status : drawn;
}

// Frame `frame` in the pools that the board has, too; through `panel`, where there is one.
Picture draw(const demos::Demo& demo, const Screen& screen, std::uint32_t frame, PanelOutput* panel) {
  demos::Stage stage;
  const Status status = stage.begin(demo, screen);
  require(status.ok(), status, demo.name);
  stage.show(frame);
  EngineOptions options;
  options.width = screen.width;
  options.height = screen.height;
  options.format = screen.format;
  if (panel != nullptr) {
    options.on_line = [panel](const FinishedLine& line) { panel->line(line); };
    panel->begin_frame(stage.view().scene().background);
  }
  Picture picture;
  const Status drawn = (demo.budget.lines != 0 ? draw_lines : draw_surfaces)(demo, stage, options, picture);
  require(drawn.ok(), drawn, demo.name);
  return panel != nullptr ? panel->finish_frame() : picture;
}

}  // namespace

DemoCommand::DemoCommand(CLI::App& app)
    : Verb(app.add_subcommand("demo", "draw a firmware's demo as its board shows it: through its panel's driver")) {
  verb_->add_option("NAME", name_, "which demo: see --list");
  verb_->add_option("--board", board_, "the board whose panel it is framed for");
  verb_->add_option("--frame", frame_, "which frame (default: 0)");
  verb_->add_option("--out", out_, "the picture, .png or .ppm");
  panel_.add_to(*verb_);
  verb_->add_flag("--list", list_, "print the names of the demos, one a line");
}

void DemoCommand::run() const {
  if (list_) {
    for (const demos::Layouts* demo : demos::kAll) std::cout << demo->name << "\n";
    return;
  }
  if (!name_) throw UsageError("NAME is required; --list prints the demos");
  const demos::Layouts& demo = find_demo(*name_);
  if (!out_) throw UsageError("--out is required");
  check_picture_path(*out_);
  const std::int64_t frame = frame_ ? parse_integer("--frame", *frame_, 0, UINT32_MAX) : 0;
  const Shown shown = this->shown();
  const Picture picture =
      draw(demo.framed_for(shown.screen), shown.screen, static_cast<std::uint32_t>(frame), shown.panel.get());
  write_picture(*out_, picture);
  if (shown.panel) panel_.save_log(*shown.panel);
}

DemoCommand::Shown DemoCommand::shown() const {
  if (board_ && (panel_.panel_given() || panel_.rotation_given())) {
    throw UsageError("--panel and --rotation: the board has its own panel; leave --board out");
  }
  if (panel_.panel_given()) {
    std::unique_ptr<PanelOutput> panel = panel_.make();
    const Screen screen{panel->width(), panel->height(), panel->format()};
    return {std::move(panel), screen};
  }
  if (!board_) throw UsageError("--board or --panel is required");
  const Board& board = find_board(*board_);
  if (board.panel == nullptr) {
    if (panel_.log_given()) throw UsageError("--spi-log: " + *board_ + " has no panel, it exists for an emulator only");
    return {nullptr, board.screen};
  }
  return {panel_.make(board.panel, board.rotation), board.screen};
}

}  // namespace spanline::host
