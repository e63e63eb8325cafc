// What budgets' sweep expects of the edge walker's frames, fitted to counted ones.
#pragma once

#include <string>
#include <vector>

#include "sim/verb.hpp"

namespace spanline::bench {

// `spanline-frames prices FOLDER SCENE… --prices F --frames F`: executes the images of those scenes that frames.sh left
// in FOLDER, of every priced core and both shadings. Writes what a pixel, a face, a crossing and a depth test cost
// (host_sim/budget/edge_prices.inc), and the frames they are held against (tests/mcu/edge_frames.inc).
class PricesCommand : public host::Verb {
 public:
  explicit PricesCommand(CLI::App& app);

  // Throws InputError where an image is not there or draws another picture.
  void run() const;

 private:
  std::string folder_, prices_, frames_;
  std::vector<std::string> scenes_;
};

}  // namespace spanline::bench
