#pragma once

#include <optional>
#include <string>

#include "sim/verb.hpp"

namespace spanline::host {

// `spanline clip`: the inside and the outside list of two GeoJSON regions.
class ClipCommand : public Verb {
 public:
  explicit ClipCommand(CLI::App& app);

  // Throws InputError.
  void run() const;

 private:
  std::string subject_, clip_;
  std::optional<std::string> out_;
};

}  // namespace spanline::host
