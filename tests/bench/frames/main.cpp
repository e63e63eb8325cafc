// Counts what frames take: `prepare` compiles scenes for tests/bench/image, `count` executes the images made of them.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "assetc/input_error.hpp"
#include "frames/code_parts.hpp"
#include "frames/count.hpp"
#include "frames/pieces.hpp"
#include "frames/prices.hpp"
#include "sim/exit_code.hpp"
#include "sim/output_file.hpp"
#include "sim/verb.hpp"

namespace spanline::bench {
namespace {

// `spanline-frames count FOLDER CPU/FRAME…`: FOLDER/CPU/FRAME.elf draws what was prepared in FOLDER/frames/FRAME.
class CountCommand : public host::Verb {
 public:
  explicit CountCommand(CLI::App& app) : Verb(app.add_subcommand("count", "execute images, print and write a table")) {
    verb_->add_option("folder", folder_, "where frames/ and the images of each core are")->required();
    verb_->add_option("image", images_, "CPU/FRAME, as m4/S1-flat")->required();
    verb_->add_option("--out", out_, "the JSON file")->required();
  }

  void run() const {
    std::vector<FrameCount> frames;
    for (const std::string& name : images_) {
      const std::filesystem::path path(name);
      const Expected expected = read_expected(folder_ + "/frames/" + path.filename().string());
      frames.push_back(count_frame(folder_ + "/" + name + ".elf", path.parent_path().string(), expected));
    }
    host::write_file(out_, frames_json(frames));
    std::cout << frames_table(frames);
  }

 private:
  std::string folder_, out_;
  std::vector<std::string> images_;
};

}  // namespace
}  // namespace spanline::bench

int main(int argc, char** argv) {
  CLI::App app{"Counts what frames take on a core."};
  app.require_subcommand(1);
  const spanline::bench::PrepareCommand prepare(app);
  const spanline::bench::CountCommand count(app);
  const spanline::bench::PiecesCommand pieces(app);
  const spanline::bench::PricesCommand prices(app);
  const spanline::bench::PartsCommand parts(app);
  return spanline::host::exit_code_of(app, [&] {
    app.parse(argc, argv);
    if (prepare.chosen()) prepare.run();
    if (count.chosen()) count.run();
    if (pieces.chosen()) pieces.run();
    if (prices.chosen()) prices.run();
    if (parts.chosen()) parts.run();
  });
}
