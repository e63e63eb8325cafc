#include "budget/mcu_verbs.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>
#include <string>

#include "assetc/input_error.hpp"
#include "boards/common/run_request.hpp"
#include "budget/budget.hpp"
#include "budget/budget_file.hpp"
#include "budget/budget_table.hpp"
#include "budget/profile_json.hpp"
#include "budget/sweep.hpp"
#include "sim/arguments.hpp"
#include "sim/output_file.hpp"
#include "sim/picture.hpp"
#include "sim/scene_options.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

constexpr std::int64_t kMostFrames = 1'000'000, kMostInstructions = 1'000'000'000'000;

// What both verbs ask for.
struct RunArguments {
  std::string image, board;
  RunOptions options;
  std::optional<std::string> frames, limit;

  void add_to(CLI::App& verb) {
    verb.add_option("image", image, "the ELF file that is flashed")->required();
    verb.add_option("--board", board, "the board, or a bare core: cortex-m0, cortex-m0plus, cortex-m3, cortex-m4, ...");
    verb.add_option("--until", options.until, "end before the first instruction at this symbol");
    verb.add_option("--frames", frames,
                    "end after so many frames: passages from --from to --until, or what our own images are asked for; "
                    "1 unless told");
    verb.add_flag("--icount", options.as_emulator,
                  "time as QEMU's -icount shift=0 has it, to compare with it: an instruction takes a nanosecond, the "
                  "wire nothing; no cycles are counted");
    verb.add_option("--limit", limit, "give up after so many instructions; 4000000000 unless told");
  }

  Image open() {
    if (limit) options.limit = static_cast<std::uint64_t>(parse_integer("--limit", *limit, 1, kMostInstructions));
    if (frames) options.passages = static_cast<unsigned>(parse_integer("--frames", *frames, 1, kMostFrames));
    Image opened(image);
    request_frames(opened);
    return opened;
  }

  // The images of our boards run for ever unless an emulator asks for a last frame.
  void request_frames(const Image& opened) {
    if (!opened.defines("run_request")) return;
    const std::uint32_t last = options.passages - 1, at = opened.address_of("run_request");
    options.words = {{at, last}, {at + 4, last ^ boards::RunRequest::kSeal}};
  }
};

}  // namespace

struct McuVerbs::Verbs {
  CLI::App* run_verb;
  CLI::App* budget_verb;
  RunArguments run, budget;
  CLI::App* table_verb;
  std::optional<std::string> out, shown, json, html, profile, notes, limits, accept, table_out;
  std::vector<std::string> reports;
  bool no_stack = false, sweeps = false;

  static void check_picture(const std::optional<std::string>& path, const BoardDescription& board) {
    if (!path) return;
    check_picture_path(*path);
    if (!board.panel) throw UsageError("--out: " + std::string(board.name) + " has no panel that is modelled");
  }

  // What the panel shows is written even where it has something to complain about.
  static void write_shown(const std::optional<std::string>& path, const RunReport& report, const Image& image) {
    if (path) write_picture(*path, report.panel->picture);
    if (report.panel && !report.panel->complaints.empty()) {
      throw InputError(image.path(), report.panel->complaints.front());
    }
  }

  void do_run() {
    if (run.board.empty()) throw UsageError("--board is required");
    const BoardDescription& board = board_named(run.board);
    check_picture(out, board);
    const Image image = run.open();
    const RunReport report = run_image(image, board, run.options);
    std::cout << report.output;
    if (profile) write_file(*profile, profile_json(report));
    std::cerr << "spanline: " << report.end << " after " << report.total.instructions << " instructions\n";
    write_shown(out, report, image);
    if (report.exit_code != 0)
      throw InputError(image.path(), "the image ended with " + std::to_string(report.exit_code));
  }

  void add_stack(BudgetReport& report, const Image& image, const BoardDescription& board) const {
    const StackNotes known = notes ? read_stack_notes(image, *notes) : StackNotes{};
    const StartState start = start_of(image, board);
    report.stack = stack_bound(image, board.core, start.pc, known);
    if (!start.has_vectors) return;
    report.exception = exception_bound(image, board.core, start.vectors, known);
    report.stack->add(*report.exception);
  }

  static void demand_bound(const StackBound& bound, const RunReport& run, const Image& image) {
    if (!bound.problems.empty()) {
      throw InputError(image.path(), "the stack is not bounded: " + bound.problems.front() +
                                         "; state what is known with --stack-notes, or leave it out with --no-stack");
    }
    if (bound.bytes < run.stack_reached) {
      throw InputError(image.path(), "the run's stack went " + std::to_string(run.stack_reached - bound.bytes) +
                                         " bytes below its bound: a note of --stack-notes is wrong");
    }
  }

  void hold_to_limits(const Image& image, const BudgetReport& report) const {
    const std::string file = image.path().substr(image.path().find_last_of('/') + 1);
    const std::string demo = file.substr(0, file.rfind('.'));
    if (accept) accept_limits(*accept, demo, report);
    if (!limits) return;
    const std::vector<std::string> exceeded = exceeded_limits(*limits, demo, report);
    for (const std::string& line : exceeded) std::cout << "over budget: " << line << "\n";
    if (!exceeded.empty()) throw InputError(*limits, exceeded.front());
  }

  void do_sweep() const {
    const Sweep swept = sweep(SceneOptions::load_plain(budget.image));
    std::cout << sweep_text(swept);
    if (json) write_file(*json, sweep_json(swept));
  }

  void do_budget() {
    if (budget.board.empty()) throw UsageError("--board is required");
    const BoardDescription& board = board_named(budget.board);
    check_picture(shown, board);
    const Image image = budget.open();
    if (budget.options.from.empty() && budget.options.until.empty() && image.defines(kFrameBeginMark)) {
      budget.options.from = kFrameBeginMark;
      budget.options.until = kFrameEndMark;
    }
    BudgetReport report{&image, &board, memory_report(image, board), {}, {}, run_image(image, board, budget.options),
                        {}};
    report.frames = frame_report(report.run, board.kilohertz);
    if (!no_stack) add_stack(report, image, board);
    std::cout << budget_text(report);
    if (json) write_file(*json, budget_json(report));
    if (html) write_file(*html, budget_html(report));
    write_shown(shown, report.run, image);
    if (report.stack) demand_bound(*report.stack, report.run, image);
    hold_to_limits(image, report);
  }

  void do_table() const {
    const std::string table = budget_table(reports);
    if (table_out) {
      write_file(*table_out, table);
    } else {
      std::cout << table;
    }
  }
};

McuVerbs::McuVerbs(CLI::App& app) : verbs_(std::make_unique<Verbs>()) {
  Verbs& v = *verbs_;
  v.run_verb = app.add_subcommand("run", "run the image of a board, instruction by instruction");
  v.run.add_to(*v.run_verb);
  v.run_verb->add_option("--out", v.out, "what the panel shows at the end, .png or .ppm");
  v.run_verb->add_option("--profile", v.profile, "write the call tree with its cycles there, for a flame graph");
  v.budget_verb = app.add_subcommand("budget", "memory, stack, instructions and core cycles of a board's image");
  v.budget.add_to(*v.budget_verb);
  v.budget_verb->add_option("--from", v.budget.options.from, "count from this symbol to --until only");
  v.budget_verb->add_option("--json", v.json, "write the whole report there");
  v.budget_verb->add_option("--limits", v.limits, "fail where the image takes more than this file allows it");
  v.budget_verb->add_option("--accept", v.accept, "set the image's limits in this file to what it takes, and a margin");
  v.budget_verb->add_option("--out", v.shown, "what the panel shows at the end, .png or .ppm");
  v.budget_verb->add_option("--html", v.html, "write a page with plots there");
  v.budget_verb->add_option("--stack-notes", v.notes,
                            "lines 'CALLER calls CALLEE', 'others call CALLEE' and 'FUNCTION recurses N'");
  v.budget_verb->add_flag("--sweep", v.sweeps,
                          "of a scene instead of an image: displays, pools and clock rates that it fits, and a budget");
  v.budget_verb->add_flag("--no-stack", v.no_stack, "do not bound the stack from the code");
  v.budget_verb->footer(
      "An image ends at a BKPT, an SVC, a semihosting exit, a jump to itself, WFI or --until; images with the marks of "
      "ours are counted frame by frame unless --from or --until says otherwise. Core cycles hold for zero wait states; "
      "memory stalls are an estimate.");
  v.table_verb = app.add_subcommand("budget-table", "a table of the reports that `budget --json` wrote");
  v.table_verb->add_option("reports", v.reports, "the reports")->required();
  v.table_verb->add_option("--out", v.table_out, "write it there");
}

McuVerbs::~McuVerbs() = default;

bool McuVerbs::chosen() const {
  return verbs_->run_verb->parsed() || verbs_->budget_verb->parsed() || verbs_->table_verb->parsed();
}

void McuVerbs::run() const {
  if (verbs_->run_verb->parsed()) {
    verbs_->do_run();
  } else if (verbs_->table_verb->parsed()) {
    verbs_->do_table();
  } else if (verbs_->sweeps) {
    verbs_->do_sweep();
  } else {
    verbs_->do_budget();
  }
}

}  // namespace spanline::host
