#include "frames/prices.hpp"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "budget/sweep.hpp"
#include "frames/count.hpp"
#include "frames/minimax.hpp"
#include "sim/output_file.hpp"

namespace spanline::bench {
namespace {

constexpr const char* kShadings[] = {"flat", "gouraud"};

// A priced core's folder: "m0plus" of "m0+".
std::string folder_of(const std::string& core) { return core == "m0+" ? "m0plus" : core; }

host::FrameWork work_of(const Expected& frame) {
  host::FrameWork work;
  work.pixels = 320 * 240;
  work.faces = frame.faces;
  work.crossings = frame.edge_crossings;
  work.overlaps = frame.depth_tests - frame.edge_crossings / 2.0;
  return work;
}

struct Scene {
  Expected frame;
  std::vector<Measured> cycles;  // by core, then by shading
};

Scene counted(const std::string& folder, const std::string& name) {
  Scene scene{};
  for (const char* core : host::kPricedCores) {
    for (const char* shading : kShadings) {
      const std::string image = name + "-" + shading;
      scene.frame = read_expected(folder + "/frames/" + image);
      const FrameCount frame =
          count_frame(folder + "/" + folder_of(core) + "/" + image + ".elf", folder_of(core), scene.frame);
      const host::FrameWork work = work_of(scene.frame);
      scene.cycles.push_back(
          {{work.pixels, work.faces, work.crossings, work.overlaps}, static_cast<double>(frame.count.cycles)});
    }
  }
  return scene;
}

constexpr const char* kWritten = "// Written by `./dev bench --pages`";

std::string prices_text(const std::vector<Scene>& scenes) {
  std::ostringstream out;
  out << kWritten << ": core, Gouraud; cycles of a pixel, a face, a crossing and a depth test.\n"
      << std::fixed << std::setprecision(2);
  std::size_t column = 0;
  for (const char* core : host::kPricedCores) {
    for (const char* shading : kShadings) {
      std::vector<Measured> rows;
      for (const Scene& scene : scenes) rows.push_back(scene.cycles[column]);
      ++column;
      const Fit fit = minimax_fit(rows);
      out << "{\"" << core << "\", " << (shading == kShadings[0] ? "false" : "true") << ", {";
      for (std::size_t k = 0; k < fit.prices.size(); ++k) out << (k == 0 ? "" : ", ") << fit.prices[k];
      out << "}},  // within " << 100 * fit.off << " %\n";
    }
  }
  return out.str();
}

std::string frames_text(const std::vector<Scene>& scenes) {
  std::ostringstream out;
  out << kWritten << ": faces, crossings, depth tests; cycles by core, flat and Gouraud.\n"
      << std::fixed << std::setprecision(0);
  for (const Scene& scene : scenes) {
    out << "{" << scene.frame.faces << ", " << scene.frame.edge_crossings << ", " << scene.frame.depth_tests << ", {";
    for (std::size_t i = 0; i < scene.cycles.size(); i += 2) {
      out << (i == 0 ? "{" : ", {") << scene.cycles[i].sum << ", " << scene.cycles[i + 1].sum << "}";
    }
    out << "}},  // " << scene.frame.scene << "\n";
  }
  return out.str();
}

}  // namespace

PricesCommand::PricesCommand(CLI::App& app)
    : Verb(app.add_subcommand("prices", "fit what the budget's sweep expects of frames")) {
  verb_->add_option("folder", folder_, "where frames/ and the images of each core are")->required();
  verb_->add_option("scene", scenes_, "as S1, flat and Gouraud")->required();
  verb_->add_option("--prices", prices_, "the file of prices")->required();
  verb_->add_option("--frames", frames_, "the file of counted frames")->required();
}

void PricesCommand::run() const {
  std::vector<Scene> scenes;
  for (const std::string& name : scenes_) scenes.push_back(counted(folder_, name));
  const std::string prices = prices_text(scenes);
  host::write_file(prices_, prices);
  host::write_file(frames_, frames_text(scenes));
  std::cout << prices;
}

}  // namespace spanline::bench
