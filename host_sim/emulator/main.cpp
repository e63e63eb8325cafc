// spanline-screendump DUMP.ppm SCALE OUT.png: an emulator's screendump as the panel's picture. ./dev emulate calls it.
#include <CLI/CLI.hpp>

#include "emulator/screendump.hpp"
#include "sim/exit_code.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Turns an emulator's screendump into the panel's picture."};
  std::string dump, out;
  std::uint16_t scale = 1;
  app.add_option("DUMP", dump, "binary PPM")->required();
  app.add_option("SCALE", scale, "pixels of the dump to one of the panel, each way")
      ->required()
      ->check(CLI::Range(1, 64));
  app.add_option("OUT", out, "PNG or PPM")->required();
  return spanline::host::exit_code_of(app, [&] {
    app.parse(argc, argv);
    spanline::host::check_picture_path(out);
    spanline::host::write_picture(out, spanline::host::shrink(spanline::host::read_ppm(dump), scale, dump));
  });
}
