#include "sim/assets_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "assetc/compile.hpp"
#include "assetc/emit_cpp.hpp"
#include "assetc/merge.hpp"
#include "sim/arguments.hpp"
#include "sim/output_file.hpp"
#include "sim/status_text.hpp"
#include "sim/unseen_merge.hpp"

namespace spanline::host {
namespace {

constexpr const char* kFooter =
    "Coplanar neighbours of one material become one face where outlines and colours stay the same. A mesh that would "
    "change a pixel that way, because something pierces or touches it, stays as it is: pictures from all around and "
    "along the motion are compared. Merging numbers the faces anew; `spanline render` never merges, so its --ids are "
    "those of the scene as it is written. With --triangles every face is cut into triangles instead, which is what the "
    "edge walker draws (Budget::walker): outlines and flat colours stay the same, and faces are numbered anew, too.";

}  // namespace

AssetsCommand::AssetsCommand(CLI::App& app)
    : Verb(app.add_subcommand("assets", "compile a scene to constexpr C++ tables for a firmware")) {
  scene_.add_to(*verb_);
  verb_->add_option("--out", out_, "the source file; its name, or the header's, is the namespace")->required();
  verb_->add_option("--header", header_, "the header with the declarations");
  verb_->add_flag("--no-merge", no_merge_, "keep coplanar neighbours apart");
  verb_->add_option("--merge-most", merge_most_, "corners of a merged face at most (default: 64)");
  verb_->add_flag("--triangles", triangles_, "cut every face into triangles, for the edge walker");
  verb_->add_flag("--report", report_, "print what the tables occupy, and how many faces there were before merging");
  verb_->footer(kFooter);
}

std::uint32_t AssetsCommand::merge_most() const {
  if (!merge_most_) return kMostMergedCorners;
  return static_cast<std::uint32_t>(parse_integer("--merge-most", *merge_most_, 3, 65535));
}

// Faces as the walker in view likes them; says on the standard error which meshes stay as they are.
void AssetsCommand::rework(CompiledScene& scene) const {
  const auto note = [](const std::vector<std::string>& meshes, const char* why) {
    for (const std::string& mesh : meshes) std::cerr << "spanline: note: the faces of " << mesh << why << '\n';
  };
  if (triangles_) {
    note(scene.triangulate(), " stay as they are: of patches, curves, detail or crossing themselves");
  } else if (!no_merge_) {
    note(merge_unseen(scene, merge_most()).kept_apart, " stay apart: merged they would change a pixel");
  }
}

void AssetsCommand::run() const {
  CompiledScene scene = compile(scene_.load(false));
  const TableSizes before = table_sizes(scene);
  rework(scene);
  const SceneRecord record = scene.record();
  validated(record, scene.description().place);
  const std::string name = identifier_from(header_.value_or(out_));
  const std::string included = header_ ? std::filesystem::path(*header_).filename().string() : "";
  write_file(out_, emit_source(scene, name, included));
  if (header_) write_file(*header_, emit_header(scene, name));
  if (scene.moves()) std::cerr << "spanline: note: moving things stand as in frame 0\n";
  if (report_) std::cout << emit_report(scene, before);
}

}  // namespace spanline::host
