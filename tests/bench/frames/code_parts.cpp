#include "frames/code_parts.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

#include "frames/link_map.hpp"

namespace spanline::bench {
namespace {

// Object files, and functions with their lengths before them, as symbols are mangled.
struct Rule {
  std::string_view part;
  std::initializer_list<std::string_view> marks;
};

constexpr std::string_view kWalk = "the walk of a line and its pixels";
constexpr std::string_view kOverlap = "stops where faces overlap, the line's right end";
constexpr std::string_view kDepth = "planes of depth and of brightness, exact ones of large faces among them";
constexpr std::string_view kEdges = "edges that begin, tall ones that go on";
constexpr std::string_view kBrightness = "brightness: looks and tables";
constexpr std::string_view kPlaces = "matrices, projection, culling, what lies inside the view";
constexpr std::string_view kLight = "light";
constexpr std::string_view kRest = "set-up, checks, refusals and their texts";
constexpr std::array kParts = {kWalk, kOverlap, kDepth, kEdges, kBrightness, kPlaces, kLight, kRest};

// The first that has a mark of the section's name or of its object file; what none has is the rest.
const std::array kRules = {
    Rule{kOverlap,
         {"15resolve_overlap", "12front_of_set", "14gather_overlap", "7cut_off", "10OverlapSet", "15DepthComparator"}},
    Rule{kDepth, {"depth.cpp", "depth_reaches.cpp", "depth_rows.cpp", "gradient.cpp", "rare_div.cpp", "10PlaneCache"}},
    Rule{kEdges, {"fan_start", "mesh_walker.cpp", "active_edge.cpp", "vertex_buckets.cpp", "edge_walker.cpp"}},
    Rule{kBrightness, {"9make_look", "7turn_to", "10learn_look", "3dip", "brightness.cpp", "look_chains.cpp"}},
    Rule{kLight, {"light.cpp", "root.cpp", "11light_faces", "14light_vertices"}},
    Rule{kPlaces,
         {"7compose", "projection.cpp", "clip_matrix.cpp", "mesh_points.cpp", "instance_cursor.cpp", "7project",
          "4cull"}},
    Rule{kWalk,
         {"walk_thumb", "line_walk.cpp", "8LineWalk", "5go_onI", "4next", "10fill_words", "12fill_exactly", "4Sink"}},
};

std::string_view part_of(const Contribution& bytes) {
  const auto marked = [&](std::string_view mark) {
    return bytes.section.find(mark) != std::string::npos || bytes.member.find(mark) != std::string::npos;
  };
  const auto rule = std::find_if(kRules.begin(), kRules.end(), [&](const Rule& one) {
    return std::any_of(one.marks.begin(), one.marks.end(), marked);
  });
  return rule == kRules.end() ? kRest : rule->part;
}

}  // namespace

std::vector<CodePart> code_parts(const std::string& path) {
  std::vector<CodePart> parts;
  for (const std::string_view name : kParts) parts.push_back({std::string(name), 0});
  for (const Contribution& bytes : engine_contributions(path)) {
    const auto part = std::find(kParts.begin(), kParts.end(), part_of(bytes));
    parts[static_cast<std::size_t>(part - kParts.begin())].bytes += bytes.size;
  }
  return parts;
}

PartsCommand::PartsCommand(CLI::App& app)
    : Verb(app.add_subcommand("parts", "what the engine's code consists of, from link maps")) {
  verb_->add_option("flat", flat_, "the map of a flat image")->required();
  verb_->add_option("gouraud", gouraud_, "that of one with Gouraud shading")->required();
}

void PartsCommand::run() const {
  const std::vector<CodePart> flat = code_parts(flat_), gouraud = code_parts(gouraud_);
  std::cout << "| bytes | flat | Gouraud |\n|---|--:|--:|\n";
  CodePart sum_flat, sum_gouraud;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    std::cout << "| " << flat[i].name << " | " << flat[i].bytes << " | " << gouraud[i].bytes << " |\n";
    sum_flat.bytes += flat[i].bytes;
    sum_gouraud.bytes += gouraud[i].bytes;
  }
  std::cout << "| all | " << sum_flat.bytes << " | " << sum_gouraud.bytes << " |\n";
}

}  // namespace spanline::bench
