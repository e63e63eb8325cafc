#include "sim/view_command.hpp"

#include <CLI/CLI.hpp>

#include "assetc/compile.hpp"
#include "sim/window.hpp"

namespace spanline::host {
namespace {

constexpr double kReach = 12;  // bounding radii: how far one can zoom out

}  // namespace

ViewCommand::ViewCommand(CLI::App& app)
    : Verb(app.add_subcommand("view", "show a scene in a window and let one walk around it")) {
  scene_.add_to(*verb_);
  verb_->footer("Drag to turn, wheel to zoom, space to start and stop the motion, S to save a picture, Esc to quit.");
}

void ViewCommand::run() const {
  refuse_without_window();
  CompiledScene scene = compile(scene_.load(false), kReach);
  show_in_window(scene, kReach);
}

}  // namespace spanline::host
