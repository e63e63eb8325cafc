#pragma once

#include <optional>
#include <string>

#include "sim/cli_app.hpp"

namespace spanline::host {

// `spanline clip`: the inside and the outside list of two GeoJSON regions.
class ClipCommand {
 public:
  explicit ClipCommand(CLI::App& app);
  bool chosen() const;

  // Throws InputError.
  void run() const;

 private:
  CLI::App* verb_;
  std::string subject_, clip_;
  std::optional<std::string> out_;
};

}  // namespace spanline::host
