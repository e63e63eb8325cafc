#include <CLI/CLI.hpp>

#include "budget/mcu_verbs.hpp"
#include "clip/clip_command.hpp"
#include "demo/demo_command.hpp"
#include "hidden/hidden_command.hpp"
#include "sim/assets_command.hpp"
#include "sim/exit_code.hpp"
#include "sim/render_command.hpp"
#include "sim/view_command.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Renders, views and compiles scenes with the engine that a board runs."};
  app.require_subcommand(1);
  const spanline::host::RenderCommand render(app);
  const spanline::host::DemoCommand demo(app);
  const spanline::host::ViewCommand view(app);
  const spanline::host::AssetsCommand assets(app);
  const spanline::host::McuVerbs mcu(app);
  const spanline::host::HiddenCommand hidden(app);
  const spanline::host::ClipCommand clip(app);
  return spanline::host::exit_code_of(app, [&] {
    app.parse(argc, argv);
    if (render.chosen()) render.run();
    if (demo.chosen()) demo.run();
    if (view.chosen()) view.run();
    if (assets.chosen()) assets.run();
    if (hidden.chosen()) hidden.run();
    if (clip.chosen()) clip.run();
    if (mcu.chosen()) mcu.run();
  });
}
