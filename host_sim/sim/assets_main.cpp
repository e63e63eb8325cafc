// `spanline assets` alone: the build compiles the demos' scenes with it before there is a `spanline`, which contains
// them.
#include <CLI/CLI.hpp>

#include "sim/assets_command.hpp"
#include "sim/exit_code.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Compiles scenes."};
  app.require_subcommand(1);
  const spanline::host::AssetsCommand assets(app);
  return spanline::host::exit_code_of(app, [&] {
    app.parse(argc, argv);
    assets.run();
  });
}
