#include "budget/mcu_verbs.hpp"

#include <iostream>
#include <optional>
#include <string>

#include "assetc/input_error.hpp"
#include "boards/common/run_request.hpp"
#include "budget/budget.hpp"
#include "budget/profile_json.hpp"
#include "sim/arguments.hpp"
#include "sim/output_file.hpp"
#include "sim/picture.hpp"
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
    verb.add_option("--board", board, "the board, or a bare core: cortex-m0, cortex-m0plus, cortex-m3, cortex-m4, ...")
        ->required();
    verb.add_option("--until", options.until, "end before the first instruction at this symbol");
    verb.add_option("--frames", frames,
                    "end after so many frames: passages from --from to --until, or what our own images are asked for; "
                    "1 unless told");
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
  std::optional<std::string> out, json, html, profile, notes;
  bool no_stack = false;

  void do_run() {
    const BoardDescription& board = board_named(run.board);
    const Image image = run.open();
    if (out) check_picture_path(*out);
    if (out && !board.panel) throw UsageError("--out: " + std::string(board.name) + " has no panel that is modelled");
    const RunReport report = run_image(image, board, run.options);
    std::cout << report.output;
    if (out) write_picture(*out, report.panel->picture);
    if (profile) write_file(*profile, profile_json(report));
    std::cerr << "spanline: " << report.end << " after " << report.total.instructions << " instructions\n";
    if (report.exit_code != 0)
      throw InputError(image.path(), "the image ended with " + std::to_string(report.exit_code));
    if (report.panel && !report.panel->complaints.empty())
      throw InputError(image.path(), report.panel->complaints.front());
  }

  void do_budget() {
    const BoardDescription& board = board_named(budget.board);
    const Image image = budget.open();
    if (budget.options.from.empty() && budget.options.until.empty() && image.defines(kFrameBeginMark)) {
      budget.options.from = kFrameBeginMark;
      budget.options.until = kFrameEndMark;
    }
    Budget report{&image, &board, memory_report(image, board), {}, {}, run_image(image, board, budget.options), {}};
    report.frames = frame_report(report.run, board.kilohertz);
    if (!no_stack) {
      const StackNotes known = notes ? read_stack_notes(image, *notes) : StackNotes{};
      const StartState start = start_of(image, board);
      report.stack = stack_bound(image, board.core, start.pc, known);
      if (start.has_vectors) report.exception = exception_bound(image, board.core, start.vectors, known);
    }
    std::cout << budget_text(report);
    if (json) write_file(*json, budget_json(report));
    if (html) write_file(*html, budget_html(report));
    if (report.stack && !report.stack->problems.empty()) {
      throw InputError(image.path(), "the stack is not bounded: " + report.stack->problems.front() +
                                         "; state what is known with --stack-notes, or leave it out with --no-stack");
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
  v.budget_verb->add_option("--html", v.html, "write a page with plots there");
  v.budget_verb->add_option("--stack-notes", v.notes,
                            "lines 'CALLER calls CALLEE', 'CALLER may call CALLEE' and 'FUNCTION recurses N'");
  v.budget_verb->add_flag("--no-stack", v.no_stack, "do not bound the stack from the code");
  v.budget_verb->footer(
      "An image ends at a BKPT, an SVC, a semihosting exit, a jump to itself, WFI or --until; images with the marks of "
      "ours are counted frame by frame unless --from or --until says otherwise. Core cycles hold for zero wait states; "
      "memory stalls are an estimate.");
}

McuVerbs::~McuVerbs() = default;

bool McuVerbs::chosen() const { return verbs_->run_verb->parsed() || verbs_->budget_verb->parsed(); }

void McuVerbs::run() const {
  if (verbs_->run_verb->parsed()) {
    verbs_->do_run();
  } else {
    verbs_->do_budget();
  }
}

}  // namespace spanline::host
