#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace spanline::host {

// `spanline clip`: the inside and the outside list of two GeoJSON regions.
class ClipCommand {
 public:
  explicit ClipCommand(CLI::App& app);
  bool chosen() const { return verb_->parsed(); }

  // Throws InputError.
  void run() const;

 private:
  CLI::App* verb_;
  std::string subject_, clip_;
  std::optional<std::string> out_;
};

}  // namespace spanline::host
