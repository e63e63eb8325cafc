#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace spanline::host {

// `spanline demo`: what a board shows, drawn on the host by the same code.
class DemoCommand {
 public:
  explicit DemoCommand(CLI::App& app);
  bool chosen() const { return verb_->parsed(); }

  // Throws UsageError and InputError.
  void run() const;

 private:
  CLI::App* verb_;
  bool list_ = false;
  std::optional<std::string> name_, board_, frame_, out_;
};

}  // namespace spanline::host
