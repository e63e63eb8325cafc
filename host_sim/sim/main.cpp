#include <CLI/CLI.hpp>
#include <iostream>

#include "assetc/input_error.hpp"
#include "sim/assets_command.hpp"
#include "sim/render_command.hpp"
#include "sim/usage_error.hpp"
#include "sim/view_command.hpp"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int complain(const std::string& text, int code) {
  std::cerr << "spanline: " << spanline::host::one_line(text) << "\n";
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Renders, views and compiles scenes with the engine that a board runs."};
  app.require_subcommand(1);
  const spanline::host::RenderCommand render(app);
  const spanline::host::ViewCommand view(app);
  const spanline::host::AssetsCommand assets(app);
  try {
    app.parse(argc, argv);
    if (render.chosen()) render.run();
    if (view.chosen()) view.run();
    if (assets.chosen()) assets.run();
    return 0;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(error.what(), kWrongUsage);
  } catch (const spanline::host::UsageError& error) {
    return complain(error.what(), kWrongUsage);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}
