// The verbs that run the image of a board: `run` and `budget`. A build without the libraries that they need has
// neither.
#pragma once

#include <memory>

#include "sim/cli_app.hpp"

namespace spanline::host {

class McuVerbs {
 public:
  // Where the verbs are missing, the help says so.
  explicit McuVerbs(CLI::App& app);
  ~McuVerbs();
  McuVerbs(const McuVerbs&) = delete;
  McuVerbs& operator=(const McuVerbs&) = delete;

  bool chosen() const;

  // Throws UsageError and InputError.
  void run() const;

 private:
  struct Verbs;
  std::unique_ptr<Verbs> verbs_;
};

}  // namespace spanline::host
