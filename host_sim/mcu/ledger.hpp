// Keeps account of a run: by function, by call, by frame, between two symbols.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mcu/call_tree.hpp"
#include "mcu/count.hpp"
#include "mcu/decoded_code.hpp"

namespace spanline::host {

class Ledger {
 public:
  // `functions`: how many there are, besides the one for what belongs to none.
  explicit Ledger(std::size_t functions) : functions_(functions + 1), at_begin_(functions + 1) {}

  void charge(const DecodedCode::Entry& entry, const Count& count) {
    if (entry.function != run_.function || calls_.node() != run_.node) begin_run(entry.function);
    total_ += count;
    run_.count += count;
  }

  // A register is asked: with this instruction a turn of a loop that waits may begin.
  void asked() {
    close_run();
    if (!watching_) watched_from_ = total_.instructions;
    watching_ = true;
  }
  // No such turn has begun before this.
  void forget_recent() {
    if (watching_) forget();
  }
  // What was charged since `begin`, when a register was asked, was a turn of a loop that waits.
  void charge_waiting(std::uint64_t begin);

  // Turns of such a loop pass, each of `turn`; charge_turns() tells whose they were.
  void pass_turns(const Count& turn, std::uint64_t turns);
  void charge_turns(std::uint32_t function, std::uint32_t node, Stage stage, const Count& turns);

  const Count& total() const { return total_; }
  StageCounts stages() const;
  CallTree& calls() { return calls_; }
  // From here on, as far as charged, the call tree's counts and all_functions() are complete.
  void settle() { close_run(); }

  // What is counted from here to the next end() is a passage.
  void begin() {
    close_run();
    begin_ = total_;
    at_begin_ = functions_;
    if (passages_.empty()) calls_.clear_counts();
  }
  void end();

  const std::vector<Count>& passages() const { return passages_; }
  const std::vector<Count>& functions() const { return counted_; }
  // Of the whole run, counted or not.
  const std::vector<Count>& all_functions() const { return functions_; }

 private:
  // Charges in a row to the same function and node of the call tree; nobody asks a register within it.
  struct Run {
    std::uint64_t when = 0;
    std::uint32_t function = 0, node = 0;
    Stage stage = Stage::other;
    Count count;
  };
  static constexpr std::uint64_t kLongestLoop = 1024;  // instructions of a turn

  void close_run();
  void begin_run(std::uint32_t function) {
    close_run();
    run_.function = function;
    run_.node = calls_.node();
    run_.stage = calls_.stage();
  }
  void forget() {
    close_run();
    watching_ = false;
    recent_.clear();
  }

  Run run_;
  bool watching_ = false;
  std::uint64_t watched_from_ = 0;  // instructions before `recent_`
  std::vector<Run> recent_;
  Count total_, begin_;
  StageCounts stages_{};
  std::vector<Count> functions_, at_begin_, counted_;
  std::vector<Count> passages_;
  CallTree calls_;
};

// Finds the loops that wait: the same instruction reads a register again, and nothing was stored in between.
class WaitFinder {
 public:
  struct Wait {
    std::uint64_t begin, end;
  };

  void stored() { ++stores_; }
  // So much time passes in which all that has been asked `since` then is asked again and again.
  Wait go_on(std::uint64_t since, std::uint64_t passed);
  std::optional<Wait> asked(std::uint32_t instruction, std::uint64_t now);

 private:
  struct Question {
    std::uint32_t instruction;
    std::uint64_t stores, when;
  };
  std::vector<Question> questions_;
  std::uint64_t stores_ = 0, counted_until_ = 0;
};

}  // namespace spanline::host
