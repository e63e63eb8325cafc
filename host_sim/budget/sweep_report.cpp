#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "budget/sweep.hpp"
#include "mcu/board.hpp"
#include "sim/fitted_budget.hpp"

namespace spanline::host {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kBesides = 6 * 1024;  // stack with the frame object on it, the application's few variables
constexpr double kClocks[] = {48, 64, 100, 125, 168};  // MHz
// What the text has room for; the JSON has every core at every clock.
struct Shown {
  const char* core;
  int megahertz;
};
constexpr Shown kShown[] = {{"m0+", 48}, {"m0+", 125}, {"m3", 50}, {"m4", 100}, {"m4", 168}};
constexpr const char* kBoards[] = {"microbit", "ek-lm3s6965", "nucleo-f411re", "stm32f429i-disc1", "pico"};

std::uint32_t ram_of(const BoardDescription& board) {
  std::uint32_t most = 0;
  for (const BoardDescription::Memory& memory : board.memories) {
    if (!memory.flash) most = std::max(most, memory.size);
  }
  return most;
}

std::string boards_with_room(const SweepRow& row) {
  std::string text;
  for (const char* name : kBoards) {
    if (row.bytes + kBesides > ram_of(board_named(name))) continue;
    text += (text.empty() ? "" : " ") + std::string(name);
  }
  return text;
}

// Frames a second, as far as computing goes.
double rate(const SweepRow& row, const char* core, double megahertz) { return megahertz * 1e6 / row.cycles_on(core); }

const char* walker_of(const SweepRow& row) { return row.budget.walker == Walker::edges ? "edges" : "segments"; }

}  // namespace

std::string sweep_text(const Sweep& sweep) {
  std::ostringstream out;
  out << "RAM: pools and two lines, " << kBesides
      << " bytes more for stack and variables; frames a second by computing, an "
      << "estimate\n     size    walker  pools     RAM  bands";
  for (const Shown& shown : kShown) {
    out << std::setw(9) << std::string(shown.core) + "@" + std::to_string(shown.megahertz);
  }
  out << "  fits\n" << std::fixed << std::setprecision(1);
  for (const SweepRow& row : sweep.rows) {
    out << std::setw(9) << std::to_string(row.budget.width) + "x" + std::to_string(row.budget.height) << std::setw(10)
        << walker_of(row) << std::setw(5) << row.percent << " %" << std::setw(8) << row.bytes << std::setw(7);
    if (row.bands == 0) {
      out << "-"
          << "  some line has no room\n";
      continue;
    }
    out << row.bands;
    for (const Shown& shown : kShown) out << std::setw(9) << rate(row, shown.core, shown.megahertz);
    out << "  " << boards_with_room(row) << "\n";
  }
  out << "\nsuggested, with a margin of " << sweep.margin_percent << " %:\n\n"
      << emit_budget(sweep.suggested, "scene", "its frames");
  return out.str();
}

std::string sweep_json(const Sweep& sweep) {
  Json rows = Json::array();
  for (const SweepRow& row : sweep.rows) {
    Json rates = Json::object();
    for (const char* const core : kPricedCores) {
      for (const double clock : kClocks) {
        if (row.bands != 0) rates[core][std::to_string(static_cast<int>(clock))] = rate(row, core, clock);
      }
    }
    rows.push_back({{"width", row.budget.width},
                    {"height", row.budget.height},
                    {"walker", walker_of(row)},
                    {"pools_percent", row.percent},
                    {"facets", row.budget.facets},
                    {"vertices", row.budget.vertices},
                    {"edges", row.budget.edges},
                    {"bytes", row.bytes},
                    {"bands", row.bands == 0 ? Json() : Json(row.bands)},
                    {"frames_a_second_estimate", rates},
                    {"fits", row.bands == 0 ? "" : boards_with_room(row)}});
  }
  const Budget& b = sweep.suggested;
  const Json json = {{"rows", rows},
                     {"suggested",
                      {{"walker", b.walker == Walker::edges ? "edges" : "segments"},
                       {"width", b.width},
                       {"height", b.height},
                       {"facets", b.facets},
                       {"vertices", b.vertices},
                       {"polygons", b.polygons},
                       {"edges", b.edges},
                       {"segments", b.segments},
                       {"active", b.active},
                       {"samples", b.samples},
                       {"implied", b.implied},
                       {"layers", b.layers},
                       {"patch_facets", b.patch_facets},
                       {"patch_vertices", b.patch_vertices},
                       {"planes", b.planes},
                       {"looks", b.looks},
                       {"tables", b.tables},
                       {"gouraud", b.gouraud}}},
                     {"margin_percent", sweep.margin_percent}};
  return json.dump(2) + "\n";
}

}  // namespace spanline::host
