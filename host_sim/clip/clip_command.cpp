#include "clip/clip_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "clip/clip_regions.hpp"
#include "sim/output_file.hpp"

namespace spanline::host {
namespace {

void note(std::uint32_t count, const char* one, const char* many) {
  if (count != 0) std::cerr << "spanline: note: " << count << (count == 1 ? one : many) << "\n";
}

}  // namespace

ClipCommand::ClipCommand(CLI::App& app)
    : Verb(app.add_subcommand("clip", "what of a region lies inside and outside of another (GeoJSON)")) {
  verb_->add_option("SUBJECT", subject_, "the region that is cut: a Polygon, a MultiPolygon or a Feature with one")
      ->required();
  verb_->add_option("CLIP", clip_, "the region that cuts it")->required();
  verb_->add_option("--out", out_, "the FeatureCollection of both lists; standard output where it is not given");
  verb_->footer(
      "Regions are even-odd: rings may cross and touch. Whole coordinates stay as they are, within -32767 and 32767; "
      "files with decimals are scaled to that grid, and each feature's `scale` says how many grid units one unit of "
      "the "
      "input has. Output rings follow RFC 7946.");
}

void ClipCommand::run() const {
  const ClippedRegions clipped = clip_regions(read_geojson(subject_), read_geojson(clip_));
  const std::string text = clipped.collection.dump() + "\n";
  if (out_) {
    write_file(*out_, text);
  } else {
    std::cout << text;
  }
  note(clipped.dropped_contours, " ring without area is left out", " rings without area are left out");
  note(clipped.merged_points, " repeated point is merged", " repeated points are merged");
}

}  // namespace spanline::host
