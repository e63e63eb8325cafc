#include "frames/pieces.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "assetc/input_error.hpp"
#include "frames/count.hpp"

namespace spanline::bench {
namespace {

using namespace host;

enum Piece : std::size_t { kVertex, kFace, kEdge, kPlane, kLook, kOverlap, kWalk, kPieces };
using Costs = std::array<double, kPieces>;

// Who a call, with all it calls, is charged to; the innermost that is named holds. All else is the walk: of lines and
// their pixels.
struct Rule {
  const char* part;  // of the function's name
  Piece piece;
};
constexpr Rule kRules[] = {{"::project(", kVertex},
                           {">::begin", kFace},
                           {"::cull", kFace},
                           {"::light_", kFace},
                           {"VertexBuckets::Mesh::file", kFace},
                           {"::start_edges", kEdge},
                           {"spanline_start", kEdge},
                           {"spanline_insert", kEdge},
                           {"DepthRows::plane", kPlane},
                           {"depth_plane(", kPlane},
                           {"::make_look(", kLook},
                           {"::learn_look(", kLook},
                           {"brightness_plane(", kLook},
                           {"::show_front", kOverlap},
                           {"::go_on", kOverlap},
                           {"resolve_", kOverlap},
                           {"spanline_", kWalk}};

struct Row {
  Piece piece;
  const char* what;
};
constexpr Row kRows[] = {{kVertex, "a vertex projected"},
                         {kFace, "a face culled or lit, its vertices filed"},
                         {kEdge, "an edge begun, once for both its faces"},
                         {kPlane, "a face before or behind others: its depth plane"},
                         {kLook, "a smooth face: its brightness plane"},
                         {kOverlap, "a span of several faces: the nearest found"},
                         {kWalk, "an edge on a line: stepped, the span to its left begun"}};

Piece piece_of(const std::string& name, Piece caller) {
  for (const Rule& rule : kRules) {
    if (name.find(rule.part) != std::string::npos) return rule.piece;
  }
  return caller;
}

void charge(const RunReport& run, std::uint32_t index, Piece caller, Costs& costs) {
  const CallTree::Node& node = run.calls.nodes()[index];
  const Piece piece = node.frame == CallTree::kRoot ? caller : piece_of(run.places[node.frame].name, caller);
  costs[piece] += static_cast<double>(node.self.instructions);
  for (const auto& [frame, child] : node.children) charge(run, child, piece, costs);
}

struct Frame {
  Costs costs{};
  Units units;
};

Frame frame_of(const std::string& folder, const std::string& cpu, const std::string& name) {
  const Expected expected = read_expected(folder + "/frames/" + name);
  Frame frame{{}, expected.units};
  const std::string image = folder + "/" + cpu + "/" + name + ".elf";
  charge(run_frames(Image(image), cpu, 1), 0, kWalk, frame.costs);
  for (const Row& row : kRows) {
    const bool smooth = name.find("gouraud") != std::string::npos;
    if (frame.costs[row.piece] == 0 && row.piece != kPlane && (smooth || row.piece != kLook) &&
        expected.units.overlaps != 0) {
      throw InputError(image, std::string("nothing of it is '") + row.what + "'");
    }
  }
  return frame;
}

// A column of the table, and what a pixel costs.
struct Column {
  Costs each;
  double pixel;
};

Column column_of(const std::string& folder, const std::string& cpu, const std::string& shading) {
  const Frame large = frame_of(folder, cpu, "S1-" + shading), many = frame_of(folder, cpu, "S4-" + shading);
  const Units& u = many.units;
  constexpr double kPixels = 320 * 240;
  Column column{many.costs, large.costs[kWalk] / kPixels};
  Costs& each = column.each;
  each[kWalk] -= column.pixel * kPixels;
  const std::array<std::uint32_t, kPieces> counts = {u.vertices, u.faces,    u.edges,     u.overlapping,
                                                     u.fronts,   u.overlaps, u.edge_lines};
  for (std::size_t piece = 0; piece < kPieces; ++piece) each[piece] /= counts[piece];
  return column;
}

}  // namespace

PiecesCommand::PiecesCommand(CLI::App& app)
    : Verb(app.add_subcommand("pieces", "a table of what each stage costs for each of its pieces")) {
  verb_->add_option("folder", folder_, "where frames/ and the images of each core are")->required();
  verb_->add_option("cpu", cpus_, "m0plus, m3, m4")->required();
}

void PiecesCommand::run() const {
  std::ostringstream head("| |", std::ios::ate), rule("|---|", std::ios::ate);
  std::vector<Column> columns;
  for (const std::string& cpu : cpus_) {
    for (const char* shading : {"flat", "gouraud"}) {
      columns.push_back(column_of(folder_, cpu, shading));
      head << " " << cpu << " " << shading << " |";
      rule << "--:|";
    }
  }
  std::cout << head.str() << "\n" << rule.str() << "\n" << std::fixed;
  for (const Row& row : kRows) {
    std::cout << "| " << row.what << " |" << std::setprecision(0);
    for (const Column& column : columns) {
      const double cost = column.each[row.piece];
      cost == 0 ? std::cout << " |" : std::cout << " " << cost << " |";
    }
    std::cout << "\n";
  }
  std::cout << "| a pixel, its part of the line's beginning included |" << std::setprecision(1);
  for (const Column& column : columns) std::cout << " " << column.pixel << " |";
  std::cout << "\n";
}

}  // namespace spanline::bench
