#include "sim/assets_command.hpp"

#include <filesystem>
#include <iostream>

#include "assetc/compile.hpp"
#include "assetc/emit_cpp.hpp"
#include "sim/output_file.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {

AssetsCommand::AssetsCommand(CLI::App& app)
    : verb_(app.add_subcommand("assets", "compile a scene to constexpr C++ tables for a firmware")) {
  scene_.add_to(*verb_);
  verb_->add_option("--out", out_, "the source file; its name, or the header's, is the namespace")->required();
  verb_->add_option("--header", header_, "the header with the declarations");
  verb_->add_flag("--report", report_, "print what the tables occupy");
}

void AssetsCommand::run() const {
  const CompiledScene scene = compile(scene_.load(false));
  const SceneRecord record = scene.record();
  validated(record, scene.description().place);
  const std::string name = identifier_from(header_.value_or(out_));
  const std::string included = header_ ? std::filesystem::path(*header_).filename().string() : "";
  write_file(out_, emit_source(scene, name, included));
  if (header_) write_file(*header_, emit_header(scene, name));
  if (scene.moves()) std::cerr << "spanline: note: moving things stand as in frame 0\n";
  if (report_) std::cout << emit_report(scene);
}

}  // namespace spanline::host
